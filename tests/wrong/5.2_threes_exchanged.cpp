// expects: Likely mistake: the two threes are exchanged: the point's rows come first
  const vec3 turn(impulse[0], impulse[1], impulse[2]), push(impulse[3], impulse[4], impulse[5]);
  return {push / h, turn / h};
