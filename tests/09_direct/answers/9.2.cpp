// mistake "a block is transposed: each has the rows of edge j's node and the columns of node k, and
//         the kernels do the rest": std::copy(L, L + m * n, block); ==> for (int a = 0; a < m; ++a)
//         for (int b = 0; b < n; ++b) block[b * m + a] = L[a * n + b];
// mistake "a block is transposed: each has the rows of edge j's node and the columns of node k, and
//         the kernels do the rest": for (int i ==> double T[36]; for (int a = 0; a < m; ++a) for
//         (int b = 0; b < n; ++b) T[b * m + a] = L[a * n + b]; for (int i ;; L, ==> T,
// mistake "a block is transposed: each has the rows of edge j's node and the columns of node k, and
//         the kernels do the rest": divide_rows(block, ==> double T[36]; for (int a = 0; a < m;
//         ++a) for (int b = 0; b < n; ++b) T[b * m + a] = block[a * n + b]; divide_rows(T,
// wrong never-set: std::copy(L, L + m * n, block) ==> std::copy(L, L + m * m, block)
// wrong drawn-stops: k + 1 < A.nodes.size() ==> k + 1 < A.nodes.size() && k < 16
// mistake "not all of L is stored, or more than that: m * n numbers": std::copy(L, L + m * n,
//         block) ==> std::copy(L, L + std::min(n * n, m * n), block)
// mistake "the diagonal block is not factored: factor_block() it first": factor_block(D, n,
//         &A.original[std::size_t(node.row)], inverse); ==> (void)inverse;
// mistake "the diagonal block is factored at last: the division needs its factor": ;
//         factor_block(D, n, &A.original[std::size_t(node.row)], inverse) ==> ;; block); } ==>
//         block); } factor_block(D, n, &A.original[std::size_t(node.row)], inverse);
// wrong "the entry before any product was subtracted: &A.original[node.row]": std::size_t(node.row)
//         ==> k
// wrong inverse-own: inverse ==> [](double p, double) { return 1 / p; }
// mistake "the target is always the first one: *target++ goes on to the next": target++ ==> target
// mistake "the first target is left out: *target++ and not *++target": *target++ ==> *++target
// mistake "the targets begin anew with each node: they go on to the end": diagonal ==> diagonal;
//         target = A.targets.data()
// mistake "it is subtracted from the edge itself: from number[*target++]": number + *target++ ==>
//         number + A.edges[i].at
// mistake "the inner loop begins with the node's first edge: from j on, the rest is symmetric": int
//         i = j; ==> int i = node.first_edge;
// mistake "the inner loop begins behind j: the product of j with itself goes to the diagonal
//         block": int i = j; ==> int i = j + 1;
// mistake "only the products of an edge with itself: with every edge from j on, each has its
//         target": i < end ==> i <= j
// mistake "L is not stored: the edge's block becomes L at last": std::copy(L, L + m * n, block);
//         ==>
// mistake "the block has become L before the products are subtracted: A_ik is needed there, so
//         store L at last": L) ==> L); std::copy(L, L + m * n, block)
// mistake "the product of two blocks of L: one of them is the original block, A_ik L_jk^T. Is L
//         stored before the products are subtracted?": j) ==> j) divide_rows(number +
//         A.edges[j].at, A.nodes[A.edges[j].to].rows, D, n, number + A.edges[j].at); for (int j =
//         node.first_edge; j < end; ++j) ;; divide_rows(block, m, D, ==> std::copy(block, block + m
//         *
// mistake "A is not divided by the diagonal block: L = divide_rows() of it": divide_rows(block, m,
//         D, n, L); ==> std::copy(block, block + m * n, L);
// mistake "rows and columns of the edge's block are exchanged in divide_rows(): it is m x n, the
//         diagonal block n x n": divide_rows(block, m, D, n, L) ==> divide_rows(block, n, D, m, L)
// mistake "the product of two blocks of A: one of them is L, A_ik L_jk^T": L, m ==> block, m
// mistake "the product is transposed: A_ik L_jk^T has the rows of i": L, m, n ==> n ;; (number ==>
//         (L, m, number
// mistake "the last node is left out: all nodes but the one behind the last": 1 ==> 2
// wrong "an index outside a vector or an array: places run from 0 to size() - 1": + 1 ==>
// mistake "the inner loop leaves the last edge out: up to the end, as the outer one": int i = j; i
//         < end ==> int i = j; i < end - 1
// mistake "only the first edge of each node: all of them": end; ==> end && j == node.first_edge;
// wrong "Case: a triangle": A.nodes[std::size_t(A.edges[j].to)].rows ==> n
// mistake "the rows of edge j in the place of those of edge i: the block of edge i has its own
//         number": A.nodes[A.edges[i].to].rows, L ==> m, L
// wrong "an index outside a vector or an array: places run from 0 to size() - 1":
//         A.nodes[std::size_t(A.edges[j].to)].rows ==> A.nodes[std::size_t(j)].rows
// mistake "the block of edge j twice: the one of edge i, and L": [i] ==> [j]
// mistake "L is stored behind the loop over the edges: each edge has its own": std::copy ==> if (j
//         + 1 == end) std::copy
// mistake "not all of L is stored, or more than that: m * n numbers": m * ==>
// mistake "the products are never subtracted: A_ij -= A_ik L_jk^T, Eq. 9-4": subtract_product ==>
//         if (false) subtract_product
// mistake "nothing is done":
  (void)number, (void)target, (void)inverse;
