// n.n = 1 may be written out, as long as K stays finite where there is no direction.
  const vec3 n = direction(body2.x - body1.x);
  if (n == vec3(0)) return body1.inverse_mass + body2.inverse_mass;
  return body1.inverse_mass * dot(n, n) + body2.inverse_mass * dot(n, n);
