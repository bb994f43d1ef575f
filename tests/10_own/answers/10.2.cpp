// mistake "the sign of the ratio: it is negative already for wheels that mesh": theta2 - ratio ==>
//         theta2 + ratio
// mistake "the sign: C grows with the angle of wheel 2": theta2 - ratio * theta1 ==> ratio * theta1
//         - theta2
// mistake "the ratio stands with the other wheel: wheel 2 turns `ratio` times as far as wheel 1":
//          theta2 - ratio * theta1 ==> ratio * theta2 - theta1
// mistake "divided by the ratio: wheel 2 turns `ratio` times as far as wheel 1": ratio * theta1 ==>
//         theta1 / ratio
// mistake "the ratio is missing": ratio * theta1 ==> theta1
// mistake "the quotient of the angles: it fails where wheel 1 is at 0": theta2 - ratio * theta1 ==>
//         theta2 / theta1 - ratio
// mistake "C is folded into half a turn: a gear that has slipped a whole turn is wrong, too":
//          return theta2 - ratio * theta1 ==> return std::remainder(theta2 - ratio * theta1, 2 *
//         std::numbers::pi_v<real>)
// mistake "the angles are folded into half a turn: they count their turns": theta2 - ratio * theta1
//         ==> std::remainder(theta2, 2 * std::numbers::pi_v<real>) - ratio * std::remainder(theta1,
//         2 * std::numbers::pi_v<real>)
// right the two terms exchanged: theta2 - ratio * theta1 ==> -ratio * theta1 + theta2
// mistake "the ratio stands with the other wheel: wheel 2 turns `ratio` times as far as wheel 1":
//         theta2 - ratio * theta1 ==> theta1 - ratio * theta2
// mistake "the ratio belongs to the angle of wheel 1 alone": theta2 - ratio * theta1 ==> ratio *
//         (theta2 - theta1)
// mistake "the angles are added: C is their difference, with the ratio": theta2 - ratio * theta1
//         ==> ratio * (theta2 + theta1)

// region 2
// mistake "the sign of the ratio": -ratio * g1 ==> ratio * g1
// mistake "the ratio stands with the other wheel": -ratio * g1, vec3(0), g2 ==> -g1, vec3(0), ratio
//         * g2
// mistake "divided by the ratio": -ratio * g1 ==> -g1 / ratio
// mistake "the ratio is missing": -ratio * g1 ==> -g1
// mistake "g1 and g2 are exchanged: each wheel has its own axle": -ratio * g1, vec3(0), g2 ==>
//         -ratio * g2, vec3(0), g1
// mistake "the axles in the place of g1 and g2: that is exact only while the wheels are straight on
//         them": -ratio * g1, vec3(0), g2 ==> -ratio * angle1.a1_local, vec3(0), angle2.a1_local
// mistake "wheel 2 is missing": vec3(0), g2 ==> vec3(0), vec3(0)
// mistake "g1 and g2 stand in v1 and v2: a wheel turns": {vec3(0), -ratio * g1, vec3(0), g2} ==>
//         {-ratio * g1, vec3(0), g2, vec3(0)}
// right the row by its members: return {vec3(0), -ratio * g1, vec3(0), g2} ==> Row J; J.w1 = -ratio
//         * g1; J.w2 = g2; return J
// mistake "the sign of the whole row": -ratio * g1, vec3(0), g2 ==> ratio * g1, vec3(0), -g2
// mistake "the ratio stands with the other wheel": -ratio * g1, vec3(0), g2 ==> g1, vec3(0), -ratio
//         * g2
// mistake "the ratio stands with both wheels: C is angle 2 less ratio times angle 1": -ratio * g1,
//         vec3(0), g2 ==> -ratio * g1, vec3(0), ratio * g2
// mistake "g2 for both wheels: each has its own axle": -ratio * g1, vec3(0), g2 ==> -ratio * g2,
//         vec3(0), g2
// mistake "g1 for both wheels: each has its own axle": -ratio * g1, vec3(0), g2 ==> -ratio * g1,
//         vec3(0), g1
// mistake "wheel 1 is missing": -ratio * g1, vec3(0), g2 ==> vec3(0), vec3(0), g2

