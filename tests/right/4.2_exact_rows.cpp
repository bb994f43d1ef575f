// region: 2
// The slope of C at every pose, dC/dt = s w2 + w2 x v - s w1 - v x w1. Where C = 0 it is the same;
// elsewhere it gives the pair angular momentum.
  quat q = body2.q * conjugate(start) * conjugate(body1.q);
  if (q.w < 0) q = -q;
  const mat3 s = mat3(q.w), v = skew(vec3(q.x, q.y, q.z));
  return jacobian_from_blocks(mat3(0), -(s + v), mat3(0), s - v);
