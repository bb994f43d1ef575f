// expects: change of v2 (on paper)
// expects: Likely mistake: the velocities hold the moves now: they stay as they are
// expects: Likely mistake: the sweep is right and its visits are not
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  body1.v = body1.w = body2.v = body2.w = vec3(0);
  apply_impulse(point.jacobian(body1, body2), lambda, body1, body2);
  for (Body* body : {&body1, &body2}) {
    body->x += body->v;
    body->q = turned(body->q, body->w, 1);
  }
