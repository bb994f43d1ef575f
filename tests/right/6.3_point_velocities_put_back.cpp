// The bodies themselves in the place of copies; their velocities are put back at the end.
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  const Jacobian<3> J = point.jacobian(body1, body2);
  const vec3 v1 = body1.v, w1 = body1.w, v2 = body2.v, w2 = body2.w;
  body1.v = body1.w = body2.v = body2.w = vec3(0);
  apply_impulse(J, lambda, body1, body2);
  for (Body* body : {&body1, &body2}) {
    body->x += body->v;
    body->q = turned(body->q, body->w, 1);
  }
  body1.v = v1;
  body1.w = w1;
  body2.v = v2;
  body2.w = w2;