// mistake "the first node is left out: from node 0 on": 0 ==> 1
// mistake "the inner loop runs backwards: the targets stand there from j to the last edge": for
//         (int i = j; i < end; ++i) ==> for (int i = end - 1; i >= j; --i)
// mistake "only the products of an edge with itself: with every edge from j on": for (int i = j; i
//         < end; ++i) ==> for (int i = j; i < end; ++i) if (i > j) ++target; else
// mistake "the last edge of each node is left out: up to first_edge of the next node": end =
//         A.nodes[k + 1].first_edge ==> end = A.nodes[k + 1].first_edge - 1
// right lower edges found by hand: int i = j; i < end; ++i) ==> int i = j; i != end; i += 1)
// right a copy of the block:
  for (std::size_t k = 0; k + 1 < A.nodes.size(); ++k) {
    const Node& node = A.nodes[k];
    const int n = node.rows, end = A.nodes[k + 1].first_edge;
    double* const D = number + node.diagonal;
    factor_block(D, n, &A.original[std::size_t(node.row)], inverse);
    std::vector<std::vector<double>> L(std::size_t(end - node.first_edge));
    for (int j = node.first_edge; j < end; ++j) {
      const int m = A.nodes[std::size_t(A.edges[j].to)].rows;
      std::vector<double>& own = L[std::size_t(j - node.first_edge)];
      own.resize(std::size_t(m * n));
      divide_rows(number + A.edges[j].at, m, D, n, own.data());
      for (int i = j; i < end; ++i)
        subtract_product(number + A.edges[i].at, A.nodes[A.edges[i].to].rows, own.data(), m, n,
                         number + *target++);
    }
    for (int j = node.first_edge; j < end; ++j) {
      const std::vector<double>& own = L[std::size_t(j - node.first_edge)];
      std::copy(own.begin(), own.end(), number + A.edges[j].at);
    }
  }

