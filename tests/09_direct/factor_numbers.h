// Exercise 9.2: the numbers of a factor, and their names.
#pragma once

#include "tests/09_direct/matrix_cases.h"

namespace joints::testing {

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
    out.push_back(block + " [" + std::to_string(i) + ", " + std::to_string(j) + "]");
  };
  for (std::size_t k = 0; k + 1 < A.nodes.size(); ++k) {
    for (int i = 0; i < A.nodes[k].rows; ++i)
      for (int j = 0; j <= i; ++j)
        name((i == j ? "1 / pivot, node " : "factor, node ") + std::to_string(k), i, j);
    for (int e = A.nodes[k].first_edge; e < A.nodes[k + 1].first_edge; ++e) {
      const int to = A.edges[std::size_t(e)].to;
      for (int i = 0; i < A.nodes[std::size_t(to)].rows; ++i)
        for (int j = 0; j < A.nodes[k].rows; ++j)
          name("L of nodes " + std::to_string(k) + ", " + std::to_string(to), i, j);
    }
  }
  return out;
}

inline constexpr std::size_t numbers_of_factor = 320;

}  // namespace joints::testing
