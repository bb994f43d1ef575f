// region: 2
// expects: Likely mistake: the sign: friction works against J V
  const real wanted = sum + rate / K, bound = mu * normal;
  const real before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;
