// expects: the sign of skew(v)
// region: 2
  const quat e = body2.q * conjugate(start) * conjugate(body1.q);
  const real s = std::abs(e.w);
  const mat3 across = skew(vec3(e.x, e.y, e.z)) * (e.w < 0 ? real(-1) : real(1));
  return jacobian_from_blocks(mat3(0), across - mat3(s), mat3(0), across + mat3(s));
