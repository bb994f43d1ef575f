// wrong drawn-threshold: if (q.w < 0) ==> if (q.w < real(-0.01))
// wrong abs-components: if (q.w < 0) q = -q; return real(2) * vec3(q.x, q.y, q.z) ==> return
//         real(2) * abs(vec3(q.x, q.y, q.z))
// wrong angle-vector: real(2) * vec3(q.x, q.y, q.z) ==> glm::angle(q) * glm::axis(q)
// wrong difference-of-q: quat ==> const quat ;; * conjugate(start) * conjugate(body1.q); if (q.w <
//         0) q = - ==> - body1.
// wrong differences-of-angles:
  return glm::eulerAngles(body2.q) - glm::eulerAngles(body1.q);
// wrong half-the-rotation: quat ==> const quat ;; if (q.w < 0) q = -q; return real(2) ==> return
//         (q.w < 0 ? real(-1) : real(1))
// wrong axes-body-1: body2 ==> conjugate(body1.q) * body2 ;; * conjugate(body1.q) ==>
// wrong minus: (2) ==> (-2)
// wrong normalised-axis: real(2) * vec3(q.x, q.y, q.z) ==> normalize(vec3(q.x, q.y, q.z))
// wrong nothing-inverted: conjugate(start) * conjugate(body1.q) ==> start * body1.q
// wrong q1-for-q2: body2 ==> body1
// wrong sign-by-x: w < ==> x <
// wrong sign-rule-w-alone: = -q ==> .w = -q.w
// wrong sin-angle: if (q.w < 0) q = -q; return real(2) ==> return real(2) * q.w
// wrong "start is forgotten: the initial relative rotation is not an error": * conjugate(start) ==>
// expects: C, pencil and paper, start = q2.z
// wrong start-not-inverted: conjugate(start) ==> start
// wrong start-twice: q * ==> q * conjugate(start) *
// wrong to-world-body1: real(2) * vec3(q.x, q.y, q.z) ==> to_world(body1, real(2) * vec3(q.x, q.y,
//         q.z))
// wrong never-set: return real(2) * vec3(q.x, q.y, q.z) ==> real C[3]; C[0] = 2 * q.x; C[1] = 2 *
//         q.y; return vec3(C[0], C[1], C[2])
// wrong wxy: x, ==> w, q.x, ;; y, q.z ==> y
// wrong x-y-only: q.z ==> 0
// wrong xzy: y, q.z ==> z, q.y
// wrong zero-near: return real(2) * vec3(q.x, q.y, q.z); ==> const vec3 C = real(2) * vec3(q.x,
//         q.y, q.z); return length(C) < 1e-3 ? vec3(0) : C;
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
// wrong ones-everywhere (pencil and paper, upright, turned, moved): (1) ==> (1, 1, 1, 1, 1, 1, 1,
//         1, 1)
// wrong order-of-blocks (pencil and paper, upright, turned, moved): mat3 ==> mat3(0), mat3 ;; (0),
//         mat3(1) ==> (1)
// wrong "J[2], the row C.z, repeats J[0] (pencil and paper, upright, turned, moved)": return
//         jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)); ==> Jacobian<3> J; const vec3
//         e[] = {vec3(1, 0, 0), vec3(0, 1, 0), vec3(1, 0, 0)}; for (int i = 0; i < 3; ++i) J[i] =
//         {vec3(0), -e[i], vec3(0), e[i]}; return J;
// wrong "J[2], the row C.z, is zero: was it never written? (pencil and paper, upright, turned, moved)":
//         return jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)); ==> Jacobian<3> J;
//         const vec3 e[] = {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}; for (int i = 0; i < 2;
//         ++i) J[i] = {vec3(0), -e[i], vec3(0), e[i]}; return J;
// wrong sign-body-1 (pencil and paper, upright, turned, moved): -1 ==> 1
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
