// wrong drawn-threshold: const real p ==> if (std::abs(q.w) < real(1e-9)) return 0; const real p
// wrong drawn-side: const real p ==> if (q.w == 0) return 0; const real p
// mistake "the sine alone: p is the sine of half the twist only where nothing swings":
//         std::atan2(p, q.w) ==> std::asin(p)
// mistake "the arguments of atan2 are exchanged: first p, then s": p, q.w ==> q.w, p
// mistake "degrees where radians belong": 2 * std::atan2(p, q.w) ==> glm::degrees(2 * std::atan2(p,
//         q.w))
// mistake "a difference of two angles: the turns are multiplied, q1^-1 q2 start^-1": *
//         conjugate(start) ==> , s = start ;; const real p = dot(vec3(q.x, q.y, q.z), a1_local);
//         return 2 * std::atan2(p, q.w); ==> if (s.w < 0) s = -s; const auto angle = [&](const
//         quat& e) { return 2 * std::atan2(dot(vec3(e.x, e.y, e.z), a1_local), e.w); }; return
//         angle(q) - angle(s);
// wrong few-digits: if (q.w < 0) q = -q; ==> ;; return ==> real angle = ;; q.w); ==> q.w); if
//         (angle > 3.14159f) angle -= 2 * 3.14159f; if (angle < -3.14159f) angle += 2 * 3.14159f;
//         return angle;
// mistake "the angle of the whole rotation: that has the swing in it, and no sign. The twist takes
//         only p, the part of v along the axis": if (q.w < 0) q = -q; ==> ;; 2 * std::atan2(p, q.w)
//         ==> glm::angle(q)
// mistake "the part of the vector along the axis: that is the twist only where nothing swings": 2 *
//         std::atan2(p, q.w) ==> glm::angle(q) * dot(glm::axis(q), a1_local)
// mistake "the angle is cut off to a whole number: an int has no fraction": return ==> const int
//         angle = ;; q.w); ==> q.w); return angle;
// mistake "`expected` does not belong here: return the measured twist, in (-pi, pi]": atan2(p, q.w)
//         ==> atan2(p, q.w) - expected
// mistake "p decides which of q and -q is taken: the sign of s does": if (q.w < 0) q = -q; ==> ;;
//         return 2 ==> if (p < 0) q = -q; return 2
// wrong "the angle of the whole rotation: that has the swing in it, and no sign. The twist takes
//         only p, the part of v along the axis":
// expects: yours expected error
// expects: 120.000000 90.000000 30.000000
  const quat q = conjugate(body1.q) * body2.q * conjugate(start);
  return 2 * std::acos(std::clamp(q.w, real(-1), real(1)));
// mistake "the rotation in world axes, and its whole angle: take q1^-1 q2, and only p":
  const quat q = body2.q * conjugate(body1.q) * conjugate(start);
  return 2 * std::atan2(length(vec3(q.x, q.y, q.z)), q.w);
// wrong "-180 in every case": const real p = ==> real p; p +=
// expects: never set
// mistake "the rotation in world axes (take q1^-1 q2), and no sign rule (s < 0: take -q)":
  const quat q = body2.q * conjugate(body1.q) * conjugate(start);
  return 2 * std::atan2(dot(vec3(q.x, q.y, q.z), a1_local), q.w);
