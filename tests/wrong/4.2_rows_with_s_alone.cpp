// expects: skew(v) is missing
// region: 2
  const quat e = body2.q * conjugate(start) * conjugate(body1.q);
  return jacobian_from_blocks(mat3(0), mat3(-std::abs(e.w)), mat3(0), mat3(std::abs(e.w)));
