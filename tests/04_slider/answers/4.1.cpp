// wrong drawn-cut: return {dot(u, to_world(body1, n1_local)), dot(u, to_world(body1, n2_local))};
//         ==> const auto cut = [](real a) { return std::clamp(a, real(-1), real(1)); }; return
//         {cut(dot(u, to_world(body1, n1_local))), cut(dot(u, to_world(body1, n2_local)))};
// wrong drawn-threshold: return {dot(u, to_world(body1, n1_local)), dot(u, to_world(body1,
//         n2_local))}; ==> const auto cut = [](real a) { return std::abs(a) < real(1e-9) ? real(0)
//         : a; }; return {cut(dot(u, to_world(body1, n1_local))), cut(dot(u, to_world(body1,
//         n2_local)))};
// wrong absolute-values: dot(u, to_world(body1, n1_local)), dot(u, to_world(body1, n2_local)) ==>
//         std::abs(dot(u, to_world(body1, n1_local))), std::abs(dot(u, to_world(body1, n2_local)))
// mistake "centres in place of anchors: u is p2 - p1": return ==> const vec3 d = body2.x - body1.x;
//         return ;; u, ==> d, ;; u, ==> d,
// wrong "an index outside an array of 2 numbers: its places run from 0 to 1": return {dot(u,
//         to_world(body1, n1_local)), dot(u, to_world(body1, n2_local))}; ==> const vec3 n[2] =
//         {to_world(body1, n1_local), to_world(body1, n2_local)}; Vector<2> C{}; for (int i = 0; i
//         <= 2; ++i) C[i] = dot(u, n[i % 2]); return C;
// wrong "0 in every case: is it computed from the arguments? Was it cut off by an int, or does it
//         use a variable that was never set?":
  const int one = dot(u, to_world(body1, n1_local)), two = dot(u, to_world(body1, n2_local));
  return {real(one), real(two)};
// mistake "n1 twice: the second number belongs to n2": n2_local ==> n1_local
// mistake "n1 x n2 runs along the line, where the displacement is free: C holds u.n1 and u.n2":
//         return {dot(u, to_world(body1, n1_local)), dot(u, to_world(body1, n2_local))} ==> const
//         vec3 a = cross(to_world(body1, n1_local), to_world(body1, n2_local)); return {dot(u, a),
//         dot(u, a)}
// mistake "n2 is turned with body 2: the line rides on body 1": body1, n2_local ==> body2, n2_local
// mistake "u is not made a unit vector: its length counts": return ==> const vec3 n = normalize(u);
//         return ;; u, ==> n, ;; u, ==> n,
// mistake "n is a direction, not a point: to_world, not world_point": to_world ==> world_point ;;
//         to_world ==> world_point
// mistake "the sign: u runs from the point of body 1 to that of body 2": , dot ==> , -dot
// mistake "the point of body 2 in the place of u: u is p2 - p1": return ==> const vec3 p2 =
//         world_point(body2, anchor2_local); return ;; u, ==> p2, ;; u, ==> p2,
// wrong never-set: return {dot(u, to_world(body1, n1_local)), dot(u, to_world(body1, n2_local))};
//         ==> Vector<2> C; C[0] = dot(u, to_world(body1, n1_local)); return C;
// mistake "n1 and n2 are exchanged":
  return {dot(u, to_world(body1, n2_local)), dot(u, to_world(body1, n1_local))};
// wrong threshold: return {dot(u, to_world(body1, n1_local)), dot(u, to_world(body1, n2_local))}
//         ==> real p = dot(u, to_world(body1, n1_local)), q = dot(u, to_world(body1, n2_local)); if
//         (std::abs(p) < 0.1) p = 0; if (std::abs(q) < 0.1) q = 0; return {p, q}
// mistake "n is turned with body 2: the line rides on body 1": body1 ==> body2 ;; body1 ==> body2
// mistake "u is turned, too: u and n are both in the world": return ==> const vec3 seen =
//         to_local(body1, u); return ;; u, ==> seen, ;; u, ==> seen,
// mistake "a static body has an error, too": return ==> if (body1.is_static()) return {}; return
// right C in axes of body 1:
  // The same two numbers, seen from body 1: u is turned and n1 and n2 stay.
  const vec3 seen = to_local(body1, u);
  return {dot(seen, n1_local), dot(seen, n2_local)};
