// Known answers of exercise 4.2, each put in the place of the solution's.

// ---- wrong: J bodies swapped
// region: 2
// expects: Likely mistake: the sign of the whole row, or bodies 1 and 2 swapped
// expects: Likely mistake: the sign of the whole row, or bodies 1 and 2 swapped (upright, turned,
// expects: moved)
  return jacobian_from_blocks(mat3(0), mat3(1), mat3(0), mat3(-1));

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

// ---- wrong: half the turn
// expects: Likely mistake: the factor 2 is forgotten: v is only half the turn
  const quat q = body2.q * conjugate(start) * conjugate(body1.q);
  return (q.w < 0 ? real(-1) : real(1)) * vec3(q.x, q.y, q.z);

// ---- wrong: in axes of body 1
// expects: Likely mistake: in the axes of body 1: C is in the world, q2 start^-1 q1^-1
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return real(2) * vec3(q.x, q.y, q.z);

// ---- wrong: rows with s alone
// region: 2
// expects: skew(v) is missing
  const quat e = body2.q * conjugate(start) * conjugate(body1.q);
  return jacobian_from_blocks(mat3(0), mat3(-std::abs(e.w)), mat3(0), mat3(std::abs(e.w)));

// ---- wrong: sign rule forgotten
// expects: C, pencil and paper, -q2.z
// expects: Likely mistake: the sign rule is forgotten: where s < 0, take -q
  const quat q = body2.q * conjugate(start) * conjugate(body1.q);
  return real(2) * vec3(q.x, q.y, q.z);

// ---- wrong: start forgotten
// expects: C, pencil and paper, start = q2.z
// expects: Likely mistake: start is forgotten: the turn that the bodies began with is no error
  quat q = body2.q * conjugate(body1.q);
  if (q.w < 0) q = -q;
  return real(2) * vec3(q.x, q.y, q.z);

// ---- right: exact rows
// region: 2
// The slope of C at every pose, dC/dt = s w2 + w2 x v - s w1 - v x w1. Where C = 0 it is the same;
// elsewhere it gives the pair angular momentum.
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  if (q.w < 0) q = -q;
  const mat3 s = mat3(q.w), v = skew(vec3(q.x, q.y, q.z));
  return jacobian_from_blocks(mat3(0), -(s + v), mat3(0), s - v);

// ---- right: row by row
// region: 2
// The unit matrix, row by row.
  const vec3 e[] = {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)};
  Jacobian<3> J;
  for (int i = 0; i < 3; ++i) J[i] = {vec3(0), -e[i], vec3(0), e[i]};
  return J;

// ---- right: seen from body 1 and turned back
// The turn in the axes of body 1; its vector is turned into the world.
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  const real sign = std::copysign(real(2), q.w);
  return to_world(body1, sign * vec3(q.x, q.y, q.z));

// ---- right: where it belongs
// The orientation that body 2 should have first, then the turn from there to where it is.
  const quat wanted = body1.q * start;
  const quat q = body2.q * inverse(wanted);
  return (q.w >= 0 ? real(2) : real(-2)) * vec3(q.x, q.y, q.z);
