// expects: Likely mistake: the size of C: below the top it is negative
  return std::abs(dot(up(body1), point(body1, body2) - body1.x) - height);
