// mistake "the sign: C is positive inside the cone": limit - std::atan2(length(cross(a1, a2)),
//         dot(a1, a2)) ==> std::atan2(length(cross(a1, a2)), dot(a1, a2)) - limit
// mistake "the cosines are compared: C is an angle here, whose slope does not vanish at small
//         swings": limit - std::atan2(length(cross(a1, a2)), dot(a1, a2)) ==> dot(a1, a2) -
//         std::cos(limit)
// mistake "an arcsine ends at a quarter turn: beyond it the swing would shrink again":
//          std::atan2(length(cross(a1, a2)), dot(a1, a2)) ==> std::asin(std::min(length(cross(a1,
//         a2)), real(1)))
// mistake "the sine of the swing: it shrinks again beyond a quarter turn":
//          std::atan2(length(cross(a1, a2)), dot(a1, a2)) ==> length(cross(a1, a2))
// mistake "an arccosine loses half of the digits at small swings: use atan2 of sine and cosine":
//          std::atan2(length(cross(a1, a2)), dot(a1, a2)) ==> std::acos(std::min(std::max(dot(a1,
//         a2), real(-1)), real(1)))
// mistake "atan2 takes the sine first": std::atan2(length(cross(a1, a2)), dot(a1, a2)) ==>
//         std::atan2(dot(a1, a2), length(cross(a1, a2)))
// mistake "the limit is missing": limit - std ==> std
// mistake "C is never negative here: beyond the limit it has to be, or nothing pushes back": return
//         limit - std::atan2(length(cross(a1, a2)), dot(a1, a2)) ==> return std::max(limit -
//         std::atan2(length(cross(a1, a2)), dot(a1, a2)), real(0))
// right the swing by half angles: return limit - std::atan2(length(cross(a1, a2)), dot(a1, a2)) ==>
//         return limit - 2 * std::atan2(length(a1 - a2), length(a1 + a2))
// mistake "half of the limit: it is the angle from the axis to the edge of the cone": limit -
//         std::atan2(length(cross(a1, a2)), dot(a1, a2)) ==> limit / 2 -
//         std::atan2(length(cross(a1, a2)), dot(a1, a2))
// mistake "the axes are left in body space: take a1 and a2 above": std::atan2(length(cross(a1,
//         a2)), dot(a1, a2)) ==> std::atan2(length(cross(a1_local, a2_local)), dot(a1_local,
//         a2_local))

// region 2
// mistake "the sign of the whole row: C shrinks as the swing grows": {vec3(0), n, vec3(0), -n} ==>
//         {vec3(0), -n, vec3(0), n}
// mistake "w1 and w2 with the same sign: if both bodies turn together, C does not change": vec3(0),
//         -n} ==> vec3(0), n}
// mistake "n stands in v1 and v2: this row turns and does not push": {vec3(0), n, vec3(0), -n} ==>
//         {n, vec3(0), -n, vec3(0)}
// mistake "body 2 is missing": vec3(0), -n} ==> vec3(0), vec3(0)}
// mistake "a1 x a2 has the length of the sine: the swing is an angle, so the row holds a unit
//         vector":
  vec3 n = cross(a1, a2);
  if (length(n) < real(1e-6)) {
    const vec3 w = body2.w - body1.w;
    n = w - dot(w, a1) * a1;
    if (length(n) == 0) return {};
    n = normalize(n);
  }
  return {vec3(0), n, vec3(0), -n};
// mistake "the part of w2 - w1 along a1 is in it: a twist does not change the swing": n = w -
//         dot(w, a1) * a1 ==> n = w
// mistake "body 1 rotates as well: w2 - w1": body2.w - body1.w ==> body2.w
// mistake "zero at swing 0: a fast body then passes the limit in one step":
  vec3 n = cross(a1, a2);
  if (length(n) < real(1e-6)) return {};
  n = normalize(n);
  return {vec3(0), n, vec3(0), -n};
// mistake "the direction in which the axis moves: the row holds the axis about which it turns": n =
//         w - dot(w, a1) * a1 ==> n = cross(w, a1)
// mistake "the sign of w2 - w1: with it the row drives the bodies through the limit": body2.w -
//         body1.w ==> body1.w - body2.w
// mistake "the row J of a cone at swing 0": if (length(n) < real(1e-6)) { const vec3 w = body2.w -
//         body1.w; n = w - dot(w, a1) * a1; if (length(n) == 0) return {}; } ==>
// mistake "a direction that does not depend on the motion: where the bodies rotate across it, the
//         row has no effect": n = w - dot(w, a1) * a1 ==> n = cross(a1, vec3(1, 0, 0))
// right a double cross product: n = w - dot(w, a1) * a1 ==> n = cross(a1, cross(w, a1))
// mistake "a1 x a2 is no unit vector, and the sign is wrong as well": n = normalize(n); ==> if
//         (length(cross(a1, a2)) < real(1e-6)) n = normalize(n); ;; {vec3(0), n, vec3(0), -n} ==>
//         {vec3(0), -n, vec3(0), n}
// mistake "an axis itself: a rotation about it does not change the swing": {vec3(0), n, vec3(0),
//         -n} ==> {vec3(0), a1, vec3(0), -a1}
// mistake "an axis itself: a rotation about it does not change the swing": {vec3(0), n, vec3(0),
//         -n} ==> {vec3(0), a2, vec3(0), -a2}
// mistake "a vector in the plane of the axes: the swing turns about their cross product": vec3 n =
//         cross(a1, a2) ==> vec3 n = a2 - dot(a1, a2) * a1
// mistake "body 1 is missing": {vec3(0), n, vec3(0), -n} ==> {vec3(0), vec3(0), vec3(0), -n}
// mistake "the row holds a unit vector at swing 0, too": n = normalize(n); ==> if (length(cross(a1,
//         a2)) >= real(1e-6)) n = normalize(n);
// mistake "a direction that does not depend on the motion: where the bodies rotate across it, the
//         row has no effect": n = w - dot(w, a1) * a1 ==> n = cross(a1, vec3(0, 1, 0))
// mistake "a direction that does not depend on the motion: where the bodies rotate across it, the
//         row has no effect": n = w - dot(w, a1) * a1 ==> n = vec3(1, 0, 0)
// mistake "a small swing has its direction a1 x a2, too: only below 1e-6 the motion decides":
//         real(1e-6) ==> real(1e-1)
// mistake "a small swing has its direction a1 x a2, too: only below 1e-6 the motion decides":
//         real(1e-6) ==> real(1e-2)
// mistake "a small swing has its direction a1 x a2, too: only below 1e-6 the motion decides":
//         real(1e-6) ==> real(1e-3)
// mistake "a small swing has its direction a1 x a2, too: only below 1e-6 the motion decides":
//         real(1e-6) ==> real(1e-4)
