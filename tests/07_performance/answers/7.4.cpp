// Known answers of exercise 7.4, each put in the place of the solution's.

// ---- wrong: K not used
// expects: Likely mistake: a value that was never set
// change: hinge.inverse_K_times(e, back); ==>

// ---- wrong: K over e
// expects: Likely mistake: K^-1 e is written over e while e is still being read: give
// change: const Number e[] ==> Number e[]
// change: hinge.inverse_K_times(e, back); ==>
//         hinge.inverse_K_times(e, e); for (int i = 0; i < 5; ++i) back[i] = e[i];

// ---- wrong: a third axis row
// expects: an index outside a vector or an array
// change: back[4] * hinge.axis_row[1] ==> back[4] * hinge.axis_row[2]

// ---- wrong: all velocities anew
// expects: Likely mistake: v1, w1, v2 and w2 take a new value where it is added to the old one
// change: body1.v = body1.v - ==> body1.v = -
// change: body1.w - hinge.I1 * (cross(hinge.r1, push) + couple) ==>
//         -(hinge.I1 * (cross(hinge.r1, push) + couple))
// change: body2.v = body2.v + ==> body2.v =
// change: body2.w = body2.w + ==> body2.w =

// ---- wrong: another order of K
// expects: Likely mistake: K^-1 is read in another order: take place(i, j)
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.w - body1.w;
  const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                      hinge.bias[3] + dot(hinge.axis_row[0], turning),
                      hinge.bias[4] + dot(hinge.axis_row[1], turning)};
  const auto place = [](int i, int j) {
    return i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
  };
  Number lambda[5];
  for (int i = 0; i < 5; ++i) {
    lambda[i] = -hinge.inverse_K[place(i, 0)] * e[0];
    for (int j = 1; j < 5; ++j) lambda[i] = lambda[i] - hinge.inverse_K[place(i, j)] * e[j];
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: bias of another row
// expects: Likely mistake: bias[1] in e[2]: it belongs to e[1]
// change: hinge.bias[2] ==> hinge.bias[1]

// ---- wrong: both the same way
// expects: Likely mistake: both bodies are pushed the same way
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v + body1.inverse_mass * push;
  body1.w = body1.w + hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: brackets forgotten for both
// expects: from w2
// expects: Likely mistake: T is not multiplied by I1 and I2: I (r x P + T), with brackets
// change: hinge.I1 * (cross(hinge.r1, push) + couple) ==>
//         (hinge.I1 * cross(hinge.r1, push) + couple)
// change: hinge.I2 * (cross(hinge.r2, push) + couple) ==>
//         (hinge.I2 * cross(hinge.r2, push) + couple)

// ---- wrong: by momentum
// expects: Likely mistake: a division by zero
// expects: v1 of lane 0 that is not used
// expects: Likely mistake: a division by zero
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  const auto less = [&](const Number& v, const Number& push) {
    if constexpr (requires { v.all; })
      return Number{(v.all / body1.inverse_mass.all - push.all) * body1.inverse_mass.all};
    else
      return body1.inverse_mass == 0 ? v : (v / body1.inverse_mass - push) * body1.inverse_mass;
  };
  body1.v = {less(body1.v.x, push.x), less(body1.v.y, push.y), less(body1.v.z, push.z)};
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: copies
// expects: Likely mistake: nothing changes: the bodies are references
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  Velocities<Number> one = body1, two = body2;
  one.v = body1.v - body1.inverse_mass * push;
  one.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  two.v = body2.v + body2.inverse_mass * push;
  two.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: diagonal only
// expects: Likely mistake: only the diagonal of K^-1 is used
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.w - body1.w;
  const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                      hinge.bias[3] + dot(hinge.axis_row[0], turning),
                      hinge.bias[4] + dot(hinge.axis_row[1], turning)};
  Number lambda[5];
  for (int i = 0; i < 5; ++i) {
    lambda[i] = -hinge.inverse_K[hinge.place(i, i)] * e[i];
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: first lane only
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
    const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
    body1.v = body1.v - body1.inverse_mass * push;
    body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
    body2.v = body2.v + body2.inverse_mass * push;
    body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);
  }

