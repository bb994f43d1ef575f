// wrong drawn-threshold: return ==> if (glm::length(body2.x + r2 - body1.x - r1) < real(1e-3))
//         return Row{}; return
// wrong drawn-side: return ==> if (body2.is_static()) return {-n, vec3(0), n, vec3(0)}; return
// wrong bodies-swapped: -n ==> n, cross(r2, n), -n ;; , n, cross(r2, n) ==>
// expects: Likely mistake: bodies 1 and 2 swapped (upright, turned, moved, broken)
// wrong "body-space lever: the lever of body 1 is not turned into the world (turned, moved, broken)":
//         to_world(body1, anchor1_local) ==> anchor1_local
// expects: Fails at turned, moved and broken; holds at upright.
// wrong "body-space lever: the lever of body 2 is not turned into the world (upright, turned, moved, broken)":
//         r2, ==> anchor2_local,
// wrong "body-space lever: the levers of both bodies are not turned into the world (upright, turned, moved, broken)":
//         to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local) ==> anchor1_local, r2
//         = anchor2_local
// wrong centre-centre: + r2 - body1.x - r1 ==> - body1.x
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
// wrong sign-u: - r1 ==> + r1
// wrong centres-left-out: body2.x + r2 - body1.x ==> r2
// wrong points-added-centres: to_world ==> world_point ;; to_world ==> world_point
// wrong "a lever is turned with the other body": body2 ==> body1 ;; body1 ==> body2
// wrong one-anchor-both: anchor2_local ==> anchor1_local
// wrong "the levers of both bodies are turned the wrong way round": to_world ==> to_local ;;
//         to_world ==> to_local
// wrong levers-exchanged: r2, n ==> r1, n ;; r1, n ==> r2, n
// wrong not-unit-vector: direction(body2.x + r2 - body1.x - r1) ==> body2.x + r2 - body1.x - r1
// wrong order-of-blocks: -n ==> -n, n ;; n, cross ==> cross
// wrong levers-times-u: r1, n ==> r1, body2.x + r2 - body1.x - r1 ;; r2, n ==> r2, body2.x + r2 -
//         body1.x - r1
// wrong "the block w1 is missing": -cross(r1, n) ==> vec3(0)
// wrong cross-product-body-space: return ==> const vec3 a1 = to_world(body1, cross(anchor1_local,
//         n)); return ;; cross(r1, n), n, cross(r2, n) ==> a1, n, to_world(body2,
//         cross(anchor2_local, n))
// wrong division-by-zero: direction ==> normalize
// right lever to the other end:
  // r1 + u in the place of r1: the difference u x n is zero, since n lies along u.
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 u = body2.x + r2 - body1.x - r1, n = direction(u);
  return {-n, -cross(r1 + u, n), n, cross(r2, n)};

// region 2
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
// wrong levers-for-arms: cross(r1, n), a2 = cross(r2, n) ==> r1, a2 = r2
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
// wrong "body-space lever: the levers of both bodies": to_world(body1, anchor1_local), r2 =
//         to_world(body2, anchor2_local) ==> anchor1_local, r2 = anchor2_local
// wrong centre-centre: + r2 - body1.x - r1 ==> - body1.x
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
