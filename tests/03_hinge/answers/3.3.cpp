// Known answers of exercise 3.3, each put in the place of the solution's.

// ---- wrong: asin of p
// expects: Likely mistake: the sine alone: p is the sine of half the twist only where nothing
// expects: swings
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return 2 * std::asin(dot(vec3(q.x, q.y, q.z), a1_local));

// ---- wrong: atan of ratio reversed
// expects: Likely mistake: the quotient the wrong way round: the tangent is p / s
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::atan(q.w / dot(vec3(q.x, q.y, q.z), a1_local));

// ---- wrong: atan2 exchanged
// expects: Likely mistake: the arguments of atan2 are exchanged: first p, then s
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(q.w, dot(vec3(q.x, q.y, q.z), a1_local));

// ---- wrong: atan2 of double angle
// expects: Likely mistake: the factor 2 belongs in front of atan2, not in front of p
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return std::atan2(2 * dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: axis with body 2
// expects: Likely mistake: the axis and the turn in different frames: in body 1's frame the axis is
// expects: a1_local as it stands
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), to_world(body2, a1_local)), q.w);

// ---- wrong: degrees
// expects: Likely mistake: degrees where radians belong
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return glm::degrees(2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w));

// ---- wrong: difference
// expects: Likely mistake: a difference of quaternions is no rotation: q1^-1 q2
  quat q = body2.q - body1.q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: difference of angles
// expects: Likely mistake: a difference of two angles: the turns are multiplied, q1^-1 q2 start^-1
  quat q = conjugate(body1.q) * body2.q, s = start;
  if (q.w < 0) q = -q;
  if (s.w < 0) s = -s;
  const auto angle = [&](const quat& e) {
    return 2 * std::atan2(dot(vec3(e.x, e.y, e.z), a1_local), e.w);
  };
  return angle(q) - angle(s);

// ---- wrong: factor two forgotten
// expects: Likely mistake: the factor 2 is missing: a quaternion holds half the angle
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: float literal pi in twist
// expects: Likely mistake: right to a few digits only: is there a float among the reals
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  real angle = 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);
  if (angle > 3.14159f) angle -= 2 * 3.14159f;
  if (angle < -3.14159f) angle += 2 * 3.14159f;
  return angle;

// ---- wrong: frames mixed
// expects: Likely mistake: the axis and the turn in different frames: in body 1's frame the axis is
// expects: a1_local as it stands
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), to_world(body1, a1_local)), q.w);

// ---- wrong: glm angle
// expects: Likely mistake: the angle of the whole rotation: that has the swing in it, and no sign.
// expects: The twist takes only p, the part of v along the axis
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return glm::angle(q);

// ---- wrong: glm angle with sign
// expects: Likely mistake: the part of the vector along the axis: that is the twist only
// expects: where nothing swings
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return glm::angle(q) * dot(glm::axis(q), a1_local);

// ---- wrong: int angle
// expects: Likely mistake: the angle is cut off to a whole number: an int has no fraction
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  const int angle = 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);
  return angle;

// ---- wrong: minus expected
// expects: Likely mistake: `expected` is not asked for here: the twist is what is measured, in
// expects: (-pi, pi]
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w) - expected;

// ---- wrong: no sign rule
// expects: Likely mistake: no sign rule: q and -q are the same rotation. Where s < 0 take -q
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: only body 2
// expects: Likely mistake: body 2 alone: the angle is that of body 2 as body 1 sees it, q1^-1 q2
  quat q = body2.q;
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: sign of s alone
// expects: s alone changes its sign
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), std::abs(q.w));

// ---- wrong: sign rule by conjugate
// expects: Likely mistake: v alone changes its sign: where s < 0 negate all of q, s too
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = conjugate(q);
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: sign rule by p
// expects: Likely mistake: p decides which of q and -q is taken: the sign of s does
// change: if (q.w < 0) q = -q; ==>
// change: return 2 ==> if (p < 0) q = -q; return 2

