// wrong "the sign: C is a1.a2 itself": dot(a1, a2) ==> -dot(a1, a2)
// wrong "1 - a1.a2 is 0 where the axes are parallel: here they are": dot(a1, a2) ==> 1 - dot(a1,
//         a2)
// wrong "the length of a1 x a2 is 1 at right angles, and 0 where": dot(a1, a2) ==>
//         length(cross(a1, a2))
// wrong "the angle between the axes: it is pi/2 at right angles": dot(a1, a2) ==>
//         std::acos(dot(a1, a2))
// wrong "the angle less pi/2: its slope is not the row of Eq. 10-2": dot(a1, a2) ==>
//         std::acos(dot(a1, a2)) - std::numbers::pi_v<real> / 2
// wrong "the sign is lost: C must tell to which side the axes lean": dot(a1, a2) ==>
//         std::abs(dot(a1, a2))
// wrong "C is squared: its slope is then 0 where C is 0, and the": dot(a1, a2) ==> dot(a1, a2) *
//         dot(a1, a2)
// right C in the axes of body 1: return dot(a1, a2) ==> return dot(a1_local, to_local(body1, a2))

// region 2
// wrong "the sign of the whole row: cycle the factors of": cross(a1, a2) ==> cross(a2, a1)
// wrong "w1 and w2 with the same sign: if both bodies turn": -n} ==> n}
// wrong "the axes themselves: a rotation changes a1 by w1 x a1, so": n, vec3(0), -n ==> a2,
//         vec3(0), a1
// wrong "a unit vector: a1 x a2 becomes shorter as the axes lean": const vec3 n = cross(a1, a2)
//         ==> const vec3 n = normalize(cross(a1, a2))
// wrong "body 2 is missing: a2 turns as well": -n} ==> vec3(0)}
// wrong "the cross products stand in v1 and v2: this row turns and": {vec3(0), n, vec3(0), -n}
//         ==> {n, vec3(0), -n, vec3(0)}
// wrong "the axes are left in body space: take a1 and a2 above": cross(a1, a2) ==>
//         cross(a1_local, a2_local)
// right the row by two products: {vec3(0), n, vec3(0), -n} ==> {vec3(0), cross(a1, a2), vec3(0),
//         cross(a2, a1)}
