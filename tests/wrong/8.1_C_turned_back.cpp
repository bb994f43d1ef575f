// expects: Likely mistake: n is turned the wrong way round
  return dot(to_local(body1, vec3(0, 1, 0)), point(body1, body2) - body1.x) - height;
