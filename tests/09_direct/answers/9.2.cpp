// Known answers of exercise 9.2, each put in the place of the solution's.

// ---- wrong: diagonal not factored
// expects: Likely mistake: the diagonal block is not factored: factor_block() it first
// change: factor_block(D, n, &A.original[std::size_t(node.row)], inverse); ==> (void)inverse;

// ---- wrong: diagonal factored at last
// expects: Likely mistake: the diagonal block is factored at last: the division needs its factor
  Number L[36];
  for (std::size_t k = 0; k + 1 < A.nodes.size(); ++k) {
    const Node& node = A.nodes[k];
    const int n = node.rows, end = A.nodes[k + 1].first_edge;
    Number* const D = number + node.diagonal;
    for (int j = node.first_edge; j < end; ++j) {
      const int m = A.nodes[std::size_t(A.edges[j].to)].rows;
      Number* const block = number + A.edges[j].at;
      divide_rows(block, m, D, n, L);
      for (int i = j; i < end; ++i)
        subtract_product(number + A.edges[i].at, A.nodes[A.edges[i].to].rows, L, m, n,
                         number + *target++);  // Eq. 9-4
  std::copy(L, L + m * n, block); } factor_block(D, n, &A.original[std::size_t(node.row)], inverse);
  }

// ---- wrong: original by the node
// expects: Likely mistake: &A.original[node.row]: by rows of the right-hand side, each node has
// change: std::size_t(node.row) ==> k

// ---- wrong: original of the first row
// expects: Likely mistake: &A.original[node.row]: by rows of the right-hand side, each node has
// change: std::size_t(node.row) ==> 0

// ---- wrong: inverse of its own
// expects: Likely mistake: `inverse` is not asked for this pivot: hand it to factor_block()
// change: node.row)], inverse ==> node.row)], [](double p, double) { return 1 / p; }

// ---- wrong: original of the pivot itself
// expects: Likely mistake: &A.original[node.row]: by rows of the right-hand side, each node has
// change: &A.original[std::size_t(node.row)] ==> D

// ---- wrong: targets not advanced
// expects: Likely mistake: the target is always the first one: *target++ goes on to the next
// change: *target++ ==> *target

// ---- wrong: targets advanced before
// expects: Likely mistake: the first target is left out: *target++ and not *++target
// change: *target++ ==> *++target

// ---- wrong: targets per node again
// expects: Likely mistake: the targets begin anew with each node: they go on to the end
// change: factor_block( ==> target = A.targets.data(); factor_block(

// ---- wrong: from the edge itself
// expects: Likely mistake: it is subtracted from the edge itself: from number[*target++]
// change: number + *target++ ==> number + A.edges[i].at

// ---- wrong: inner loop from the first edge
// expects: Likely mistake: the inner loop begins with the node's first edge: from j on, the rest
// change: int i = j; ==> int i = node.first_edge;

// ---- wrong: inner loop behind j
// expects: Likely mistake: the inner loop begins behind j: the product of j with itself goes to
// change: int i = j; ==> int i = j + 1;

// ---- wrong: inner loop to j alone
// expects: Likely mistake: only the products of an edge with itself: with every edge from j on
// change: i < end; ++i) ==> i <= j; ++i)

// ---- wrong: L not stored
// expects: Likely mistake: L is not stored: the edge's block becomes L at last
// change: std::copy(L, L + m * n, block); ==>

// ---- wrong: L stored too early
// expects: Likely mistake: the block has become L before the products are subtracted: A_ik is
// change: divide_rows(block, m, D, n, L); ==>
//         divide_rows(block, m, D, n, L); std::copy(L, L + m * n, block);

// ---- wrong: divided in place
// expects: Likely mistake: the block has become L before the products are subtracted: A_ik is
// change: divide_rows(block, m, D, n, L); ==>
//         divide_rows(block, m, D, n, block); std::copy(block, block + m * n, L);

// ---- wrong: not divided
// expects: Likely mistake: A is not divided by the diagonal block: L = divide_rows() of it
// change: divide_rows(block, m, D, n, L); ==> std::copy(block, block + m * n, L);

// ---- wrong: m and n exchanged in the division
// expects: Likely mistake: rows and columns of the edge's block are exchanged in divide_rows()
// change: divide_rows(block, m, D, n, L) ==> divide_rows(block, n, D, m, L)

// ---- wrong: A times A
// expects: Likely mistake: the product of two blocks of A: one of them is L, A_ik L_jk^T
// change: subtract_product(number + A.edges[i].at, A.nodes[A.edges[i].to].rows, L, ==>
//         subtract_product(number + A.edges[i].at, A.nodes[A.edges[i].to].rows, block,

