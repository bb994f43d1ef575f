// Exercise 9.2: the factor by dense solutions, without the chapter's arithmetic.
#pragma once

#include "tests/09_direct/matrix_cases.h"

namespace joints::testing {

/// The factor of a matrix without the chapter's arithmetic: L of each edge by a dense solution with
/// what elimination has left of the diagonal block.
inline JointMatrix dense_factor(const MatrixCase& c) {
  JointMatrix out = joint_matrix(c);
  Dense S = c.A;  // what is left
  for (int k = 0; k < c.count(); ++k) {
    const Node& node = out.nodes[std::size_t(k)];
    const int n = node.rows, r = node.row;
    Dense D(n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) D(i, j) = S(r + i, r + j);
    const auto L_row = [&](int row) {
      Numbers b;
      for (int j = 0; j < n; ++j) b.push_back(S(row, r + j));
      return gauss(D, b);  // D is symmetric
    };
    const int end = out.nodes[std::size_t(k) + 1].first_edge;
    std::vector<std::pair<int, Numbers>> L;  // row of x, its n numbers
    for (int e = node.first_edge; e < end; ++e) {
      const Edge& edge = out.edges[std::size_t(e)];
      const Node& to = out.nodes[std::size_t(edge.to)];
      for (int i = 0; i < to.rows; ++i) {
        L.push_back({to.row + i, L_row(to.row + i)});
        std::copy_n(L.back().second.data(), n, &out.numbers[std::size_t(edge.at + i * n)]);
      }
    }
    for (const auto& [row, l] : L)
      for (const auto& [column, other] : L) {
        double sum = 0;
        for (int j = 0; j < n; ++j) sum += l[std::size_t(j)] * S(column, r + j);
        S(row, column) -= sum;
      }
    for (int j = 0; j < n; ++j) {  // D = L d L^T
      for (int i = j + 1; i < n; ++i)
        for (int m = j + 1; m < n; ++m) D(i, m) -= D(i, j) * D(j, m) / D(j, j);
      for (int i = j + 1; i < n; ++i)
        out.numbers[std::size_t(node.diagonal + i * n + j)] = D(i, j) / D(j, j);
      out.numbers[std::size_t(node.diagonal + j * n + j)] = 1 / D(j, j);
    }
  }
  return out;
}

/// The numbers of a factor: of the diagonal blocks those that count, of the edges all.
inline Numbers flat(const JointMatrix& A) {
  Numbers out;
  for (std::size_t k = 0; k + 1 < A.nodes.size(); ++k) {
    const Node& node = A.nodes[k];
    for (int i = 0; i < node.rows; ++i)
      for (int j = 0; j <= i; ++j)
        out.push_back(A.numbers[std::size_t(node.diagonal + i * node.rows + j)]);
    for (int e = node.first_edge; e < A.nodes[k + 1].first_edge; ++e)
      for (int i = 0; i < A.nodes[std::size_t(A.edges[std::size_t(e)].to)].rows * node.rows; ++i)
        out.push_back(A.numbers[std::size_t(A.edges[std::size_t(e)].at + i)]);
  }
  return out;
}
inline std::vector<std::string> factor_names(const MatrixCase& c) {
  const JointMatrix A = joint_matrix(c);
  std::vector<std::string> out;
  const auto name = [&](const std::string& block, int i, int j) {
    out.push_back(block + "[" + std::to_string(i) + ", " + std::to_string(j) + "]");
  };
  for (std::size_t k = 0; k + 1 < A.nodes.size(); ++k) {
    for (int i = 0; i < A.nodes[k].rows; ++i)
      for (int j = 0; j <= i; ++j)
        name((i == j ? "1 / pivot, node " : "node ") + std::to_string(k), i, j);
    for (int e = A.nodes[k].first_edge; e < A.nodes[k + 1].first_edge; ++e) {
      const int to = A.edges[std::size_t(e)].to;
      for (int i = 0; i < A.nodes[std::size_t(to)].rows; ++i)
        for (int j = 0; j < A.nodes[k].rows; ++j)
          name("edge " + std::to_string(k) + " to " + std::to_string(to), i, j);
    }
  }
  return out;
}

inline constexpr std::size_t numbers_of_factor = 320;

}  // namespace joints::testing
