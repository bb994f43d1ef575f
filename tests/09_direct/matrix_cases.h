// Exercise 9.2: small matrices of joints, made by hand, and the dense solution that they are
// compared with.
#pragma once

#include <algorithm>
#include <set>

#include "chapters/09_direct/direct.h"
#include "tests/checker/padded.h"

namespace joints::testing {

/// A dense matrix, row by row.
struct Dense {
  int size = 0;
  Numbers a = {};
  explicit Dense(int size) : size(size), a(std::size_t(size * size), 0) {}
  double& operator()(int i, int j) { return a[std::size_t(i * size + j)]; }
  double operator()(int i, int j) const { return a[std::size_t(i * size + j)]; }
};

/// The solution of A x = b by Gauss elimination with pivoting: none of the chapter's code.
inline Numbers gauss(Dense A, Numbers b) {
  const int n = A.size;
  for (int k = 0; k < n; ++k) {
    int best = k;
    for (int i = k; i < n; ++i)
      if (std::abs(A(i, k)) > std::abs(A(best, k))) best = i;
    for (int j = 0; j < n; ++j) std::swap(A(k, j), A(best, j));
    std::swap(b[std::size_t(k)], b[std::size_t(best)]);
    for (int i = k + 1; i < n; ++i) {
      const double l = A(i, k) / A(k, k);
      for (int j = k; j < n; ++j) A(i, j) -= l * A(k, j);
      b[std::size_t(i)] -= l * b[std::size_t(k)];
    }
  }
  for (int k = n - 1; k >= 0; --k) {
    for (int j = k + 1; j < n; ++j) b[std::size_t(k)] -= A(k, j) * b[std::size_t(j)];
    b[std::size_t(k)] /= A(k, k);
  }
  return b;
}

/// Nodes in the order of elimination, and which of them A couples.
struct MatrixCase {
  std::string words;
  std::vector<int> rows;                    ///< of each node
  std::vector<std::pair<int, int>> coupled; ///< nodes (earlier, later) with a block in A
  std::vector<int> row = {};                ///< where each node's numbers begin in x
  Dense A{0};                               ///< by rows of x
  PivotInverse inverse = [](double pivot, double) { return 1 / pivot; };
  std::vector<int> dropped = {};            ///< rows of x that depend on others

