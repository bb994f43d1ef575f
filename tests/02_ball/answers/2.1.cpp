// wrong "body-space lever: the levers of both bodies are not turned into":
// expects: the world (upright, turned, moved, broken)
  return jacobian_from_blocks(mat3(-1), skew(anchor1_local), mat3(1), -skew(anchor2_local));
// wrong levers-exchanged: (r2) ==> (r1) ;; (r1) ==> (r2)
// expects: Likely mistake: the levers r1 and r2 are exchanged (upright, turned, moved, broken)
// wrong points-for-levers: r1 = to_world ==> p1 = world_point ;; r2 = to_world ==> p2 = world_point
//         ;; (r1) ==> (p1) ;; (r2) ==> (p2)
// expects: anchor (to_world, not world_point) (upright, turned, moved, broken)
// wrong sign-all-rows: (-1), skew(r1), mat3(1), - ==> (1), -skew(r1), mat3(-1),
// expects: (upright, turned, moved, broken)
// wrong "the sign of the block w1": skew ==> -skew
// wrong "the sign of the block v1": -1 ==> 1
// wrong order-of-blocks: skew(r1), mat3(1) ==> mat3(1), skew(r1)
// wrong without-levers: skew(r1), mat3(1), -skew(r2) ==> mat3(0), mat3(1), mat3(0)
// mistake "one anchor for both bodies: each has its own": anchor1_local ==> anchor2_local
// wrong "each lever is turned with the other body": body2 ==> body1 ;; body1 ==> body2
// wrong "the levers of both bodies are turned the wrong way round": to_world ==> to_local ;;
//         to_world ==> to_local
// mistake "E has ones on its diagonal alone: mat3(1)": return ==> const mat3 ones(1, 1, 1, 1, 1, 1,
//         1, 1, 1); return ;; mat3(-1) ==> -ones ;; mat3(1) ==> ones
// mistake "the lever runs from the body's own centre to its own anchor, not from lever to lever":
//         (r1) ==> (r2 - r1) ;; (r2) ==> (r2 - r1)
// wrong bodies-swapped: (-1), skew(r1), mat3(1), -skew(r2) ==> (1), -skew(r2), mat3(-1), skew(r1)
// mistake "the sign of the blocks w1 and w2: a x b is -(b x a). Or columns for rows: skew(r)[i] is
//         a column": return jacobian_from_blocks(mat3(-1), skew(r1), mat3(1), -skew(r2)); ==> const
//         mat3 s1 = skew(r1), s2 = -skew(r2), E(1); Jacobian<3> J; for (int i = 0; i < 3; ++i) J[i]
//         = {-E[i], s1[i], E[i], s2[i]}; return J;
// wrong "J[1], the row C.y and J[2], the row C.z, are zero": return jacobian_from_blocks(mat3(-1),
//         skew(r1), mat3(1), -skew(r2)); ==> Jacobian<3> J; J[0] = {vec3(-1, 0, 0), vec3(0, -r1.z,
//         r1.y), vec3(1, 0, 0), vec3(0, r2.z, -r2.y)}; return J;
// wrong "J[0], the row C.x, is zero": return ==> const Jacobian<3> all = ;; r2)); ==> r2));
//         Jacobian<3> J; for (int i = 1; i < 3; ++i) J[i] = all[i]; return J;
// mistake "a lever has its length: it is no unit vector": (mat3(-1), skew(r1), mat3(1), -skew(r2))
//         ==> (mat3(-1), skew(normalize(r1)), mat3(1), -skew(normalize(r2)))
// right row by row: r1 ==> a ;; r2 ==> b ;; jacobian_from_blocks(mat3(-1), skew(r1), mat3(1),
//         -skew(r2)) ==> {{Row{vec3(-1, 0, 0), vec3(0, -a.z, a.y), vec3(1, 0, 0), vec3(0, b.z,
//         -b.y)}, Row{vec3(0, -1, 0), vec3(a.z, 0, -a.x), vec3(0, 1, 0), vec3(-b.z, 0, b.x)},
//         Row{vec3(0, 0, -1), vec3(-a.y, a.x, 0), vec3(0, 0, 1), vec3(b.y, -b.x, 0)}}}
// right cross products with unit vectors: return jacobian_from_blocks(mat3(-1), skew(r1), mat3(1),
//         -skew(r2)); ==> Jacobian<3> J; for (int i = 0; i < 3; ++i) { vec3 e(0); e[i] = 1; J[i] =
//         {-e, -cross(r1, e), e, cross(r2, e)}; } return J;
// mistake "one anchor for both bodies: each has its own": anchor2_local ==> anchor1_local
// mistake "the lever of body 1 runs to its own anchor, not to that of body 2": skew(r1) ==>
//         skew(body2.x + r2 - body1.x)
// mistake "the levers are turned twice: to_world has turned them already": to_world(body1,
//         anchor1_local), r2 = to_world(body2, anchor2_local) ==> to_world(body1, to_world(body1,
//         anchor1_local)), r2 = to_world(body2, to_world(body2, anchor2_local))
// mistake "the lever of body 1 is turned twice: to_world has turned it already": to_world(body1,
//         anchor1_local) ==> to_world(body1, to_world(body1, anchor1_local))
// mistake "the lever of body 2 is turned twice: to_world has turned it already": to_world(body2,
//         anchor2_local) ==> to_world(body2, to_world(body2, anchor2_local))
// mistake "body-space lever: the lever of body 1 is not turned into the world": to_world(body1,
//         anchor1_local) ==> anchor1_local
// mistake "body-space lever: the lever of body 2 is not turned into the world": to_world(body2,
//         anchor2_local) ==> anchor2_local
// from right row by row
// wrong one-sign: -b ==> b
