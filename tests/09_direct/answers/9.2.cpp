// wrong block-transposed: std::copy(L, L + m * n, block); ==> for (int a = 0; a < m; ++a) for (int
//         b = 0; b < n; ++b) block[b * m + a] = L[a * n + b];
// wrong block-transposed: for (int i = j; i < end; ++i) ==> double T[36]; for (int a = 0; a < m;
//         ++a) for (int b = 0; b < n; ++b) T[b * m + a] = L[a * n + b]; for (int i = j; i < end;
//         ++i) ;; rows, L, ==> rows, T,
// wrong block-transposed: divide_rows(block, ==> double T[36]; for (int a = 0; a < m; ++a) for (int
//         b = 0; b < n; ++b) T[b * m + a] = block[a * n + b]; divide_rows(T,
// wrong never-set: std::copy(L, L + m * n, block) ==> std::copy(L, L + m * m, block)
// wrong drawn-stops: k + 1 < A.nodes.size() ==> k + 1 < A.nodes.size() && k < 16
// wrong half-l-stored: std::copy(L, L + m * n, block) ==> std::copy(L, L + std::min(n * n, m * n),
//         block)
// wrong diagonal-not-factored: factor_block(D, n, &A.original[std::size_t(node.row)], inverse); ==>
//         (void)inverse;
// wrong diagonal-factored-last: ; factor_block(D, n, &A.original[std::size_t(node.row)], inverse)
//         ==> ;; block); } ==> block); } factor_block(D, n, &A.original[std::size_t(node.row)],
//         inverse);
// wrong "the entry before any product was subtracted: &A.original[node.row]": std::size_t(node.row)
//         ==> k
// wrong inverse-own: inverse ==> [](double p, double) { return 1 / p; }
// wrong targets-not-advanced: *target++ ==> *target
// wrong targets-advanced-before: *target++ ==> *++target
// wrong targets-per-node-again: diagonal ==> diagonal; target = A.targets.data()
// wrong edge-itself: number + *target++ ==> number + A.edges[i].at
// wrong inner-loop-first-edge: int i = j; ==> int i = node.first_edge;
// wrong inner-loop-behind-j: int i = j; ==> int i = j + 1;
// wrong inner-loop-j-alone: i < end ==> i <= j
// wrong l-not-stored: std::copy(L, L + m * n, block); ==>
// wrong l-stored-too-early: divide_rows(block, m, D, n, L); ==> divide_rows(block, m, D, n, L);
//         std::copy(L, L + m * n, block);
// wrong l-times-l: for (int j = node.first_edge; j < end; ++j) { ==> for (int j = node.first_edge;
//         j < end; ++j) divide_rows(number + A.edges[j].at, A.nodes[A.edges[j].to].rows, D, n,
//         number + A.edges[j].at); for (int j = node.first_edge; j < end; ++j) { ;;
//         divide_rows(block, m, D, n, L); ==> std::copy(block, block + m * n, L);
// wrong not-divided: divide_rows(block, m, D, n, L); ==> std::copy(block, block + m * n, L);
// wrong m-n-exchanged-division: divide_rows(block, m, D, n, L) ==> divide_rows(block, n, D, m, L)
// wrong a-times-a: L, m ==> block, m
// wrong product-transposed: L, m, n ==> n ;; (number ==> (L, m, number
// wrong last-node-left-out: k + 1 < A.nodes.size() ==> k + 2 < A.nodes.size()
// wrong "an index outside a vector or an array: places run from 0 to size() - 1": + 1 ==>
// wrong last-edge-left-out: int i = j; i < end ==> int i = j; i < end - 1
// wrong only-first-edge: j < end; ++j ==> j < end && j == node.first_edge; ++j
// wrong "Case: a triangle": A.nodes[std::size_t(A.edges[j].to)].rows ==> n
// wrong rows-j-i: A.nodes[A.edges[i].to].rows, L ==> m, L
// wrong "an index outside a vector or an array: places run from 0 to size() - 1":
//         A.nodes[std::size_t(A.edges[j].to)].rows ==> A.nodes[std::size_t(j)].rows
// wrong block-wrong-edge: [i] ==> [j]
// wrong only-last-edge-stored: std::copy ==> if (j + 1 == end) std::copy
// wrong half-l-stored: std::copy(L, L + m * n, block) ==> std::copy(L, L + n, block)
// wrong nothing-subtracted: subtract_product ==> if (false) subtract_product
// wrong solve-does-nothing:
  (void)number, (void)target, (void)inverse;
// wrong first-node-left-out: 0 ==> 1
// wrong inner-loop-backwards: for (int i = j; i < end; ++i) ==> for (int i = end - 1; i >= j; --i)
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
// wrong "cases drawn with seed 1 are wrong": for (int k = count - 1; ==> for (int i = 0; i <
//         A.nodes.back().row; ++i) if (std::abs(x[i]) < 1e-9) x[i] = 0; for (int k = count - 1;
// wrong drawn-stops: count = int(A.nodes.size()) - 1; ==> count = std::min(16, int(A.nodes.size())
//         - 1);
// wrong forward-without-division: divide(number + node.diagonal, node.rows, x + node.row); ==>
// wrong divided-before-edges: divide(number + node.diagonal, node.rows, x + node.row); ==> ;; [k]
//         ==> [k]; divide(number + node.diagonal, node.rows, x + node.row)
// wrong back-forward-order: int k = count - 1; k >= 0; --k ==> int k = 0; k < count; ++k
// wrong forward-last: int k = 0; k < count; ++k ==> int k = count - 1; k >= 0; --k
// wrong no-way-back: int k = count - 1; k >= 0; --k ==> int k = -1; k >= 0; --k
// wrong no-way-forward: subtract_times ==> if (false) subtract_times
// wrong back-not-transposed: subtract_transposed_times ==> subtract_times ;; to.row, x + node ==>
//         node.row, x + to
// wrong back-untransposed: subtract_transposed_times ==> subtract_times
// wrong back-untransposed: subtract_transposed_times(number + A.edges[j].at, to.rows, node.rows,
//         ==> subtract_times(number + A.edges[j].at, node.rows, to.rows,
// wrong forward-transposed: subtract_times(number + A.edges[j].at, to.rows, node.rows, x +
//         node.row, x + to.row) ==> subtract_transposed_times(number + A.edges[j].at, to.rows,
//         node.rows, x + to.row, x + node.row)
// wrong back-ends-exchanged: to.row, x + node ==> node.row, x + to
// wrong rows-exchanged-way-forward: to.rows, node ==> node.rows, to
// wrong number-node-row: x + node.row, x + to.row ==> x + k, x + A.edges[j].to
// wrong last-node-left-out-solution: 1 ==> 2
// wrong first-node-left-out-way: k >= 0 ==> k > 0
// wrong "Case: three scalar rows of a chain": number + node.diagonal, ==> number + node.row,
// wrong only-first-edge-forward: 1] ==> 1].first_edge && j == node
// wrong edges-all-nodes: node.first_edge ==> 0
// wrong solve-does-nothing:
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
// wrong divided-both-ways: } for ==> divide(number + node.diagonal, node.rows, x + node.row); } for
// wrong divided-once-each-edge: row); ==> row); divide(number + node.diagonal, node.rows, x +
//         node.row); ;; [k]; divide(number + node.diagonal, node.rows, x + node.row) ==> [k]
