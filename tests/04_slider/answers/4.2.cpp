// wrong drawn-threshold: if (q.w < 0) ==> if (q.w < real(-0.01))
// mistake "no absolute values: each number of v has a sign": if (q.w < 0) q = -q; return real(2) *
//         vec3(q.x, q.y, q.z) ==> return real(2) * abs(vec3(q.x, q.y, q.z))
// mistake "the vector of the rotation itself: C is 2 v, whose length is 2 sin(angle/2)": real(2) *
//         vec3(q.x, q.y, q.z) ==> glm::angle(q) * glm::axis(q)
// mistake "a difference of quaternions is no rotation": quat ==> const quat ;; * conjugate(start) *
//         conjugate(body1.q); if (q.w < 0) q = - ==> - body1.
// mistake "differences of angles about three axes: these are no rotation, and their rates are not
//         w. C is 2 v":
  return glm::eulerAngles(body2.q) - glm::eulerAngles(body1.q);
// mistake "the factor 2 is forgotten: v is only half the rotation": quat ==> const quat ;; if (q.w
//         < 0) q = -q; return real(2) ==> return (q.w < 0 ? real(-1) : real(1))
// mistake "in the axes of body 1: C is in the world, q2 start^-1 q1^-1": body2 ==>
//         conjugate(body1.q) * body2 ;; * conjugate(body1.q) ==>
// mistake "the sign: body 2 is turned too far, so q2 stands first and q1 is inverted; and -q is
//         taken where s < 0, not where s > 0": (2) ==> (-2)
// mistake "the axis alone: C is 2 v, whose length is 2 sin(angle/2)": real(2) * vec3(q.x, q.y, q.z)
//         ==> normalize(vec3(q.x, q.y, q.z))
// mistake "start and q1 must be inverted": conjugate(start) * conjugate(body1.q) ==> start *
//         body1.q
// mistake "body 1 alone: the rotation is that of body 2": body2 ==> body1
// mistake "x decides which of q and -q is taken: the sign of s does": w < ==> x <
// mistake "the sign rule is forgotten: where s < 0, take -q": = -q ==> .w = -q.w
// mistake "the sine of the whole angle: it is zero again at a half turn": if (q.w < 0) q = -q;
//         return real(2) ==> return real(2) * q.w
// mistake "start is forgotten: the initial relative rotation is not an error": * conjugate(start)
//         ==>
// expects: C, pencil and paper, start = q2.z
// mistake "start must be inverted": conjugate(start) ==> start
// mistake "start is taken away twice": q * ==> q * conjugate(start) *
// mistake "turned once more with a body: q2 start^-1 q1^-1 is in the world": real(2) * vec3(q.x,
//         q.y, q.z) ==> to_world(body1, real(2) * vec3(q.x, q.y, q.z))
// wrong never-set: return real(2) * vec3(q.x, q.y, q.z) ==> real C[3]; C[0] = 2 * q.x; C[1] = 2 *
//         q.y; return vec3(C[0], C[1], C[2])
// mistake "the numbers w, x, y: the vector of q is (q.x, q.y, q.z)": x, ==> w, q.x, ;; y, q.z ==> y
// mistake "C is zero, though body 2 is turned too far": q.z ==> 0
// mistake "the numbers x, z, y: the vector of q is (q.x, q.y, q.z)": y, q.z ==> z, q.y
// mistake "a small rotation is an error, too: no threshold belongs here": return real(2) *
//         vec3(q.x, q.y, q.z); ==> const vec3 C = real(2) * vec3(q.x, q.y, q.z); return length(C) <
//         1e-3 ? vec3(0) : C;
// right axis and half angle: (start) * conjugate(body1.q); if (q.w < 0) q = -q; return real(2) *
//         vec3(q.x, q.y, q.z); ==> (body1.q * start); if (q.w < 0) q = -q; const vec3 v(q.x, q.y,
//         q.z); const real sine = length(v), angle = 2 * std::atan2(sine, q.w); return sine > 0 ? 2
//         * std::sin(angle / 2) * (v / sine) : vec3(0);
// right rotation matrix: quat q = body2.q * conjugate(start) * conjugate(body1.q) ==> const mat3 R1
//         = glm::mat3_cast(body1.q), R2 = glm::mat3_cast(body2.q); const mat3 E = R2 *
//         transpose(glm::mat3_cast(start)) * transpose(R1); quat q = glm::quat_cast(E)
// right seen from body 1 and turned back:
  // The rotation in the axes of body 1; its vector is turned into the world.
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  const real sign = std::copysign(real(2), q.w);
  return to_world(body1, sign * vec3(q.x, q.y, q.z));
