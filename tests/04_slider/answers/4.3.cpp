// wrong drawn-threshold: return dot(u, to_world(body1, a1_local)); ==> const real d = dot(u,
//         to_world(body1, a1_local)); return std::abs(d) < real(1e-9) ? 0 : d;
// wrong drawn-cut: return dot(u, to_world(body1, a1_local)); ==> return std::clamp(dot(u,
//         to_world(body1, a1_local)), real(-10), real(10));
// mistake "the displacement has a sign: it is negative behind the start": dot(u, to_world(body1,
//         a1_local)) ==> std::abs(dot(u, to_world(body1, a1_local)))
// wrong max-0: dot(u, to_world(body1, a1_local)) ==> std::max(real(0), dot(u, to_world(body1,
//         a1_local)))
// mistake "u is not made a unit vector: its length counts": u, ==> normalize(u),
// mistake "centres in place of anchors: u is p2 - p1": u, ==> body2.x - body1.x,
// mistake "the anchor of body 2 is forgotten: u is p2 - p1": u, ==> body2.x - world_point(body1,
//         anchor1_local),
// wrong cut-int: return ==> const int displacement = ;; ; ==> ; return displacement;
// mistake "the length of u: only its part along a counts": dot(u, to_world(body1, a1_local)) ==>
//         length(u)
// mistake "the square: the dot product of u and a itself": return dot(u, to_world(body1,
//         a1_local)); ==> const real d = dot(u, to_world(body1, a1_local)); return d * d;
// wrong threshold: return dot(u, to_world(body1, a1_local)); ==> const real displacement = dot(u,
//         to_world(body1, a1_local)); return std::abs(displacement) < 0.2 ? 0 : displacement;
// wrong never-set: return dot(u, to_world(body1, a1_local)); ==> real displacement; const vec3 a =
//         to_world(body1, a1_local); for (int k = 0; k < 3; ++k) displacement += u[k] * a[k];
//         return displacement;
// mistake "a is a direction, not a point: to_world, not world_point": to_world ==> world_point
// right displacement in axes of body 1: (u, to_world(body1, a1_local)) ==> (to_local(body1, u),
//         a1_local)
// mistake "the sign: u runs from the point of body 1 to that of body 2": dot(u, to_world(body1,
//         a1_local)) ==> dot(-u, to_world(body1, a1_local))
// mistake "a is left in body space: turn it into the world with body 1": dot(u, to_world(body1,
//         a1_local)) ==> dot(u, a1_local)
// mistake "a is turned the wrong way round: to_world, not to_local": dot(u, to_world(body1,
//         a1_local)) ==> dot(u, to_local(body1, a1_local))
// mistake "a is turned with body 2: the line rides on body 1": dot(u, to_world(body1, a1_local))
//         ==> dot(u, to_world(body2, a1_local))
// mistake "u is turned, too: u and a are both in the world": dot(u, to_world(body1, a1_local)) ==>
//         dot(to_local(body1, u), to_world(body1, a1_local))
// mistake "centres in place of anchors, and a left in body space": dot(u, to_world(body1,
//         a1_local)) ==> dot((body2.x - body1.x), a1_local)
// mistake "the point of body 2 in the place of u: u is p2 - p1": dot(u, to_world(body1, a1_local))
//         ==> dot(world_point(body2, anchor2_local), to_world(body1, a1_local))
// mistake "the anchor of body 1 is forgotten: u is p2 - p1": dot(u, to_world(body1, a1_local)) ==>
//         dot((world_point(body2, anchor2_local) - body1.x), to_world(body1, a1_local))
// mistake "the length of u: only its part along a counts": dot(u, to_world(body1, a1_local)) ==>
//         std::copysign(length(u), dot(u, to_world(body1, a1_local)))
// mistake "the length of a cross product: take the dot product of u and a": dot(u, to_world(body1,
//         a1_local)) ==> length(cross(u, to_world(body1, a1_local)))
// mistake "a static body has an error, too": return ==> if (body1.is_static()) return 0; return
// mistake "a static body has an error, too": return ==> if (body2.is_static()) return 0; return
// mistake "a static body has an error, too": return ==> if (body1.is_static() || body2.is_static())
//         return 0; return

