// One bound after the other.
// region: 2
  const real before = sum, bound = mu * normal;
  sum -= rate / K;
  if (sum > bound) sum = bound;
  if (sum < -bound) sum = -bound;
  return sum - before;
