// region: 2
// expects: Likely mistake: 0 is returned: keep the old sum before the new one is stored
  const real bound = mu * normal;
  sum = std::clamp(sum - rate / K, -bound, bound);
  return sum - sum;
