// region: 2
// expects: Likely mistake: nothing is done beyond the bound: the sum goes to the bound
  const real wanted = sum - rate / K, before = sum;
  sum = std::abs(wanted) > mu * normal ? real(0) : wanted;
  return sum - before;
