// expects: Likely mistake: the first row stands there twice
  out.r1 = triple(to_world(body1, hinge.point.anchor1_local));
  out.r2 = triple(to_world(body2, hinge.point.anchor2_local));
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  for (int i = 0; i < 2; ++i) out.axis_row[i] = triple(axis[0].w2);
  out.I1 = symmetric(inverse_inertia(body1));
  out.I2 = symmetric(inverse_inertia(body2));
  const real rate = hinge.beta / h;
  const vec3 gap = hinge.point.error(body1, body2);
  const Vector<2> tilt = hinge.axis.error(body1, body2);
  for (int i = 0; i < 3; ++i) out.bias[i] = rate * gap[i];
  for (int i = 0; i < 2; ++i) out.bias[3 + i] = rate * tilt[i];
