// No function of Triple at all for the gap and the push.
  const auto& [r1, r2, a, I1, I2, bias, inverse_K] = hinge;
  const auto rate = [](const auto& v, const auto& w, const auto& r) {
    return Triple<Number>{v.x + w.y * r.z - w.z * r.y, v.y + w.z * r.x - w.x * r.z,
                          v.z + w.x * r.y - w.y * r.x};
  };
  const Triple<Number> p1 = rate(body1.v, body1.w, r1), p2 = rate(body2.v, body2.w, r2);
  Number e[5] = {bias[0] + p2.x - p1.x, bias[1] + p2.y - p1.y, bias[2] + p2.z - p1.z, bias[3],
                 bias[4]};
  for (int k = 0; k < 2; ++k)
    e[3 + k] = e[3 + k] + a[k].x * (body2.w.x - body1.w.x) + a[k].y * (body2.w.y - body1.w.y) +
               a[k].z * (body2.w.z - body1.w.z);
  Number f[5];  // -lambda
  for (int i = 0; i < 5; ++i) {
    f[i] = inverse_K[hinge.place(i, i)] * e[i];
    for (int j = 0; j < 5; ++j)
      if (j != i) f[i] = f[i] + inverse_K[hinge.place(i, j)] * e[j];
  }
  const Triple<Number> P{f[0], f[1], f[2]}, T = f[3] * a[0] + f[4] * a[1];
  const Triple<Number> around1 = rate(T, r1, P), around2 = rate(T, r2, P);
  body1.v = body1.v + body1.inverse_mass * P;
  body1.w = body1.w + I1 * around1;
  body2.v = body2.v - body2.inverse_mass * P;
  body2.w = body2.w - I2 * around2;
