// expects: Likely mistake: each impulse is clamped: it is the sum that must not push
// expects: Likely mistake: a rope never gives back what it pulled too much
  dlambda = glm::max(dlambda, real(0));
  sum += dlambda;
  return dlambda;
