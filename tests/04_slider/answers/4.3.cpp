// wrong drawn-threshold: return dot(u, to_world(body1, a1_local)); ==> const real d = dot(u,
//         to_world(body1, a1_local)); return std::abs(d) < real(1e-9) ? 0 : d;
// wrong drawn-cut: return dot(u, to_world(body1, a1_local)); ==> return std::clamp(dot(u,
//         to_world(body1, a1_local)), real(-10), real(10));
// wrong abs: dot(u, to_world(body1, a1_local)) ==> std::abs(dot(u, to_world(body1, a1_local)))
// wrong max-0: dot(u, to_world(body1, a1_local)) ==> std::max(real(0), dot(u, to_world(body1,
//         a1_local)))
// wrong cosine: u, ==> normalize(u),
// wrong centres-place-anchors-u: u, ==> body2.x - body1.x,
// wrong p1-x2: u, ==> body2.x - world_point(body1, anchor1_local),
// wrong cut-int: return ==> const int displacement = ;; ; ==> ; return displacement;
// wrong "the length of u: only its part along a counts": dot(u, to_world(body1, a1_local)) ==>
//         length(u)
// wrong "the square: the dot product of u and a itself": return dot(u, to_world(body1, a1_local));
//         ==> const real d = dot(u, to_world(body1, a1_local)); return d * d;
// wrong threshold: return dot(u, to_world(body1, a1_local)); ==> const real displacement = dot(u,
//         to_world(body1, a1_local)); return std::abs(displacement) < 0.2 ? 0 : displacement;
// wrong never-set: return dot(u, to_world(body1, a1_local)); ==> real displacement; const vec3 a =
//         to_world(body1, a1_local); for (int k = 0; k < 3; ++k) displacement += u[k] * a[k];
//         return displacement;
// wrong "a is a direction, not a point: to_world, not world_point": to_world ==> world_point
// right displacement in axes of body 1: (u, to_world(body1, a1_local)) ==> (to_local(body1, u),
//         a1_local)

// region 2
// wrong "a direction of body 1 is not turned into the world (turned, moved, broken)": u, a ==> u,
//         a1_local ;; r2, a ==> r2, a1_local
// wrong order-cross-products (pencil and paper, upright, turned, moved, broken): r1 + u, a ==> a,
//         r1 + u ;; r2, a ==> a, r2
// wrong centres-place-anchors-u (pencil and paper, upright, turned, moved, broken): r1 =
//         to_world(body1, anchor1_local), ==> ;; r1 + u ==> body2.x - body1.x
// wrong "the block w2 is missing (pencil and paper, upright, turned, moved, broken)": ; const vec3
//         r1 ==> , r1 ;; ), r2 = to_world(body2, anchor2_local ==> ;; cross(r2, a) ==> vec3(0)
// wrong "the unit vector along u in the place of a: the row runs along a (pencil and paper, upright, turned, moved, broken)":
//         to_world(body1, a1_local) ==> normalize(u) ;; + u ==>
// wrong order-of-blocks (pencil and paper, upright, turned, moved, broken): -a ==> -a, a ;; a,
//         cross ==> cross
// wrong r1-for-both (pencil and paper, upright, turned, moved, broken): r2, ==> r1 + u,
// wrong r2-for-r1 (pencil and paper, upright, turned, moved, broken): r1 + ==> r2 +
// wrong "body-space lever: the lever of body 2 is not turned into the world (pencil and paper, upright, turned, moved, broken)":
//         ; const vec3 r1 ==> , r1 ;; to_world(body2, anchor2_local) ==> anchor2_local
// wrong "u belongs to the lever of body 1: a rides on body 1 (pencil and paper, turned, moved, broken)":
//         + u ==> ;; r2, ==> r2 + u,
// wrong never-set: ; const ==> * f; const ;; const ==> Row row; real f; f += 1; const
// wrong "the sign of the block w1 (pencil and paper, upright, turned, moved, broken)": a, - ==> a,
// wrong "levers are missing: such a row drives the centres, not the points, and": const vec3 r1 =
//         to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local); return {-a,
//         -cross(r1 + u, a), a, cross(r2, a)} ==> return {a, vec3(0), -a, vec3(0)}
// expects: its sign is wrong as well (upright, turned, moved, broken)
// wrong "a is left in body space: turn it into the world with body 1 (turned, moved, broken)":
//         to_world(body1, a1_local) ==> a1_local
// wrong "u is forgotten, the lever of body 1 is r1 + u, because a rides on body 1": + u ==>
// expects: (turned, moved, broken)
// wrong "levers are missing: such a row drives the centres, not the points":
// expects: (upright, turned, moved, broken)
  const vec3 a = to_world(body1, a1_local);
  return {-a, vec3(0), a, vec3(0)};
// right J from the balance of momentum:
  const vec3 a = to_world(body1, a1_local), r2 = to_world(body2, anchor2_local);
  const vec3 w2 = cross(r2, a);
  return {-a, -(cross(body2.x - body1.x, a) + w2), a, w2};
// right J with the part of u across: return ==> const vec3 across = u - dot(u, a) * a; return ;; +
//         u ==> + across
// right lever to the point of body 2: ; const vec3 r1 = to_world(body1, anchor1_local), r2 =
//         to_world ==> , p2 = world_point ;; r1 + u ==> p2 - body1.x ;; r2, a ==> p2 - body2.x, a
