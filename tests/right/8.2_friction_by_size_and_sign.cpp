// The size is bounded, the sign is put back.
// region: 2
  const real before = sum, wanted = sum - rate / K;
  sum = std::copysign(std::min(std::abs(wanted), mu * normal), wanted);
  return sum - before;
