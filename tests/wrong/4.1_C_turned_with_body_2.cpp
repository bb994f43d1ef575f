// expects: Likely mistake: n is turned with body 2: the line rides on body 1
  return {dot(u, to_world(body2, n1_local)), dot(u, to_world(body2, n2_local))};
