// expects: Likely mistake: the push changes v only: w gets r x P, too
// expects: holds at no levers
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
  body1.w = body1.w - hinge.I1 * turn;
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * turn;