// right sign factor:
  const quat q = body2.q * conjugate(body1.q * start);
  const vec3 v(q.x, q.y, q.z);
  return q.w < 0 ? real(-2) * v : real(2) * v;
// right sign by the conjugate: -q ==> conjugate(q)
// right where it belongs: quat ==> const quat wanted = body1.q * start; const quat ;;
//         conjugate(start) * conjugate(body1.q); if (q.w < 0) q = -q; return real(2) ==>
//         inverse(wanted); return (q.w >= 0 ? real(2) : real(-2))
// mistake "the sign rule is forgotten: where s < 0, take -q": if (q.w < 0) q = -q; ==>
// mistake "the factor 2 and the sign rule are forgotten": if (q.w < 0) q = -q; ==> ;; real(2) * ==>
// mistake "the half angle in place of its sine: C is 2 v": real(2) * ==> 2 * std::acos(q.w < 1 ?
//         q.w : real(1)) *
// mistake "the numbers y, z, w: the vector of q is (q.x, q.y, q.z)": q.x, q.y, q.z ==> q.y, q.z,
//         q.w
// mistake "the sine of the whole angle: it is zero again at a half turn": real(2) * ==> real(2) *
//         q.w *
// mistake "the tangent of half the angle: it is unbounded at a half turn": q.z) ==> q.z) / q.w
// mistake "no absolute values: each number of v has a sign": real(2) * vec3(q.x, q.y, q.z) ==>
//         abs(real(2) * vec3(q.x, q.y, q.z))
// mistake "differences of angles about three axes: these are no rotation, and their rates are not
//         w. C is 2 v": real(2) * vec3(q.x, q.y, q.z) ==> glm::eulerAngles(conjugate(body1.q) *
//         body2.q) - glm::eulerAngles(start)
// mistake "differences of angles about three axes: these are no rotation, and their rates are not
//         w. C is 2 v": real(2) * vec3(q.x, q.y, q.z) ==> glm::eulerAngles(body2.q *
//         conjugate(start)) - glm::eulerAngles(body1.q)
// mistake "differences of angles about three axes: these are no rotation, and their rates are not
//         w. C is 2 v": real(2) * vec3(q.x, q.y, q.z) ==> glm::eulerAngles(q)
// mistake "differences of angles about three axes: these are no rotation, and their rates are not
//         w. C is 2 v": if (q.w < 0) q = -q; ==> ;; real(2) * vec3(q.x, q.y, q.z) ==>
//         glm::eulerAngles(q)
// mistake "in the axes of body 1: C is in the world, q2 start^-1 q1^-1": real(2) * vec3(q.x, q.y,
//         q.z) ==> to_local(body1, real(2) * vec3(q.x, q.y, q.z))
// mistake "in the axes of body 2: C is in the world, q2 start^-1 q1^-1": real(2) * vec3(q.x, q.y,
//         q.z) ==> to_local(body2, real(2) * vec3(q.x, q.y, q.z))
// mistake "turned once more with a body: q2 start^-1 q1^-1 is in the world": real(2) * vec3(q.x,
//         q.y, q.z) ==> to_world(body2, real(2) * vec3(q.x, q.y, q.z))
// mistake "C is zero, though body 2 is turned too far": real(2) * vec3(q.x, q.y, q.z) ==> vec3(0)
// mistake "a small rotation is an error, too: no threshold belongs here": return ==> if
//         (length(real(2) * vec3(q.x, q.y, q.z)) < real(1e-1)) return vec3(0); return
// mistake "a small rotation is an error, too: no threshold belongs here": return ==> if
//         (length(real(2) * vec3(q.x, q.y, q.z)) < real(1e-2)) return vec3(0); return
// mistake "a small rotation is an error, too: no threshold belongs here": return ==> if
//         (length(real(2) * vec3(q.x, q.y, q.z)) < real(1e-4)) return vec3(0); return
// mistake "start is forgotten, and the order is q2 q1^-1": body2.q * conjugate(start) *
//         conjugate(body1.q) ==> conjugate(body1.q) * body2.q
// mistake "body 2 alone: q1 and start say where it should be": body2.q * conjugate(start) *
//         conjugate(body1.q) ==> body2.q
// mistake "start is on the wrong side of q1^-1: (q1 start)^-1 = start^-1 q1^-1": body2.q *
//         conjugate(start) * conjugate(body1.q) ==> body2.q * conjugate(body1.q) * conjugate(start)
// mistake "q1 must be inverted": body2.q * conjugate(start) * conjugate(body1.q) ==> body2.q *
//         conjugate(start) * body1.q
// mistake "the order of the product: q2, then start^-1, then q1^-1": body2.q * conjugate(start) *
//         conjugate(body1.q) ==> conjugate(start) * body2.q * conjugate(body1.q)
// mistake "the order of the product: q2, then start^-1, then q1^-1": body2.q * conjugate(start) *
//         conjugate(body1.q) ==> conjugate(body1.q) * conjugate(start) * body2.q
// mistake "the order of the product: q2, then start^-1, then q1^-1": body2.q * conjugate(start) *
//         conjugate(body1.q) ==> conjugate(body1.q) * start * body2.q
// mistake "in the axes of body 1: C is in the world, q2 start^-1 q1^-1": body2.q * conjugate(start)
//         * conjugate(body1.q) ==> conjugate(body1.q) * body2.q * conjugate(start)
// mistake "in the axes of body 2: C is in the world, q2 start^-1 q1^-1": body2.q * conjugate(start)
//         * conjugate(body1.q) ==> conjugate(start) * conjugate(body1.q) * body2.q
// mistake "start must be inverted, and the order is q2 start^-1 q1^-1": body2.q * conjugate(start)
//         * conjugate(body1.q) ==> conjugate(body1.q) * body2.q * start
// mistake "start is forgotten: the initial relative rotation is not an error": body2.q *
//         conjugate(start) * conjugate(body1.q) ==> body2.q * conjugate(body1.q)

