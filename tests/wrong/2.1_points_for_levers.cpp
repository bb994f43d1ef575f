// expects: Likely mistake: a point where a lever belongs: r runs from the body's centre to the
// expects: anchor (to_world, not world_point) (upright, turned, moved, broken)
  const vec3 p1 = world_point(body1, anchor1_local), p2 = world_point(body2, anchor2_local);
  return jacobian_from_blocks(mat3(-1), skew(p1), mat3(1), -skew(p2));
