// Exercise 9.2: the factor as a table.
#pragma once

#include "chapters/09_direct/block_kernels.h"
#include "tests/09_direct/factor_numbers.h"

namespace joints::testing {

/// All blocks of L of a node before any of them is stored.
inline JointMatrix right_factor(const MatrixCase& c) {
  JointMatrix A = joint_matrix(c);
  const auto at = [&](int place) { return &A.numbers[std::size_t(place)]; };
  const int* target = A.targets.data();
  for (std::size_t k = 0; k + 1 < A.nodes.size(); ++k) {
    const Node& node = A.nodes[k];
    const auto rows = [&](const Edge& edge) { return A.nodes[std::size_t(edge.to)].rows; };
    const auto first = A.edges.begin() + node.first_edge;
    const auto end = A.edges.begin() + A.nodes[k + 1].first_edge;
    factor_block(at(node.diagonal), node.rows, &A.original[std::size_t(node.row)], c.inverse);
    std::vector<Numbers> L;
    for (auto edge = first; edge != end; ++edge) {
      L.emplace_back(36);
      divide_rows(at(edge->at), rows(*edge), at(node.diagonal), node.rows, L.back().data());
      for (auto other = edge; other != end; ++other)
        subtract_product(at(other->at), rows(*other), L.back().data(), rows(*edge), node.rows,
                         at(*target++));
    }
    for (auto edge = first; edge != end; ++edge)
      std::copy_n(L[std::size_t(edge - first)].begin(), rows(*edge) * node.rows, at(edge->at));
  }
  return A;
}

inline CaseTable<MatrixCase> factor_table() {
  auto table = padded_table<MatrixCase>({"9.2", "the factor L D L^T"}, numbers_of_factor,
                                        factor_names);
  table.cases = matrix_cases();
  judge(table, factor, [](auto factor, const MatrixCase& c) {
    JointMatrix A = joint_matrix(c);
    factor(A, c.inverse);
    return padded(flat(A), numbers_of_factor);
  });
  table.right = [](const MatrixCase& c) {
    return padded(flat(right_factor(c)), numbers_of_factor);
  };
  tell_where_it_holds(table);
  return table;
}

}  // namespace joints::testing
