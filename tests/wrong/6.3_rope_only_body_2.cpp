// region: 2
// expects: Likely mistake: only body 2 moves: body 1 has its share of the gap
  const real C = rope.error(body1, body2);
  if (C >= 0) return;
  const real lambda = -C / rope.K(body1, body2);
  const Row J = rope.jacobian(body1, body2);
  body2.x += body2.inverse_mass * lambda * J.v2;
  body2.q = turned(body2.q, inverse_inertia(body2) * (lambda * J.w2), 1);
