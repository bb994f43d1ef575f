// Known answers of exercise 9.1, each put in the place of the solution's.

// ---- wrong: set instead of added
// expects: Likely mistake: the entries are set: they grow. Two blocks may share both their
// change: A[i * m + j] += ==> A[i * m + j] =

// ---- wrong: minus the product
// expects: Likely mistake: the sign: the product is added
// change: A[i * m + j] += ==> A[i * m + j] -=

// ---- wrong: column by column
// expects: Likely mistake: column by column: entry (i, j) stands at A[i * m + j]: A is n x m, row
// change: A[i * m + j] ==> A[j * n + i]

// ---- wrong: transposed
// expects: Likely mistake: transposed: entry (i, j) stands at A[i * m + j]: A is n x m, row by
// change: A[i * m + j] ==> A[j * m + i]

// ---- wrong: stride n
// expects: Likely mistake: a row is n numbers long, it has m: entry (i, j) stands at A[i * m +
// change: A[i * m + j] ==> A[i * n + j]

// ---- wrong: stride six
// expects: Likely mistake: a row is six numbers long, it has m: entry (i, j) stands at A[i * m +
// change: A[i * m + j] ==> A[i * 6 + j]

// ---- wrong: linear part alone
// expects: Likely mistake: only the linear halves: add dot(J[i].w, response[j].w)
// change: + dot(J[i].w, response[j].w) ==>

// ---- wrong: angular part alone
// expects: Likely mistake: only the angular halves: add dot(J[i].v, response[j].v)
// change: dot(J[i].v, response[j].v) + ==>

// ---- wrong: v with w
// expects: Likely mistake: linear halves with angular ones: v goes with v, w with w
// change: dot(J[i].v, response[j].v) + dot(J[i].w, response[j].w) ==>
//         dot(J[i].v, response[j].w) + dot(J[i].w, response[j].v)

// ---- wrong: v twice
// expects: Likely mistake: the linear halves twice: the second product is of the angular ones
// change: dot(J[i].w, response[j].w) ==> dot(J[i].v, response[j].v)

// ---- wrong: linear and angular multiplied
// expects: Likely mistake: the linear and the angular part are multiplied: they are added
// change: + dot(J[i].w ==> * dot(J[i].w

// ---- wrong: angular part subtracted
// expects: Likely mistake: the sign of the angular part: both are added
// change: + dot(J[i].w ==> - dot(J[i].w

// ---- wrong: rows and columns of the blocks exchanged
// expects: Likely mistake: i and j are exchanged at J and the response: row i is of J, column j
// change: dot(J[i].v, response[j].v) + dot(J[i].w, response[j].w) ==>
//         dot(J[j].v, response[i].v) + dot(J[j].w, response[i].w)

// ---- wrong: J with J
// expects: Likely mistake: J with J: the response has the masses in it
// change: dot(J[i].v, response[j].v) + dot(J[i].w, response[j].w) ==>
//         dot(J[i].v, J[j].v) + dot(J[i].w, J[j].w)

// ---- wrong: J with itself in the angular half
// expects: Likely mistake: the angular product is of J[i].w and J[j].w: of J[i].w and
// change: dot(J[i].w, response[j].w) ==> dot(J[i].w, J[j].w)

// ---- wrong: first row of J always
// expects: Likely mistake: always the first half-row of J: row i has J[i]
// change: dot(J[i].v, response[j].v) + dot(J[i].w, response[j].w) ==>
//         dot(J[0].v, response[j].v) + dot(J[0].w, response[j].w)

// ---- wrong: first row of J in the angular half
// expects: Likely mistake: the angular product is of J[0].w and response[j].w: of J[i].w and
// change: dot(J[i].w ==> dot(J[0].w

// ---- wrong: i for j at the angular response
// expects: Likely mistake: the angular product is of J[i].w and response[i].w: of J[i].w and
// change: response[j].w ==> response[i].w

// ---- wrong: only the diagonal
// expects: Likely mistake: only the entries with i = j: every row of one block is coupled with
// change: for (int j = 0; j < m; ++j) ==> if (int j = i; j < m)

// ---- wrong: lower triangle only
// expects: Likely mistake: only the entries with j <= i: this is no diagonal block, all n x m
// change: j < m; ++j ==> j < m && j <= i; ++j

// ---- wrong: j to n
// expects: Likely mistake: j runs to n: the second block has m rows
// change: j < m ==> j < n

// ---- wrong: i to m
// expects: Likely mistake: i runs to m: the first block has n rows
// change: i < n ==> i < m

// ---- wrong: loops exchanged
// expects: Likely mistake: n and m are exchanged in the loops: i runs to n, j to m
// change: i < n ==> i < m
// change: j < m ==> j < n

// ---- wrong: last row left out
// expects: Likely mistake: the last row is left out: i < n
// change: i < n ==> i < n - 1

// ---- wrong: one row too many
// expects: Likely mistake: one row too many: i < n
// change: i < n ==> i <= n

// ---- wrong: one column too many
// expects: Likely mistake: one column too many: j < m
// change: j < m ==> j <= m

// ---- wrong: begins with 1
// expects: Likely mistake: the first column is left out: j begins with 0
// change: int j = 0 ==> int j = 1

// ---- wrong: sum goes on
// expects: Likely mistake: a sum goes on from entry to entry: begin with 0 for each
// change: for (int i ==> Number sum{}; for (int i
// change: += dot ==> += sum += dot

// ---- wrong: both triangles at once
// expects: Likely mistake: something is written behind the n x m numbers of A: do the loops end
// change: response[j].w); ==> response[j].w), A[j * m + i] = A[i * m + j];

// ---- wrong: half
// expects: Likely mistake: half of the product: all of it
// change: += dot(J[i].v ==> += 0.5 * (dot(J[i].v
// change: response[j].w); ==> response[j].w));

// ---- wrong: x and y alone
// expects: Likely mistake: only x and y count in the linear product: all three do
// change: dot(J[i].v, response[j].v) ==> (J[i].v.x * response[j].v.x + J[i].v.y * response[j].v.y)

// ---- wrong: nothing done
// expects: Likely mistake: nothing is added: A[i * m + j] += the product
  (void)J, (void)n, (void)response, (void)m, (void)A;

// ---- wrong: a pointer that goes on by n
// expects: Likely mistake: a row is n numbers long, it has m: entry (i, j) stands at A[i * m +
  Number* a = A;
  for (int i = 0; i < n; ++i, a += n)
    for (int j = 0; j < m; ++j)
      a[j] += dot(J[i].v, response[j].v) + dot(J[i].w, response[j].w);

// ---- wrong: two-dimensional index
// expects: Likely mistake: A[i, j] is A[j] in C++: A[i * m + j]
// change: * m + ==> ,

// ---- right: a pointer that goes on
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) *A++ += dot(response[j].v, J[i].v) + dot(response[j].w, J[i].w);

// ---- right: columns outside
// change: for (int i = 0; i < n; ++i) ==>
// change: A[i * m + j] += dot(J[i].v, response[j].v) + dot(J[i].w, response[j].w); ==>
//         for (int i = 0; i < n; ++i) { Number sum = A[i * m + j]; sum = sum + dot(J[i].w,
//         response[j].w); sum += dot(J[i].v, response[j].v); A[i * m + j] = sum; }