// ---- wrong: sign rule on w > 0
// expects: Likely mistake: the sign rule the wrong way round: where s > 0 -q was taken
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w > 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: sign rule on x
// expects: Likely mistake: x decides which of q and -q is taken: the sign of s does
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.x < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

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
// expects: Likely mistake: the angle of the whole rotation: that has the swing in it, and no sign.
// expects: The twist takes only p, the part of v along the axis
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::acos(std::clamp(q.w, real(-1), real(1)));

// ---- wrong: total angle in the world
// expects: Likely mistake: the rotation as the world sees it, and its whole angle: take q1^-1 q2,
// expects: and only p
  const quat q = body2.q * conjugate(body1.q) * conjugate(start);
  return 2 * std::atan2(length(vec3(q.x, q.y, q.z)), q.w);

// ---- wrong: turn in the world
// expects: Likely mistake: the rotation as the world sees it (q2 q1^-1): it changes when both
// expects: bodies turn as one. q1^-1 q2 is body 2 as body 1 sees it
  quat q = body2.q * conjugate(body1.q) * conjugate(start);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: unset p
// expects: never set
// change: const real p = dot(vec3(q.x, q.y, q.z), a1_local) ==>
//         real p; p += q.x * a1_local.x; p += q.y * a1_local.y; p += q.z * a1_local.z

// ---- wrong: unwrapped 3.14159
// region: 2
// expects: Likely mistake: pi with too few digits: std::numbers::pi_v<real>
  return expected + std::remainder(measured - expected, real(2 * 3.14159));

// ---- wrong: unwrapped abs
// region: 2
// expects: Likely mistake: no absolute value: what remains has a sign
  return expected + std::abs(std::remainder(measured - expected, 2 * std::numbers::pi_v<real>));

// ---- wrong: unwrapped bracket forgotten
// region: 2
// expects: Likely mistake: a bracket is missing: the difference expected - measured is divided by 2
// expects: pi
  const real turn = 2 * std::numbers::pi_v<real>;
  return measured + turn * std::round(expected - measured / turn);

// ---- wrong: unwrapped if
// region: 2
// expects: Likely mistake: the angle nearest to `expected` counts, not one from 0 to 2 pi
  if (measured < 0) return measured + 2 * std::numbers::pi_v<real>;
  return measured;

// ---- wrong: unwrapped int truncation
// region: 2
// expects: Likely mistake: the number of turns is cut off (as std::fmod does), not rounded: the
// expects: nearest one counts
// change: return expected + std::remainder(measured - expected, turn) ==>
//         const int k = (expected - measured) / turn; return measured + turn * k

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

// ---- wrong: unwrapped plus
// region: 2
// expects: Likely mistake: the sign of `expected`: what remains is of measured - expected
  return expected + std::remainder(measured + expected, 2 * std::numbers::pi_v<real>);

// ---- wrong: unwrapped round no turn
// region: 2
// expects: Likely mistake: the number of turns is added: each of them is 2 pi
  const real turn = 2 * std::numbers::pi_v<real>;
  return measured + std::round((expected - measured) / turn);

// ---- wrong: unwrapped swapped remainder args
// region: 2
// expects: Likely mistake: the arguments of std::remainder are exchanged: first the difference,
// expects: then 2 pi
  return expected + std::remainder(2 * std::numbers::pi_v<real>, measured - expected);

// ---- wrong: unwrapped threshold only when far
// region: 2
// expects: Likely mistake: half a turn off is another turn already: the nearest one counts
  const real pi = std::numbers::pi_v<real>;
  if (std::abs(measured - expected) < 2 * pi) return measured;
  return expected + std::remainder(measured - expected, 2 * pi);

// ---- wrong: unwrapped truncation of expected/turn
// region: 2
// expects: Likely mistake: the turns of `expected` alone: k comes from expected - measured
  const real turn = 2 * std::numbers::pi_v<real>;
  return measured + turn * int(expected / turn);

// ---- wrong: unwrapped while adds pi
// region: 2
// expects: Likely mistake: half turns are added: a whole turn is 2 pi
  const real pi = std::numbers::pi_v<real>;
  while (measured < expected - pi) measured += pi;
  while (measured > expected + pi) measured -= pi;
  return measured;