// mistake "the sign: u runs from the point of body 1 to that of body 2": dot(u, to_world(body1,
//         n1_local)), dot(u, to_world(body1, n2_local)) ==> dot(-u, to_world(body1, n1_local)),
//         dot(-u, to_world(body1, n2_local))
// mistake "n is left in body space: turn it into the world with body 1": dot(u, to_world(body1,
//         n1_local)), dot(u, to_world(body1, n2_local)) ==> dot(u, n1_local), dot(u, n2_local)
// mistake "n is turned the wrong way round: to_world, not to_local": dot(u, to_world(body1,
//         n1_local)), dot(u, to_world(body1, n2_local)) ==> dot(u, to_local(body1, n1_local)),
//         dot(u, to_local(body1, n2_local))
// mistake "centres in place of anchors, and n left in body space": dot(u, to_world(body1,
//         n1_local)), dot(u, to_world(body1, n2_local)) ==> dot((body2.x - body1.x), n1_local),
//         dot((body2.x - body1.x), n2_local)
// mistake "the anchor of body 2 is forgotten: u is p2 - p1": dot(u, to_world(body1, n1_local)),
//         dot(u, to_world(body1, n2_local)) ==> dot((body2.x - world_point(body1, anchor1_local)),
//         to_world(body1, n1_local)), dot((body2.x - world_point(body1, anchor1_local)),
//         to_world(body1, n2_local))
// mistake "the anchor of body 1 is forgotten: u is p2 - p1": dot(u, to_world(body1, n1_local)),
//         dot(u, to_world(body1, n2_local)) ==> dot((world_point(body2, anchor2_local) - body1.x),
//         to_world(body1, n1_local)), dot((world_point(body2, anchor2_local) - body1.x),
//         to_world(body1, n2_local))
// mistake "the length of u: only its part along n counts": dot(u, to_world(body1, n1_local)),
//         dot(u, to_world(body1, n2_local)) ==> length(u), length(u)
// mistake "the length of u: only its part along n counts": dot(u, to_world(body1, n1_local)),
//         dot(u, to_world(body1, n2_local)) ==> std::copysign(length(u), dot(u, to_world(body1,
//         n1_local))), std::copysign(length(u), dot(u, to_world(body1, n2_local)))
// mistake "the length of a cross product: take the dot product of u and n": dot(u, to_world(body1,
//         n1_local)), dot(u, to_world(body1, n2_local)) ==> length(cross(u, to_world(body1,
//         n1_local))), length(cross(u, to_world(body1, n2_local)))
// mistake "the square: the dot product of u and n itself": dot(u, to_world(body1, n1_local)),
//         dot(u, to_world(body1, n2_local)) ==> dot(u, to_world(body1, n1_local)) * dot(u,
//         to_world(body1, n1_local)), dot(u, to_world(body1, n2_local)) * dot(u, to_world(body1,
//         n2_local))
// mistake "a static body has an error, too": return ==> if (body2.is_static()) return {}; return
// mistake "a static body has an error, too": return ==> if (body1.is_static() || body2.is_static())
//         return {}; return
// mistake "n2 twice: the first number belongs to n1": n1_local ==> n2_local
// mistake "n1 x n2 runs along the line, where the displacement is free: C holds u.n1 and u.n2":
//         dot(u, to_world(body1, n1_local)), dot(u, to_world(body1, n2_local)) ==> dot(u,
//         cross(to_world(body1, n1_local), to_world(body1, n2_local))), 0
// mistake "the second number is missing": , dot(u, to_world(body1, n2_local)) ==>
// mistake "the first number is missing": dot(u, to_world(body1, n1_local)) ==> 0

