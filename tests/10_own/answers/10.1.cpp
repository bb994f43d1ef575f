// mistake "the sign: C is a1.a2 itself": dot(a1, a2) ==> -dot(a1, a2)
// mistake "1 - a1.a2 is 0 where the axes are parallel: here they are to be at right angles":
//          dot(a1, a2) ==> 1 - dot(a1, a2)
// mistake "the length of a1 x a2 is 1 at right angles, and 0 where the axes are parallel": dot(a1,
//         a2) ==> length(cross(a1, a2))
// mistake "the angle between the axes: it is pi/2 at right angles, not 0": dot(a1, a2) ==>
//         std::acos(dot(a1, a2))
// mistake "the angle less pi/2: its slope is not the row of Eq. 10-2": dot(a1, a2) ==>
//         std::acos(dot(a1, a2)) - std::numbers::pi_v<real> / 2
// mistake "the sign is lost: C must tell to which side the axes lean": dot(a1, a2) ==>
//         std::abs(dot(a1, a2))
// mistake "C is squared: its slope is then 0 where C is 0, and the row has no effect": dot(a1, a2)
//         ==> dot(a1, a2) * dot(a1, a2)
// right C in the axes of body 1: return dot(a1, a2) ==> return dot(a1_local, to_local(body1, a2))
// mistake "both axes are turned with one body, or with none: a1 is fixed in body 1 and a2 in body
//         2": dot(a1, a2) ==> dot(a1_local, a2_local)
// mistake "a1 is left in body space: take a1 and a2 above": dot(a1, a2) ==> dot(a1_local, a2)
// mistake "a2 is left in body space: take a1 and a2 above": dot(a1, a2) ==> dot(a1, a2_local)

// region 2
// mistake "the sign of the whole row: cycle the factors of (w1 x a1).a2 once more": cross(a1, a2)
//         ==> cross(a2, a1)
// mistake "w1 and w2 with the same sign: if both bodies turn together, C does not change": -n} ==>
//         n}
// mistake "the axes themselves: a rotation changes a1 by w1 x a1, so the row holds a cross
//         product": n, vec3(0), -n ==> a2, vec3(0), a1
// mistake "a unit vector: a1 x a2 becomes shorter as the axes lean": const vec3 n = cross(a1, a2)
//         ==> const vec3 n = normalize(cross(a1, a2))
// mistake "body 2 is missing: a2 turns as well": -n} ==> vec3(0)}
// mistake "the cross products stand in v1 and v2: this row turns and does not push": {vec3(0), n,
//         vec3(0), -n} ==> {n, vec3(0), -n, vec3(0)}
// mistake "the axes are left in body space: take a1 and a2 above": cross(a1, a2) ==>
//         cross(a1_local, a2_local)
// right the row by two products: {vec3(0), n, vec3(0), -n} ==> {vec3(0), cross(a1, a2), vec3(0),
//         cross(a2, a1)}
// mistake "w1 and w2 with the same sign: if both bodies turn together, C does not change":
//         {vec3(0), n, vec3(0), -n} ==> {vec3(0), -n, vec3(0), -n}
// mistake "the axes themselves: a rotation changes a1 by w1 x a1, so the row holds a cross
//         product": {vec3(0), n, vec3(0), -n} ==> {vec3(0), a1, vec3(0), a2}
// mistake "the axes themselves: a rotation changes a1 by w1 x a1, so the row holds a cross
//         product": {vec3(0), n, vec3(0), -n} ==> {vec3(0), a2, vec3(0), -a1}
// mistake "the axes themselves: a rotation changes a1 by w1 x a1, so the row holds a cross
//         product": {vec3(0), n, vec3(0), -n} ==> {vec3(0), a1, vec3(0), -a2}
// mistake "body 1 is missing: a1 turns as well": {vec3(0), n, vec3(0), -n} ==> {vec3(0), vec3(0),
//         vec3(0), -n}
// wrong "w1, nearly parallel": return ==> if (length(n) < real(1e-6)) return {};
//         return