// ---- wrong: unwrapped while one side
// region: 2
// expects: Likely mistake: only turns forward are added
  const real pi = std::numbers::pi_v<real>;
  while (measured < expected - pi) measured += 2 * pi;
  return measured;

// ---- wrong: unwrapped without expected
// region: 2
// expects: Likely mistake: `expected` is not added again after std::remainder
  return std::remainder(measured - expected, 2 * std::numbers::pi_v<real>);

// ---- wrong: v made a unit vector
// expects: Likely mistake: v is not made a unit vector: its length is the sine
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(normalize(vec3(q.x, q.y, q.z)), a1_local), q.w);

// ---- wrong: vector q.w q.x q.y
// expects: Likely mistake: the numbers w, x, y: the vector of q is (q.x, q.y, q.z)
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.w, q.x, q.y), a1_local), q.w);

// ---- wrong: world frame and no sign rule
// expects: and no sign rule
  const quat q = body2.q * conjugate(body1.q) * conjugate(start);
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);

// ---- wrong: wrapped to 0..2pi
// expects: Likely mistake: from 0 to 360 degrees: the angle must be in (-pi, pi]
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  real angle = 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);
  if (angle < 0) angle += 2 * std::numbers::pi_v<real>;
  return angle;

// ---- wrong: zero below epsilon
// expects: Likely mistake: what is small has become 0: no threshold belongs here
// change: return 2 ==> if (std::abs(p) < 1e-2) return 0; return 2

// ---- right: twist from the arc cosine
// The twist alone, s over the length of (s, p), and the sign of p.
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  const real p = dot(vec3(q.x, q.y, q.z), a1_local);
  const real angle = 2 * std::acos(std::min(q.w / std::hypot(q.w, p), real(1)));
  return p < 0 ? -angle : angle;

// ---- right: twist from the double angle
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  const real p = dot(vec3(q.x, q.y, q.z), a1_local);
  return std::atan2(2 * p * q.w, q.w * q.w - p * p);

// ---- right: twist from the inverse turn
  quat q = inverse(start * inverse(inverse(body1.q) * body2.q));
  const real sign = q.w < 0 ? -1 : 1;
  return 2 * std::atan2(sign * dot(vec3(q.x, q.y, q.z), a1_local), sign * q.w);

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

// ---- right: twist made a unit quaternion
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  const real p = dot(vec3(q.x, q.y, q.z), a1_local);
  quat twist = normalize(quat(q.w, p * a1_local.x, p * a1_local.y, p * a1_local.z));
  if (twist.w < 0) twist = -twist;
  return 2 * std::atan2(dot(vec3(twist.x, twist.y, twist.z), a1_local), twist.w);

// ---- right: twist with a remainder
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  const real p = dot(vec3(q.x, q.y, q.z), a1_local);
  return std::remainder(2 * std::atan2(p, q.w), 2 * std::numbers::pi_v<real>);

// ---- right: unwrapped in a loop
// region: 2
// Turn by turn.
  const real pi = std::numbers::pi_v<real>;
  while (measured < expected - pi) measured += 2 * pi;
  while (measured > expected + pi) measured -= 2 * pi;
  return measured;

// ---- right: unwrapped lround
// region: 2
  const real turn = 2 * std::numbers::pi_v<real>;
  return measured + turn * std::lround((expected - measured) / turn);

// ---- right: unwrapped nearbyint
// region: 2
  const real turn = 2 * std::numbers::pi_v<real>;
  return measured - turn * std::nearbyint((measured - expected) / turn);

// ---- right: unwrapped via atan2
// region: 2
  const real d = measured - expected;
  return expected + std::atan2(std::sin(d), std::cos(d));

// ---- right: unwrapped with floor
// region: 2
// Half a turn more and rounded down is rounded to the nearest.
  const real turn = 2 * std::numbers::pi_v<real>;
  return measured + turn * std::floor((expected - measured) / turn + real(0.5));