// region 2
// mistake "in w1 and w2 the direction a is left in body space: turn it into the world with body 1":
//         u, a ==> u, a1_local ;; r2, a ==> r2, a1_local
// wrong order-cross-products (pencil and paper, upright, turned, moved, broken): r1 + u, a ==> a,
//         r1 + u ;; r2, a ==> a, r2
// mistake "centres in place of anchors: u is p2 - p1": r1 = to_world(body1, anchor1_local), ==> ;;
//         r1 + u ==> body2.x - body1.x
// expects: (pencil and paper, upright, turned, moved, broken)
// wrong "the block w2 is missing (pencil and paper, upright, turned, moved, broken)": ; const vec3
//         r1 ==> , r1 ;; ), r2 = to_world(body2, anchor2_local ==> ;; cross(r2, a) ==> vec3(0)
// mistake "the unit vector along u in the place of a: the row runs along a":  to_world(body1,
//         a1_local) ==> normalize(u) ;; + u ==>
// expects: (pencil and paper, upright, turned, moved, broken)
// wrong order-of-blocks (pencil and paper, upright, turned, moved, broken): -a ==> -a, a ;; a,
//         cross ==> cross
// wrong r1-for-both (pencil and paper, upright, turned, moved, broken): r2, ==> r1 + u,
// mistake "the lever of body 1 is r1 + u, not r2 + u": r1 + ==> r2 +
// expects: (pencil and paper, upright, turned, moved, broken)
// mistake "body-space lever: the lever of body 2 is not turned into the world":  ; const vec3 r1
//         ==> , r1 ;; to_world(body2, anchor2_local) ==> anchor2_local
// expects: (pencil and paper, upright, turned, moved, broken)
// mistake "u belongs to the lever of body 1: a rides on body 1":  + u ==> ;; r2, ==> r2 + u,
// expects: (pencil and paper, turned, moved, broken)
// wrong never-set: ; const ==> * f; const ;; const ==> Row row; real f; f += 1; const
// wrong "the sign of the block w1 (pencil and paper, upright, turned, moved, broken)": a, - ==> a,
// wrong "levers are missing: such a row drives the centres, not the points, and": const vec3 r1 =
//         to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local); return {-a,
//         -cross(r1 + u, a), a, cross(r2, a)} ==> return {a, vec3(0), -a, vec3(0)}
// expects: its sign is wrong as well (upright, turned, moved, broken)
// mistake "a is left in body space: turn it into the world with body 1": to_world(body1, a1_local)
//         ==> a1_local
// expects: (turned, moved, broken)
// mistake "u is forgotten, the lever of body 1 is r1 + u, because a rides on body 1": + u ==>
// expects: (turned, moved, broken)
// mistake "levers are missing: such a row drives the centres, not the points":
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
// mistake "r1 is forgotten, the lever of body 1 is r1 + u": -cross(r1 + u, a) ==> -cross(u, a) ;; ,
//         cross(r2, a) ==> , cross(r2, a)
// mistake "the sign of u or of r1, the lever of body 1 is r1 + u": -cross(r1 + u, a) ==> -cross(r1
//         - u, a) ;; , cross(r2, a) ==> , cross(r2, a)
// mistake "the sign of u or of r1, the lever of body 1 is r1 + u": -cross(r1 + u, a) ==> -cross(u -
//         r1, a) ;; , cross(r2, a) ==> , cross(r2, a)
// mistake "u belongs to the lever of body 1: a rides on body 1": -cross(r1 + u, a) ==> -cross(r1,
//         a) ;; , cross(r2, a) ==> , cross(r2 - u, a)
// mistake "u belongs to the lever of body 1 alone": -cross(r1 + u, a) ==> -cross(r1 + u, a) ;; ,
//         cross(r2, a) ==> , cross(r2 + u, a)
// mistake "u belongs to the lever of body 1 alone": -cross(r1 + u, a) ==> -cross(r1 + u, a) ;; ,
//         cross(r2, a) ==> , cross(r2 - u, a)
// mistake "the levers r1 and r2 are exchanged": -cross(r1 + u, a) ==> -cross(r2 + u, a) ;; ,
//         cross(r2, a) ==> , cross(r1, a)
// mistake "u belongs to the lever of body 1 once": -cross(r1 + u, a) ==> -cross(r1 + u + u, a) ;; ,
//         cross(r2, a) ==> , cross(r2, a)
// mistake "a lever has its length: it is no unit vector": -cross(r1 + u, a) ==> -cross(normalize(r1
//         + u), a) ;; , cross(r2, a) ==> , cross(normalize(r2), a)
// mistake "the lever of body 2 is r2, not r1": -cross(r1 + u, a) ==> -cross(r1 + u, a) ;; ,
//         cross(r2, a) ==> , cross(r1, a)
// mistake "u belongs to the lever of body 1, all of it: a rides on body 1": -cross(r1 + u, a) ==>
//         -cross(r1 + u / real(2), a) ;; , cross(r2, a) ==> , cross(r2 - u / real(2), a)
// mistake "u is turned with body 1 once more: the lever of body 1 is r1 + u, and u is in the
//         world": -cross(r1 + u, a) ==> -cross(r1 + to_world(body1, u), a) ;; , cross(r2, a) ==> ,
//         cross(r2, a)
// mistake "u is turned into the axes of body 1: the lever of body 1 is r1 + u, all in the world":
//         -cross(r1 + u, a) ==> -cross(r1 + to_local(body1, u), a) ;; , cross(r2, a) ==> ,
//         cross(r2, a)
// mistake "the levers are turned twice: to_world has turned them already": -cross(r1 + u, a) ==>
//         -cross(to_world(body1, r1) + u, a) ;; , cross(r2, a) ==> , cross(to_world(body2, r2), a)
// mistake "the lever r1 is turned twice: to_world has turned it already": -cross(r1 + u, a) ==>
//         -cross(to_world(body1, r1) + u, a) ;; , cross(r2, a) ==> , cross(r2, a)
// mistake "the lever r2 is turned twice: to_world has turned it already": -cross(r1 + u, a) ==>
//         -cross(r1 + u, a) ;; , cross(r2, a) ==> , cross(to_world(body2, r2), a)
// mistake "centres in place of anchors: u is p2 - p1": -cross(r1 + u, a) ==> -cross(r1 + (body2.x -
//         body1.x), a) ;; , cross(r2, a) ==> , cross(r2, a)
// mistake "a point where a lever belongs: the lever of body 1 is r1 + u": -cross(r1 + u, a) ==>
//         -cross(body1.x + r1, a) ;; , cross(r2, a) ==> , cross(r2, a)
// mistake "a point where a lever belongs: the lever of body 1 is r1 + u": -cross(r1 + u, a) ==>
//         -cross(body1.x + r1, a) ;; , cross(r2, a) ==> , cross(body2.x + r2, a)
// mistake "a point where a lever belongs: the lever of body 1 is r1 + u": -cross(r1 + u, a) ==>
//         -cross(body2.x + r2, a) ;; , cross(r2, a) ==> , cross(r2, a)
// mistake "a point where a lever belongs: the lever of body 1 is r1 + u": -cross(r1 + u, a) ==>
//         -cross(body2.x + r2, a) ;; , cross(r2, a) ==> , cross(body2.x + r2, a)
// mistake "body-space lever: the lever of body 1 is not turned into the world": -cross(r1 + u, a)
//         ==> -cross(anchor1_local + u, a) ;; , cross(r2, a) ==> , cross(r2, a)
// mistake "body-space lever: the lever of body 2 is not turned into the world": -cross(r1 + u, a)
//         ==> -cross(r1 + u, a) ;; , cross(r2, a) ==> , cross(anchor2_local, a)
// mistake "body-space lever: r1 and r2 are not turned into the world": -cross(r1 + u, a) ==>
//         -cross(anchor1_local + u, a) ;; , cross(r2, a) ==> , cross(anchor2_local, a)
// mistake "a is turned with body 2 here, but a rides on body 1": {-a, -cross(r1 + u, a), a,
//         cross(r2, a)} ==> {-m, -cross(r1 + u, m), m, cross(r2, m)} ;; const vec3 a ==> const vec3
//         m = to_world(body2, a1_local); const vec3 a
// mistake "a is turned with body 2 here, but a rides on body 1": {-a, -cross(r1 + u, a), a,
//         cross(r2, a)} ==> {-m, -cross(r1, m), m, cross(r2, m)} ;; const vec3 a ==> const vec3 m =
//         to_world(body2, a1_local); const vec3 a
// mistake "a is left in body space: turn it into the world with body 1": {-a, -cross(r1 + u, a), a,
//         cross(r2, a)} ==> {-m, -cross(r1, m), m, cross(r2, m)} ;; const vec3 a ==> const vec3 m =
//         a1_local; const vec3 a
// mistake "the unit vector along u in the place of a: the row runs along a": {-a, -cross(r1 + u,
//         a), a, cross(r2, a)} ==> {-m, -cross(r1 + u, m), m, cross(r2, m)} ;; const vec3 a ==>
//         const vec3 m = normalize(u); const vec3 a
// mistake "levers are missing: such a row drives the centres, not the points, and its sign is wrong
//         as well": {-a, -cross(r1 + u, a), a, cross(r2, a)} ==> {a, vec3(0), -a, vec3(0)}
// mistake "u is forgotten, the lever of body 1 is r1 + u, because a rides on body 1": + u ==>
// mistake "levers are missing: such a row drives the centres, not the points": -cross(r1 + u, a)
//         ==> vec3(0) ;; , cross(r2, a) ==> , vec3(0)
