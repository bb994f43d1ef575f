// Exercise 9.2: the factor as a table, with the usual mistakes.
#pragma once

#include "chapters/09_direct/block_kernels.h"
#include "tests/09_direct/factor_numbers.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

/// The steps of the factorisation, each of which a mistake may change.
struct FactorReference {
  MatrixCase c;
  enum class When { never, first, right, last } diagonal = When::right;
  enum class Store { never, early, all_early, right, edge_once } store = Store::right;
  enum class Targets { forward, stuck, again, own_edge } targets = Targets::forward;
  enum class Original { own, by_node, first } original = Original::own;
  int skip_nodes = 0, skip_edges = 0, from = 0;  ///< from: the inner loop begins at j + from
  bool from_first = false, only_diagonal = false, divides = true, plain = false, exchanged = false;
  bool plain_times_plain = false, divides_exchanged = false, rows_of_j = false, block_of_j = false;
  bool only_own = false, only_first = false, advances_before = false;
  enum class Stored { all, row, square } stored = Stored::all;  ///< how much of L
  enum class Turned { none, divided, factor, stored } turned = Turned::none;  ///< transposed
  int skip_inner = 0, first_node = 0;
  bool backwards = false;  ///< the inner loop

  explicit FactorReference(const MatrixCase& c) : c(c) {}

  JointMatrix factored() const {
    JointMatrix A = joint_matrix(c);
    double* const number = A.numbers.data();
    const int* target = A.targets.data();
    double L[36], kept[36];
    for (int k = first_node; k < c.count() - skip_nodes; ++k) {
      const Node& node = A.nodes[std::size_t(k)];
      const int n = node.rows, end = A.nodes[std::size_t(k) + 1].first_edge - skip_edges;
      double* const D = &number[node.diagonal];
      const auto factor_diagonal = [&] {
        const std::size_t at = std::size_t(original == Original::own       ? node.row
                                           : original == Original::by_node ? k
                                                                           : 0);
        factor_block(D, n, &A.original[at],
                     plain ? [](double p, double) { return 1 / p; } : c.inverse);
      };
      if (diagonal == When::right) factor_diagonal();
      for (int j = node.first_edge; store == Store::all_early && j < end; ++j) {
        const Edge& edge = A.edges[std::size_t(j)];
        divide_rows(number + edge.at, A.nodes[std::size_t(edge.to)].rows, D, n, number + edge.at);
      }
      if (targets == Targets::again) target = A.targets.data();
      for (int j = node.first_edge; j < (only_first ? std::min(node.first_edge + 1, end) : end);
           ++j) {
        const Edge& edge = A.edges[std::size_t(j)];
        const int m = A.nodes[std::size_t(edge.to)].rows;
        double* const block = number + edge.at;
        const auto transposed = [m, n](const double* from, double* to) {
          for (int a = 0; a < m; ++a)
            for (int b = 0; b < n; ++b) to[b * m + a] = from[a * n + b];
        };
        double across[36];
        if (turned == Turned::divided) {
          transposed(block, across);
          divide_rows(across, m, D, n, L);
        } else if (store == Store::all_early) std::copy(block, block + m * n, L);
        else if (divides_exchanged) divide_rows(block, n, D, m, L);
        else if (divides) divide_rows(block, m, D, n, L);
        else std::copy(block, block + m * n, L);
        std::copy(block, block + m * n, kept);
        transposed(L, across);
        const double* const second = turned == Turned::factor ? across : L;
        if (store == Store::early) std::copy_n(L, m * n, block);
        for (int n_th = from_first ? node.first_edge : j + from; n_th < end - skip_inner; ++n_th) {
          const int i = backwards ? end - 1 - (n_th - j) : n_th;
          const Edge& other = A.edges[std::size_t(i)];
          if (only_own && i != j) continue;
          if (only_diagonal && i != j) {
            ++target;
            continue;
          }
          const int rows = rows_of_j ? m : A.nodes[std::size_t(other.to)].rows;
          if (advances_before) ++target;
          const int place = targets == Targets::own_edge ? other.at : *target;
          if (targets != Targets::stuck && !advances_before) ++target;
          if (exchanged)
            subtract_product(L, m, number + other.at, rows, n, number + place);
          else
            subtract_product(number + (block_of_j ? edge : other).at, rows,
                             plain_times_plain ? kept : second, m, n, number + place);
        }
        const int all = m * n, part = stored == Stored::row ? n : std::min(n * n, all);
        if (turned == Turned::stored) std::copy(across, across + all, block);
        else if (store == Store::right)
          std::copy(L, L + (stored == Stored::all ? all : part), block);
      }
      if (store == Store::edge_once && end > node.first_edge) {
        const Edge& edge = A.edges[std::size_t(end) - 1];
        std::copy(L, L + A.nodes[std::size_t(edge.to)].rows * n, number + edge.at);
      }
      if (diagonal == When::last) factor_diagonal();
    }
    return A;
  }
};

