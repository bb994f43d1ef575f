// Each of the fifteen numbers is read once and serves both sides of the diagonal.
  const Triple<Number> gap =
      body2.v - body1.v + cross(body2.w, hinge.r2) + cross(hinge.r1, body1.w);
  const Triple<Number> spin = body1.w - body2.w;
  const Number e[] = {gap.x + hinge.bias[0], gap.y + hinge.bias[1], gap.z + hinge.bias[2],
                      hinge.bias[3] - dot(hinge.axis_row[0], spin),
                      hinge.bias[4] - dot(hinge.axis_row[1], spin)};
  Number lambda[5];
  const Number* entry = hinge.inverse_K;
  for (int i = 0; i < 5; ++i) {
    const Number own = *entry++ * e[i];
    lambda[i] = i == 0 ? -own : lambda[i] - own;
    for (int j = i + 1; j < 5; ++j, ++entry) {
      lambda[i] = lambda[i] - *entry * e[j];
      lambda[j] = i == 0 ? -(*entry * e[i]) : lambda[j] - *entry * e[i];
    }
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> turn = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body2.v = body2.v + body2.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + turn);
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + turn);
