// wrong drawn-threshold: return ==> if (glm::length(body2.x + r2 - body1.x - r1) < real(1e-3))
//         return Row{}; return
// wrong drawn-side: return ==> if (body2.is_static()) return {-n, vec3(0), n, vec3(0)}; return
// wrong bodies-swapped: -n ==> n, cross(r2, n), -n ;; , n, cross(r2, n) ==>
// expects: Likely mistake: bodies 1 and 2 swapped (upright, turned, moved, broken)
// mistake "the direction runs from centre to centre, not from anchor to anchor": + r2 - body1.x -
//         r1 ==> - body1.x
// expects: (upright, turned, moved, broken)
// wrong order-cross-products (pencil and paper, upright, turned, moved, broken): r1, n ==> n, r1 ;;
//         r2, n ==> n, r2
// expects: Likely mistake: the sign of the blocks w1 and w2: a x b is -(b x a) (upright, turned,
// wrong "the sign of the block w1 (upright, turned, moved, broken)": -cross ==> cross
// wrong without-levers (pencil and paper, upright, turned, moved, broken):
// expects: Likely mistake: the blocks w1 and w2 are missing: they hold the levers (upright,
  const vec3 u = world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
  const vec3 n = direction(u);
  return {-n, vec3(0), n, vec3(0)};
// mistake "a sign in u: it is x2 + r2 - x1 - r1": - r1 ==> + r1
// mistake "the centres are missing in u: it is x2 + r2 - x1 - r1": body2.x + r2 - body1.x ==> r2
// mistake "points where levers belong: world_point adds the centre, to_world does not": to_world
//         ==> world_point ;; to_world ==> world_point
// wrong "a lever is turned with the other body": body2 ==> body1 ;; body1 ==> body2
// mistake "one anchor for both bodies: each has its own": anchor2_local ==> anchor1_local
// wrong "the levers of both bodies are turned the wrong way round": to_world ==> to_local ;;
//         to_world ==> to_local
// wrong levers-exchanged: r2, n ==> r1, n ;; r1, n ==> r2, n
// mistake "not a unit vector: take direction(...) of the difference": direction(body2.x + r2 -
//         body1.x - r1) ==> body2.x + r2 - body1.x - r1
// wrong order-of-blocks: -n ==> -n, n ;; n, cross ==> cross
// mistake "r x n takes the unit vector n, not u": r1, n ==> r1, body2.x + r2 - body1.x - r1 ;; r2,
//         n ==> r2, body2.x + r2 - body1.x - r1
// wrong "the block w1 is missing": -cross(r1, n) ==> vec3(0)
// mistake "the cross product comes too early: the lever is turned into the world first": return ==>
//         const vec3 a1 = to_world(body1, cross(anchor1_local, n)); return ;; cross(r1, n), n,
//         cross(r2, n) ==> a1, n, to_world(body2, cross(anchor2_local, n))
// wrong division-by-zero: direction ==> normalize
// right lever to the other end:
  // r1 + u in the place of r1: the difference u x n is zero, since n lies along u.
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 u = body2.x + r2 - body1.x - r1, n = direction(u);
  return {-n, -cross(r1 + u, n), n, cross(r2, n)};