// region 2
// mistake "divided behind the way back: on the way forward, after the node's edges": divide(number
//         + node.diagonal, node.rows, x + node.row); ==> ;; // Eq. 9-5 } ==> } divide(number +
//         node.diagonal, node.rows, x + node.row);
// mistake "only the last edge of each node on the way back: all of them": -k) { const Node& node =
//         A.nodes[k]; for (int j = node.first_edge ==> -k) { const Node& node = A.nodes[k]; for
//         (int j = std::max(node.first_edge, A.nodes[k + 1].first_edge - 1)
// mistake "the last edge of each node is left out: up to first_edge of the next node": ].first_edge
//         ==> ].first_edge - 1 ;; ].first_edge; ==> ].first_edge - 1;
// mistake "the node's number in the place of its row: its numbers begin at x + node.row": x +
//         node.row, x + to.row ==> x + k, x + A.edges[j].to ;; x + node.row ==> x + k ;; x +
//         to.row, x + node.row ==> x + A.edges[j].to, x + k
// wrong "cases drawn with seed 1 are wrong": for (int k = count - 1; ==> for (int i = 0; i <
//         A.nodes.back().row; ++i) if (std::abs(x[i]) < 1e-9) x[i] = 0; for (int k = count - 1;
// wrong drawn-stops: int(A.nodes.size()) - 1 ==> std::min(16, int(A.nodes.size()) - 1)
// mistake "nothing is divided: each node's numbers by its diagonal block, on the way forward":
//         divide(number + node.diagonal, node.rows, x + node.row); ==>
// mistake "divided before its edges are gone through: they take the numbers as they are,
//         undivided": divide(number + node.diagonal, node.rows, x + node.row); ==> ;; [k] ==> [k];
//         divide(number + node.diagonal, node.rows, x + node.row)
// mistake "back in the order of elimination: from the last node to the first": int k = count - 1; k
//         >= 0; --k ==> int k = 0; k < count; ++k
// mistake "the way forward begins with the last node: forward in the order of elimination": int k =
//         0; k < count; ++k ==> int k = count - 1; k >= 0; --k
// mistake "the way back is missing: subtract L^T x of each edge from the node's own numbers": int k
//         = count - 1; k >= 0; --k ==> int k = -1; k >= 0; --k
// mistake "the way forward is missing: subtract L x of each edge from the other node's numbers":
//         subtract_times ==> if (false) subtract_times
// mistake "the way back goes like the way forward: there the other node's numbers are multiplied by
//         L^T and taken from the node's own": subtract_transposed_times ==> subtract_times ;;
//         to.row, x + node ==> node.row, x + to
// mistake "the transpose is forgotten on the way back: L^T of the other node's numbers, which is
//         subtract_transposed_times()": subtract_transposed_times ==> subtract_times
// mistake "the transpose is forgotten on the way back: L^T of the other node's numbers, which is
//         subtract_transposed_times()": subtract_transposed_times(number + A.edges[j].at, to.rows,
//         node.rows, ==> subtract_times(number + A.edges[j].at, node.rows, to.rows,
// mistake "the way forward goes like the way back: there L of the node's own numbers is taken from
//         the other node's": subtract_times(number + A.edges[j].at, to.rows, node.rows, x +
//         node.row, x + to.row) ==> subtract_transposed_times(number + A.edges[j].at, to.rows,
//         node.rows, x + to.row, x + node.row)
// mistake "x and y are exchanged on the way back: L^T of the other node's numbers is taken from the
//         node's own": to.row, x + node ==> node.row, x + to
// mistake "rows and columns of the edge's block are exchanged on the way forward: it has the rows
//         of the other node": to.rows, node ==> node.rows, to
// mistake "the node's number in the place of its row on the way forward: its numbers begin at x +
//         node.row": x + node.row, x + to.row ==> x + k, x + A.edges[j].to
// mistake "the last node is left out: it has no edges, but it must be divided": 1 ==> 2
// mistake "the way back leaves the first node out: k >= 0": k >= 0 ==> k > 0
// mistake "the node's row in the place of its diagonal: its diagonal block begins at number +
//         node.diagonal": number + node.diagonal, ==> number + node.row,
// mistake "only the first edge of each node on the way forward: all of them": 1] ==> 1].first_edge
//         && j == node
// mistake "the edges of other nodes, too: from the node's first_edge on": node.first_edge ==> 0
// mistake "nothing is done":
  (void)A, (void)x, (void)number;
// right divided on the way back: divide(number + node.diagonal, node.rows, x + node.row); } for
//         (int k = count - 1; k >= 0; --k) { const Node& node = A.nodes[k] ==> } for (int k = count
//         - 1; k >= 0; --k) { const Node& node = A.nodes[k]; divide(number + node.diagonal,
//         node.rows, x + node.row)
// right edges from the last: for (int j = node.first_edge; j < A.nodes[k + 1].first_edge; ++j) {
//         ==> for (int j = A.nodes[k + 1].first_edge; j-- > node.first_edge;) {
// right division in a loop of its own: divide(number + node.diagonal, node.rows, x + node.row); }
//         ==> } for (int k = 0; k < count; ++k) divide(number + A.nodes[k].diagonal,
//         A.nodes[k].rows, x + A.nodes[k].row);
// from right divided on the way back
// mistake "divided on the way forward and on the way back: once": } for ==> divide(number +
//         node.diagonal, node.rows, x + node.row); } for
// mistake "divided once for each edge: once for each node, after its edges": row); ==> row);
//         divide(number + node.diagonal, node.rows, x + node.row); ;; [k]; divide(number +
//         node.diagonal, node.rows, x + node.row) ==> [k]
