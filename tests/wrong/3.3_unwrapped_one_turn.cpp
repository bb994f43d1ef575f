// region: 2
// expects: Likely mistake: one turn at most is added: a fast wheel makes several of them in a step
  const real pi = std::numbers::pi_v<real>;
  if (expected - measured > pi) return measured + 2 * pi;
  if (expected - measured < -pi) return measured - 2 * pi;
  return measured;
