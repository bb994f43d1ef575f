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
  const Triple<Number> turn = a * hinge.axis_row[0] + b * hinge.axis_row[1];
  body1.v = body1.v + body1.inverse_mass * push;
  body2.v = body2.v - body2.inverse_mass * push;
  body1.w = body1.w + hinge.I1 * cross(hinge.r1, push) + hinge.I1 * turn;
  body2.w = body2.w - hinge.I2 * cross(hinge.r2, push) - hinge.I2 * turn;
