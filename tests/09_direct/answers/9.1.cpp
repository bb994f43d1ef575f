// wrong drawn-threshold: dot(J[i].v, response.v) + dot(J[i].w, response.w) ==> (std::abs(
//         dot(J[i].v, response.v) + dot(J[i].w, response.w)) < 1e-9 ? 0 : dot(J[i].v, response.v) +
//         dot(J[i].w, response.w))
// wrong drawn-cut: dot(J[i].v, response.v) + dot(J[i].w, response.w) ==> (std::abs(
//         dot(J[i].v, response.v) + dot(J[i].w, response.w)) > 1e6 ? 0 : dot(J[i].v, response.v) +
//         dot(J[i].w, response.w))
// wrong drawn-threshold: for (int j ==> if (mass.linear < 1e-6) return; for (int j
// wrong drawn-threshold: dot(J[i].v, response.v) ==> (mass.linear < 1e-5 ? 0 : dot(J[i].v, response.v))
// mistake "J with J: an impulse is no velocity. How much do v and w of a body of this mass and
//         inertia change?": mass.linear * ==> ;; mass.angular * ==>
// mistake "the inverse mass is missing: how much does v of the body change?": mass.linear * ==>
// mistake "the inverse inertia is missing: how much does w of the body change?": mass.angular * ==>
// mistake "divided by the inverse mass: a heavy body changes its velocity less": mass.linear *
//         other[j].v ==> other[j].v / mass.linear
// mistake "the inverse mass is there twice: J M^-1 J^T has it once": * ==> * mass.linear *
// mistake "the inverse mass in the place of the inverse inertia: turning is opposed by the
//         inertia": mass.angular ==> mass.linear
// mistake "the inverse mass multiplies the angular part as well: it belongs to v alone": dot(J[i].w
//         ==> mass.linear * dot(J[i].w
// mistake "only the diagonal of the inverse inertia: mass.angular * other[j].w has all of it":
//         mass.angular * other[j].w ==> glm::dvec3{mass.angular[0][0] * other[j].w.x,
//         mass.angular[1][1] * other[j].w.y, mass.angular[2][2] * other[j].w.z}
// mistake "only x and y count in the angular product: all three do": dot(J[i].w, response.w) ==>
//         J[i].w.x * response.w.x + J[i].w.y * response.w.y
// mistake "the rows stop at 5: a block has up to six": i < n ==> i < n && i < 5
// mistake "the columns stop at 5: a block has up to six": j < m ==> j < m && j < 5
// mistake "the entries are set: they grow. Two blocks may share both their bodies, and each of
//         these adds its part": A[i * m + j] += ==> A[i * m + j] =
// mistake "the sign: the product is added": A[i * m + j] += ==> A[i * m + j] -=
// mistake "column by column: entry (i, j) stands at A[i * m + j]: A is n x m, row by row": A[i * m
//         + j] ==> A[j * n + i]
// mistake "transposed: entry (i, j) stands at A[i * m + j]: A is n x m, row by row": A[i * m + j]
//         ==> A[j * m + i]
// mistake "a row is n numbers long, it has m: entry (i, j) stands at A[i * m + j]: A is n x m, row
//         by row": m + ==> n +
// mistake "a row is six numbers long, it has m: entry (i, j) stands at A[i * m + j]: A is n x m,
//         row by row": m + ==> 6 +
// mistake "only the linear halves: an impulse turns the body, too": + dot(J[i].w, response.w) ==>
// mistake "only the angular halves: an impulse moves the centre, too": dot(J[i].v, response.v) +
//         ==>
// mistake "linear halves with angular ones: v goes with v, w with w": dot(J[i].v, response.v) +
//         dot(J[i].w, response.w) ==> dot(J[i].v, response.w) + dot(J[i].w, response.v)
// mistake "the linear halves twice: the second product is of the angular ones": dot(J[i].w,
//         response.w) ==> dot(J[i].v, response.v)
// mistake "the linear and the angular part are multiplied: they are added": + dot ==> * dot
// mistake "the sign of the angular part: both are added": + dot ==> - dot
// mistake "i and j are exchanged at J and the response: row i is of J, column j of the other
//         block's response": const HalfRow response{mass.linear * other[j].v, mass.angular *
//         other[j].w}; ==> ;; A ==> { const HalfRow response{mass.linear * other[i].v, mass.angular
//         * other[i].w}; A ;; J[i ==> J[j ;; J[i ==> J[j ;; ); ==> ); }
// mistake "J with itself: the impulse acts along a row of the other block": other ==> J ;;
//         mass.linear * ==> ;; mass.angular * ==> ;; other ==> J
// mistake "the angular product is of J[i].w and J[j].w: of J[i].w and M^-1 other[j].w": response.w
//         ==> J[j].w
// mistake "always the first half-row of J: row i has J[i]": [i] ==> [0] ;; [i] ==> [0]
// mistake "the angular product is of J[0].w and M^-1 other[j].w: of J[i].w and M^-1 other[j].w":
//         i].w ==> 0].w
// mistake "the angular product is of J[i].w and M^-1 other[i].w: of J[i].w and M^-1 other[j].w":
//         response.w ==> (mass.angular * other[i].w)
// mistake "only the entries with i = j: every row of one block is coupled with every row of the
//         other": A[i ==> if (i == j) A[i
// mistake "only the entries with j <= i: this is no diagonal block, all n x m count": A[i ==> if (j
//         <= i) A[i
// mistake "j runs to n: the second block has m rows": j < m ==> j < n
// mistake "i runs to m: the first block has n rows": i < n ==> i < m
// mistake "n and m are exchanged in the loops: i runs to n, j to m": < n ==> < m ;; m ==> n
// mistake "the last row is left out: i < n": i < n ==> i < n - 1
// mistake "one row too many: i < n": i < n ==> i <= n
// mistake "one column too many: j < m": j < m ==> j <= m
// mistake "the first column is left out: j begins with 0": int j = 0 ==> int j = 1
// mistake "a sum goes on from entry to entry: begin with 0 for each":
  double sum{};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      sum += mass.linear * dot(J[i].v, other[j].v) + dot(J[i].w, mass.angular * other[j].w);
      A[i * m + j] += sum;
    }