inline Pieces<FactorReference> wrong_factors() {
  using T = FactorReference;
  const char* const early = "#l-stored-too-early the block has become L before the products are "
                            "subtracted: A_ik is needed there, so store L at last";
  const char* const half = "#half-l-stored not all of L is stored, or more than that: m * n "
                           "numbers";
  const char* const turned = "#block-transposed a block is transposed: each has the rows of edge "
                             "j's node and the columns of node k, and the kernels do the rest";
  return {
      {turned, [](T& t) { t.turned = T::Turned::divided; }},
      {turned, [](T& t) { t.turned = T::Turned::factor; }},
      {turned, [](T& t) { t.turned = T::Turned::stored; }},
      {"#diagonal-not-factored the diagonal block is not factored: factor_block() it first",
       [](T& t) { t.diagonal = T::When::never; }},
      {"#diagonal-factored-last the diagonal block is factored at last: the division needs its "
       "factor",
       [](T& t) { t.diagonal = T::When::last; }},
      {"#nothing-subtracted the products are never subtracted: A_ij -= A_ik L_jk^T, Eq. 9-4",
       [](T& t) { t.from = 1000; }},
      {"#l-not-stored L is not stored: the edge's block becomes L at last",
       [](T& t) { t.store = T::Store::never; }},
      {early, [](T& t) { t.store = T::Store::early; }},
      {"#l-times-l the product of two blocks of L: one of them is the original block, A_ik L_jk^T. "
       "Is L stored before the products are subtracted?",
       [](T& t) { t.store = T::Store::all_early; }},
      {"#only-last-edge-stored L is stored behind the loop over the edges: each edge has its own",
       [](T& t) { t.store = T::Store::edge_once; }},
      {"#targets-not-advanced the target is always the first one: *target++ goes on to the next",
       [](T& t) { t.targets = T::Targets::stuck; }},
      {"#targets-advanced-before the first target is left out: *target++ and not *++target",
       [](T& t) { t.advances_before = true; }},
      {"#targets-per-node-again the targets begin anew with each node: they go on to the end",
       [](T& t) { t.targets = T::Targets::again; }},
      {"#edge-itself it is subtracted from the edge itself: from number[*target++]",
       [](T& t) { t.targets = T::Targets::own_edge; }},
      {"#inner-loop-first-edge the inner loop begins with the node's first edge: from j on, the "
       "rest is symmetric",
       [](T& t) { t.from_first = true; }},
      {"#inner-loop-behind-j the inner loop begins behind j: the product of j with itself goes to "
       "the diagonal block",
       [](T& t) { t.from = 1; }},
      {"only the products of an edge with itself: with every edge from j on",
       [](T& t) { t.only_diagonal = true; }},
      {"#inner-loop-j-alone only the products of an edge with itself: with every edge from j on, "
       "each has its target",
       [](T& t) { t.only_own = true; }},
      {"#only-first-edge only the first edge of each node: all of them",
       [](T& t) { t.only_first = true; }},
      {"#last-edge-left-out the inner loop leaves the last edge out: up to the end, as the outer "
       "one",
       [](T& t) { t.skip_inner = 1; }},
      {"#m-n-exchanged-division rows and columns of the edge's block are exchanged in "
       "divide_rows(): it is m x n, the diagonal block n x n",
       [](T& t) { t.divides_exchanged = true; }},
      {"#rows-j-i the rows of edge j in the place of those of edge i: the block of edge i has its "
       "own number",
       [](T& t) { t.rows_of_j = true; }},
      {"#block-wrong-edge the block of edge j twice: the one of edge i, and L",
       [](T& t) { t.block_of_j = true; }},
      {half, [](T& t) { t.stored = T::Stored::row; }},
      {half, [](T& t) { t.stored = T::Stored::square; }},
      {"#first-node-left-out the first node is left out: from node 0 on",
       [](T& t) { t.first_node = 1; }},
      {"#inner-loop-backwards the inner loop runs backwards: the targets stand there from j to "
       "the last edge",
       [](T& t) { t.backwards = true; }},
      {"#solve-does-nothing nothing is done", [](T& t) { t.skip_nodes = 1000; }},
      {"#not-divided A is not divided by the diagonal block: L = divide_rows() of it",
       [](T& t) { t.divides = false; }},
      {"#a-times-a the product of two blocks of A: one of them is L, A_ik L_jk^T",
       [](T& t) { t.plain_times_plain = true; }},
      {"#product-transposed the product is transposed: A_ik L_jk^T has the rows of i",
       [](T& t) { t.exchanged = true; }},
      {"#last-node-left-out the last node is left out: all nodes but the one behind the last",
       [](T& t) { t.skip_nodes = 1; }},
      {"the last edge of each node is left out: up to first_edge of the next node",
       [](T& t) { t.skip_edges = 1; }}};
}

inline CaseTable<MatrixCase> factor_table() {
  auto table = padded_table<MatrixCase>({"9.2", "the factor L D L^T"}, numbers_of_factor,
                                        factor_names);
  table.cases = matrix_cases();
  table.yours = [](const MatrixCase& c) {
    JointMatrix A = joint_matrix(c);
    factor(A, c.inverse);
    return padded(flat(A), numbers_of_factor);
  };
  table.right = [](const MatrixCase& c) {
    return padded(flat(FactorReference(c).factored()), numbers_of_factor);
  };
  add_pieces(table, [](const MatrixCase& c) { return FactorReference(c); },
             [](const FactorReference& t) {
               return padded(flat(t.factored()), numbers_of_factor);
             },
             wrong_factors());
  tell_where_it_holds(table);
  return table;
}

}  // namespace joints::testing