// ---- wrong: product transposed
// expects: Likely mistake: the product is transposed: A_ik L_jk^T has the rows of i
// change: subtract_product(number + A.edges[i].at, A.nodes[A.edges[i].to].rows, L, m, n, ==>
//         subtract_product(L, m, number + A.edges[i].at, A.nodes[A.edges[i].to].rows, n,

// ---- wrong: last node left out
// expects: Likely mistake: the last node is left out: all nodes but the one behind the last
// change: k + 1 < A.nodes.size() ==> k + 2 < A.nodes.size()

// ---- wrong: node behind the last too
// expects: an index outside a vector or an array: places run from 0 to size() - 1
// change: k + 1 < A.nodes.size() ==> k < A.nodes.size()

// ---- wrong: last edge left out
// expects: Likely mistake: the inner loop leaves the last edge out: up to the end, as the outer
// change: int i = j; i < end ==> int i = j; i < end - 1

// ---- wrong: only the first edge
// expects: Likely mistake: only the first edge of each node: all of them
// change: j < end; ++j ==> j < end && j == node.first_edge; ++j

// ---- wrong: rows of the node for the edge
// expects: Case: a triangle
// change: const int m = A.nodes[std::size_t(A.edges[j].to)].rows ==> const int m = n

// ---- wrong: rows of j for i
// expects: Likely mistake: the rows of edge j in the place of those of edge i: the block of edge
// change: A.nodes[A.edges[i].to].rows, L ==> m, L

// ---- wrong: edges numbered as nodes
// expects: an index outside a vector or an array: places run from 0 to size() - 1
// change: A.nodes[std::size_t(A.edges[j].to)].rows ==> A.nodes[std::size_t(j)].rows

// ---- wrong: block of the wrong edge
// expects: Likely mistake: the block of edge j twice: the one of edge i, and L
// change: subtract_product(number + A.edges[i].at ==> subtract_product(number + A.edges[j].at

// ---- wrong: only the last edge stored
// expects: Likely mistake: L is stored behind the loop over the edges: each edge has its own
  Number L[36];
  for (std::size_t k = 0; k + 1 < A.nodes.size(); ++k) {
    const Node& node = A.nodes[k];
    const int n = node.rows, end = A.nodes[k + 1].first_edge;
    Number* const D = number + node.diagonal;
    factor_block(D, n, &A.original[std::size_t(node.row)], inverse);
    for (int j = node.first_edge; j < end; ++j) {
      const int m = A.nodes[std::size_t(A.edges[j].to)].rows;
      Number* const block = number + A.edges[j].at;
      divide_rows(block, m, D, n, L);
      for (int i = j; i < end; ++i)
        subtract_product(number + A.edges[i].at, A.nodes[A.edges[i].to].rows, L, m, n,
                         number + *target++);  // Eq. 9-4
  if (j + 1 == end) std::copy(L, L + m * n, block); }
  }

// ---- wrong: half of L stored
// expects: Likely mistake: only a part of L is stored: m * n numbers
// change: std::copy(L, L + m * n, block) ==> std::copy(L, L + n, block)

// ---- wrong: nothing subtracted
// expects: Likely mistake: the products are never subtracted: A_ij -= A_ik L_jk^T, Eq. 9-4
// change: subtract_product( ==> if (false) subtract_product(

// ---- wrong: factor does nothing
// expects: Likely mistake: nothing is done
  (void)number, (void)target, (void)inverse;

// ---- wrong: first node left out
// expects: Likely mistake: the first node is left out: from node 0 on
// change: for (std::size_t k = 0; ==> for (std::size_t k = 1;

// ---- wrong: inner loop backwards
// expects: Likely mistake: the inner loop runs backwards: the targets stand there from j to the
// change: for (int i = j; i < end; ++i) ==> for (int i = end - 1; i >= j; --i)

// ---- wrong: forward without division
// region: 2
// expects: Likely mistake: nothing is divided: each node's numbers by its diagonal block, on the
// change: divide(number + node.diagonal, node.rows, x + node.row); ==>

