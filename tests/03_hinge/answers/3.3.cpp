// wrong drawn-threshold: const real p ==> if (std::abs(q.w) < real(1e-9)) return 0; const real p
// wrong drawn-side: const real p ==> if (q.w == 0) return 0; const real p
// wrong asin-of-p: std::atan2(p, q.w) ==> std::asin(p)
// wrong atan2-exchanged: p, q.w ==> q.w, p
// wrong degrees: 2 * std::atan2(p, q.w) ==> glm::degrees(2 * std::atan2(p, q.w))
// wrong difference-of-angles: * conjugate(start) ==> , s = start ;; const real p = dot(vec3(q.x,
//         q.y, q.z), a1_local); return 2 * std::atan2(p, q.w); ==> if (s.w < 0) s = -s; const auto
//         angle = [&](const quat& e) { return 2 * std::atan2(dot(vec3(e.x, e.y, e.z), a1_local),
//         e.w); }; return angle(q) - angle(s);
// wrong few-digits: if (q.w < 0) q = -q; ==> ;; return ==> real angle = ;; q.w); ==> q.w); if
//         (angle > 3.14159f) angle -= 2 * 3.14159f; if (angle < -3.14159f) angle += 2 * 3.14159f;
//         return angle;
// wrong glm-angle: if (q.w < 0) q = -q; ==> ;; 2 * std::atan2(p, q.w) ==> glm::angle(q)
// wrong glm-angle-sign: 2 * std::atan2(p, q.w) ==> glm::angle(q) * dot(glm::axis(q), a1_local)
// wrong int-angle: return ==> const int angle = ;; q.w); ==> q.w); return angle;
// wrong minus-expected: atan2(p, q.w) ==> atan2(p, q.w) - expected
// wrong sign-rule-p: if (q.w < 0) q = -q; ==> ;; return 2 ==> if (p < 0) q = -q; return 2
// wrong "the angle of the whole rotation: that has the swing in it, and no sign. The twist takes only p, the part of v along the axis":
// expects: yours expected error
// expects: 120.000000 90.000000 30.000000
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::acos(std::clamp(q.w, real(-1), real(1)));
// wrong total-angle-world:
  const quat q = body2.q * conjugate(body1.q) * conjugate(start);
  return 2 * std::atan2(length(vec3(q.x, q.y, q.z)), q.w);
// wrong "-180 in every case": const real p = ==> real p; p +=
// expects: never set
// wrong world-frame-no-sign:
  const quat q = body2.q * conjugate(body1.q) * conjugate(start);
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);
// wrong wrapped-0-2pi: return ==> real angle = ;; q.w); ==> q.w); if (angle < 0) angle += 2 *
//         std::numbers::pi_v<real>; return angle;
// wrong threshold: return 2 ==> if (std::abs(p) < 1e-2) return 0; return 2
// right twist from the arc cosine: return 2 * std::atan2(p, q.w); ==> const real angle = 2 *
//         std::acos(std::min(q.w / std::hypot(q.w, p), real(1))); return p < 0 ? -angle : angle;
// right twist from the double angle: quat ==> const quat ;; ; if (q.w < 0) q = -q ==> ;; 2 *
//         std::atan2(p, q.w) ==> std::atan2(2 * p * q.w, q.w * q.w - p * p)
// right twist from the inverse turn:
  quat q = inverse(start * inverse(inverse(body1.q) * body2.q));
  const real sign = q.w < 0 ? -1 : 1;
  return 2 * std::atan2(sign * dot(vec3(q.x, q.y, q.z), a1_local), sign * q.w);
// right twist from the opposite turn: < 0 ==> > 0 ;; p, q ==> -p, -q
// right twist from the tangent:
  // p/s is the same for q and -q, and atan stays within a quarter turn: no rule of signs is needed.
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::atan(dot(vec3(q.x, q.y, q.z), a1_local) / q.w);
// right twist in the world:
  // The relative turn in world axes, with the axis in world axes.
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), to_world(body1, a1_local)), q.w);
// right twist made a unit quaternion: quat ==> const quat ;; ; if (q.w < 0) q = -q ==> ;; return
//         ==> quat twist = normalize(quat(q.w, p * a1_local.x, p * a1_local.y, p * a1_local.z)); if
//         (twist.w < 0) twist = -twist; return ;; p, q ==> dot(vec3(twist.x, twist.y, twist.z),
//         a1_local), twist
// right twist with a remainder:
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  const real p = dot(vec3(q.x, q.y, q.z), a1_local);
  return std::remainder(2 * std::atan2(p, q.w), 2 * std::numbers::pi_v<real>);
