// expects: Likely mistake: centres in place of anchors: u is p2 - p1
  const vec3 d = body2.x - body1.x;
  return {dot(d, to_world(body1, n1_local)), dot(d, to_world(body1, n2_local))};
