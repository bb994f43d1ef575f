// Known answers of exercise 4.2, each put in the place of the solution's.

// ---- wrong: J bodies swapped
// region: 2
// expects: Likely mistake: the sign of the whole row, or bodies 1 and 2 swapped
// expects: Likely mistake: the sign of the whole row, or bodies 1 and 2 swapped (upright, turned,
// expects: moved)
  return jacobian_from_blocks(mat3(0), mat3(1), mat3(0), mat3(-1));

// ---- wrong: J exact same sign
// region: 2
// expects: Likely mistake: the sign of skew(v) in one block: w1 holds -(s E + skew(v)), w2 s E -
// expects: skew(v) (broken)
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  if (q.w < 0) q = -q;
  const mat3 A = mat3(q.w) + skew(vec3(q.x, q.y, q.z));
  return jacobian_from_blocks(mat3(0), -A, mat3(0), A);

// ---- wrong: J exact without sign rule
// region: 2
// expects: Likely mistake: the sign of the whole row where s < 0: the sign rule belongs to s and v
// expects: of J, too (broken)
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  const mat3 s = mat3(q.w), v = skew(vec3(q.x, q.y, q.z));
  return jacobian_from_blocks(mat3(0), -(s + v), mat3(0), s - v);

// ---- wrong: J half
// region: 2
// expects: Likely mistake: a factor of 0.5 (pencil and paper, upright, turned, moved)
  return jacobian_from_blocks(mat3(0), mat3(real(-0.5)), mat3(0), mat3(real(0.5)));

// ---- wrong: J one number
// region: 2
// expects: Likely mistake: E has ones on its diagonal alone: mat3(1) (pencil and paper, upright,
// expects: turned, moved)
  return jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1, 1, 1, 1, 1, 1, 1, 1, 1));

// ---- wrong: J order
// region: 2
// expects: Likely mistake: the order of the blocks: a row is {v1, w1, v2, w2} (pencil and paper,
// expects: upright, turned, moved)
  return jacobian_from_blocks(mat3(0), mat3(0), mat3(-1), mat3(1));

// ---- wrong: J row x twice
// region: 2
// expects: Likely mistake: J[2], the row C.z, repeats J[0] (pencil and paper, upright, turned,
// expects: moved)
// change: return jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)); ==>
//         Jacobian<3> J; const vec3 e[] = {vec3(1, 0, 0), vec3(0, 1, 0), vec3(1, 0, 0)}; for (int i
//         = 0; i < 3; ++i) J[i] = {vec3(0), -e[i], vec3(0), e[i]}; return J;

// ---- wrong: J rows 0 and 1 only
// region: 2
// expects: Likely mistake: J[2], the row C.z, is zero: was it never written? (pencil and paper,
// expects: upright, turned, moved)
// change: return jacobian_from_blocks(mat3(0), mat3(-1), mat3(0), mat3(1)); ==>
//         Jacobian<3> J; const vec3 e[] = {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}; for (int i
//         = 0; i < 2; ++i) J[i] = {vec3(0), -e[i], vec3(0), e[i]}; return J;

// ---- wrong: J sign of body 1
// region: 2
// expects: Likely mistake: w1 and w2 with the same sign: C grows with w2 - w1 (pencil and paper,
// expects: upright, turned, moved)
  return jacobian_from_blocks(mat3(0), mat3(1), mat3(0), mat3(1));

// ---- wrong: J v blocks too
// region: 2
// expects: Likely mistake: the blocks v1 and v2 should be zero (pencil and paper, upright, turned,
// expects: moved)
  return jacobian_from_blocks(mat3(-1), mat3(-1), mat3(1), mat3(1));

// ---- wrong: J w1 forgotten
// region: 2
// expects: Likely mistake: the block w1 is missing (pencil and paper, upright, turned, moved)
  return jacobian_from_blocks(mat3(0), mat3(0), mat3(0), mat3(1));

// ---- wrong: J with inertia
// region: 2
// expects: Likely mistake: J times M^-1: masses and inertias come in with K (pencil and paper,
// expects: upright, turned, moved)
  return jacobian_from_blocks(mat3(0), -inverse_inertia(body1), mat3(0), inverse_inertia(body2));

