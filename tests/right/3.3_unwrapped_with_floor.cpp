// region: 2
// Half a turn more and rounded down is rounded to the nearest.
  const real turn = 2 * std::numbers::pi_v<real>;
  return measured + turn * std::floor((expected - measured) / turn + real(0.5));
