// wrong angular-x-y-alone: dot(J[i].w, response[j].w) ==> J[i].w.x * response[j].w.x + J[i].w.y *
//         response[j].w.y
// wrong rows-stop: i < n ==> i < n && i < 5
// wrong columns-stop: j < m ==> j < m && j < 5
// wrong set-instead-added: A[i * m + j] += ==> A[i * m + j] =
// wrong minus-the-product: A[i * m + j] += ==> A[i * m + j] -=
// wrong "column by column: entry (i, j) stands at A[i * m + j]: A is n x m, row": A[i * m + j] ==>
//         A[j * n + i]
// wrong "transposed: entry (i, j) stands at A[i * m + j]: A is n x m, row by": A[i * m + j] ==> A[j
//         * m + i]
// wrong "a row is n numbers long, it has m: entry (i, j) stands at A[i * m +": m + ==> n +
// wrong "a row is six numbers long, it has m: entry (i, j) stands at A[i * m +": m + ==> 6 +
// wrong linear-part-alone: + dot(J[i].w, response[j].w) ==>
// wrong angular-part-alone: dot(J[i].v, response[j].v) + ==>
// wrong v-with-w: dot(J[i].v, response[j].v) + dot(J[i].w, response[j].w) ==> dot(J[i].v,
//         response[j].w) + dot(J[i].w, response[j].v)
// wrong v-twice: dot(J[i].w, response[j].w) ==> dot(J[i].v, response[j].v)
// wrong linear-angular-multiplied: + dot ==> * dot
// wrong angular-part-subtracted: + dot ==> - dot
// wrong rows-columns-blocks-exchanged: dot(J[i].v, response[j].v) + dot(J[i].w, response[j].w) ==>
//         dot(J[j].v, response[i].v) + dot(J[j].w, response[i].w)
// wrong j-with-j: response ==> J ;; response ==> J
// wrong "the angular product is of J[i].w and J[j].w: of J[i].w and": w, response ==> w, J
// wrong first-row-j-always: [i] ==> [0] ;; [i] ==> [0]
// wrong "the angular product is of J[0].w and response[j].w: of J[i].w and": i].w ==> 0].w
// wrong "the angular product is of J[i].w and response[i].w: of J[i].w and": response[j].w ==>
//         response[i].w
// wrong only-entries-i-j: for (int j = 0; j < m; ++j) ==> if (int j = i; j < m)
// wrong lower-triangle-only: j < m; ++j ==> j < m && j <= i; ++j
// wrong j-to-n: j < m ==> j < n
// wrong i-to-m: i < n ==> i < m
// wrong loops-exchanged: i < n ==> i < m ;; j < m ==> j < n
// wrong last-row-left-out-i-n: i < n ==> i < n - 1
// wrong one-row-too-many: i < n ==> i <= n
// wrong one-column-too-many: j < m ==> j <= m
// wrong begins-with-1: int j = 0 ==> int j = 1
// wrong sum-goes-on: for ==> Number sum{}; for ;; dot ==> sum += dot
// wrong both-triangles-once: response[j].w); ==> response[j].w), A[j * m + i] = A[i * m + j];
// wrong half: dot ==> 0.5 * (dot ;; w) ==> w))
// wrong x-y-alone: dot(J[i].v, response[j].v) ==> (J[i].v.x * response[j].v.x + J[i].v.y *
//         response[j].v.y)
// wrong nothing-done:
  (void)J, (void)n, (void)response, (void)m, (void)A;
// wrong two-dimensional-index: * m + ==> ,
// right a pointer that goes on: A[i * m + j] += dot(J[i].v, response[j].v) + dot(J[i].w,
//         response[j].w) ==> *A++ += dot(response[j].v, J[i].v) + dot(response[j].w, J[i].w)
// right columns outside: for (int i = 0; i < n; ++i) ==> ;; A[i * m + j] += dot(J[i].v,
//         response[j].v) + dot(J[i].w, response[j].w); ==> for (int i = 0; i < n; ++i) { Number sum
//         = A[i * m + j]; sum = sum + dot(J[i].w, response[j].w); sum += dot(J[i].v,
//         response[j].v); A[i * m + j] = sum; }