// ---- wrong: gap of body 1 less body 2
// expects: Likely mistake: the sign of e in the point's rows: rates of body 2 less those of body 1
// change: body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1) ==>
//         body1.v + cross(body1.w, hinge.r1) - body2.v - cross(body2.w, hinge.r2)

// ---- wrong: gap with r1 twice
// expects: The path of Eq. 7-6. Yours is worked back from your velocities
// expects: Likely mistake: r1 in the place of r2 in the gap's rate
// change: cross(body2.w, hinge.r2) ==> cross(body2.w, hinge.r1)

// ---- wrong: gap with w1 twice
// expects: Likely mistake: w1 in the place of w2 in the gap's rate
// change: cross(body2.w, hinge.r2) ==> cross(body1.w, hinge.r2)

// ---- wrong: gap y twice
// expects: yours        0.4600    0.8000    1.5200    0.5000    0.0000  x
// expects: Likely mistake: the rate of e[1] stands in e[2], too
// change: gap.z ==> gap.y

// ---- wrong: inertia of body 1 for both
// expects: w2.x
// expects: Likely mistake: I1 is taken for both bodies
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I1 * (cross(hinge.r2, push) + couple);

// ---- wrong: lambda five taken away
// expects: Likely mistake: the sign of lambda[4]
// change: - back[4] ==> + back[4]

// ---- wrong: lambda over e
// expects: Likely mistake: lambda is written over e while e is still being read
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.w - body1.w;
  Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                      hinge.bias[3] + dot(hinge.axis_row[0], turning),
                      hinge.bias[4] + dot(hinge.axis_row[1], turning)};
  for (int i = 0; i < 5; ++i) {
    Number lambda = -hinge.inverse_K[hinge.place(i, 0)] * e[0];
    for (int j = 1; j < 5; ++j) lambda = lambda - hinge.inverse_K[hinge.place(i, j)] * e[j];
    e[i] = lambda;
  }
  const Triple<Number> push{e[0], e[1], e[2]};
  const Triple<Number> couple = e[3] * hinge.axis_row[0] + e[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: levers exchanged
// expects: Likely mistake: the levers are exchanged: r1 belongs to body 1
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r1) - body1.v - cross(body1.w, hinge.r2);
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r2, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r1, push) + couple);

// ---- wrong: levers exchanged in the push
// expects: Likely mistake: the levers are exchanged in what the push does
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r2, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r1, push) + couple);

// ---- wrong: only body 2
// expects: Likely mistake: only body 2 feels it
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: order of the cross products
// expects: Likely mistake: r x w in the place of w x r in the gap's rate
  const Triple<Number> gap =
      body2.v + cross(hinge.r2, body2.w) - body1.v - cross(hinge.r1, body1.w);
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: push begins too late
// expects: Likely mistake: the push begins with lambda[1]: it is lambda[0] to lambda[2]
// change: {-back[0], -back[1], -back[2]} ==> {-back[1], -back[2], -back[3]}

// ---- wrong: push itself turns
// expects: Likely mistake: P in the place of r2 x P in w2
// change: cross(hinge.r2, push) ==> push

