// expects: Likely mistake: from centre to centre
  return dot(up(body1), body2.x - body1.x) - height;