// region 2
// wrong sign-row (pencil and paper, upright, turned, moved): (1) ==> (-1) ;; -1 ==> 1
// expects: Likely mistake: the sign of the whole row, or bodies 1 and 2 swapped (upright, turned,
// wrong exact-same-sign (broken): return ==> quat q = body2.q * conjugate(start) *
//         conjugate(body1.q); if (q.w < 0) q = -q; const mat3 A = mat3(q.w) + skew(vec3(q.x, q.y,
//         q.z)); return ;; mat3(-1) ==> -A ;; mat3(1) ==> A
// wrong exact-without-sign-rule (broken): return ==> quat q = body2.q * conjugate(start) *
//         conjugate(body1.q); const mat3 s = mat3(q.w), v = skew(vec3(q.x, q.y, q.z)); return ;;
//         mat3(-1) ==> -(s + v) ;; mat3(1) ==> s - v
// wrong "a factor of 0.5 (pencil and paper, upright, turned, moved)": -1 ==> real(-0.5) ;; 1 ==>
//         real(0.5)
// mistake "E has ones on its diagonal alone: mat3(1)": (1) ==> (1, 1, 1, 1, 1, 1, 1, 1, 1)
// expects: (pencil and paper, upright, turned, moved)
// wrong order-of-blocks (pencil and paper, upright, turned, moved): mat3 ==> mat3(0), mat3 ;; (0),
//         mat3(1) ==> (1)
// wrong "J[2], the row C.z, repeats J[0] (pencil and paper, upright, turned, moved)": return
//         jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)); ==> Jacobian<3> J; const vec3
//         e[] = {vec3(1, 0, 0), vec3(0, 1, 0), vec3(1, 0, 0)}; for (int i = 0; i < 3; ++i) J[i] =
//         {vec3(0), -e[i], vec3(0), e[i]}; return J;
// wrong "J[2], the row C.z, is zero: was it never written? (pencil and paper, upright, turned,
//         moved)":  return jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)); ==>
//         Jacobian<3> J; const vec3 e[] = {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}; for (int i
//         = 0; i < 2; ++i) J[i] = {vec3(0), -e[i], vec3(0), e[i]}; return J;
// mistake "w1 and w2 with the same sign: C grows with w2 - w1": -1 ==> 1
// expects: (pencil and paper, upright, turned, moved)
// wrong "the blocks v1 and v2 should be zero (pencil and paper, upright, turned, moved)": 0 ==> -1
//         ;; 0 ==> 1
// wrong "the block w1 is missing (pencil and paper, upright, turned, moved)": -1 ==> 0
// wrong inverse-masses-row (pencil and paper, upright, turned, moved): mat3(-1) ==>
//         -inverse_inertia(body1) ;; mat3(1) ==> inverse_inertia(body2)
// wrong all-zero (pencil and paper, upright, turned, moved): jacobian_from_blocks(mat3(0),
//         mat3(-1), mat3(0), mat3(1)) ==> {}
// wrong exact-rows-other-sign: return ==> const quat e = body2.q * conjugate(start) *
//         conjugate(body1.q); const real s = std::abs(e.w); const mat3 across = skew(vec3(e.x, e.y,
//         e.z)) * (e.w < 0 ? real(-1) : real(1)); return ;; mat3(-1) ==> across - mat3(s) ;;
//         mat3(1) ==> across + mat3(s)
// wrong rows-s-alone: (1) ==> (std::abs(e.w)) ;; 1 ==> std::abs(e.w) ;; return ==> const quat e =
//         body2.q * conjugate(start) * conjugate(body1.q); return
// right exact rows: return ==> quat q = body2.q * conjugate(start) * conjugate(body1.q); if (q.w <
//         0) q = -q; const mat3 s = mat3(q.w), v = skew(vec3(q.x, q.y, q.z)); return ;; mat3(-1)
//         ==> -(s + v) ;; mat3(1) ==> s - v
// right row by row: return jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)); ==> const
//         vec3 e[] = {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}; Jacobian<3> J; for (int i = 0;
//         i < 3; ++i) J[i] = {vec3(0), -e[i], vec3(0), e[i]}; return J;
// mistake "the rows are in the axes of a body: C, w1 and w2 are in the world":
//         jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)) ==>
//         jacobian_from_blocks(mat3(0), -transpose(mat3(mat3_cast(body1.q))), mat3(0),
//         transpose(mat3(mat3_cast(body1.q))))
// mistake "the rows are in the axes of a body: C, w1 and w2 are in the world":
//         jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)) ==>
//         jacobian_from_blocks(mat3(0), -mat3(mat3_cast(body1.q)), mat3(0),
//         mat3(mat3_cast(body1.q)))
// mistake "the rows are in the axes of a body: C, w1 and w2 are in the world":
//         jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)) ==>
//         jacobian_from_blocks(mat3(0), -transpose(mat3(mat3_cast(body2.q))), mat3(0),
//         transpose(mat3(mat3_cast(body2.q))))
// mistake "the rows are in the axes of a body: C, w1 and w2 are in the world":
//         jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)) ==>
//         jacobian_from_blocks(mat3(0), -mat3(mat3_cast(body2.q)), mat3(0),
//         mat3(mat3_cast(body2.q)))
// mistake "the rows are in the axes of a body: C, w1 and w2 are in the world":
//         jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)) ==>
//         jacobian_from_blocks(mat3(0), -transpose(mat3(mat3_cast(body1.q))), mat3(0),
//         transpose(mat3(mat3_cast(body2.q))))
// mistake "the rows are in the axes of a body: C, w1 and w2 are in the world":
//         jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)) ==>
//         jacobian_from_blocks(mat3(0), -mat3(mat3_cast(body1.q)), mat3(0),
//         mat3(mat3_cast(body2.q)))
// mistake "E has ones on its diagonal alone: mat3(1)": return ==> const mat3 ones(1, 1, 1, 1, 1, 1,
//         1, 1, 1); return ;; mat3(-1) ==> -ones ;; mat3(1) ==> ones
// mistake "a lock turns and does not push: E belongs to w1 and w2, not to v1 and v2":
//         jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)) ==>
//         jacobian_from_blocks(mat3(-1), mat3(0), mat3(1), mat3(0))
