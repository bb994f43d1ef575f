// Everything at once, and what stood in inverse_K is put back.
  const HingeNumbers<real> before = out;
  const Jacobian<2> axis = hinge.axis.jacobian(body1, body2);
  const vec3 u = hinge.point.error(body1, body2);
  const Vector<2> C = hinge.axis.error(body1, body2);
  const real share = hinge.beta / h;
  out = {triple(to_world(body1, hinge.point.anchor1_local)),
         triple(to_world(body2, hinge.point.anchor2_local)),
         {triple(axis[0].w2), triple(axis[1].w2)},
         symmetric(inverse_inertia(body1)),
         symmetric(inverse_inertia(body2)),
         {share * u.x, share * u.y, share * u.z, share * C[0], share * C[1]},
         {}};
  for (int n = 0; n < 15; ++n) out.inverse_K[n] = before.inverse_K[n];
