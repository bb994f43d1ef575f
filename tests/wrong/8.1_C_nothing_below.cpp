// expects: Likely mistake: nothing below the top
  return std::max(real(0), dot(up(body1), point(body1, body2) - body1.x) - height);
