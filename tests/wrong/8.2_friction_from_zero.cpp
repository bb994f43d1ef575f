// region: 2
// expects: Likely mistake: the sum is kept from 0 to mu normal
  const real wanted = sum - rate / K, bound = mu * normal;
  const real before = sum;
  sum = std::clamp(wanted, real(0), bound);
  return sum - before;
