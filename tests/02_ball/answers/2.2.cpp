// wrong unit-matrix-between-walls: return mat3( ==> return mat3(real(1e-9)) + mat3(
// wrong body-space-inertia-both: const ==> const auto local = [](const Body& body) { const vec3 i =
//         body.inverse_inertia_local; return mat3(i.x, 0, 0, 0, i.y, 0, 0, 0, i.z); }; const ;; *
//         inverse_inertia ==> * local ;; * inverse_inertia ==> * local
// expects: I^-1 R^T (upright, turned, moved, broken)
// wrong number-plus-matrix: return mat3 ==> return
// expects: (upright, turned, moved, broken)
// wrong without-rotation:
// expects: Likely mistake: the term of the rotation is missing (upright, turned, moved, broken)
  return mat3(body1.inverse_mass + body2.inverse_mass);
// wrong without-transpose: transpose(s1) ==> s1 ;; transpose(s2) ==> s2
// expects: lacks a transpose) (upright, turned, moved, broken)
// wrong world-inertia-half-turned: const ==> const auto world = [](const Body& body) { const vec3 i
//         = body.inverse_inertia_local; const mat3 R = mat3_cast(body.q), local(i.x, 0, 0, 0, i.y,
//         0, 0, 0, i.z); return R * local; }; const ;; * inverse_inertia ==> * world ;; *
//         inverse_inertia ==> * world
// wrong world-inertia-half-turned-back: const ==> const auto world = [](const Body& body) { const
//         vec3 i = body.inverse_inertia_local; const mat3 R = mat3_cast(body.q), local(i.x, 0, 0,
//         0, i.y, 0, 0, 0, i.z); return local * transpose(R); }; const ;; * inverse_inertia ==> *
//         world ;; * inverse_inertia ==> * world
// wrong inertia-turned-wrong-way: const ==> const auto world = [](const Body& body) { const vec3 i
//         = body.inverse_inertia_local; const mat3 R = mat3_cast(body.q), local(i.x, 0, 0, 0, i.y,
//         0, 0, 0, i.z); return transpose(R) * local * R; }; const ;; * inverse_inertia ==> * world
//         ;; * inverse_inertia ==> * world
// wrong "body-space lever: the levers of both bodies": to_world(body1, anchor1_local) ==>
//         anchor1_local ;; (to_world(body2, anchor2_local)) ==> (anchor2_local)
// wrong inertias-exchanged: body2, anchor2_local ==> body1, anchor1_local ;; body1, anchor1_local
//         ==> body2, anchor2_local
// wrong inverse-of-k: return ==> return inverse( ;; (s2) ==> (s2))
// wrong without-masses: body1.inverse_mass + body2.inverse_mass ==> 0
// wrong mass-body-1-left: body1.inverse_mass + ==>
// wrong inverse-masses-multiplied: + body2 ==> ) * mat3(body2
// wrong order-product: * transpose(s2) ==> ;; * transpose(s1) + s2 ==> + s2 * transpose(s2) ;; s1 *
//         ==> s1 * transpose(s1) *
// wrong rotation-body-1-left: s1 * inverse_inertia(body1) * transpose(s1) + ==>
// wrong rotation-body-1-twice: s2 * inverse_inertia(body2) * transpose(s2) ==> s1 *
//         inverse_inertia(body1) * transpose(s1)
// wrong points-for-levers: to_world ==> world_point ;; , s2 ==> ; const mat3 s2 ;; to_world ==>
//         world_point
// wrong only-the-diagonal: return mat3(body1.inverse_mass + body2.inverse_mass) + ==> const mat3
//         turns = ;; (s2); ==> (s2); return mat3(body1.inverse_mass + body2.inverse_mass) +
//         mat3(turns[0][0], 0, 0, 0, turns[1][1], 0, 0, 0, turns[2][2]);
// wrong without-inertia: * inverse_inertia(body1) ==> ;; inverse_inertia(body2) * ==>
// wrong mass-for-inertia: inverse_inertia(body1) ==> mat3(body1.inverse_mass) ;;
//         inverse_inertia(body2) ==> mat3(body2.inverse_mass)
// wrong "the world inertia is turned once more: inverse_inertia(body) is in world axes already":
//         const mat3 ==> const auto again = [](const Body& body) { const mat3 R =
//         mat3_cast(body.q); return R * inverse_inertia(body) * transpose(R); }; const mat3 ;; *
//         inverse_inertia(body1) ==> * again(body1) ;; * inverse_inertia(body2) ==> * again(body2)
// wrong "the rotation's terms are halved: each stands once in K": + s1 * ==> + real(0.5) * s1 * ;;
//         s2 * ==> real(0.5) * s2 *
// wrong one-moment: inverse_inertia(body1) ==> body1.inverse_inertia_local.x ;;
//         inverse_inertia(body2) ==> body2.inverse_inertia_local.x
// wrong unit-matrix-between-walls: return mat3 ==> if (body1.is_static() && body2.is_static())
//         return mat3(1); return mat3
// right with minus signs: + s1 ==> - s1 ;; transpose(s1) + ==> s1 - ;; transpose(s2) ==> s2
// right transposed on the left: transpose(s2) ==> s2 ;; transpose(s1) + s2 ==> s1 + transpose(s2)
//         ;; s1 * ==> transpose(s1) *
// right from the rows:
  const Jacobian<3> J = jacobian(body1, body2);
  mat3 K;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      K[j][i] = body1.inverse_mass * dot(J[i].v1, J[j].v1) +
                body2.inverse_mass * dot(J[i].v2, J[j].v2) +
                dot(J[i].w1, inverse_inertia(body1) * J[j].w1) +
                dot(J[i].w2, inverse_inertia(body2) * J[j].w2);
  return K;
// wrong units "in K, adding kg m^4 to 1/kg: inertia where its inverse belongs":
//          inverse_inertia(body1) ==> inverse(inverse_inertia(body1)) ;; inverse_inertia(body2) ==>
//         inverse(inverse_inertia(body2))
// mistake "body-space lever: the levers of both bodies are not turned into the world":
//         to_world(body1, anchor1_local) ==> anchor1_local ;; (to_world(body2, anchor2_local)) ==>
//         (anchor2_local)
// mistake "body-space lever: the lever of body 1 is not turned into the world": to_world(body1,
//         anchor1_local) ==> anchor1_local
// mistake "body-space lever: the lever of body 2 is not turned into the world": (to_world(body2,
//         anchor2_local)) ==> (anchor2_local)
// mistake "the levers are turned twice: to_world has turned them already": to_world(body1,
//         anchor1_local) ==> to_world(body1, to_world(body1, anchor1_local)) ;; (to_world(body2,
//         anchor2_local)) ==> (to_world(body2, to_world(body2, anchor2_local)))
