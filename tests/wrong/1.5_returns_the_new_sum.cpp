// expects: Likely mistake: the new sum is returned instead of its growth
  sum = glm::max(sum + dlambda, real(0));
  return sum;