// ---- wrong: divided before the edges
// region: 2
// expects: Likely mistake: divided before its edges are gone through: they take the numbers as
  const int count = int(A.nodes.size()) - 1;
  for (int k = 0; k < count; ++k) {
    const Node& node = A.nodes[k];
  divide(number + node.diagonal, node.rows, x + node.row); for (int j = node.first_edge;
      j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_times(number + A.edges[j].at, to.rows, node.rows, x + node.row, x + to.row); }
  }
  for (int k = count - 1; k >= 0; --k) {
    const Node& node = A.nodes[k];
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_transposed_times(number + A.edges[j].at, to.rows, node.rows, x + to.row,
                                x + node.row);  // Eq. 9-5
    }
  }

// ---- wrong: divided both ways
// region: 2
// expects: Likely mistake: divided on the way forward and on the way back: once
  const int count = int(A.nodes.size()) - 1;
  for (int k = 0; k < count; ++k) {
    const Node& node = A.nodes[k];
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_times(number + A.edges[j].at, to.rows, node.rows, x + node.row, x + to.row);
    }
    divide(number + node.diagonal, node.rows, x + node.row);
  }
  for (int k = count - 1; k >= 0; --k) { const Node& node = A.nodes[k];
      divide(number + node.diagonal, node.rows, x + node.row);
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_transposed_times(number + A.edges[j].at, to.rows, node.rows, x + to.row,
                                x + node.row);  // Eq. 9-5
    }
  }

// ---- wrong: back in forward order
// region: 2
// expects: Likely mistake: back in the order of elimination: from the last node to the first
// change: int k = count - 1; k >= 0; --k ==> int k = 0; k < count; ++k

// ---- wrong: forward from the last
// region: 2
// expects: Likely mistake: the way forward begins with the last node: forward in the order of
// change: int k = 0; k < count; ++k ==> int k = count - 1; k >= 0; --k

// ---- wrong: no way back
// region: 2
// expects: Likely mistake: the way back is missing: subtract L^T x of each edge from the node's
// change: int k = count - 1; k >= 0; --k ==> int k = -1; k >= 0; --k

// ---- wrong: no way forward
// region: 2
// expects: Likely mistake: the way forward is missing: subtract L x of each edge from the other
// change: subtract_times( ==> if (false) subtract_times(

// ---- wrong: back not transposed
// region: 2
// expects: Likely mistake: the way back goes like the way forward: there the other node's numbers
  const int count = int(A.nodes.size()) - 1;
  for (int k = 0; k < count; ++k) {
    const Node& node = A.nodes[k];
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_times(number + A.edges[j].at, to.rows, node.rows, x + node.row, x + to.row);
    }
    divide(number + node.diagonal, node.rows, x + node.row);
  }
  for (int k = count - 1; k >= 0; --k) {
    const Node& node = A.nodes[k];
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_times(number + A.edges[j].at, to.rows, node.rows, x + node.row, x + to.row);
           // Eq. 9-5
    }
  }

// ---- wrong: forward transposed
// region: 2
// expects: Likely mistake: the way forward goes like the way back: there L of the node's own
// change: subtract_times(number + A.edges[j].at, to.rows, node.rows, x + node.row, x + to.row) ==>
//         subtract_transposed_times(number + A.edges[j].at, to.rows, node.rows, x + to.row, x +
//         node.row)

// ---- wrong: back with the ends exchanged
// region: 2
// expects: Likely mistake: x and y are exchanged on the way back: L^T of the other node's numbers
  const int count = int(A.nodes.size()) - 1;
  for (int k = 0; k < count; ++k) {
    const Node& node = A.nodes[k];
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_times(number + A.edges[j].at, to.rows, node.rows, x + node.row, x + to.row);
    }
    divide(number + node.diagonal, node.rows, x + node.row);
  }
  for (int k = count - 1; k >= 0; --k) {
    const Node& node = A.nodes[k];
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_transposed_times(number + A.edges[j].at, to.rows, node.rows, x + node.row, x +
          to.row);  // Eq. 9-5
    }
  }

// ---- wrong: rows exchanged on the way forward
// region: 2
// expects: Likely mistake: rows and columns of the edge's block are exchanged on the way forward
// change: to.rows, node.rows, x + node.row, x + to.row ==>
//         node.rows, to.rows, x + node.row, x + to.row

// ---- wrong: number of the node for its row
// region: 2
// expects: Likely mistake: the node's number in the place of its row on the way forward: its
// change: x + node.row, x + to.row ==> x + k, x + A.edges[j].to

// ---- wrong: last node left out of the solution
// region: 2
// expects: Likely mistake: the last node is left out: it has no edges, but it must be divided
// change: int count = int(A.nodes.size()) - 1 ==> int count = int(A.nodes.size()) - 2