// wrong both-triangles-once: response.w); ==> response.w), A[j * m + i] = A[i * m + j];
// mistake "half of the product: all of it": dot ==> 0.5 * (dot ;; w) ==> w))
// mistake "only x and y count in the linear product: all three do": dot(J[i].v, response.v) ==>
//         (J[i].v.x * response.v.x + J[i].v.y * response.v.y)
// mistake "nothing is added: A[i * m + j] += the product":
  (void)J, (void)n, (void)other, (void)m, (void)mass, (void)A;
// mistake "A[i, j] is A[j] in C++: A[i * m + j]": * m + ==> ,
// mistake "the angular halves twice: the first product is of the linear ones": v, response.v ==> w,
//         response.w
// mistake "the sums of both halves are multiplied: v with v and w with w, then add": dot(J[i].v,
//         response.v) + dot(J[i].w, response.w) ==> dot(J[i].v + J[i].w, response.v + response.w)
// mistake "twice the product, or the loops run twice: once": dot(J[i].v, response.v) + dot(J[i].w,
//         response.w) ==> 2.0 * (dot(J[i].v, response.v) + dot(J[i].w, response.w))
// mistake "the size of the product: it may have either sign": dot(J[i].v, response.v) + dot(J[i].w,
//         response.w) ==> std::abs(dot(J[i].v, response.v) + dot(J[i].w, response.w))
// mistake "only x counts in the angular product: all three do": dot(J[i].v, response.v) +
//         dot(J[i].w, response.w) ==> dot(J[i].v, response.v) + J[i].w.x * response.w.x
// mistake "the response with itself: the rate is that of a row of J": J ==> mass.linear * other ;;
//         J ==> mass.angular * other
// mistake "always the first half-row of the response: column j belongs to other[j]": other[j].v ==>
//         other[0].v ;; other[j].w ==> other[0].w
// mistake "i is not multiplied by m: entry (i, j) stands at A[i * m + j]: A is n x m, row by row":
//         i * m + j ==> i + j
// mistake "everything is added to the first entry: (i, j) stands at A[i * m + j]": i * m + j ==> 0
// mistake "only the entries with j >= i: this is no diagonal block, all n x m count": A[i ==> if (j
//         >= i) A[i
// mistake "the old entry is taken away: it grows by the product": += ==> = -A[i * m + j] +
// mistake "the old entry is counted twice: A[i * m + j] += has it already": A[i * m + j] += ==> A[i
//         * m + j] += A[i * m + j] +
// mistake "the old entry is multiplied: it grows by the product": += ==> *=
// mistake "the last column is left out: j < m": j < m ==> j < m - 1
// mistake "the first row is left out: i begins with 0": int i = 0 ==> int i = 1
// mistake "the rows stop at {3|4}: a block has up to six": i < n ==> i < n && i < {3|4}
// mistake "the columns stop at {3|4}: a block has up to six": j < m ==> j < m && j < {3|4}
// mistake "the linear product is of {J[i].v and J[j].v|J[0].v and M^-1 other[j].v|J[i].v and M^-1
//         other[i].v|J[j].v and M^-1 other[j].v|J[j].v and M^-1 other[i].v|J[i].v and M^-1
//         other[0].v|J[i].v and J[i].v|J[j].v and J[0].v|M^-1 other[j].v and M^-1 other[j].v|M^-1
//         other[i].v and M^-1 other[j].v}: of J[i].v and M^-1 other[j].v": dot(J[i].v, response.v)
//         ==> {dot(J[i].v, J[j].v)|dot(J[0].v, (mass.linear * other[j].v))|dot(J[i].v, (mass.linear
//         * other[i].v))|dot(J[j].v, (mass.linear * other[j].v))|dot(J[j].v, (mass.linear *
//         other[i].v))|dot(J[i].v, (mass.linear * other[0].v))|dot(J[i].v, J[i].v)|dot(J[j].v,
//         J[0].v)|dot((mass.linear * other[j].v), (mass.linear * other[j].v))|dot((mass.linear *
//         other[i].v), (mass.linear * other[j].v))}
// mistake "the angular product is of {J[i].w and J[j].w|J[0].w and M^-1 other[j].w|J[i].w and M^-1
//         other[i].w|J[j].w and M^-1 other[j].w|J[j].w and M^-1 other[i].w|J[i].w and M^-1
//         other[0].w|J[i].w and J[i].w|J[j].w and J[0].w|M^-1 other[j].w and M^-1 other[j].w|M^-1
//         other[i].w and M^-1 other[j].w}: of J[i].w and M^-1 other[j].w": dot(J[i].w, response.w)
//         ==> {dot(J[i].w, J[j].w)|dot(J[0].w, (mass.angular * other[j].w))|dot(J[i].w,
//         (mass.angular * other[i].w))|dot(J[j].w, (mass.angular * other[j].w))|dot(J[j].w,
//         (mass.angular * other[i].w))|dot(J[i].w, (mass.angular * other[0].w))|dot(J[i].w,
//         J[i].w)|dot(J[j].w, J[0].w)|dot((mass.angular * other[j].w), (mass.angular *
//         other[j].w))|dot((mass.angular * other[i].w), (mass.angular * other[j].w))}
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
