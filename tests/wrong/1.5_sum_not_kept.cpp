// expects: Likely mistake: the sum is not kept
  return glm::max(sum + dlambda, real(0)) - sum;
