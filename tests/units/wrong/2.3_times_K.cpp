// expects: Units: lambda is in m/(kg s) and should be in kg m/s: an inverse mass where a mass
// expects: belongs (K is one, divide by it)
  vec3 e = bias;
  for (int i = 0; i < 3; ++i) e[i] += row_velocity(J[i], body1, body2);
  return -K * e;
