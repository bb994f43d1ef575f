// region: 2
// expects: Likely mistake: what is too much is cut back to the edge, not dropped
  const real wanted = sum - rate / K, bound = mu * normal;
  if (std::abs(wanted) > bound) return 0;
  const real before = sum;
  sum = wanted;
  return sum - before;
