// expects: Likely mistake: centres in place of anchors: u is p2 - p1
  return dot(body2.x - body1.x, to_world(body1, a1_local));
