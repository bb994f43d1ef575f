// region: 2
// expects: Likely mistake: the ends of clamp are exchanged: clamp(a, low, high)
  const real wanted = sum - rate / K, low = mu * normal, high = -low;
  const real before = sum;
  sum = wanted < low ? low : wanted > high ? high : wanted;
  return sum - before;