// region 2
// wrong drawn-threshold: -cross(r1 + u, n[i]) ==> -cross(length(u) < real(1e-3) ? r1 : r1 + u,
//         n[i])
// wrong bodies-swapped (pencil and paper, upright, turned, moved, broken): -n ==> n[i], cross(r2,
//         n[i]), -n ;; , n[i], cross(r2, n[i]) ==>
// mistake "the unit vector along u in the place of n: the row runs along n":  Jacobian ==> const
//         vec3 d = normalize(u); Jacobian ;; n[i], -cross(r1 + u, n[i]), n[i], cross(r2, n[i]) ==>
//         d, -cross(r1 + u, d), d, cross(r2, d)
// expects: (pencil and paper, upright, turned, moved, broken)
// mistake "u belongs to the lever of body 1 once": , n[i], ==> - cross(u, n[i]), n[i],
// expects: (pencil and paper, turned, moved, broken)
// wrong "J[0] is written twice, J[1] never: the row C.2 stands in the place of C.1 (pencil and
//         paper, upright, turned, moved, broken)":  for (int i = 0; i < 2; ++i) J[i] = {-n[i],
//         -cross(r1 + u, n[i]), n[i], cross(r2, n[i])} ==> J[0] = {-n[0], -cross(r1 + u, n[0]),
//         n[0], cross(r2, n[0])}; J[0] = {-n[1], -cross(r1 + u, n[1]), n[1], cross(r2, n[1])}
// wrong "an index outside an array of 2 rows: its places run from 0 to 1": (int i = 0; i < 2; ++i)
//         J[i] = {-n[i], -cross(r1 + u, n[i]), n[i], cross(r2, n[i])}; ==> (int i = 0; i <= 2; ++i)
//         { const vec3 m = n[i % 2]; J[i] = {-m, -cross(r1 + u, m), m, cross(r2, m)}; }
// wrong "the lever of body 1 is turned with the other body: each body turns its own (pencil and
//         paper, upright, turned, moved, broken)":  body1 ==> body2
// wrong "J[1], the row C.2, repeats J[0] (pencil and paper, upright, turned, moved, broken)": [i],
//         -cross(r1 + u, n[i]), n[i], cross(r2, n[i]) ==> [0], -cross(r1 + u, n[0]), n[0],
//         cross(r2, n[0])
// wrong no-arms-n-turns (pencil and paper, upright, turned, moved, broken): const vec3 r1 =
//         to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local); ==> ;; cross(r1 + u,
//         n[i]) ==> n[i] ;; cross(r2, n[i]) ==> n[i]
// wrong "the block w1 is missing (pencil and paper, upright, turned, moved, broken)": r1 =
//         to_world(body1, anchor1_local), ==> ;; -cross(r1 + u, n[i]) ==> vec3(0)
// mistake "a lever has its length: it is no unit vector": to_world(body1, anchor1_local), r2 =
//         to_world(body2, anchor2_local) ==> normalize(to_world(body1, anchor1_local) + u); const
//         vec3 r2 = normalize(to_world(body2, anchor2_local)) ;; + u, ==> ,
// expects: (pencil and paper, upright, turned, moved, broken)
// wrong order-of-blocks (pencil and paper, upright, turned, moved, broken): -cross ==> n[i], -cross
//         ;; n[i], cross ==> cross
// mistake "a point where a lever belongs: the lever of body 1 is r1 + u":  to_world ==> world_point
//         ;; to_world ==> world_point
// expects: (pencil and paper, upright, turned, moved, broken)
// mistake "the sign of u or of r1, the lever of body 1 is r1 + u":  + u ==> - u
// expects: (pencil and paper, turned, moved, broken)
// wrong r1-for-both (pencil and paper, upright, turned, moved, broken): r2, ==> r1 + u,
// mistake "the lever of body 2 is r2, not r1": r2, ==> r1,
// expects: (pencil and paper, upright, turned, moved, broken)
// wrong "in one row alone: u is forgotten, the lever of body 1 is r1 + u, because n rides on body 1
//         (pencil and paper, turned, moved, broken)":  for (int i = 0; i < 2; ++i) J[i] = {-n[i],
//         -cross(r1 + u, n[i]), n[i], cross(r2, n[i])} ==> J[0] = {-n[0], -cross(r1 + u, n[0]),
//         n[0], cross(r2, n[0])}; J[1] = {-n[1], -cross(r1, n[1]), n[1], cross(r2, n[1])}
// wrong "the rows C.1 and C.2 are exchanged (pencil and paper, upright, turned, moved, broken)":
//          [i] ==> [1 - i]
// wrong "J[1], the row C.2, is zero: was it never written? (pencil and paper, upright, turned,
//         moved, broken)":  2; ==> 1;
// wrong "w2 of J[1] is that of J[0] (pencil and paper, upright, turned, moved, broken)": r2, n[i]
//         ==> r2, n[0]
// mistake "the levers r1 and r2 are exchanged": body2, anchor2_local ==> body1, anchor1_local ;;
//         body1, anchor1_local ==> body2, anchor2_local
// expects: (pencil and paper, upright, turned, moved, broken)
// wrong "the levers of both bodies are turned the wrong way round: to_world, not to_local (pencil
//         and paper, upright, turned, moved, broken)":  to_world ==> to_local ;; to_world ==>
//         to_local
// mistake "u belongs to the lever of body 1 alone": r2, ==> r2 + u,
// expects: (pencil and paper, turned, moved, broken)
// wrong never-set: J[i] = {-n[i], -cross(r1 + u, n[i]), n[i], cross(r2, n[i])}; ==> { real k[3];
//         for (int j = 0; j < 3; ++j) k[j] += cross(r2, n[i])[j]; J[i] = {-n[i], -cross(r1 + u,
//         n[i]), n[i], vec3(k[0], k[1], k[2])}; }
// mistake "n is left in body space: turn it into the world with body 1": J[i] = {-n[i], -cross(r1 +
//         u, n[i]), n[i], cross(r2, n[i])}; ==> { const vec3 m = i == 0 ? n1_local : n2_local; J[i]
//         = {-m, -cross(r1 + u, m), m, cross(r2, m)}; }
// expects: (turned, moved, broken)
// mistake "n is turned with body 2 here, but n rides on body 1": J[i] = {-n[i], -cross(r1 + u,
//         n[i]), n[i], cross(r2, n[i])}; ==> { const vec3 m = to_world(body2, i == 0 ? n1_local :
//         n2_local); J[i] = {-m, -cross(r1 + u, m), m, cross(r2, m)}; }
// expects: Likely mistake: n is turned with body 2 here, but n rides on body 1 (upright, turned,
// expects: moved, broken)
// mistake "u is forgotten, the lever of body 1 is r1 + u, because n rides on body 1": + u ==>
// expects: (turned, moved, broken)
// right J skew: vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local) ==>
//         mat3 L1 = skew(to_world(body1, anchor1_local) + u); const mat3 L2 = skew(to_world(body2,
//         anchor2_local)) ;; J[i] = {-n[i], -cross(r1 + u, n[i]), n[i], cross(r2, n[i])}; ==> {
//         J[i].v1 = -n[i]; J[i].w1 = n[i] * L1; J[i].v2 = n[i]; J[i].w2 = L2 * n[i]; }
// right J with n first in the products:
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const Row rows[] = {
      Row{-n[0], cross(n[0], r1 + u), n[0], -cross(n[0], r2)},
      Row{-n[1], cross(n[1], r1) + cross(n[1], u), n[1], cross(r2, n[1])}};
  return {{rows[0], rows[1]}};
