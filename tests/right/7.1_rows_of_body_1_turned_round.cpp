// The blocks w1 are the opposites of those that are wanted; the point's levers stand in its J.
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  for (int i = 0; i < 2; ++i) out.axis_row[i] = triple(-axis[i].w1);
  out.r1 = triple(world_point(body1, hinge.point.anchor1_local) - body1.x);
  out.r2 = triple(world_point(body2, hinge.point.anchor2_local) - body2.x);
  const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
  out.I1 = {I1[0].x, I1[1].y, I1[2].z, I1[0].y, I1[0].z, I1[1].z};
  out.I2 = {I2[0].x, I2[1].y, I2[2].z, I2[0].y, I2[0].z, I2[1].z};
  const vec3 gap = hinge.point.error(body1, body2) * hinge.beta / h;
  const Vector<2> tilt = hinge.axis.error(body1, body2);
  out.bias[0] = gap.x;
  out.bias[1] = gap.y;
  out.bias[2] = gap.z;
  out.bias[3] = hinge.beta * tilt[0] / h;
  out.bias[4] = hinge.beta * tilt[1] / h;