// mistake "from 0 to 360 degrees: the angle must be in (-pi, pi]": return ==> real angle = ;; q.w);
//         ==> q.w); if (angle < 0) angle += 2 * std::numbers::pi_v<real>; return angle;
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
// mistake "the angle of the whole rotation: that has the swing in it, and no sign. The twist takes
//         only p, the part of v along the axis": if (q.w < 0) q = -q; ==> ;; (p, q.w) ==>
//         (length(vec3(q.x, q.y, q.z)), q.w)
// mistake "the angle of the whole rotation: that has the swing in it, and no sign. The twist takes
//         only p, the part of v along the axis": (p, q.w) ==> (length(vec3(q.x, q.y, q.z)), q.w)
// mistake "the angle of the whole rotation: that has the swing in it, and no sign. The twist takes
//         only p, the part of v along the axis": return 2 ==> const real size = length(vec3(q.x,
//         q.y, q.z)); return 2 ;; (p, q.w) ==> (p < 0 ? -size : size, q.w)
// mistake "the angle of the whole rotation: that has the swing in it, and no sign. The twist takes
//         only p, the part of v along the axis": if (q.w < 0) q = -q; ==> ;; return 2 ==> const
//         real size = length(vec3(q.x, q.y, q.z)); return 2 ;; (p, q.w) ==> (p < 0 ? -size : size,
//         q.w)
// mistake "the angle of the whole rotation: that has the swing in it, and no sign. The twist takes
//         only p, the part of v along the axis": 2 * std::atan2(p, q.w) ==> glm::angle(q)
// mistake "the rotation in world axes (q2 q1^-1): it changes when both bodies rotate together.
//         q1^-1 q2 is body 2 in the axes of body 1": conjugate(body1.q) * body2.q ==> body2.q *
//         conjugate(body1.q) ;; a1_local ==> to_world(body1, a1_local)
// mistake "a factor of 4: the quaternion holds half the angle, so take it twice": 2 * ==> 4 *
// mistake "the sign of the rotation: it is that of body 2 in the axes of body 1": 2 * ==> -2 *
// mistake "the sign is lost": (p, ==> (std::abs(p),
// mistake "half the range: the sine of 80 degrees is that of 100. atan2 takes p and s": 2 *
//         std::atan2(p, q.w) ==> std::asin(std::sin(2 * std::atan2(p, q.w)))
// mistake "half the range: the sine of 80 degrees is that of 100. atan2 takes p and s": 2 *
//         std::atan2(p, q.w) ==> std::asin(2 * p * q.w)
// mistake "2 p is the angle only while it is small": std::atan2(p, q.w) ==> p
// mistake "`expected` does not belong here: return the measured twist, in (-pi, pi]": 2 *
//         std::atan2(p, q.w) ==> expected + std::remainder(2 * std::atan2(p, q.w) - expected, 2 *
//         std::numbers::pi_v<real>)
// mistake "p and s are multiplied: std::atan2 takes both, their quotient is the tangent": atan2(p,
//         q.w) ==> atan(p * q.w)
// mistake "angles about three axes are no rotation: their sum along the axis is not the twist": 2 *
//         std::atan2(p, q.w) ==> dot(glm::eulerAngles(q), a1_local)
// mistake "angles about three axes are no rotation: their sum along the axis is not the twist": if
//         (q.w < 0) q = -q; ==> ;; 2 * std::atan2(p, q.w) ==> dot(glm::eulerAngles(q), a1_local)
// mistake "a difference of two angles: the turns are multiplied, q1^-1 q2 start^-1": if (q.w < 0) q
//         = -q; ==> const auto angle = [&](const quat& e) { return 2 * std::atan2(dot(vec3(e.x,
//         e.y, e.z), a1_local), e.w); }; ;; 2 * std::atan2(p, q.w) ==> angle(body2.q) -
//         angle(body1.q)
// mistake "start is forgotten, and the sign rule (where s < 0 negate all of q)": * conjugate(start)
//         ==> ;; if (q.w < 0) q = -q; ==>
// mistake "start is multiplied, not its inverse": conjugate(start) ==> start
// mistake "start stands on the wrong side, and not its inverse: q1^-1 q2 start^-1": q = ==> q =
//         start * ;; * conjugate(start) ==>
// mistake "body 1's rotation is forgotten: q1^-1 q2 start^-1": conjugate(body1.q) * ==>
// mistake "q1 is multiplied, not its inverse": conjugate(body1.q) ==> body1.q
// mistake "bodies 1 and 2 swapped": conjugate(body1.q) * body2.q ==> conjugate(body2.q) * body1.q
// mistake "bodies 1 and 2 swapped, and start is not inverted: q1^-1 q2 start^-1":
//         conjugate(body1.q) * body2.q * conjugate(start) ==> conjugate(body2.q) * body1.q * start
// mistake "bodies 1 and 2 swapped, and start is forgotten: q1^-1 q2 start^-1": conjugate(body1.q) *
//         body2.q * conjugate(start) ==> conjugate(body2.q) * body1.q
// mistake "the axis and the turn in different frames: in body 1's frame the axis is a1_local as it
//         stands": a1_local ==> conjugate(start) * a1_local
// mistake "the axis and the turn in different frames: in body 1's frame the axis is a1_local as it
//         stands": conjugate(body1.q) * body2.q * conjugate(start) ==> body2.q * conjugate(start) *
//         conjugate(body1.q)
// mistake "the axis is not used: p is v.a1_local, not one entry of v": dot(vec3(q.x, q.y, q.z),
//         a1_local) ==> q.x
// mistake "the axis is not used: p is v.a1_local, not one entry of v": dot(vec3(q.x, q.y, q.z),
//         a1_local) ==> q.y
// mistake "the axis is not used: p is v.a1_local, not one entry of v": dot(vec3(q.x, q.y, q.z),
//         a1_local) ==> q.z
// from right in one expression
// mistake "the factor 2 belongs in front of atan2, not in front of p": 2 * ==> ;; dot ==> 2 * dot
// mistake "the axis and the turn in different frames: in body 1's frame the axis is a1_local as it
//         stands": a1_local ==> to_world(body2, a1_local)
// mistake "a difference of quaternions is no rotation: q1^-1 q2": conjugate(body1.q) * ==> ;; *
//         conjugate(start); if (q.w < 0) q = - ==> - body1.
// mistake "the factor 2 is missing: a quaternion holds half the angle": 2 * ==>
// mistake "the axis and the turn in different frames: in body 1's frame the axis is a1_local as it
//         stands": a1_local ==> to_world(body1, a1_local)
// mistake "body 2 alone: the angle is that of body 2 in the axes of body 1, q1^-1 q2":
//         conjugate(body1.q) * ==> ;; * conjugate(start) ==>
// mistake "v alone changes its sign: where s < 0 negate all of q, s too": -q ==> conjugate(q)
// mistake "the sign rule the wrong way round: where s > 0 -q was taken": < 0 ==> > 0
// mistake "x decides which of q and -q is taken: the sign of s does": w ==> x
// mistake "start is forgotten": * conjugate(start) ==>
// mistake "start^-1 stands on the wrong side: q1^-1 q2 start^-1": q = ==> q = conjugate(start) * ;;
//         * conjugate(start) ==>
// mistake "the rotation in world axes (q2 q1^-1): it changes when both bodies rotate together.
//         q1^-1 q2 is body 2 in the axes of body 1": q = ==> q = body2.q * ;; * body2.q ==>
// mistake "v is not made a unit vector: its length is the sine": vec3(q.x, q.y, q.z) ==>
//         normalize(vec3(q.x, q.y, q.z))
// mistake "the numbers w, x, y: the vector of q is (q.x, q.y, q.z)": x, q.y, q.z ==> w, q.x, q.y
// from right twist from the tangent
// mistake "the quotient the wrong way round: the tangent is p / s": const ==> ;; dot ==> q.w / dot
//         ;; / q.w ==>
// mistake "no sign rule: q and -q are the same rotation. Where s < 0 take -q": ::atan ==> ::atan2
//         ;; / q ==> , q
// mistake "s alone changes its sign: where s < 0 negate all of q, p too": atan(dot(vec3(q.x, q.y,
//         q.z), a1_local) / q.w) ==> atan2(dot(vec3(q.x, q.y, q.z), a1_local), std::abs(q.w))

