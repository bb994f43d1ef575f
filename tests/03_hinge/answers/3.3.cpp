// Known answers of exercise 3.3, each put in the place of the solution's.

// ---- wrong: factor two forgotten
// expects: Likely mistake: the factor 2 is missing: a quaternion holds half the angle
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: frames mixed
// expects: Likely mistake: the axis and the turn in different frames: in body 1's frame the axis is
// expects: a1_local as it stands
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), to_world(body1, a1_local)), q.w);

// ---- wrong: no sign rule
// expects: Likely mistake: no sign rule: q and -q are the same turn. Where s < 0 turn all of q
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: sign of s alone
// expects: s alone changes its sign
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), std::abs(q.w));

// ---- wrong: start forgotten
// expects: Likely mistake: start is forgotten
  quat q = conjugate(body1.q) * body2.q;
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: start on the wrong side
// expects: Likely mistake: start^-1 stands on the wrong side: q1^-1 q2 start^-1
  quat q = conjugate(start) * conjugate(body1.q) * body2.q;
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: total angle
// expects: yours expected error
// expects: 120.000000 90.000000 30.000000
// expects: Likely mistake: the angle of the whole turn: that has the swing in it, and no sign. The
// expects: twist takes only p, the part of v along the axis
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::acos(std::clamp(q.w, real(-1), real(1)));

// ---- wrong: total angle in the world
// expects: Likely mistake: the turn as the world sees it, and its whole angle: take q1^-1 q2, and
// expects: only p
  const quat q = body2.q * conjugate(body1.q) * conjugate(start);
  return 2 * std::atan2(length(vec3(q.x, q.y, q.z)), q.w);

// ---- wrong: turn in the world
// expects: Likely mistake: the turn as the world sees it (q2 q1^-1): it changes when both bodies
// expects: turn as one. q1^-1 q2 is body 2 as body 1 sees it
  quat q = body2.q * conjugate(body1.q) * conjugate(start);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: unwrapped measured
// region: 2
// expects: Likely mistake: `measured` is returned as it is: no turn is counted
  return measured;

// ---- wrong: unwrapped one turn
// region: 2
// expects: Likely mistake: one turn at most is added: a fast wheel makes several of them in a step
  const real pi = std::numbers::pi_v<real>;
  if (expected - measured > pi) return measured + 2 * pi;
  if (expected - measured < -pi) return measured - 2 * pi;
  return measured;

// ---- wrong: unwrapped without expected
// region: 2
// expects: Likely mistake: `expected` is not added again after std::remainder
  return std::remainder(measured - expected, 2 * std::numbers::pi_v<real>);

// ---- wrong: world frame and no sign rule
// expects: and no sign rule
  const quat q = body2.q * conjugate(body1.q) * conjugate(start);
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- right: twist from the arc cosine
// The twist alone, s over the length of (s, p), and the sign of p.
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  const real p = dot(vec3(q.x, q.y, q.z), a1_local);
  const real angle = 2 * std::acos(std::min(q.w / std::hypot(q.w, p), real(1)));
  return p < 0 ? -angle : angle;

// ---- right: twist from the opposite turn
// -q instead of q where s > 0: then both signs turn, in s and in p.
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w > 0) q = -q;
  const real p = dot(vec3(q.x, q.y, q.z), a1_local);
  return 2 * std::atan2(-p, -q.w);

// ---- right: twist from the tangent
// p/s is the same for q and -q, and atan stays within a quarter turn: no rule of signs is needed.
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::atan(dot(vec3(q.x, q.y, q.z), a1_local) / q.w);

// ---- right: twist in the world
// The relative turn in world axes, with the axis in world axes.
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), to_world(body1, a1_local)), q.w);

// ---- right: unwrapped in a loop
// region: 2
// Turn by turn.
  const real pi = std::numbers::pi_v<real>;
  while (measured < expected - pi) measured += 2 * pi;
  while (measured > expected + pi) measured -= 2 * pi;
  return measured;

// ---- right: unwrapped with floor
// region: 2
// Half a turn more and rounded down is rounded to the nearest.
  const real turn = 2 * std::numbers::pi_v<real>;
  return measured + turn * std::floor((expected - measured) / turn + real(0.5));