// mistake "divided by the length of the rod: that is the distance only while C = 0":
//         direction(body2.x + r2 - body1.x - r1) ==> (body2.x + r2 - body1.x - r1) / length
// mistake "divided by the distance twice: n is a unit vector already": direction(body2.x + r2 -
//         body1.x - r1) ==> direction(body2.x + r2 - body1.x - r1) / glm::length(body2.x + r2 -
//         body1.x - r1)
// mistake "the positions are added: the direction is their difference": - body1.x - r1 ==> +
//         body1.x + r1
// mistake "the position of body 1 is missing in the direction": - body1.x - r1 ==>
// mistake "the sign of each number of the direction is lost": direction(body2.x + r2 - body1.x -
//         r1) ==> abs(direction(body2.x + r2 - body1.x - r1))
// mistake "the sign of the error is in the row: it belongs to the bias, and J is independent of
//         it": direction(body2.x + r2 - body1.x - r1) ==> (error(body1, body2) < 0 ? real(-1) :
//         real(1)) * direction(body2.x + r2 - body1.x - r1)
// mistake "the row is 0 while the rod is too short: a rod pushes, too": return ==> if (error(body1,
//         body2) < 0) return Row{}; return
// mistake "the row is 0 where the error is 0: a row constrains velocities, also there": return ==>
//         if (std::abs(error(body1, body2)) < real(1e-3)) return Row{}; return
// mistake "the row is multiplied by the error: the error belongs to the bias": direction(body2.x +
//         r2 - body1.x - r1) ==> error(body1, body2) * direction(body2.x + r2 - body1.x - r1)
// mistake "the row is multiplied by the length of the rod": direction(body2.x + r2 - body1.x - r1)
//         ==> length * direction(body2.x + r2 - body1.x - r1)
// mistake "the x of the direction is left out": n = direction(body2.x + r2 - body1.x - r1) ==> m =
//         direction(body2.x + r2 - body1.x - r1), n(0, m.y, m.z)
// mistake "the x of the direction is left out": n = direction(body2.x + r2 - body1.x - r1) ==> m =
//         body2.x + r2 - body1.x - r1, n = direction(vec3(0, m.y, m.z))
// mistake "the y of the direction is left out": n = direction(body2.x + r2 - body1.x - r1) ==> m =
//         direction(body2.x + r2 - body1.x - r1), n(m.x, 0, m.z)
// mistake "the y of the direction is left out": n = direction(body2.x + r2 - body1.x - r1) ==> m =
//         body2.x + r2 - body1.x - r1, n = direction(vec3(m.x, 0, m.z))
// mistake "the z of the direction is left out": n = direction(body2.x + r2 - body1.x - r1) ==> m =
//         direction(body2.x + r2 - body1.x - r1), n(m.x, m.y, 0)
// mistake "the z of the direction is left out": n = direction(body2.x + r2 - body1.x - r1) ==> m =
//         body2.x + r2 - body1.x - r1, n = direction(vec3(m.x, m.y, 0))
// mistake "the direction runs from centre to centre, not from anchor to anchor": body2.x + r2 -
//         body1.x - r1 ==> body2.x - body1.x ;; -cross(r1, n) ==> vec3(0) ;; cross(r2, n) ==>
//         vec3(0)
// mistake "the lever of body 1 is missing in u": - r1 ==>
// mistake "the lever of body 2 is missing in u": body2.x + r2 ==> body2.x
// mistake "a sign in u: it is x2 + r2 - x1 - r1": + r2 ==> - r2
// mistake "a sign in u: it is x2 + r2 - x1 - r1": body2.x + r2 - body1.x - r1 ==> body2.x - r2 -
//         body1.x + r1
// mistake "the centres are counted twice in u: world_point adds them already": body2.x + r2 -
//         body1.x - r1 ==> body2.x + body2.x + r2 - body1.x - body1.x - r1
// mistake "the lever runs from the body's own centre to its own anchor, not from anchor to anchor":
//         cross(r1, n) ==> cross(r2 - r1, n) ;; cross(r2, n) ==> cross(r2 - r1, n)
// mistake "one anchor for both bodies: each has its own": anchor1_local ==> anchor2_local
// mistake "the cross products are turned into the axes of the bodies: J is in world axes":
//         -cross(r1, n) ==> -to_local(body1, cross(r1, n)) ;; cross(r2, n)} ==> to_local(body2,
//         cross(r2, n))}
// mistake "the cross products are turned once more: lever and direction are in the world already":
//         -cross(r1, n) ==> -to_world(body1, cross(r1, n)) ;; cross(r2, n)} ==> to_world(body2,
//         cross(r2, n))}
// mistake "the cross product in w1 is turned into the axes of body 1: J is in world axes":
//         -cross(r1, n) ==> -to_local(body1, cross(r1, n))
// mistake "the cross product in w2 is turned into the axes of body 2: J is in world axes": ,
//         cross(r2, n) ==> , to_local(body2, cross(r2, n))
// mistake "the levers are turned twice: to_world has turned them already": -cross(r1, n) ==>
//         -cross(to_world(body1, r1), n) ;; , cross(r2, n) ==> , cross(to_world(body2, r2), n)
// mistake "the levers are turned twice: to_world has turned them already": to_world(body1,
//         anchor1_local), r2 = to_world(body2, anchor2_local) ==> to_world(body1, to_world(body1,
//         anchor1_local)), r2 = to_world(body2, to_world(body2, anchor2_local))
// mistake "the lever of body 1 is turned twice: to_world has turned it already": to_world(body1,
//         anchor1_local) ==> to_world(body1, to_world(body1, anchor1_local))
// mistake "the lever of body 2 is turned twice: to_world has turned it already": to_world(body2,
//         anchor2_local) ==> to_world(body2, to_world(body2, anchor2_local))
// mistake "body-space lever: the lever of body 1 is not turned into the world": to_world(body1,
//         anchor1_local) ==> anchor1_local
// expects: Fails at turned, moved and broken; holds at upright.
// mistake "body-space lever: the lever of body 2 is not turned into the world": to_world(body2,
//         anchor2_local) ==> anchor2_local
// mistake "body-space lever: the levers of both bodies are not turned into the world":
//         to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local) ==> anchor1_local, r2
//         = anchor2_local
// mistake "body-space lever: in w1 the lever of body 1 is not turned into the world": cross(r1, n)
//         ==> cross(anchor1_local, n)
// mistake "body-space lever: in w2 the lever of body 2 is not turned into the world": cross(r2, n)
//         ==> cross(anchor2_local, n)
// mistake "body-space lever: in w1 and w2 the levers are not turned into the world": cross(r1, n)
//         ==> cross(anchor1_local, n) ;; cross(r2, n) ==> cross(anchor2_local, n)
// wrong "right only where body 1 is not turned: something of it is left in the body's axes, or is
//         turned twice": -cross(r1, n) ==> -cross(r1, to_local(body1, n))