  int size() const { return A.size; }
  int first(int node) const { return row[std::size_t(node)]; }
  int count() const { return int(rows.size()); }
};

/// Fills a case with numbers: symmetric, positive definite.
inline MatrixCase filled(MatrixCase c, unsigned seed) {
  Random random(seed);
  int size = 0;
  c.row.resize(c.rows.size());
  for (int k = c.count() - 1; k >= 0; --k) {  // the last node has the first numbers
    c.row[std::size_t(k)] = size;
    size += c.rows[std::size_t(k)];
  }
  c.A = Dense(size);
  const auto couple = [&](int a, int b) {
    for (int i = 0; i < c.rows[std::size_t(a)]; ++i)
      for (int j = 0; j < c.rows[std::size_t(b)]; ++j) {
        const int one = c.first(a) + i, other = c.first(b) + j;
        if (one != other) c.A(one, other) = c.A(other, one) = double(random.uniform(-1, 1));
      }
  };
  for (int k = 0; k < c.count(); ++k) couple(k, k);
  for (const auto& [a, b] : c.coupled) couple(a, b);
  for (int i = 0; i < size; ++i) {
    double sum = 0;
    for (int j = 0; j < size; ++j) sum += std::abs(c.A(i, j));
    c.A(i, i) = 0.5 + sum;
  }
  return c;
}

/// The chain of the text: three rods on four masses of 1 kg in a line.
inline MatrixCase paper_chain() {
  MatrixCase c{"three scalar rows of a chain", {1, 1, 1}, {{0, 1}, {1, 2}}};
  c.row = {0, 1, 2};
  c.A = Dense(3);
  for (int i = 0; i < 3; ++i) c.A(i, i) = 2;
  for (int i = 0; i < 2; ++i) c.A(i, i + 1) = c.A(i + 1, i) = -1;
  return c;
}

inline std::vector<MatrixCase> matrix_cases() {
  const auto chain = [](int nodes) {
    std::vector<std::pair<int, int>> out;
    for (int k = 0; k + 1 < nodes; ++k) out.push_back({k, k + 1});
    return out;
  };
  return {paper_chain(),
          filled({"one node of three rows", {3}, {}}, 1),
          filled({"two nodes, one row each", {1, 1}, {{0, 1}}}, 2),
          filled({"a chain of four ball joints", {3, 3, 3, 3}, chain(4)}, 3),
          filled({"a triangle", {2, 3, 1}, {{0, 1}, {0, 2}, {1, 2}}}, 4),
          filled({"a ring of four, one block is filled in", {2, 1, 3, 2},
                  {{0, 1}, {0, 3}, {1, 2}, {2, 3}}}, 5),
          filled({"a star whose hub comes last", {1, 2, 3, 2, 4},
                  {{0, 4}, {1, 4}, {2, 4}, {3, 4}}}, 6),
          filled({"a star whose hub comes first, all is filled in", {3, 1, 2, 2},
                  {{0, 1}, {0, 2}, {0, 3}}}, 7),
          filled({"nodes of 1 to 6 rows", {5, 1, 6, 2, 4, 3},
                  {{0, 1}, {0, 3}, {1, 2}, {1, 5}, {2, 4}, {3, 5}, {4, 5}}}, 8),
          filled({"two chains that share nothing", {2, 3, 1, 2}, {{0, 2}, {1, 3}}}, 9)};
}

/// The node of a row of x.
inline int node_of(const MatrixCase& c, int row) {
  for (int k = 0; k < c.count(); ++k)
    if (c.first(k) <= row && row < c.first(k) + c.rows[std::size_t(k)]) return k;
  return -1;
}

/// Matrices with a row that depends on others: such a pivot gets the inverse 0. The diagonal is
/// scaled from row to row, so that each pivot needs its own original entry.
inline std::vector<MatrixCase> dependent_cases() {
  std::vector<MatrixCase> out;
  for (const MatrixCase& whole : matrix_cases()) {
    if (whole.count() < 2 || whole.size() < 4) continue;
    MatrixCase c = whole;
    c.words += ", the last row is the first once more";
    // the last row that is eliminated becomes a copy of the first one of its node, or of node 0's
    const int last = c.count() - 1;
    const int copy = c.first(last) + c.rows[std::size_t(last)] - 1;
    int of = c.first(last);
    if (of == copy) continue;
    for (int j = 0; j < c.size(); ++j) c.A(copy, j) = c.A(of, j);
    for (int i = 0; i < c.size(); ++i) c.A(i, copy) = c.A(i, of);
    double scale = 1e-3;
    for (int i = 0; i < c.size(); ++i, scale *= 3)
      for (int j = 0; j < c.size(); ++j) c.A(i, j) *= scale, c.A(j, i) *= scale;
    c.dropped = {copy};
    c.inverse = [](double pivot, double original) {
      return pivot > 1e-9 * original ? 1 / pivot : 0;
    };
    out.push_back(c);
  }
  return out;
}

constexpr double upper_triangle = 77;  ///< what stands above the diagonal of a diagonal block

/// The matrix of the joints of a case, with places for fill-in. Behind the targets stand
/// more of them, which point behind the numbers: reading too many does no harm.
inline JointMatrix joint_matrix(const MatrixCase& c) {
  JointMatrix A;
  std::vector<std::set<int>> later(c.rows.size());
  for (const auto& [a, b] : c.coupled) later[std::size_t(a)].insert(b);
  int at = 0;
  for (int k = 0; k < c.count(); ++k) {
    const int n = c.rows[std::size_t(k)];
    const auto& to = later[std::size_t(k)];
    A.nodes.push_back({n, c.first(k), at, int(A.edges.size())});
    at += n * n;
    for (auto j = to.begin(); j != to.end(); ++j) {
      A.edges.push_back({*j, at});
      at += n * c.rows[std::size_t(*j)];
      later[std::size_t(*j)].insert(std::next(j), to.end());
    }
  }
  A.nodes.push_back({0, c.size(), at, int(A.edges.size())});
  A.numbers.assign(std::size_t(at) + 36, 0);
  const auto edge = [&](int from, int to) {
    for (int j = A.nodes[std::size_t(from)].first_edge;; ++j)
      if (A.edges[std::size_t(j)].to == to) return A.edges[std::size_t(j)].at;
  };
  for (int k = 0; k < c.count(); ++k) {
    const Node& node = A.nodes[std::size_t(k)];
    for (int i = 0; i < node.rows; ++i)
      for (int j = 0; j < node.rows; ++j)
        A.numbers[std::size_t(node.diagonal + i * node.rows + j)] =
            j > i ? upper_triangle : c.A(node.row + i, node.row + j);
    const int end = A.nodes[std::size_t(k) + 1].first_edge;
    for (int e = node.first_edge; e < end; ++e) {
      const Node& to = A.nodes[std::size_t(A.edges[std::size_t(e)].to)];
      for (int i = 0; i < to.rows; ++i)
        for (int j = 0; j < node.rows; ++j)
          A.numbers[std::size_t(A.edges[std::size_t(e)].at + i * node.rows + j)] =
              c.A(to.row + i, node.row + j);
      for (int f = e; f < end; ++f) {
        const int other = A.edges[std::size_t(f)].to, one = A.edges[std::size_t(e)].to;
        A.targets.push_back(other == one ? A.nodes[std::size_t(one)].diagonal : edge(one, other));
      }
    }
  }
  for (int k = 0; k < 200; ++k) A.targets.push_back(at);
  for (int i = 0; i < c.size(); ++i) A.original.push_back(c.A(i, i));
  A.original.push_back(1);
  return A;
}

}  // namespace joints::testing
