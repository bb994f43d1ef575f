// First what an impulse of 1 along b does to the velocities, then the rate that row a sees.
  Body one = body1, two = body2;
  one.v = body1.inverse_mass * b.v1;
  one.w = inverse_inertia(body1) * b.w1;
  two.v = body2.inverse_mass * b.v2;
  two.w = inverse_inertia(body2) * b.w2;
  return row_velocity(a, one, two);
