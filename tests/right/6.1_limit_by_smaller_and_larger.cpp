// region: 2
// What is behind and what is ahead, each by itself: one of them is zero.
  return (beta * glm::min(C, real(0)) + glm::max(C, real(0))) / h;
