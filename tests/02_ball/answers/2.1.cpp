// Known answers of exercise 2.1, each put in the place of the solution's.

// ---- wrong: body space arms
// expects: Likely mistake: body-space lever: the levers of both bodies are not turned into
// expects: the world (upright, turned, moved, broken)
  return jacobian_from_blocks(mat3(-1), skew(anchor1_local), mat3(1), -skew(anchor2_local));

// ---- wrong: levers exchanged
// expects: Likely mistake: the levers r1 and r2 are exchanged
// expects: Likely mistake: the levers r1 and r2 are exchanged (upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return jacobian_from_blocks(mat3(-1), skew(r2), mat3(1), -skew(r1));

// ---- wrong: points for levers
// expects: Likely mistake: a point where a lever belongs: r runs from the body's centre to the
// expects: anchor (to_world, not world_point) (upright, turned, moved, broken)
  const vec3 p1 = world_point(body1, anchor1_local), p2 = world_point(body2, anchor2_local);
  return jacobian_from_blocks(mat3(-1), skew(p1), mat3(1), -skew(p2));

// ---- wrong: sign of all rows
// expects: Likely mistake: the sign of the whole row: C grows when body 2 moves positively
// expects: (upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return jacobian_from_blocks(mat3(1), -skew(r1), mat3(-1), skew(r2));

// ---- wrong: transposed levers
// expects: Likely mistake: the sign of the blocks w1 and w2: a x b is -(b x a)
// expects: Or columns for rows: skew(r)[i] is a column (upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return jacobian_from_blocks(mat3(-1), transpose(skew(r1)), mat3(1), -transpose(skew(r2)));

// ---- wrong: sign of w1
// expects: Likely mistake: the sign of the block w1
// change: skew ==> -skew

// ---- wrong: sign of v1
// expects: Likely mistake: the sign of the block v1
// change: -1 ==> 1

// ---- wrong: order of the blocks
// expects: Likely mistake: the order of the blocks
// change: skew(r1), mat3(1) ==> mat3(1), skew(r1)

// ---- wrong: without levers
// expects: Likely mistake: the blocks w1 and w2 are missing: they hold the levers
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return jacobian_from_blocks(mat3(-1), mat3(0), mat3(1), mat3(0));

// ---- wrong: one anchor for both
// expects: Likely mistake: one anchor for both bodies
// change: anchor1_local ==> anchor2_local

// ---- wrong: turned with the other body
// expects: Likely mistake: each lever is turned with the other body
  const vec3 r1 = to_world(body2, anchor1_local), r2 = to_world(body1, anchor2_local);
  return jacobian_from_blocks(mat3(-1), skew(r1), mat3(1), -skew(r2));

// ---- wrong: turned the wrong way round
// expects: Likely mistake: the levers of both bodies are turned the wrong way round
  const vec3 r1 = to_local(body1, anchor1_local), r2 = to_local(body2, anchor2_local);
  return jacobian_from_blocks(mat3(-1), skew(r1), mat3(1), -skew(r2));

// ---- wrong: ones everywhere
// expects: Likely mistake: E has ones on its diagonal alone
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const mat3 ones(1, 1, 1, 1, 1, 1, 1, 1, 1);
  return jacobian_from_blocks(-ones, skew(r1), ones, -skew(r2));

// ---- wrong: from lever to lever
// expects: Likely mistake: the lever runs from the body's own centre to its own anchor
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return jacobian_from_blocks(mat3(-1), skew(r2 - r1), mat3(1), -skew(r2 - r1));

// ---- wrong: bodies swapped
// expects: Likely mistake: bodies 1 and 2 swapped
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return jacobian_from_blocks(mat3(1), -skew(r2), mat3(-1), skew(r1));

// ---- wrong: columns taken as rows
// expects: Likely mistake: the sign of the blocks w1 and w2: a x b is -(b x a). Or columns
// change: return jacobian_from_blocks(mat3(-1), skew(r1), mat3(1), -skew(r2)); ==>
//         const mat3 s1 = skew(r1), s2 = -skew(r2), E(1); Jacobian<3> J; for (int i = 0; i < 3;
//         ++i) J[i] = {-E[i], s1[i], E[i], s2[i]}; return J;

// ---- wrong: only the first row
// expects: Likely mistake: J[1], the row C.y and J[2], the row C.z, are zero
// change: return jacobian_from_blocks(mat3(-1), skew(r1), mat3(1), -skew(r2)); ==>
//         Jacobian<3> J; J[0] = {vec3(-1, 0, 0), vec3(0, -r1.z, r1.y), vec3(1, 0, 0), vec3(0, r2.z,
//         -r2.y)}; return J;

// ---- wrong: first row left out
// expects: Likely mistake: J[0], the row C.x, is zero
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const Jacobian<3> all = jacobian_from_blocks(mat3(-1), skew(r1), mat3(1), -skew(r2));
  Jacobian<3> J;
  for (int i = 1; i < 3; ++i) J[i] = all[i];
  return J;

// ---- wrong: one sign
// expects: Likely mistake: the sign of single entries
  const vec3 a = to_world(body1, anchor1_local), b = to_world(body2, anchor2_local);
  return {{Row{vec3(-1, 0, 0), vec3(0, -a.z, a.y), vec3(1, 0, 0), vec3(0, b.z, b.y)},
           Row{vec3(0, -1, 0), vec3(a.z, 0, -a.x), vec3(0, 1, 0), vec3(-b.z, 0, b.x)},
           Row{vec3(0, 0, -1), vec3(-a.y, a.x, 0), vec3(0, 0, 1), vec3(b.y, -b.x, 0)}}};

// ---- wrong: lever of length 1
// expects: Likely mistake: a lever has its length
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return jacobian_from_blocks(mat3(-1), skew(normalize(r1)), mat3(1), -skew(normalize(r2)));

// ---- right: row by row
// The block w of row i is r x e_i, written out entry by entry.
  const vec3 a = to_world(body1, anchor1_local), b = to_world(body2, anchor2_local);
  return {{Row{vec3(-1, 0, 0), vec3(0, -a.z, a.y), vec3(1, 0, 0), vec3(0, b.z, -b.y)},
           Row{vec3(0, -1, 0), vec3(a.z, 0, -a.x), vec3(0, 1, 0), vec3(-b.z, 0, b.x)},
           Row{vec3(0, 0, -1), vec3(-a.y, a.x, 0), vec3(0, 0, 1), vec3(b.y, -b.x, 0)}}};

// ---- right: cross products with unit vectors
// change: return jacobian_from_blocks(mat3(-1), skew(r1), mat3(1), -skew(r2)); ==>
//         Jacobian<3> J; for (int i = 0; i < 3; ++i) { vec3 e(0); e[i] = 1; J[i] = {-e, -cross(r1,
//         e), e, cross(r2, e)}; } return J;
