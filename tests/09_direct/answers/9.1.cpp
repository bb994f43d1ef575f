// wrong masses-missing: mass.linear * ==> ;; mass.angular * ==>
// wrong mass-missing: mass.linear * ==>
// wrong inertia-missing: mass.angular * ==>
// wrong mass-inverted: mass.linear * other[j].v ==> other[j].v / mass.linear
// wrong mass-squared: mass.linear * ==> mass.linear * mass.linear *
// wrong mass-turns: mass.angular ==> mass.linear
// wrong mass-at-both: dot(J[i].w ==> mass.linear * dot(J[i].w
// wrong inertia-diagonal: mass.angular * other[j].w ==> glm::dvec3{mass.angular[0][0]
//         * other[j].w.x, mass.angular[1][1] * other[j].w.y, mass.angular[2][2] * other[j].w.z}
// wrong angular-x-y-alone: dot(J[i].w, response.w) ==> J[i].w.x * response.w.x + J[i].w.y *
//         response.w.y
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
// wrong linear-part-alone: + dot(J[i].w, response.w) ==>
// wrong angular-part-alone: dot(J[i].v, response.v) + ==>
// wrong v-with-w: dot(J[i].v, response.v) + dot(J[i].w, response.w) ==> dot(J[i].v, response.w) +
//         dot(J[i].w, response.v)
// wrong v-twice: dot(J[i].w, response.w) ==> dot(J[i].v, response.v)
// wrong linear-angular-multiplied: + dot ==> * dot
// wrong angular-part-subtracted: + dot ==> - dot
// wrong rows-columns-blocks-exchanged: const HalfRow response{mass.linear * other[j].v,
//         mass.angular * other[j].w}; ==> ;; A[ ==> { const HalfRow response{mass.linear
//         * other[i].v, mass.angular * other[i].w}; A[ ;; J[i] ==> J[j] ;; J[i] ==> J[j] ;;
//         response.w); ==> response.w); }
// wrong j-with-j: other ==> J ;; mass.linear * ==> ;; mass.angular * ==> ;; other ==> J
// wrong "the angular product is of J[i].w and J[j].w: of J[i].w and": response.w ==> J[j].w
// wrong first-row-j-always: [i] ==> [0] ;; [i] ==> [0]
// wrong "the angular product is of J[0].w and M^-1 other[j].w: of J[i].w and": i].w ==> 0].w
// wrong "the angular product is of J[i].w and M^-1 other[i].w: of J[i].w and": response.w ==>
//         (mass.angular * other[i].w)
// wrong only-entries-i-j: A[i ==> if (i == j) A[i
// wrong lower-triangle-only: A[i ==> if (j <= i) A[i
// wrong j-to-n: j < m ==> j < n
// wrong i-to-m: i < n ==> i < m
// wrong loops-exchanged: i < n ==> i < m ;; j < m ==> j < n
// wrong last-row-left-out-i-n: i < n ==> i < n - 1
// wrong one-row-too-many: i < n ==> i <= n
// wrong one-column-too-many: j < m ==> j <= m
// wrong begins-with-1: int j = 0 ==> int j = 1
// wrong sum-goes-on:
  double sum{};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      sum += mass.linear * dot(J[i].v, other[j].v) + dot(J[i].w, mass.angular * other[j].w);
      A[i * m + j] += sum;
    }
// wrong both-triangles-once: response.w); ==> response.w), A[j * m + i] = A[i * m + j];
// wrong half: dot ==> 0.5 * (dot ;; w) ==> w))
// wrong x-y-alone: dot(J[i].v, response.v) ==> (J[i].v.x * response.v.x + J[i].v.y * response.v.y)
// wrong nothing-done:
  (void)J, (void)n, (void)other, (void)m, (void)mass, (void)A;
// wrong two-dimensional-index: * m + ==> ,
// right a pointer that goes on:
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      *A++ += mass.linear * dot(other[j].v, J[i].v) + dot(mass.angular * J[i].w, other[j].w);
// right all responses first:
  HalfRow response[6];
  for (int j = 0; j < m; ++j)
    response[j] = {mass.linear * other[j].v, mass.angular * other[j].w};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      double sum = A[i * m + j];
      sum = sum + dot(J[i].w, response[j].w);
      sum += dot(J[i].v, response[j].v);
      A[i * m + j] = sum;
    }
