// region: 2
// expects: Likely mistake: the old sum is divided by K, too
  const real wanted = (sum - rate) / K, bound = mu * normal;
  const real before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;
