// wrong "the sign of the ratio: it is negative already for wheels": theta2 - ratio ==> theta2 +
//         ratio
// wrong "the sign: C grows with the angle of wheel 2": theta2 - ratio * theta1 ==> ratio * theta1
//         - theta2
// wrong "the ratio stands with the other wheel: wheel 2 turns": theta2 - ratio * theta1 ==> ratio
//         * theta2 - theta1
// wrong "divided by the ratio: wheel 2 turns `ratio` times as far": ratio * theta1 ==> theta1 /
//         ratio
// wrong "the ratio is missing": ratio * theta1 ==> theta1
// wrong "the quotient of the angles: it fails where wheel 1 is at 0": theta2 - ratio * theta1 ==>
//         theta2 / theta1 - ratio
// wrong "C is folded into half a turn: a gear that has slipped a": return theta2 - ratio * theta1
//         ==> return std::remainder(theta2 - ratio * theta1, 2 * std::numbers::pi_v<real>)
// wrong "the angles are folded into half a turn: they count their": theta2 - ratio * theta1 ==>
//         std::remainder(theta2, 2 * std::numbers::pi_v<real>) - ratio * std::remainder(theta1, 2
//         * std::numbers::pi_v<real>)
// right the two terms exchanged: theta2 - ratio * theta1 ==> -ratio * theta1 + theta2

// region 2
// wrong "the sign of the ratio": -ratio * g1 ==> ratio * g1
// wrong "the ratio stands with the other wheel": -ratio * g1, vec3(0), g2 ==> -g1, vec3(0), ratio
//         * g2
// wrong "divided by the ratio": -ratio * g1 ==> -g1 / ratio
// wrong "the ratio is missing": -ratio * g1 ==> -g1
// wrong "g1 and g2 are exchanged: each wheel has its own axle": -ratio * g1, vec3(0), g2 ==>
//         -ratio * g2, vec3(0), g1
// wrong "the axles in the place of g1 and g2: that is exact only": -ratio * g1, vec3(0), g2 ==>
//         -ratio * angle1.a1_local, vec3(0), angle2.a1_local
// wrong "wheel 2 is missing": vec3(0), g2 ==> vec3(0), vec3(0)
// wrong "g1 and g2 stand in v1 and v2: a wheel turns": {vec3(0), -ratio * g1, vec3(0), g2} ==>
//         {-ratio * g1, vec3(0), g2, vec3(0)}
// right the row by its members: return {vec3(0), -ratio * g1, vec3(0), g2} ==> Row J; J.w1 =
//         -ratio * g1; J.w2 = g2; return J

// region 3
// wrong "the angle now: in a fast step a wheel turns by more than": + h * dot(slope_of(angle1,
//         body1), body1.w) ==> ;; + h * dot(slope_of(angle2, body2), body2.w) ==>
// wrong "the sign of the rate: the step is still to come": + h * dot(slope_of(angle1 ==> - h *
//         dot(slope_of(angle1 ;; + h * dot(slope_of(angle2 ==> - h * dot(slope_of(angle2
// wrong "h is missing: a rate is no angle": + h * ==> + ;; + h * ==> +
// wrong "the old expected value is moved on and the angle never": = angle_of(angle1, body1) ==> =
//         angle1.expected ;; = angle_of(angle2, body2) ==> = angle2.expected
// wrong "the angle is missing": = angle_of(angle1, body1) + ==> = ;; = angle_of(angle2, body2) +
//         ==> =
// wrong "the length of w has no sign: the rate is g.w": dot(slope_of(angle1, body1), body1.w) ==>
//         length(body1.w) ;; dot(slope_of(angle2, body2), body2.w) ==> length(body2.w)
// wrong units "h is missing": + h * ==> + ;; + h * ==> +
// right in a loop over both:
  for (auto [angle, body] : {std::pair(&angle1, &body1), std::pair(&angle2, &body2)})
    angle->expected = angle_of(*angle, *body) + h * dot(slope_of(*angle, *body), body->w);