// region 2
// wrong "only the diagonal of the world inertia is used: it has nine entries": const vec3 r1 ==>
//         const auto diagonal = [](const Body& body) { const mat3 I = inverse_inertia(body); return
//         mat3(I[0][0], 0, 0, 0, I[1][1], 0, 0, 0, I[2][2]); }; const vec3 r1 ;;
//         inverse_inertia(body1) * a1 ==> diagonal(body1) * a1 ;; inverse_inertia(body2) * a2 ==>
//         diagonal(body2) * a2
// wrong "the rotation's terms are halved: each stands once in K": + dot(a1, ==> + real(0.5) *
//         dot(a1, ;; dot(a2, ==> real(0.5) * dot(a2,
// wrong "the rotation's terms are doubled: each stands once in K": + dot(a1, ==> + 2 * dot(a1, ;;
//         dot(a2, ==> 2 * dot(a2,
// wrong "the cross product in w1 is turned into the axes of body 1: J is in world axes":
//         a1 = cross(r1, n) ==> a1 = to_local(body1, cross(r1, n))
// right K from the row fresh:
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  const Row J{-n, -cross(r1, n), n, cross(r2, n)};
  return body1.inverse_mass * dot(J.v1, J.v1) + dot(J.w1, inverse_inertia(body1) * J.w1) +
         body2.inverse_mass * dot(J.v2, J.v2) + dot(J.w2, inverse_inertia(body2) * J.w2);
// wrong drawn-threshold: return ==> return real(1e-9) +
// wrong body-space-inertia-both (upright, turned, moved, broken): inverse_inertia(body1) ==>
//         body1.inverse_inertia_local ;; inverse_inertia(body2) ==> body2.inverse_inertia_local
// wrong without-rotation:
// expects: Likely mistake: the term of the rotation is missing (upright, turned, moved, broken)
  return body1.inverse_mass + body2.inverse_mass;
// wrong inertias-exchanged: (body1) ==> (body2) ;; (body2) * a2 ==> (body1) * a2
// mistake "the levers themselves stand beside the inertia: it is r x n, as in J": cross(r1, n), a2
//         = cross(r2, n) ==> r1, a2 = r2
// wrong sign-rotation: a1) + ==> a1) -
// wrong rotation-body-2-left: + dot(a2, inverse_inertia(body2) * a2) ==>
// wrong rotation-body-1-twice: a2, inverse_inertia(body2) * a2 ==> a1, inverse_inertia(body1) * a1
// wrong without-inertia: inverse_inertia(body1) * ==> ;; inverse_inertia(body2) * ==>
// wrong mass-for-inertia: dot(a1, inverse_inertia(body1) * a1) ==> body1.inverse_mass * dot(a1, a1)
//         ;; dot(a2, inverse_inertia(body2) * a2) ==> body2.inverse_mass * dot(a2, a2)
// wrong one-moment: inverse_inertia(body1) ==> body1.inverse_inertia_local.x ;;
//         inverse_inertia(body2) ==> body2.inverse_inertia_local.x
// wrong without-masses: body1.inverse_mass + body2.inverse_mass + ==>
// wrong inverse-of-k: return ==> return 1 / ( ;; a2) ==> a2))
// mistake "the direction runs from centre to centre, not from anchor to anchor": + r2 - body1.x -
//         r1 ==> - body1.x
// wrong inertia-inverse: inverse_inertia(body1) ==> inverse(inverse_inertia(body1)) ;;
//         inverse_inertia(body2) ==> inverse(inverse_inertia(body2))
// wrong world-inertia-half-turned: a2, inverse_inertia ==> a2, world ;; inverse_inertia ==> world
//         ;; const ==> const auto world = [](const Body& body) { const vec3 i =
//         body.inverse_inertia_local; const mat3 R = mat3_cast(body.q), local(i.x, 0, 0, 0, i.y, 0,
//         0, 0, i.z); return R * local; }; const
// wrong never-set: return ==> real k; k += ;; a2); ==> a2); return k;
// right K from the row:
  if (direction(world_point(body2, anchor2_local) - world_point(body1, anchor1_local)) == vec3(0))
    return body1.inverse_mass + body2.inverse_mass;
  const Row J = jacobian(body1, body2);
  return body1.inverse_mass * dot(J.v1, J.v1) + dot(J.w1, inverse_inertia(body1) * J.w1) +
         body2.inverse_mass * dot(J.v2, J.v2) + dot(J.w2, inverse_inertia(body2) * J.w2);
// wrong units "in K, adding 1/(kg m^2) to 1/kg: the levers are missing":
  const vec3 n = direction(world_point(body2, anchor2_local) - world_point(body1, anchor1_local));
  return body1.inverse_mass + body2.inverse_mass + dot(n, inverse_inertia(body1) * n) +
         dot(n, inverse_inertia(body2) * n);
// mistake "body-space lever: the levers of both bodies are not turned into the world":
//         to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local) ==> anchor1_local, r2
//         = anchor2_local
// mistake "body-space lever: the lever of body 1 is not turned into the world": to_world(body1,
//         anchor1_local) ==> anchor1_local
// mistake "body-space lever: the lever of body 2 is not turned into the world": to_world(body2,
//         anchor2_local) ==> anchor2_local