// region 2
// mistake "pi with too few digits: std::numbers::pi_v<real>": std::numbers::pi_v<real> ==>
//         real(3.14159)
// mistake "no absolute value: the remainder has a sign": std::remainder ==> std::abs(std::remainder
//         ;; turn); ==> turn));
// mistake "a bracket is missing: the difference expected - measured is divided by 2 pi": expected +
//         std::remainder(measured - expected, turn) ==> measured + turn * std::round(expected -
//         measured / turn)
// mistake "the angle nearest to `expected` counts, not one from 0 to 2 pi": const real turn = 2 ==>
//         if (measured < 0) return measured + 2 ;; expected + std::remainder(measured - expected,
//         turn) ==> measured
// mistake "the number of turns is cut off (as std::fmod does), not rounded: the nearest one
//         counts": return expected + std::remainder(measured - expected, turn) ==> const int k =
//         (expected - measured) / turn; return measured + turn * k
// mistake "`measured` is returned as it is: no turn is counted": return ==> return measured; return
// mistake "one turn at most is added: a fast wheel makes several of them in a step": turn = 2 * ==>
//         pi = ;; return expected + std::remainder(measured - expected, turn); ==> if (expected -
//         measured > pi) return measured + 2 * pi; if (expected - measured < -pi) return measured -
//         2 * pi; return measured;
// mistake "the sign of `expected`: the remainder is that of measured - expected": measured - ==>
//         measured +
// mistake "the number of turns is added: each of them is 2 pi": expected + std::remainder(measured
//         - expected, turn) ==> measured + std::round((expected - measured) / turn)
// mistake "the arguments of std::remainder are exchanged: first the difference, then 2 pi":
//         measured - expected, turn ==> turn, measured - expected
// mistake "half a turn off is another turn already: the nearest one counts": turn = 2 * ==> pi = ;;
//         real> ==> real>; if (std::abs(measured - expected) < 2 * pi) return measured ;; , turn
//         ==> , 2 * pi
// mistake "the turns of `expected` alone: k comes from expected - measured": expected +
//         std::remainder(measured - expected, turn) ==> measured + turn * int(expected / turn)
// mistake "`expected` is not added again after std::remainder": expected + std ==> std
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
// mistake "`expected` is returned: it decides only the turn; the angle is the measured one": return
//         expected + std::remainder(measured - expected, turn) ==> return expected
// mistake "one turn at most is added: a fast wheel makes several of them in a step": expected +
//         std::remainder(measured - expected, turn) ==> measured + turn *
//         std::clamp(std::round((expected - measured) / turn), real(-1), real(1))
// mistake "only turns back are added": expected + std::remainder(measured - expected, turn) ==>
//         measured + turn * std::min(std::round((expected - measured) / turn), real(0))
// mistake "the number of turns is rounded down: the nearest one counts": expected +
//         std::remainder(measured - expected, turn) ==> measured + turn * std::floor((expected -
//         measured) / turn)
// mistake "the number of turns is rounded up: the nearest one counts": expected +
//         std::remainder(measured - expected, turn) ==> measured + turn * std::ceil((expected -
//         measured) / turn)
// mistake "turns in the wrong direction: measured + 2 pi k": expected + std::remainder(measured -
//         expected, turn) ==> measured - turn * std::round((expected - measured) / turn)
// mistake "half turns: a whole turn is 2 pi": 2 * ==>
// mistake "degrees where radians belong: a whole turn is 2 pi": 2 * std::numbers::pi_v<real> ==>
//         360
// mistake "two turns at a time: a whole turn is 2 pi": 2 * ==> 4 *
// mistake "the turns of `expected` alone: k comes from expected - measured": expected +
//         std::remainder(measured - expected, turn) ==> measured + turn * std::round(expected /
//         turn)
// mistake "times 2 pi where it must be divided by 2 pi: how many turns is the difference?":
//         expected + std::remainder(measured - expected, turn) ==> measured + turn *
//         std::round((expected - measured) * turn)
// mistake "the remainder belongs to `expected`: expected + remainder(measured - expected, 2 pi)":
//         expected + ==> measured +
// mistake "remainder of measured alone: expected + remainder(measured - expected, 2 pi)": measured
//         - expected, ==> measured,
// mistake "the sign: expected + remainder(measured - expected, 2 pi)": expected + ==> expected -
// mistake "measured and expected are exchanged": expected + std::remainder(measured - expected, ==>
//         measured + std::remainder(expected - measured,
// mistake "the angle is folded into (-pi, pi]: it must be the one nearest to `expected`": expected
//         + std::remainder(measured - expected, ==> std::remainder(measured,
// mistake "the angle is folded into (-pi, pi]: it must be the one nearest to `expected`": expected
//         + std::remainder(measured - expected, ==> std::remainder(expected,
// mistake "pi with too few digits: std::numbers::pi_v<real>": std::numbers::pi_v<real> ==>
//         real(3.14)
// mistake "pi with too few digits: std::numbers::pi_v<real>": std::numbers::pi_v<real> ==>
//         real(3.142)
// mistake "pi with too few digits: std::numbers::pi_v<real>": std::numbers::pi_v<real> ==>
//         real(3.1416)
// mistake "pi with too few digits: std::numbers::pi_v<real>": std::numbers::pi_v<real> ==>
//         real(3.141593)
// mistake "pi with too few digits: std::numbers::pi_v<real>": std::numbers::pi_v<real> ==>
//         3.14159265f
// from right unwrapped in a loop
// mistake "half turns are added: a whole turn is 2 pi": 2 * ==> ;; 2 * ==>
// mistake "only turns forward are added": while (measured > expected + pi) measured -= 2 * pi; ==>