// ---- wrong: J zero
// region: 2
// expects: Likely mistake: every entry is zero (pencil and paper, upright, turned, moved)
  return {};

// ---- wrong: abs components
// expects: Likely mistake: no absolute values: each number of v has a sign
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  return real(2) * abs(vec3(q.x, q.y, q.z));

// ---- wrong: angle vector
// expects: Likely mistake: the vector of the rotation itself: C is 2 v, whose length is 2 sin(
// change: real(2) * vec3(q.x, q.y, q.z) ==> glm::angle(q) * glm::axis(q)

// ---- wrong: difference of q
// expects: Likely mistake: a difference of quaternions is no rotation
  const quat q = body2.q - body1.q;
  return real(2) * vec3(q.x, q.y, q.z);

// ---- wrong: differences of angles
// expects: Likely mistake: differences of angles about three axes: these are no rotation
  return glm::eulerAngles(body2.q) - glm::eulerAngles(body1.q);

// ---- wrong: exact rows with the other sign
// region: 2
// expects: the sign of skew(v)
  const quat e = body2.q * conjugate(start) * conjugate(body1.q);
  const real s = std::abs(e.w);
  const mat3 across = skew(vec3(e.x, e.y, e.z)) * (e.w < 0 ? real(-1) : real(1));
  return jacobian_from_blocks(mat3(0), across - mat3(s), mat3(0), across + mat3(s));

// ---- wrong: half the rotation
// expects: Likely mistake: the factor 2 is forgotten: v is only half the rotation
  const quat q = body2.q * conjugate(start) * conjugate(body1.q);
  return (q.w < 0 ? real(-1) : real(1)) * vec3(q.x, q.y, q.z);

// ---- wrong: in axes of body 1
// expects: Likely mistake: in the axes of body 1: C is in the world, q2 start^-1 q1^-1
// change: body2 ==> conjugate(body1.q) * body2
// change: * conjugate(body1.q) ==>

// ---- wrong: minus
// expects: Likely mistake: the sign: body 2 is turned too far, so q2 stands first and q1 is
// expects: inverted; and -q is taken where s < 0, not where s > 0
// change: (2) ==> (-2)

// ---- wrong: normalised axis
// expects: Likely mistake: the axis alone: C is 2 v, whose length is 2 sin(angle/2)
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  if (q.w < 0) q = -q;
  return normalize(vec3(q.x, q.y, q.z));

// ---- wrong: nothing inverted
// expects: Likely mistake: start and q1 must be inverted
// change: conjugate(start) * conjugate(body1.q) ==> start * body1.q

// ---- wrong: q1 for q2
// expects: Likely mistake: body 1 alone: the rotation is that of body 2
// change: body2 ==> body1

// ---- wrong: rows with s alone
// region: 2
// expects: skew(v) is missing
  const quat e = body2.q * conjugate(start) * conjugate(body1.q);
  return jacobian_from_blocks(mat3(0), mat3(-std::abs(e.w)), mat3(0), mat3(std::abs(e.w)));

// ---- wrong: sign by x
// expects: Likely mistake: x decides which of q and -q is taken: the sign of s does
// change: w < ==> x <

// ---- wrong: sign rule forgotten
// expects: C, pencil and paper, -q2.z
// expects: Likely mistake: the sign rule is forgotten: where s < 0, take -q
  const quat q = body2.q * conjugate(start) * conjugate(body1.q);
  return real(2) * vec3(q.x, q.y, q.z);

// ---- wrong: sign rule on w alone
// expects: Likely mistake: the sign rule is forgotten: where s < 0, take -q
// change: = -q ==> .w = -q.w

// ---- wrong: sin of the angle
// expects: Likely mistake: the sine of the whole angle: it is zero again at a half turn
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  return real(2) * q.w * vec3(q.x, q.y, q.z);

// ---- wrong: start forgotten
// expects: C, pencil and paper, start = q2.z
// expects: Likely mistake: start is forgotten: the rotation that the bodies began with is no error
  quat q = body2.q * conjugate(body1.q);
  if (q.w < 0) q = -q;
  return real(2) * vec3(q.x, q.y, q.z);