// right in one expression:
  quat q = conjugate(body1.q) * body2.q * conjugate(start);
  if (q.w < 0) q = -q;
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);
// from right in one expression
// wrong atan2-double-angle: 2 * ==> ;; dot ==> 2 * dot
// wrong axis-turn-different-frames: a1_local ==> to_world(body2, a1_local)
// wrong difference: conjugate(body1.q) * ==> ;; * conjugate(start); if (q.w < 0) q = - ==> - body1.
// wrong factor-two-forgotten: 2 * ==>
// wrong axis-turn-different-frames: a1_local ==> to_world(body1, a1_local)
// wrong only-body-2: conjugate(body1.q) * ==> ;; * conjugate(start) ==>
// wrong sign-rule-conjugate: -q ==> conjugate(q)
// wrong sign-rule-w-0: < 0 ==> > 0
// wrong sign-rule-x: w ==> x
// wrong start-forgotten: * conjugate(start) ==>
// wrong start-wrong-side: q = ==> q = conjugate(start) * ;; * conjugate(start) ==>
// wrong turn-world: q = ==> q = body2.q * ;; * body2.q ==>
// wrong v-made-unit-vector: vec3(q.x, q.y, q.z) ==> normalize(vec3(q.x, q.y, q.z))
// wrong vector-q-w-q: x, q.y, q.z ==> w, q.x, q.y
// from right twist from the tangent
// wrong atan-ratio-reversed: const ==> ;; dot ==> q.w / dot ;; / q.w ==>
// wrong no-sign-rule: ::atan ==> ::atan2 ;; / q ==> , q
// wrong sign-s-alone: atan(dot(vec3(q.x, q.y, q.z), a1_local) / q.w) ==> atan2(dot(vec3(q.x, q.y,
//         q.z), a1_local), std::abs(q.w))

// region 2
// wrong 3-14159: std::numbers::pi_v<real> ==> real(3.14159)
// wrong abs: std::remainder ==> std::abs(std::remainder ;; turn); ==> turn));
// wrong bracket-forgotten: expected + std::remainder(measured - expected, turn) ==> measured + turn
//         * std::round(expected - measured / turn)
// wrong if: const real turn = 2 ==> if (measured < 0) return measured + 2 ;; expected +
//         std::remainder(measured - expected, turn) ==> measured
// wrong int-truncation: return expected + std::remainder(measured - expected, turn) ==> const int k
//         = (expected - measured) / turn; return measured + turn * k
// wrong measured: return ==> return measured; return
// wrong one-turn: turn = 2 * ==> pi = ;; return expected + std::remainder(measured - expected,
//         turn); ==> if (expected - measured > pi) return measured + 2 * pi; if (expected -
//         measured < -pi) return measured - 2 * pi; return measured;
// wrong plus: measured - ==> measured +
// wrong round-no-turn: expected + std::remainder(measured - expected, turn) ==> measured +
//         std::round((expected - measured) / turn)
// wrong swapped-remainder-args: measured - expected, turn ==> turn, measured - expected
// wrong threshold-only-when-far: turn = 2 * ==> pi = ;; real> ==> real>; if (std::abs(measured -
//         expected) < 2 * pi) return measured ;; , turn ==> , 2 * pi
// wrong truncation-expected-turn: expected + std::remainder(measured - expected, turn) ==> measured
//         + turn * int(expected / turn)
// wrong without-expected: expected + std ==> std
// right unwrapped in a loop: turn = 2 * ==> pi = ;; return expected + std::remainder(measured -
//         expected, turn); ==> while (measured < expected - pi) measured += 2 * pi; while (measured
//         > expected + pi) measured -= 2 * pi; return measured;
// right unwrapped lround: expected + std::remainder(measured - expected, turn) ==> measured + turn
//         * std::lround((expected - measured) / turn)
// right unwrapped nearbyint: expected + std::remainder(measured - expected, turn) ==> measured -
//         turn * std::nearbyint((measured - expected) / turn)
// right unwrapped via atan2: turn = 2 * std::numbers::pi_v<real> ==> d = measured - expected ;;
//         remainder(measured - expected, turn) ==> atan2(std::sin(d), std::cos(d))
// right unwrapped with floor: expected + std::remainder(measured - expected, turn) ==> measured +
//         turn * std::floor((expected - measured) / turn + real(0.5))
// from right unwrapped in a loop
// wrong while-adds-pi: 2 * ==> ;; 2 * ==>
// wrong while-one-side: while (measured > expected + pi) measured -= 2 * pi; ==>
