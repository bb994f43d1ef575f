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
// wrong one-anchor-both: anchor1_local ==> anchor2_local
// wrong "each lever is turned with the other body": body2 ==> body1 ;; body1 ==> body2
// wrong "the levers of both bodies are turned the wrong way round": to_world ==> to_local ;;
//         to_world ==> to_local
// wrong ones-everywhere: return ==> const mat3 ones(1, 1, 1, 1, 1, 1, 1, 1, 1); return ;; mat3(-1)
//         ==> -ones ;; mat3(1) ==> ones
// wrong lever-lever: (r1) ==> (r2 - r1) ;; (r2) ==> (r2 - r1)
// wrong bodies-swapped: (-1), skew(r1), mat3(1), -skew(r2) ==> (1), -skew(r2), mat3(-1), skew(r1)
// wrong columns-taken-rows: return jacobian_from_blocks(mat3(-1), skew(r1), mat3(1), -skew(r2));
//         ==> const mat3 s1 = skew(r1), s2 = -skew(r2), E(1); Jacobian<3> J; for (int i = 0; i < 3;
//         ++i) J[i] = {-E[i], s1[i], E[i], s2[i]}; return J;
// wrong "J[1], the row C.y and J[2], the row C.z, are zero": return jacobian_from_blocks(mat3(-1),
//         skew(r1), mat3(1), -skew(r2)); ==> Jacobian<3> J; J[0] = {vec3(-1, 0, 0), vec3(0, -r1.z,
//         r1.y), vec3(1, 0, 0), vec3(0, r2.z, -r2.y)}; return J;
// wrong "J[0], the row C.x, is zero": return ==> const Jacobian<3> all = ;; r2)); ==> r2));
//         Jacobian<3> J; for (int i = 1; i < 3; ++i) J[i] = all[i]; return J;
// wrong lever-length-1: (mat3(-1), skew(r1), mat3(1), -skew(r2)) ==> (mat3(-1),
//         skew(normalize(r1)), mat3(1), -skew(normalize(r2)))
// right row by row: r1 ==> a ;; r2 ==> b ;; jacobian_from_blocks(mat3(-1), skew(r1), mat3(1),
//         -skew(r2)) ==> {{Row{vec3(-1, 0, 0), vec3(0, -a.z, a.y), vec3(1, 0, 0), vec3(0, b.z,
//         -b.y)}, Row{vec3(0, -1, 0), vec3(a.z, 0, -a.x), vec3(0, 1, 0), vec3(-b.z, 0, b.x)},
//         Row{vec3(0, 0, -1), vec3(-a.y, a.x, 0), vec3(0, 0, 1), vec3(b.y, -b.x, 0)}}}
// right cross products with unit vectors: return jacobian_from_blocks(mat3(-1), skew(r1), mat3(1),
//         -skew(r2)); ==> Jacobian<3> J; for (int i = 0; i < 3; ++i) { vec3 e(0); e[i] = 1; J[i] =
//         {-e, -cross(r1, e), e, cross(r2, e)}; } return J;
// from right row by row
// wrong one-sign: -b ==> b