// right lever to the point of body 2:
  // r1 + u is the vector from the centre of body 1 to the point of body 2.
  const vec3 p2 = world_point(body2, anchor2_local);
  return {{Row{-n[0], cross(n[0], p2 - body1.x), n[0], cross(p2 - body2.x, n[0])},
           Row{-n[1], cross(n[1], p2 - body1.x), n[1], cross(p2 - body2.x, n[1])}}};
// wrong units "J.w1 is a pure number and should be in m: a lever is missing":
  return {{Row{-n[0], -n[0], n[0], n[0]}, Row{-n[1], -n[1], n[1], n[1]}}};
// mistake "r1 is forgotten, the lever of body 1 is r1 + u": -cross(r1 + u, n[i]) ==> -cross(u,
//         n[i]) ;; , cross(r2, n[i]) ==> , cross(r2, n[i])
// mistake "the sign of u or of r1, the lever of body 1 is r1 + u": -cross(r1 + u, n[i]) ==>
//         -cross(u - r1, n[i]) ;; , cross(r2, n[i]) ==> , cross(r2, n[i])
// mistake "u belongs to the lever of body 1: n rides on body 1": -cross(r1 + u, n[i]) ==>
//         -cross(r1, n[i]) ;; , cross(r2, n[i]) ==> , cross(r2 + u, n[i])
// mistake "u belongs to the lever of body 1: n rides on body 1": -cross(r1 + u, n[i]) ==>
//         -cross(r1, n[i]) ;; , cross(r2, n[i]) ==> , cross(r2 - u, n[i])
// mistake "u belongs to the lever of body 1 alone": -cross(r1 + u, n[i]) ==> -cross(r1 + u, n[i])
//         ;; , cross(r2, n[i]) ==> , cross(r2 - u, n[i])
// mistake "the levers r1 and r2 are exchanged": -cross(r1 + u, n[i]) ==> -cross(r2 + u, n[i]) ;; ,
//         cross(r2, n[i]) ==> , cross(r1, n[i])
// mistake "the lever of body 1 is r1 + u, not r2 + u": -cross(r1 + u, n[i]) ==> -cross(r2 + u,
//         n[i]) ;; , cross(r2, n[i]) ==> , cross(r2, n[i])
// mistake "u belongs to the lever of body 1, all of it: n rides on body 1": -cross(r1 + u, n[i])
//         ==> -cross(r1 + u / real(2), n[i]) ;; , cross(r2, n[i]) ==> , cross(r2 - u / real(2),
//         n[i])
// mistake "u is turned with body 1 once more: the lever of body 1 is r1 + u, and u is in the
//         world": -cross(r1 + u, n[i]) ==> -cross(r1 + to_world(body1, u), n[i]) ;; , cross(r2,
//         n[i]) ==> , cross(r2, n[i])
// mistake "u is turned into the axes of body 1: the lever of body 1 is r1 + u, all in the world":
//         -cross(r1 + u, n[i]) ==> -cross(r1 + to_local(body1, u), n[i]) ;; , cross(r2, n[i]) ==> ,
//         cross(r2, n[i])
// mistake "the levers are turned twice: to_world has turned them already": -cross(r1 + u, n[i]) ==>
//         -cross(to_world(body1, r1) + u, n[i]) ;; , cross(r2, n[i]) ==> , cross(to_world(body2,
//         r2), n[i])
// mistake "the lever r1 is turned twice: to_world has turned it already": -cross(r1 + u, n[i]) ==>
//         -cross(to_world(body1, r1) + u, n[i]) ;; , cross(r2, n[i]) ==> , cross(r2, n[i])
// mistake "the lever r2 is turned twice: to_world has turned it already": -cross(r1 + u, n[i]) ==>
//         -cross(r1 + u, n[i]) ;; , cross(r2, n[i]) ==> , cross(to_world(body2, r2), n[i])
// mistake "centres in place of anchors: u is p2 - p1": -cross(r1 + u, n[i]) ==> -cross(r1 +
//         (body2.x - body1.x), n[i]) ;; , cross(r2, n[i]) ==> , cross(r2, n[i])
// mistake "centres in place of anchors: u is p2 - p1": -cross(r1 + u, n[i]) ==> -cross((body2.x -
//         body1.x), n[i]) ;; , cross(r2, n[i]) ==> , cross(r2, n[i])
// mistake "a point where a lever belongs: the lever of body 1 is r1 + u": -cross(r1 + u, n[i]) ==>
//         -cross(body1.x + r1, n[i]) ;; , cross(r2, n[i]) ==> , cross(r2, n[i])
// mistake "a point where a lever belongs: the lever of body 1 is r1 + u": -cross(r1 + u, n[i]) ==>
//         -cross(body1.x + r1, n[i]) ;; , cross(r2, n[i]) ==> , cross(body2.x + r2, n[i])
// mistake "a point where a lever belongs: the lever of body 1 is r1 + u": -cross(r1 + u, n[i]) ==>
//         -cross(body2.x + r2, n[i]) ;; , cross(r2, n[i]) ==> , cross(r2, n[i])
// mistake "a point where a lever belongs: the lever of body 1 is r1 + u": -cross(r1 + u, n[i]) ==>
//         -cross(body2.x + r2, n[i]) ;; , cross(r2, n[i]) ==> , cross(body2.x + r2, n[i])
// mistake "body-space lever: the lever of body 1 is not turned into the world": -cross(r1 + u,
//         n[i]) ==> -cross(anchor1_local + u, n[i]) ;; , cross(r2, n[i]) ==> , cross(r2, n[i])
// mistake "body-space lever: the lever of body 2 is not turned into the world": -cross(r1 + u,
//         n[i]) ==> -cross(r1 + u, n[i]) ;; , cross(r2, n[i]) ==> , cross(anchor2_local, n[i])
// mistake "body-space lever: r1 and r2 are not turned into the world": -cross(r1 + u, n[i]) ==>
//         -cross(anchor1_local + u, n[i]) ;; , cross(r2, n[i]) ==> , cross(anchor2_local, n[i])
// mistake "n is turned with body 2 here, but n rides on body 1": J[i] = {-n[i], -cross(r1 + u,
//         n[i]), n[i], cross(r2, n[i])}; ==> { const vec3 m = to_world(body2, i == 0 ? n1_local :
//         n2_local); J[i] = {-m, -cross(r1, m), m, cross(r2, m)}; }
// mistake "n is left in body space: turn it into the world with body 1": J[i] = {-n[i], -cross(r1 +
//         u, n[i]), n[i], cross(r2, n[i])}; ==> { const vec3 m = i == 0 ? n1_local : n2_local; J[i]
//         = {-m, -cross(r1, m), m, cross(r2, m)}; }
// mistake "the unit vector along u in the place of n: the row runs along n": J[i] = {-n[i],
//         -cross(r1 + u, n[i]), n[i], cross(r2, n[i])}; ==> { const vec3 m = normalize(u); J[i] =
//         {-m, -cross(r1, m), m, cross(r2, m)}; }
// mistake "levers are missing: such a row drives the centres, not the points": -cross(r1 + u, n[i])
//         ==> vec3(0) ;; , cross(r2, n[i]) ==> , vec3(0)
// mistake "levers are missing: such a row drives the centres, not the points, and its sign is wrong
//         as well": {-n[i], -cross(r1 + u, n[i]), n[i], cross(r2, n[i])} ==> {n[i], vec3(0), -n[i],
//         vec3(0)}
// mistake "u is forgotten, the lever of body 1 is r1 + u, because n rides on body 1": + u ==>
