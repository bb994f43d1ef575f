// region: 2
// expects: Likely mistake: J where J^T belongs: the sign of the turn
  vec3 push1, turn1, push2, turn2;
  for (int i = 0; i < 3; ++i) {
    push1[i] = dot(J[i].v1, lambda);
    turn1[i] = dot(J[i].w1, lambda);
    push2[i] = dot(J[i].v2, lambda);
    turn2[i] = dot(J[i].w2, lambda);
  }
  body1.v += body1.inverse_mass * push1;
  body1.w += inverse_inertia(body1) * turn1;
  body2.v += body2.inverse_mass * push2;
  body2.w += inverse_inertia(body2) * turn2;
