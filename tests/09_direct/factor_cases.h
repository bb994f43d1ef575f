// Exercise 9.2: the factor and what is solved with it as tables, with the usual mistakes.
#pragma once

#include "chapters/09_direct/block_kernels.h"
#include "tests/09_direct/matrix_cases.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

// ---- the factor ---------------------------------------------------------------------------------

/// The steps of the factorisation, each of which a mistake may change.
struct FactorReference {
  MatrixCase c;
  enum class When { never, first, right, last } diagonal = When::right;
  enum class Store { never, early, right, edge_once } store = Store::right;
  enum class Targets { forward, stuck, again, own_edge } targets = Targets::forward;
  enum class Original { own, by_node, first } original = Original::own;
  int skip_nodes = 0, skip_edges = 0, from = 0;  ///< from: the inner loop begins at j + from
  bool from_first = false, only_diagonal = false, divides = true, plain = false, exchanged = false;
  bool plain_times_plain = false, divides_exchanged = false, rows_of_j = false, block_of_j = false;
  bool only_own = false, only_first = false, stores_a_row = false, advances_before = false;
  int skip_inner = 0;

  explicit FactorReference(const MatrixCase& c) : c(c) {}

  JointMatrix factored() const {
    JointMatrix A = joint_matrix(c);
    double* const number = A.numbers.data();
    const int* target = A.targets.data();
    double L[36], kept[36];
    for (int k = 0; k < c.count() - skip_nodes; ++k) {
      const Node& node = A.nodes[std::size_t(k)];
      const int n = node.rows, end = A.nodes[std::size_t(k) + 1].first_edge - skip_edges;
      double* const D = number + node.diagonal;
      const auto factor_diagonal = [&] {
        const std::size_t at = std::size_t(original == Original::own       ? node.row
                                           : original == Original::by_node ? k
                                                                           : 0);
        factor_block(D, n, &A.original[at],
                     plain ? [](double p, double) { return 1 / p; } : c.inverse);
      };
      if (diagonal == When::right) factor_diagonal();
      if (targets == Targets::again) target = A.targets.data();
      for (int j = node.first_edge; j < (only_first ? std::min(node.first_edge + 1, end) : end);
           ++j) {
        const Edge& edge = A.edges[std::size_t(j)];
        const int m = A.nodes[std::size_t(edge.to)].rows;
        double* const block = number + edge.at;
        if (divides_exchanged) divide_rows(block, n, D, m, L);
        else if (divides) divide_rows(block, m, D, n, L);
        else std::copy(block, block + m * n, L);
        std::copy(block, block + m * n, kept);
        if (store == Store::early) std::copy(L, L + m * n, block);
        for (int i = from_first ? node.first_edge : j + from; i < end - skip_inner; ++i) {
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
            subtract_product(number + (block_of_j ? edge : other).at, rows, plain_times_plain ? kept : L, m, n,
                             number + place);
        }
        if (store == Store::right) std::copy(L, L + (stores_a_row ? n : m * n), block);
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
      for (int j = 0; j <= i; ++j) name("node " + std::to_string(k), i, j);
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

inline Pieces<FactorReference> wrong_factors() {
  using T = FactorReference;
  const char* const early = "the block has become L before the products are subtracted: A_ik is "
                            "needed there, so store L at last";
  return {
      {"the diagonal block is not factored: factor_block() it first",
       [](T& t) { t.diagonal = T::When::never; }},
      {"the diagonal block is factored at last: the division needs its factor",
       [](T& t) { t.diagonal = T::When::last; }},
      {"the products are never subtracted: A_ij -= A_ik L_jk^T, Eq. 9-4",
       [](T& t) { t.from = 1000; }},
      {"L is not stored: the edge's block becomes L at last",
       [](T& t) { t.store = T::Store::never; }},
      {early, [](T& t) { t.store = T::Store::early; }},
      {"L is stored behind the loop over the edges: each edge has its own",
       [](T& t) { t.store = T::Store::edge_once; }},
      {"the target is always the first one: *target++ goes on to the next",
       [](T& t) { t.targets = T::Targets::stuck; }},
      {"the first target is left out: *target++ and not *++target",
       [](T& t) { t.advances_before = true; }},
      {"the targets begin anew with each node: they go on to the end",
       [](T& t) { t.targets = T::Targets::again; }},
      {"it is subtracted from the edge itself: from number[*target++]",
       [](T& t) { t.targets = T::Targets::own_edge; }},
      {"the inner loop begins with the node's first edge: from j on, the rest is symmetric",
       [](T& t) { t.from_first = true; }},
      {"the inner loop begins behind j: the product of j with itself goes to the diagonal block",
       [](T& t) { t.from = 1; }},
      {"only the products of an edge with itself: with every edge from j on",
       [](T& t) { t.only_diagonal = true; }},
      {"only the products of an edge with itself: with every edge from j on, each has its target",
       [](T& t) { t.only_own = true; }},
      {"only the first edge of each node: all of them", [](T& t) { t.only_first = true; }},
      {"the inner loop leaves the last edge out: up to the end, as the outer one",
       [](T& t) { t.skip_inner = 1; }},
      {"rows and columns of the edge's block are exchanged in divide_rows(): it is m x n, the "
       "diagonal block n x n",
       [](T& t) { t.divides_exchanged = true; }},
      {"the rows of edge j in the place of those of edge i: the block of edge i has its own number",
       [](T& t) { t.rows_of_j = true; }},
      {"the block of edge j twice: the one of edge i, and L",
       [](T& t) { t.block_of_j = true; }},
      {"only a part of L is stored: m * n numbers", [](T& t) { t.stores_a_row = true; }},
      {"nothing is done", [](T& t) { t.skip_nodes = 1000; }},
      {"A is not divided by the diagonal block: L = divide_rows() of it",
       [](T& t) { t.divides = false; }},
      {"the product of two blocks of A: one of them is L, A_ik L_jk^T",
       [](T& t) { t.plain_times_plain = true; }},
      {"the product is transposed: A_ik L_jk^T has the rows of i",
       [](T& t) { t.exchanged = true; }},
      {"the last node is left out: all nodes but the one behind the last",
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
    return padded(flat(dense_factor(c)), numbers_of_factor);
  };
  add_pieces(table, [](const MatrixCase& c) { return FactorReference(c); },
             [](const FactorReference& t) {
               return padded(flat(t.factored()), numbers_of_factor);
             },
             wrong_factors());
  tell_where_it_holds(table);
  return table;
}

// ---- solving with it ----------------------------------------------------------------------------

/// Right-hand sides: a row each.
inline std::vector<Numbers> right_sides(const MatrixCase& c) {
  Random random(92);
  std::vector<Numbers> out(3, Numbers(std::size_t(c.size()), 0));
  if (c.size() > 0) out[0][0] = 4;
  for (std::size_t k = 1; k < 3; ++k)
    for (double& b : out[k]) b = double(random.uniform(-3, 3));
  return out;
}

/// The steps of solving, each of which a mistake may change.
struct SolveReference {
  MatrixCase c;
  bool forward = true, back = true, back_in_order = false;
  bool forward_transposed = false, back_plain = false;
  int divides = 1, skip_nodes = 0, skip_edges = 0;
  enum class Divide { after, before, at_last } divide_when = Divide::after;
  bool by_node = false;  ///< x is asked by node's number
  bool forward_from_last = false, back_exchanged = false, first_edge = false, by_edge = false;
  bool all_edges = false, forward_by_node = false, rows_exchanged = false;
  int back_to = 0;

  explicit SolveReference(const MatrixCase& c) : c(c) {}

  Numbers solved(Numbers b) const {
    const JointMatrix A = dense_factor(c);
    b.resize(b.size() + 8, 0);
    double* const x = b.data();
    const double* const number = A.numbers.data();
    const auto at = [&](int k) { return x + (by_node ? k : A.nodes[std::size_t(k)].row); };
    const auto each_edge = [&](int k, bool forwards, auto what) {
      const Node& node = A.nodes[std::size_t(k)];
      const int end = A.nodes[std::size_t(k) + 1].first_edge - skip_edges;
      for (int e = all_edges && forwards ? 0 : node.first_edge; e < end; ++e) {
        const Edge& edge = A.edges[std::size_t(e)];
        what(node, A.nodes[std::size_t(edge.to)], number + edge.at, at(edge.to), edge.to);
      }
    };
    const auto divide_own = [&](int k) {
      const Node& node = A.nodes[std::size_t(k)];
      for (int n = 0; n < divides; ++n) divide(number + node.diagonal, node.rows, at(k));
    };
    const int count = c.count() - skip_nodes;
    for (int n = 0; n < count; ++n) {
      const int k = forward_from_last ? count - 1 - n : n;
      bool first = true;
      if (divide_when == Divide::before) divide_own(k);
      each_edge(k, true, [&](const Node& node, const Node& to, const double* L, double* other,
                             int number_of) {
        double* const own = forward_by_node ? x + k : at(k);
        if (forward_by_node) other = x + number_of;
        if (forward && (first || !first_edge)) {
          if (forward_transposed) subtract_transposed_times(L, to.rows, node.rows, other, at(k));
          else if (rows_exchanged) subtract_times(L, node.rows, to.rows, own, other);
          else subtract_times(L, to.rows, node.rows, own, other);
        }
        first = false;
        if (by_edge) divide_own(k);
      });
      if (divide_when == Divide::after && !by_edge) divide_own(k);
    }
    for (int n = 0; n < count; ++n) {
      const int k = back_in_order ? n : count - 1 - n;
      each_edge(k, false, [&](const Node& node, const Node& to, const double* L, double* other,
                              int) {
        if (!back || k < back_to) return;
        if (back_exchanged) subtract_transposed_times(L, to.rows, node.rows, at(k), other);
        else if (back_plain) subtract_times(L, to.rows, node.rows, at(k), other);
        else subtract_transposed_times(L, to.rows, node.rows, other, at(k));
      });
      if (divide_when == Divide::at_last) divide_own(k);
    }
    b.resize(b.size() - 8);
    return b;
  }
};

inline Pieces<SolveReference> wrong_solves() {
  using T = SolveReference;
  return {
      {"nothing is divided: each node's numbers by its diagonal block, on the way forward",
       [](T& t) { t.divides = 0; }},
      {"divided on the way forward and on the way back: once",
       [](T& t) { t.divides = 2; }},
      {"divided before its edges are gone through: they take the numbers as they are, undivided",
       [](T& t) { t.divide_when = T::Divide::before; }},
      {"divided behind the way back: on the way forward, after the node's edges",
       [](T& t) { t.divide_when = T::Divide::at_last; }},
      {"the way forward is missing: subtract L x of each edge from the other node's numbers",
       [](T& t) { t.forward = false; }},
      {"the way back is missing: subtract L^T x of each edge from the node's own numbers",
       [](T& t) { t.back = false; }},
      {"back in the order of elimination: from the last node to the first",
       [](T& t) { t.back_in_order = true; }},
      {"the way back goes like the way forward: there the other node's numbers are multiplied by "
       "L^T and taken from the node's own",
       [](T& t) { t.back_plain = true; }},
      {"the way forward begins with the last node: forward in the order of elimination",
       [](T& t) { t.forward_from_last = true; }},
      {"the way forward goes like the way back: there L of the node's own numbers is taken from "
       "the other node's",
       [](T& t) { t.forward_transposed = true; }},
      {"x and y are exchanged on the way back: L^T of the other node's numbers is taken from the "
       "node's own",
       [](T& t) { t.back_exchanged = true; }},
      {"the way back leaves the first node out: k >= 0",
       [](T& t) { t.back_to = 1; }},
      {"only the first edge of each node on the way forward: all of them",
       [](T& t) { t.first_edge = true; }},
      {"divided once for each edge: once for each node, after its edges",
       [](T& t) { t.by_edge = true; }},
      {"the edges of other nodes, too: from the node's first_edge on",
       [](T& t) { t.all_edges = true; }},
      {"nothing is done", [](T& t) { t.forward = t.back = false, t.divides = 0; }},
      {"the last node is left out: it has no edges, but it must be divided",
       [](T& t) { t.skip_nodes = 1; }},
      {"the last edge of each node is left out: up to first_edge of the next node",
       [](T& t) { t.skip_edges = 1; }},
      {"the node's number in the place of its row: its numbers begin at x + node.row",
       [](T& t) { t.by_node = true; }},
      {"the node's number in the place of its row on the way forward: its numbers begin at x + "
       "node.row",
       [](T& t) { t.forward_by_node = true; }},
      {"rows and columns of the edge's block are exchanged on the way forward: it has the rows of "
       "the other node",
       [](T& t) { t.rows_exchanged = true; }}};
}

inline constexpr std::size_t numbers_of_solve = 72;

inline CaseTable<MatrixCase> solve_table() {
  auto table = padded_table<MatrixCase>(
      {"9.2", "the solution x with the factor", 2}, numbers_of_solve, [](const MatrixCase& c) {
        std::vector<std::string> out;
        for (int k = 1; k <= 3; ++k)
          for (int i = 0; i < c.size(); ++i)
            out.push_back("x[" + std::to_string(i) + "] of right side " + std::to_string(k) +
                          ", node " + std::to_string(node_of(c, i)));
        return out;
      });
  const auto all = [](const MatrixCase& c, auto solved) {
    Numbers out;
    for (const Numbers& b : right_sides(c)) {
      const Numbers x = solved(b);
      out.insert(out.end(), x.begin(), x.end());
    }
    return padded(out, numbers_of_solve);
  };
  table.cases = matrix_cases();
  table.yours = [=](const MatrixCase& c) {
    const JointMatrix A = dense_factor(c);
    return all(c, [&](Numbers x) {
      x.resize(x.size() + 8, 0);
      solve(A, x.data());
      x.resize(x.size() - 8);
      return x;
    });
  };
  table.right = [=](const MatrixCase& c) {
    return all(c, [&](const Numbers& b) { return gauss(c.A, b); });
  };
  add_pieces(table, [](const MatrixCase& c) { return SolveReference(c); },
             [=](const SolveReference& t) {
               return all(t.c, [&](const Numbers& b) { return t.solved(b); });
             },
             wrong_solves());
  tell_where_it_holds(table);
  return table;
}

// ---- both together ------------------------------------------------------------------------------

inline constexpr Subject whole_subject{"9.2", "the solution x with your own factor", 1};

/// The original entries that came with the pivots, in the order of elimination.
inline Numbers pivots_seen;

inline void check_originals(const MatrixCase& c, const Numbers& seen) {
  std::size_t n = 0;
  for (int k = 0; k < c.count(); ++k)
    for (int i = 0; i < c.rows[std::size_t(k)]; ++i, ++n) {
      const int row = c.first(k) + i;
      const double yours = n < seen.size() ? seen[n] : 0;
      expect({"9.2", "what comes with a pivot"},
             "original entry of row " + std::to_string(row) + ", node " + std::to_string(k) +
                 ", " + c.words,
             yours, c.A(row, row), 0,
             {{yours, n >= seen.size()
                          ? "`inverse` is not asked for this pivot: hand it to factor_block()"
                          : "&A.original[node.row]: by rows of the right-hand side, each node has "
                            "its own"}});
    }
}

/// The solution where the dropped row's x is 0 and its equation is left out.
inline Numbers without_dropped(const MatrixCase& c, const Numbers& b) {
  const int gone = c.dropped[0];
  Dense A = c.A;
  Numbers right = b;
  for (int i = 0; i < c.size(); ++i) A(gone, i) = A(i, gone) = 0;
  A(gone, gone) = 1;
  right[std::size_t(gone)] = 0;
  return gauss(A, right);
}

}  // namespace joints::testing