// region 3
// mistake "the angle now: in a fast step a wheel turns by more than half a turn, so the rate
//         belongs to it (Eq. 3-12)": + h * dot(slope_of(angle1, body1), body1.w) ==> ;; + h *
//         dot(slope_of(angle2, body2), body2.w) ==>
// mistake "the sign of the rate: the step is still to come": + h * dot(slope_of(angle1 ==> - h *
//         dot(slope_of(angle1 ;; + h * dot(slope_of(angle2 ==> - h * dot(slope_of(angle2
// mistake "h is missing: a rate is no angle": + h * ==> + ;; + h * ==> +
// mistake "the old expected value is moved on and the angle never measured: its errors add up": =
//         angle_of(angle1, body1) ==> = angle1.expected ;; = angle_of(angle2, body2) ==> =
//         angle2.expected
// mistake "the angle is missing": = angle_of(angle1, body1) + ==> = ;; = angle_of(angle2, body2) +
//         ==> =
// mistake "the length of w has no sign: the rate is g.w": dot(slope_of(angle1, body1), body1.w) ==>
//         length(body1.w) ;; dot(slope_of(angle2, body2), body2.w) ==> length(body2.w)
// wrong units "h is missing": + h * ==> + ;; + h * ==> +
// right in a loop over both:
  for (auto [angle, body] : {std::pair(&angle1, &body1), std::pair(&angle2, &body2)})
    angle->expected = angle_of(*angle, *body) + h * dot(slope_of(*angle, *body), body->w);
// mistake "nothing is set": angle1.expected = angle_of(angle1, body1) + h * dot(slope_of(angle1,
//         body1), body1.w); ==> ;; angle2.expected = angle_of(angle2, body2) + h *
//         dot(slope_of(angle2, body2), body2.w); ==>
// mistake "w is turned into the axes of its body: g and w are both in the world":
//         dot(slope_of(angle1, body1), body1.w) ==> dot(slope_of(angle1, body1), to_local(body1,
//         body1.w)) ;; dot(slope_of(angle2, body2), body2.w) ==> dot(slope_of(angle2, body2),
//         to_local(body2, body2.w))
// mistake "w is turned with its body once more: it is in the world already": dot(slope_of(angle1,
//         body1), body1.w) ==> dot(slope_of(angle1, body1), to_world(body1, body1.w)) ;;
//         dot(slope_of(angle2, body2), body2.w) ==> dot(slope_of(angle2, body2), to_world(body2,
//         body2.w))
// mistake "the rate has a sign": dot(slope_of(angle1, body1), body1.w) ==>
//         std::abs(dot(slope_of(angle1, body1), body1.w)) ;; dot(slope_of(angle2, body2), body2.w)
//         ==> std::abs(dot(slope_of(angle2, body2), body2.w))
// mistake "the axle in the place of g: that is exact only while the wheel is straight on it":
//         dot(slope_of(angle1, body1), body1.w) ==> dot(angle1.a1_local, body1.w) ;;
//         dot(slope_of(angle2, body2), body2.w) ==> dot(angle2.a1_local, body2.w)
// mistake "the wheels are exchanged in the rates: each has its own w": dot(slope_of(angle1, body1),
//         body1.w) ==> dot(slope_of(angle1, body1), body2.w) ;; dot(slope_of(angle2, body2),
//         body2.w) ==> dot(slope_of(angle2, body2), body1.w)
// mistake "half of the step: h, not h / 2": dot(slope_of(angle1, body1), body1.w) ==>
//         dot(slope_of(angle1, body1), body1.w) / 2 ;; dot(slope_of(angle2, body2), body2.w) ==>
//         dot(slope_of(angle2, body2), body2.w) / 2
// mistake "h is the argument, not 1/60": h * ==> real(1) / 60 * ;; h * ==> real(1) / 60 *
// mistake "the angle is added to the old expected value: it takes its place": angle1.expected = ==>
//         angle1.expected += ;; angle2.expected = ==> angle2.expected +=
// mistake "the wheels are exchanged: angle1 is that of body 1": angle1.expected = angle_of(angle1,
//         body1) + h * dot(slope_of(angle1, body1), body1.w); ==> ;; angle2.expected =
//         angle_of(angle2, body2) + h * dot(slope_of(angle2, body2), body2.w); ==> const real first
//         = angle_of(angle1, body1) + h * dot(slope_of(angle1, body1), body1.w); angle1.expected =
//         angle_of(angle2, body2) + h * dot(slope_of(angle2, body2), body2.w); angle2.expected =
//         first;
// mistake "wheel 2 is never set": angle2.expected = angle_of(angle2, body2) + h *
//         dot(slope_of(angle2, body2), body2.w); ==>
// mistake "wheel 1 is never set": angle1.expected = angle_of(angle1, body1) + h *
//         dot(slope_of(angle1, body1), body1.w); ==>
// mistake "wheel 2 is expected where the ratio puts it: measure it, too": angle2.expected =
//         angle_of(angle2, body2) + h * dot(slope_of(angle2, body2), body2.w); ==> angle2.expected
//         = ratio * angle1.expected;
// wrong "angle1.expected at 1e-08 rad/s": dot(slope_of(angle1, body1), body1.w) ==>
//         dot(slope_of(angle1, body1), length(body1.w) < real(1e-7) ? vec3(0) : body1.w)
// wrong "angle2.expected at 3e+07 rad": = angle_of(angle2, body2) ==> =
//         glm::min(angle_of(angle2, body2), real(1e6))
