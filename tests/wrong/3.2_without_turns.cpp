// expects: Likely mistake: the turns are missing: the blocks w1 and w2
  return body1.inverse_mass * dot(a.v1, b.v1) + body2.inverse_mass * dot(a.v2, b.v2);
