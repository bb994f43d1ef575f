// expects: v1 of lane 1 (upright)
// expects: Likely mistake: this lane is not solved
  constexpr int lanes = int(sizeof(Number) / sizeof(real));
  const auto first = [](const auto& all, auto one) {
    const real* const from = reinterpret_cast<const real*>(&all);
    real* const to = reinterpret_cast<real*>(&one);
    for (std::size_t n = 0; n < sizeof one / sizeof(real); ++n) to[n] = from[n * lanes];
    return one;
  };
  if constexpr (lanes > 1) {
    Velocities<real> a = first(body1, Velocities<real>{}), b = first(body2, Velocities<real>{});
    solve<real>(first(hinge, HingeNumbers<real>{}), a, b);
    for (int n = 0; n < 8; ++n) {
      reinterpret_cast<real*>(&body1)[n * lanes] = reinterpret_cast<const real*>(&a)[n];
      reinterpret_cast<real*>(&body2)[n * lanes] = reinterpret_cast<const real*>(&b)[n];
    }
    return;
  } else {
    const Triple<Number> gap =
        body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
    const Triple<Number> turning = body2.w - body1.w;
    const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                        hinge.bias[3] + dot(hinge.axis_row[0], turning),
                        hinge.bias[4] + dot(hinge.axis_row[1], turning)};
    Number lambda[5];
    for (int i = 0; i < 5; ++i) {
      lambda[i] = -hinge.inverse_K[hinge.place(i, 0)] * e[0];
      for (int j = 1; j < 5; ++j) lambda[i] = lambda[i] - hinge.inverse_K[hinge.place(i, j)] * e[j];
    }
    const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
    const Triple<Number> turn = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
    body1.v = body1.v - body1.inverse_mass * push;
    body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + turn);
    body2.v = body2.v + body2.inverse_mass * push;
    body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + turn);
  }