// ---- wrong: push of the first lane
// expects: v1 of lane 1
// expects: Likely mistake: the lanes are mixed: nothing may pass
// expects: Likely mistake: the numbers of another lane
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
  for (Number& each : lambda) {
    real* const lane = reinterpret_cast<real*>(&each);
    for (std::size_t k = 1; k < sizeof each / sizeof(real); ++k) lane[k] = lane[0];
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: push on w only
// expects: v2.z
// expects: Likely mistake: the push changes w only
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: push with two exchanged
// expects: Likely mistake: lambda[1] and lambda[2] are exchanged
// change: -back[1], -back[2] ==> -back[2], -back[1]

// ---- wrong: read as if full
// expects: Likely mistake: K^-1 is read as if all 25 entries stood there
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.w - body1.w;
  const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                      hinge.bias[3] + dot(hinge.axis_row[0], turning),
                      hinge.bias[4] + dot(hinge.axis_row[1], turning)};
  const auto place = [](int i, int j) { return 5 * i + j < 15 ? 5 * i + j : 14; };
  Number lambda[5];
  for (int i = 0; i < 5; ++i) {
    lambda[i] = -hinge.inverse_K[place(i, 0)] * e[0];
    for (int j = 1; j < 5; ++j) lambda[i] = lambda[i] - hinge.inverse_K[place(i, j)] * e[j];
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: records made anew
// expects: inverse mass of body 1
// expects: Likely mistake: the record is made anew without its inverse mass
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  const Triple<Number> v1 = body1.v - body1.inverse_mass * push;
  const Triple<Number> w1 = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body1 = {v1, Number{}, w1, Number{}};
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: sign
// expects: v1.x
// expects: Pose: pencil and paper
// expects: Likely mistake: the sign: lambda = -K^-1 e works against e
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.w - body1.w;
  const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                      hinge.bias[3] + dot(hinge.axis_row[0], turning),
                      hinge.bias[4] + dot(hinge.axis_row[1], turning)};
  Number lambda[5];
  for (int i = 0; i < 5; ++i) {
    lambda[i] = hinge.inverse_K[hinge.place(i, 0)] * e[0];
    for (int j = 1; j < 5; ++j) lambda[i] = lambda[i] + hinge.inverse_K[hinge.place(i, j)] * e[j];
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: turn only
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * couple;
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * couple;

// ---- wrong: two blocks
// expects: Likely mistake: what K^-1 holds between the point and the axis is not used
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.w - body1.w;
  const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                      hinge.bias[3] + dot(hinge.axis_row[0], turning),
                      hinge.bias[4] + dot(hinge.axis_row[1], turning)};
  Number lambda[5];
  for (int i = 0; i < 5; ++i) {
    lambda[i] = i < 3 ? -hinge.inverse_K[hinge.place(i, 0)] * e[0] : e[0] - e[0];
    for (int j = 1; j < 5; ++j)
      if ((i < 3) == (j < 3)) lambda[i] = lambda[i] - hinge.inverse_K[hinge.place(i, j)] * e[j];
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: unknown in the bias
// expects: None of the usual mistakes explains it
// expects: yours        3.8800    0.8000    2.1000    0.5000   -1.4400  x
// change: {-back[0], -back[1], -back[2]} ==>
//         {-back[0] - hinge.bias[0], -back[1] - hinge.bias[1], -back[2] - hinge.bias[2]}

// ---- wrong: upper half only
// expects: Likely mistake: only the upper half of K^-1 is used
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.w - body1.w;
  const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                      hinge.bias[3] + dot(hinge.axis_row[0], turning),
                      hinge.bias[4] + dot(hinge.axis_row[1], turning)};
  Number lambda[5];
  for (int i = 0; i < 5; ++i) {
    lambda[i] = -hinge.inverse_K[hinge.place(i, i)] * e[i];
    for (int j = i + 1; j < 5; ++j)
      lambda[i] = lambda[i] - hinge.inverse_K[hinge.place(i, j)] * e[j];
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: v in the axis rows
// expects: Likely mistake: v in the place of w in the axis rows: a_j . (w2 - w1)
// change: turning = body2.w - body1.w ==> turning = body2.v - body1.v

// ---- wrong: v of body 2 forgotten
// expects: Likely mistake: v2 is never changed
// change: body2.v = body2.v + body2.inverse_mass * push; ==>

// ---- wrong: velocities added
// expects: Likely mistake: the velocities of body 1 are added in e
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r2) + body1.v + cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.w + body1.w;
  const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                      hinge.bias[3] + dot(hinge.axis_row[0], turning),
                      hinge.bias[4] + dot(hinge.axis_row[1], turning)};
  Number lambda[5];
  for (int i = 0; i < 5; ++i) {
    lambda[i] = -hinge.inverse_K[hinge.place(i, 0)] * e[0];
    for (int j = 1; j < 5; ++j) lambda[i] = lambda[i] - hinge.inverse_K[hinge.place(i, j)] * e[j];
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: w of body 1 with the lever of body 2
// expects: from w1     -0.1684    0.0736    0.1667  x
// expects: Likely mistake: r2 in the place of r1 in w1
// change: cross(hinge.r1, push) ==> cross(hinge.r2, push)

// ---- wrong: w of body 2 anew
// expects: Likely mistake: w2 takes a new value where it is added to the old one: += and not =
// change: body2.w = body2.w + ==> body2.w =

// ---- wrong: w of body 2 taken away
// expects: Likely mistake: the sign of what is added to w2
// change: body2.w = body2.w + ==> body2.w = body2.w -

// ---- wrong: without bias
// expects: Likely mistake: the bias is forgotten: e = bias + J V
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.w - body1.w;
  const Number e[] = {gap.x, gap.y, gap.z,
                      dot(hinge.axis_row[0], turning),
                      dot(hinge.axis_row[1], turning)};
  Number lambda[5];
  for (int i = 0; i < 5; ++i) {
    lambda[i] = -hinge.inverse_K[hinge.place(i, 0)] * e[0];
    for (int j = 1; j < 5; ++j) lambda[i] = lambda[i] - hinge.inverse_K[hinge.place(i, j)] * e[j];
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong: without inverse inertia
// expects: Likely mistake: the inverse inertias are missing
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + (cross(hinge.r2, push) + couple);

// ---- wrong: without the turn
// expects: Likely mistake: the turn T is missing: w gets r x P + T
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * cross(hinge.r1, push);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * cross(hinge.r2, push);

// ---- wrong: without w1 in the axis rows
// expects: Likely mistake: w1 is missing in the axis rows
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.w;
  const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                      hinge.bias[3] + dot(hinge.axis_row[0], turning),
                      hinge.bias[4] + dot(hinge.axis_row[1], turning)};
  Number lambda[5];
  for (int i = 0; i < 5; ++i) {
    lambda[i] = -hinge.inverse_K[hinge.place(i, 0)] * e[0];
    for (int j = 1; j < 5; ++j) lambda[i] = lambda[i] - hinge.inverse_K[hinge.place(i, j)] * e[j];
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- right: J transposed
// Row by row: M^-1 J^T lambda, all sums in another order.
  const Triple<Number> slip1 = body1.v + cross(body1.w, hinge.r1);
  const Triple<Number> slip2 = body2.v + cross(body2.w, hinge.r2);
  const Number e[] = {slip2.x - slip1.x + hinge.bias[0], slip2.y - slip1.y + hinge.bias[1],
                      slip2.z - slip1.z + hinge.bias[2],
                      dot(hinge.axis_row[0], body2.w) - dot(hinge.axis_row[0], body1.w) +
                          hinge.bias[3],
                      dot(hinge.axis_row[1], body2.w) - dot(hinge.axis_row[1], body1.w) +
                          hinge.bias[4]};
  const auto minus_lambda = [&](int i) {
    Number sum = hinge.inverse_K[hinge.place(4, i)] * e[4];
    for (int j = 3; j >= 0; --j) sum = sum + hinge.inverse_K[hinge.place(j, i)] * e[j];
    return sum;
  };
  const Triple<Number> push{minus_lambda(0), minus_lambda(1), minus_lambda(2)};
  const Number a = minus_lambda(3), b = minus_lambda(4);
  const Triple<Number> couple = a * hinge.axis_row[0] + b * hinge.axis_row[1];
  body1.v = body1.v + body1.inverse_mass * push;
  body2.v = body2.v - body2.inverse_mass * push;
  body1.w = body1.w + hinge.I1 * cross(hinge.r1, push) + hinge.I1 * couple;
  body2.w = body2.w - hinge.I2 * cross(hinge.r2, push) - hinge.I2 * couple;

// ---- right: K read once
// Each of the fifteen numbers is read once and serves both sides of the diagonal.
  const Triple<Number> gap =
      body2.v - body1.v + cross(body2.w, hinge.r2) + cross(hinge.r1, body1.w);
  const Triple<Number> w = body1.w - body2.w;
  const Number e[] = {gap.x + hinge.bias[0], gap.y + hinge.bias[1], gap.z + hinge.bias[2],
                      hinge.bias[3] - dot(hinge.axis_row[0], w),
                      hinge.bias[4] - dot(hinge.axis_row[1], w)};
  Number lambda[5];
  const Number* entry = hinge.inverse_K.data();
  for (int i = 0; i < 5; ++i) {
    const Number own = *entry++ * e[i];
    lambda[i] = i == 0 ? -own : lambda[i] - own;
    for (int j = i + 1; j < 5; ++j, ++entry) {
      lambda[i] = lambda[i] - *entry * e[j];
      lambda[j] = i == 0 ? -(*entry * e[i]) : lambda[j] - *entry * e[i];
    }
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body2.v = body2.v + body2.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- right: added in place
// The sums with += and -=.
// change: body1.v = body1.v - ==> body1.v -=
// change: body1.w = body1.w - ==> body1.w -=
// change: body2.v = body2.v + ==> body2.v +=
// change: body2.w = body2.w + ==> body2.w +=

// ---- right: axis after the point
// The axis sees the velocities that the push has left: row i of K^-1 K is row i of the unit matrix,
// so that its lambda is the same.
  const auto lambda = [&](int i) {
    const Triple<Number> gap =
        body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
    const Triple<Number> turning = body2.w - body1.w;
    const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                        hinge.bias[3] + dot(hinge.axis_row[0], turning),
                        hinge.bias[4] + dot(hinge.axis_row[1], turning)};
    Number sum = hinge.inverse_K[hinge.place(i, 0)] * e[0];
    for (int j = 1; j < 5; ++j) sum = sum + hinge.inverse_K[hinge.place(i, j)] * e[j];
    return -sum;
  };
  const Triple<Number> push{lambda(0), lambda(1), lambda(2)};
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * cross(hinge.r1, push);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * cross(hinge.r2, push);
  const Triple<Number> couple = lambda(3) * hinge.axis_row[0] + lambda(4) * hinge.axis_row[1];
  body1.w = body1.w - hinge.I1 * couple;
  body2.w = body2.w + hinge.I2 * couple;

// ---- right: component by component
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

// ---- right: lambda as an array
// With a minus in front of each of the five.
// change: const Triple<Number> push{-back[0], -back[1], -back[2]}; ==>
//         for (Number& l : back) l = -l; const Triple<Number> push{back[0], back[1], back[2]};
// change: -back[3] * hinge.axis_row[0] - back[4] ==> back[3] * hinge.axis_row[0] + back[4]

// ---- wrong units: push without levers
// expects: Units: in the solve, adding
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (push + couple);

// ---- wrong units: v for w in the axis rows
// expects: Units: in the solve, adding m/s to 1/s
  const Triple<Number> gap =
      body2.v + cross(body2.w, hinge.r2) - body1.v - cross(body1.w, hinge.r1);
  const Triple<Number> turning = body2.v - body1.v;
  const Number e[] = {hinge.bias[0] + gap.x, hinge.bias[1] + gap.y, hinge.bias[2] + gap.z,
                      hinge.bias[3] + dot(hinge.axis_row[0], turning),
                      hinge.bias[4] + dot(hinge.axis_row[1], turning)};
  Number lambda[5];
  for (int i = 0; i < 5; ++i) {
    lambda[i] = -hinge.inverse_K[hinge.place(i, 0)] * e[0];
    for (int j = 1; j < 5; ++j) lambda[i] = lambda[i] - hinge.inverse_K[hinge.place(i, j)] * e[j];
  }
  const Triple<Number> push{lambda[0], lambda[1], lambda[2]};
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - body1.inverse_mass * push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);

// ---- wrong units: without inverse mass
// expects: Units: in the solve, taking kg m/s from m/s: the inverse mass is missing
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
  const Triple<Number> couple = lambda[3] * hinge.axis_row[0] + lambda[4] * hinge.axis_row[1];
  body1.v = body1.v - push;
  body1.w = body1.w - hinge.I1 * (cross(hinge.r1, push) + couple);
  body2.v = body2.v + body2.inverse_mass * push;
  body2.w = body2.w + hinge.I2 * (cross(hinge.r2, push) + couple);
