// wrong "the sign: C is positive inside the cone": limit - std::atan2(length(cross(a1, a2)),
//         dot(a1, a2)) ==> std::atan2(length(cross(a1, a2)), dot(a1, a2)) - limit
// wrong "the cosines are compared: C is an angle here, whose slope": limit -
//         std::atan2(length(cross(a1, a2)), dot(a1, a2)) ==> dot(a1, a2) - std::cos(limit)
// wrong "an arcsine ends at a quarter turn: beyond it the swing": std::atan2(length(cross(a1,
//         a2)), dot(a1, a2)) ==> std::asin(std::min(length(cross(a1, a2)), real(1)))
// wrong "the sine of the swing: it shrinks again beyond a quarter": std::atan2(length(cross(a1,
//         a2)), dot(a1, a2)) ==> length(cross(a1, a2))
// wrong "an arccosine loses half of the digits at small swings": std::atan2(length(cross(a1,
//         a2)), dot(a1, a2)) ==> std::acos(std::min(std::max(dot(a1, a2), real(-1)), real(1)))
// wrong "atan2 takes the sine first": std::atan2(length(cross(a1, a2)), dot(a1, a2)) ==>
//         std::atan2(dot(a1, a2), length(cross(a1, a2)))
// wrong "the limit is missing": limit - std ==> std
// wrong "C is never negative here: beyond the limit it has to be": return limit -
//         std::atan2(length(cross(a1, a2)), dot(a1, a2)) ==> return std::max(limit -
//         std::atan2(length(cross(a1, a2)), dot(a1, a2)), real(0))
// right the swing by half angles: return limit - std::atan2(length(cross(a1, a2)), dot(a1, a2))
//         ==> return limit - 2 * std::atan2(length(a1 - a2), length(a1 + a2))

// region 2
// wrong "the sign of the whole row: C shrinks as the swing grows": {vec3(0), n, vec3(0), -n} ==>
//         {vec3(0), -n, vec3(0), n}
// wrong "w1 and w2 with the same sign: if both bodies turn": vec3(0), -n} ==> vec3(0), n}
// wrong "n stands in v1 and v2: this row turns and does not push": {vec3(0), n, vec3(0), -n} ==>
//         {n, vec3(0), -n, vec3(0)}
// wrong "body 2 is missing": vec3(0), -n} ==> vec3(0), vec3(0)}
// wrong "a1 x a2 has the length of the sine: the swing is an":
  vec3 n = cross(a1, a2);
  if (length(n) < real(1e-6)) {
    const vec3 w = body2.w - body1.w;
    n = w - dot(w, a1) * a1;
    if (length(n) == 0) return {};
    n = normalize(n);
  }
  return {vec3(0), n, vec3(0), -n};
// wrong "the part of w2 - w1 along a1 is in it: a twist does not": n = w - dot(w, a1) * a1 ==> n
//         = w
// wrong "body 1 rotates as well: w2 - w1": body2.w - body1.w ==> body2.w
// wrong "zero at swing 0: a fast body then passes the limit in one":
  vec3 n = cross(a1, a2);
  if (length(n) < real(1e-6)) return {};
  n = normalize(n);
  return {vec3(0), n, vec3(0), -n};
// wrong "the direction in which the axis moves: the row holds the": n = w - dot(w, a1) * a1 ==> n
//         = cross(w, a1)
// wrong "the sign of w2 - w1: with it the row drives the bodies": body2.w - body1.w ==> body1.w -
//         body2.w
// wrong "the row J of a cone at swing 0": if (length(n) < real(1e-6)) { const vec3 w = body2.w -
//         body1.w; n = w - dot(w, a1) * a1; if (length(n) == 0) return {}; } ==>
// wrong "a direction that does not depend on the motion: where the": n = w - dot(w, a1) * a1 ==>
//         n = cross(a1, vec3(1, 0, 0))
// right a double cross product: n = w - dot(w, a1) * a1 ==> n = cross(a1, cross(w, a1))