// ---- wrong: first node left out on the way back
// region: 2
// expects: Likely mistake: the way back leaves the first node out: k >= 0
// change: k >= 0 ==> k > 0

// ---- wrong: divided by the place of the row
// region: 2
// expects: Case: three scalar rows of a chain
// change: number + node.diagonal, ==> number + node.row,

// ---- wrong: only the first edge forward
// region: 2
// expects: Likely mistake: only the first edge of each node on the way forward: all of them
// change: for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) { ==>
//         for (int j = node.first_edge; j < A.nodes[k + 1].first_edge && j == node.first_edge; ++j)
//         {

// ---- wrong: edges of all nodes
// region: 2
// expects: Likely mistake: the edges of other nodes, too: from the node's first_edge on
// change: for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) { ==>
//         for (int j = 0; j < A.nodes[k + 1].first_edge; ++j) {

// ---- wrong: divided once for each edge
// region: 2
// expects: Likely mistake: divided once for each edge: once for each node, after its edges
  const int count = int(A.nodes.size()) - 1;
  for (int k = 0; k < count; ++k) {
    const Node& node = A.nodes[k];
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_times(number + A.edges[j].at, to.rows, node.rows, x + node.row, x + to.row);
          divide(number + node.diagonal, node.rows, x + node.row); }
  }
  for (int k = count - 1; k >= 0; --k) {
    const Node& node = A.nodes[k];
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_transposed_times(number + A.edges[j].at, to.rows, node.rows, x + to.row,
                                x + node.row);  // Eq. 9-5
    }
  }

// ---- wrong: solve does nothing
// region: 2
// expects: Likely mistake: nothing is done
  (void)A, (void)x, (void)number;

// ---- right: lower edges found by hand
// change: int i = j; i < end; ++i) ==> int i = j; i != end; i += 1)

// ---- right: a copy of the block
  for (std::size_t k = 0; k + 1 < A.nodes.size(); ++k) {
    const Node& node = A.nodes[k];
    const int n = node.rows, end = A.nodes[k + 1].first_edge;
    Number* const D = number + node.diagonal;
    factor_block(D, n, &A.original[std::size_t(node.row)], inverse);
    std::vector<std::vector<Number>> L(std::size_t(end - node.first_edge));
    for (int j = node.first_edge; j < end; ++j) {
      const int m = A.nodes[std::size_t(A.edges[j].to)].rows;
      std::vector<Number>& own = L[std::size_t(j - node.first_edge)];
      own.resize(std::size_t(m * n));
      divide_rows(number + A.edges[j].at, m, D, n, own.data());
      for (int i = j; i < end; ++i)
        subtract_product(number + A.edges[i].at, A.nodes[A.edges[i].to].rows, own.data(), m, n,
                         number + *target++);
    }
    for (int j = node.first_edge; j < end; ++j) {
      const std::vector<Number>& own = L[std::size_t(j - node.first_edge)];
      std::copy(own.begin(), own.end(), number + A.edges[j].at);
    }
  }

// ---- right: divided on the way back
// region: 2
  const int count = int(A.nodes.size()) - 1;
  for (int k = 0; k < count; ++k) {
    const Node& node = A.nodes[k];
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_times(number + A.edges[j].at, to.rows, node.rows, x + node.row, x + to.row);
    }
  }
  for (int k = count - 1; k >= 0; --k) { const Node& node = A.nodes[k];
      divide(number + node.diagonal, node.rows, x + node.row);
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_transposed_times(number + A.edges[j].at, to.rows, node.rows, x + to.row,
                                x + node.row);  // Eq. 9-5
    }
  }

// ---- right: edges from the last
// region: 2
// change: for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) { ==>
//         for (int j = A.nodes[k + 1].first_edge; j-- > node.first_edge;) {

// ---- right: division in a loop of its own
// region: 2
  const int count = int(A.nodes.size()) - 1;
  for (int k = 0; k < count; ++k) {
    const Node& node = A.nodes[k];
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_times(number + A.edges[j].at, to.rows, node.rows, x + node.row, x + to.row);
    }
  }
  for (int k = 0; k < count;
      ++k) divide(number + A.nodes[k].diagonal, A.nodes[k].rows, x + A.nodes[k].row);
      for (int k = count - 1; k >= 0; --k) {
    const Node& node = A.nodes[k];
    for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
      const Node& to = A.nodes[A.edges[j].to];
      subtract_transposed_times(number + A.edges[j].at, to.rows, node.rows, x + to.row,
                                x + node.row);  // Eq. 9-5
    }
  }
