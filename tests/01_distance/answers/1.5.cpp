// Known answers of exercise 1.5, each put in the place of the solution's.

// ---- wrong: clamps each impulse
// expects: Likely mistake: each impulse is clamped: it is the sum that must not push
// expects: Likely mistake: a rope never gives back what it pulled too much
  dlambda = glm::max(dlambda, real(0));
  sum += dlambda;
  return dlambda;

// ---- wrong: returns the new sum
// expects: Likely mistake: the new sum is returned instead of its growth
  sum = glm::max(sum + dlambda, real(0));
  return sum;

// ---- wrong: sum not kept
// expects: Likely mistake: the sum is not kept
  return glm::max(sum + dlambda, real(0)) - sum;

// ---- right: with an if
// The same in two cases: all of dlambda, or as much as was there.
  if (sum + dlambda < 0) {
    const real given_back = -sum;
    sum = 0;
    return given_back;
  }
  sum += dlambda;
  return dlambda;
