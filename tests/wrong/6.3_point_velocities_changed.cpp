// expects: Likely mistake: the velocities are changed, and the poses stay
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  apply_impulse(point.jacobian(body1, body2), lambda, body1, body2);
