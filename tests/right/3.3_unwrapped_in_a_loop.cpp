// region: 2
// Turn by turn.
  const real pi = std::numbers::pi_v<real>;
  while (measured < expected - pi) measured += 2 * pi;
  while (measured > expected + pi) measured -= 2 * pi;
  return measured;
