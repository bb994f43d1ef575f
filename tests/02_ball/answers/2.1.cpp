// Known answers of exercise 2.1, each put in the place of the solution's.

// ---- wrong: body space arms
// expects: Likely mistake: body-space arm: the levers of both bodies are not turned into the world
// expects: (upright, turned, moved, broken)
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

// ---- right: row by row
// The block w of row i is r x e_i, written out entry by entry.
  const vec3 a = to_world(body1, anchor1_local), b = to_world(body2, anchor2_local);
  return {{Row{vec3(-1, 0, 0), vec3(0, -a.z, a.y), vec3(1, 0, 0), vec3(0, b.z, -b.y)},
           Row{vec3(0, -1, 0), vec3(a.z, 0, -a.x), vec3(0, 1, 0), vec3(-b.z, 0, b.x)},
           Row{vec3(0, 0, -1), vec3(-a.y, a.x, 0), vec3(0, 0, 1), vec3(b.y, -b.x, 0)}}};
