// Exercise 9.2: what is solved with the factor as a table, with the usual mistakes.
#pragma once

#include "chapters/09_direct/block_kernels.h"
#include "tests/09_direct/factor_cases.h"
#include "tests/checker/pieces.h"

namespace joints::testing {

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
  enum class Untransposed { no, rows_as_they_are, rows_exchanged } back_as = Untransposed::no;
  int divides = 1, skip_nodes = 0, skip_edges = 0;
  enum class Divide { after, before, at_last } divide_when = Divide::after;
  bool by_node = false;  ///< x is asked by node's number
  bool forward_from_last = false, back_exchanged = false, first_edge = false, by_edge = false;
  bool all_edges = false, forward_by_node = false, rows_exchanged = false, last_edge_back = false;
  int back_to = 0;

  explicit SolveReference(const MatrixCase& c) : c(c) {}

  Numbers solved(Numbers b) const {
    const JointMatrix A = FactorReference(c).factored();
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
      for (int n = 0; n < divides; ++n) divide(&number[node.diagonal], node.rows, at(k));
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
      int left = A.nodes[std::size_t(k) + 1].first_edge - A.nodes[std::size_t(k)].first_edge;
      each_edge(k, false, [&](const Node& node, const Node& to, const double* L, double* other,
                              int) {
        if (!back || k < back_to || (last_edge_back && --left > 0)) return;
        if (back_exchanged) subtract_transposed_times(L, to.rows, node.rows, at(k), other);
        else if (back_as == Untransposed::rows_as_they_are)
          subtract_times(L, to.rows, node.rows, other, at(k));
        else if (back_as == Untransposed::rows_exchanged)
          subtract_times(L, node.rows, to.rows, other, at(k));
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
  const char* const untransposed =
      "#back-untransposed the transpose is forgotten on the way back: L^T of the other node's "
      "numbers, which is subtract_transposed_times()";
  return {
      {"#forward-without-division nothing is divided: each node's numbers by its diagonal block, "
       "on the way forward",
       [](T& t) { t.divides = 0; }},
      {"#divided-both-ways divided on the way forward and on the way back: once",
       [](T& t) { t.divides = 2; }},
      {"#divided-before-edges divided before its edges are gone through: they take the numbers as "
       "they are, undivided",
       [](T& t) { t.divide_when = T::Divide::before; }},
      {"divided behind the way back: on the way forward, after the node's edges",
       [](T& t) { t.divide_when = T::Divide::at_last; }},
      {"#no-way-forward the way forward is missing: subtract L x of each edge from the other "
       "node's numbers",
       [](T& t) { t.forward = false; }},
      {"#no-way-back the way back is missing: subtract L^T x of each edge from the node's own "
       "numbers",
       [](T& t) { t.back = false; }},
      {"#back-forward-order back in the order of elimination: from the last node to the first",
       [](T& t) { t.back_in_order = true; }},
      {"#back-not-transposed the way back goes like the way forward: there the other node's "
       "numbers are multiplied by L^T and taken from the node's own",
       [](T& t) { t.back_plain = true; }},
      {untransposed, [](T& t) { t.back_as = T::Untransposed::rows_as_they_are; }},
      {untransposed, [](T& t) { t.back_as = T::Untransposed::rows_exchanged; }},
      {"#forward-last the way forward begins with the last node: forward in the order of "
       "elimination",
       [](T& t) { t.forward_from_last = true; }},
      {"#forward-transposed the way forward goes like the way back: there L of the node's own "
       "numbers is taken from the other node's",
       [](T& t) { t.forward_transposed = true; }},
      {"#back-ends-exchanged x and y are exchanged on the way back: L^T of the other node's "
       "numbers is taken from the node's own",
       [](T& t) { t.back_exchanged = true; }},
      {"#first-node-left-out-way the way back leaves the first node out: k >= 0",
       [](T& t) { t.back_to = 1; }},
      {"#only-first-edge-forward only the first edge of each node on the way forward: all of them",
       [](T& t) { t.first_edge = true; }},
      {"only the last edge of each node on the way back: all of them",
       [](T& t) { t.last_edge_back = true; }},
      {"#divided-once-each-edge divided once for each edge: once for each node, after its edges",
       [](T& t) { t.by_edge = true; }},
      {"#edges-all-nodes the edges of other nodes, too: from the node's first_edge on",
       [](T& t) { t.all_edges = true; }},
      {"#solve-does-nothing nothing is done",
       [](T& t) { t.forward = t.back = false, t.divides = 0; }},
      {"#last-node-left-out-solution the last node is left out: it has no edges, but it must be "
       "divided",
       [](T& t) { t.skip_nodes = 1; }},
      {"the last edge of each node is left out: up to first_edge of the next node",
       [](T& t) { t.skip_edges = 1; }},
      {"the node's number in the place of its row: its numbers begin at x + node.row",
       [](T& t) { t.by_node = true; }},
      {"#number-node-row the node's number in the place of its row on the way forward: its "
       "numbers begin at x + node.row",
       [](T& t) { t.forward_by_node = true; }},
      {"#rows-exchanged-way-forward rows and columns of the edge's block are exchanged on the way "
       "forward: it has the rows of the other node",
       [](T& t) { t.rows_exchanged = true; }}};
}

inline constexpr std::size_t numbers_of_solve = 72;

inline CaseTable<MatrixCase> solve_table() {
  auto table = padded_table<MatrixCase>(
      {"9.2", "the solution x with the factor", 2}, numbers_of_solve, [](const MatrixCase& c) {
        std::vector<std::string> out;
        for (int k = 1; k <= 3; ++k)
          for (int i = 0; i < c.size(); ++i)
            out.push_back("x[" + std::to_string(i) + "] for b " + std::to_string(k) + ", node " +
                          std::to_string(node_of(c, i)));
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
    const JointMatrix A = FactorReference(c).factored();
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

inline void check_originals(const MatrixCase& c) {
  pivots_seen.clear();
  JointMatrix A = joint_matrix(c);
  factor(A, [](double pivot, double original) {
    pivots_seen.push_back(original);
    return pivot > 1e-9 * original ? 1 / pivot : 0;
  });
  const Numbers& seen = pivots_seen;
  std::size_t n = 0;
  const std::string given = "Matrix: " + c.words + ".";
  const Subject about{"9.2", "the original entry that comes with a pivot", 1, given.c_str()};
  for (int k = 0; k < c.count(); ++k)
    for (int i = 0; i < c.rows[std::size_t(k)]; ++i, ++n) {
      const int row = c.first(k) + i;
      const double yours = n < seen.size() ? seen[n] : 0;
      expect(about,
             "entry of row " + std::to_string(row) + ", node " + std::to_string(k),
             yours, c.A(row, row), 0,
             {{yours, n >= seen.size()
                          ? "#inverse-own `inverse` is not called for this pivot: pass it to "
                            "factor_block()"
                          : "the entry before any product was subtracted: &A.original[node.row], "
                            "each node has its own"}});
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

/// factor() and solve() after one another.
inline void check_whole(const MatrixCase& c, const Numbers& b, const Numbers& right) {
  JointMatrix A = joint_matrix(c);
  factor(A, c.inverse);
  Numbers x = b;
  solve(A, x.data());
  const std::string given = "Matrix: " + c.words + ".";
  Subject about = whole_subject;
  about.given = given.c_str();
  for (std::size_t i = 0; i < x.size(); ++i)
    expect(about, "x[" + std::to_string(i) + "]", x[i], right[i],
           1e-8 * (1 + std::abs(right[i])));
}

}  // namespace joints::testing