// ---- wrong: start not inverted
// expects: Likely mistake: start must be inverted
// change: conjugate(start) ==> start

// ---- wrong: start twice
// expects: Likely mistake: start is taken away twice
  quat q = body2.q * conjugate(start) * conjugate(start) * conjugate(body1.q);
  if (q.w < 0) q = -q;
  return real(2) * vec3(q.x, q.y, q.z);

// ---- wrong: to_world body1
// expects: Likely mistake: turned once more with a body: q2 start^-1 q1^-1 is in the world
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  if (q.w < 0) q = -q;
  return to_world(body1, real(2) * vec3(q.x, q.y, q.z));

// ---- wrong: unset
// expects: Likely mistake: a value that was never set
// change: return real(2) * vec3(q.x, q.y, q.z) ==>
//         real C[3]; C[0] = 2 * q.x; C[1] = 2 * q.y; return vec3(C[0], C[1], C[2])

// ---- wrong: wxy
// expects: Likely mistake: the numbers w, x, y: the vector of q is (q.x, q.y, q.z)
// change: x, ==> w, q.x,
// change: y, q.z ==> y

// ---- wrong: x y only
// expects: Likely mistake: in C.z alone: C is zero, though body 2 is turned too far
// change: q.z ==> 0

// ---- wrong: xzy
// expects: Likely mistake: the numbers x, z, y: the vector of q is (q.x, q.y, q.z)
// change: y, q.z ==> z, q.y

// ---- wrong: zero near
// expects: Likely mistake: a small rotation is an error, too: no threshold belongs here
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  if (q.w < 0) q = -q;
  const vec3 C = real(2) * vec3(q.x, q.y, q.z);
  return length(C) < 1e-3 ? vec3(0) : C;

// ---- right: axis and half angle
  quat q = body2.q * conjugate(body1.q * start);
  if (q.w < 0) q = -q;
  const vec3 v(q.x, q.y, q.z);
  const real sine = length(v), angle = 2 * std::atan2(sine, q.w);
  return sine > 0 ? 2 * std::sin(angle / 2) * (v / sine) : vec3(0);

// ---- right: exact rows
// region: 2
// The slope of C at every pose, dC/dt = s w2 + w2 x v - s w1 - v x w1. Where C = 0 it is the same;
// elsewhere it gives the pair angular momentum.
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  if (q.w < 0) q = -q;
  const mat3 s = mat3(q.w), v = skew(vec3(q.x, q.y, q.z));
  return jacobian_from_blocks(mat3(0), -(s + v), mat3(0), s - v);

// ---- right: rotation matrix
  const mat3 R1 = glm::mat3_cast(body1.q), R2 = glm::mat3_cast(body2.q);
  const mat3 E = R2 * transpose(glm::mat3_cast(start)) * transpose(R1);
  quat q = glm::quat_cast(E);
  if (q.w < 0) q = -q;
  return real(2) * vec3(q.x, q.y, q.z);

// ---- right: row by row
// region: 2
// The unit matrix, row by row.
  const vec3 e[] = {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)};
  Jacobian<3> J;
  for (int i = 0; i < 3; ++i) J[i] = {vec3(0), -e[i], vec3(0), e[i]};
  return J;

// ---- right: seen from body 1 and turned back
// The rotation in the axes of body 1; its vector is turned into the world.
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  const real sign = std::copysign(real(2), q.w);
  return to_world(body1, sign * vec3(q.x, q.y, q.z));

// ---- right: sign factor
  const quat q = body2.q * conjugate(body1.q * start);
  const vec3 v(q.x, q.y, q.z);
  return q.w < 0 ? real(-2) * v : real(2) * v;

// ---- right: sign by the conjugate
// Where s < 0 only v turns its sign: s has no part in C.
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  if (q.w < 0) q = conjugate(q);
  return real(2) * vec3(q.x, q.y, q.z);

// ---- right: where it belongs
// The orientation that body 2 should have first, then the rotation from there to where it is.
  const quat wanted = body1.q * start;
  const quat q = body2.q * inverse(wanted);
  return (q.w >= 0 ? real(2) : real(-2)) * vec3(q.x, q.y, q.z);
