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

// ---- wrong: new sum minus itself
// expects: Likely mistake: 0 is returned: the old sum must be remembered
  const real before = sum;
  sum = glm::max(before + dlambda, real(0));
  return sum - sum;

// ---- wrong: old minus new
// expects: Likely mistake: the sign of the growth: new minus old
  const real before = sum;
  sum = glm::max(before + dlambda, real(0));
  return before - sum;

// ---- wrong: nothing clamped
// expects: Likely mistake: nothing is clamped
  const real before = sum;
  sum = before + dlambda;
  return sum - before;

// ---- wrong: min for max
// expects: Likely mistake: max and min are mixed up
  const real before = sum;
  sum = glm::min(before + dlambda, real(0));
  return sum - before;

// ---- wrong: returns dlambda
// expects: Likely mistake: all of dlambda is returned
  const real before = sum;
  sum = glm::max(before + dlambda, real(0));
  return dlambda;

// ---- wrong: sum set to dlambda
// expects: Likely mistake: the sum becomes dlambda: it must grow by it
  const real before = sum;
  sum = glm::max(dlambda, real(0));
  return sum - before;

// ---- wrong: old sum taken too late
// expects: Likely mistake: the sum is changed before its growth is computed from it
  sum = glm::max(sum + dlambda, real(0));
  return glm::max(sum + dlambda, real(0)) - sum;

// ---- wrong: sign of dlambda
// expects: Likely mistake: the sign of dlambda
  const real before = sum;
  sum = glm::max(before - dlambda, real(0));
  return sum - before;

// ---- wrong: asks too much, gets nothing
// expects: Likely mistake: where more is asked back than there is, all that is there is given back
  if (sum + dlambda < 0) return 0;
  sum += dlambda;
  return dlambda;

// ---- wrong: minus a sum that is 0 already
// expects: Likely mistake: where more is asked back than there is, all that is there is given back
  if (sum + dlambda < 0) { sum = 0; return -sum; }
  sum += dlambda;
  return dlambda;

// ---- wrong: sum kept where it is emptied
// expects: Likely mistake: the sum is not kept where more is asked back than there is
  if (sum + dlambda < 0) return -sum;
  sum += dlambda;
  return dlambda;

// ---- wrong: size of the sum
// expects: Likely mistake: the size of the sum is taken
  const real before = sum;
  sum = std::abs(before + dlambda);
  return sum - before;

// ---- wrong: dlambda twice
// expects: Likely mistake: dlambda is added twice
  const real before = sum;
  sum = glm::max(before + dlambda, real(0));
  sum += dlambda;
  return sum - before;

// ---- wrong: small ones left out
// expects: Likely mistake: a small dlambda is left out
  if (std::abs(dlambda) < real(1e-6)) return 0;
  const real before = sum;
  sum = glm::max(before + dlambda, real(0));
  return sum - before;

// ---- wrong: old sum never set
// expects: Likely mistake: a value that was never set
  real before;
  sum = glm::max(before + dlambda, real(0));
  return sum - before;

// ---- wrong: corrected by a sum that is 0 already
// expects: Likely mistake: all of dlambda is returned
  sum += dlambda;
  if (sum < 0) {
    sum = 0;
    dlambda -= sum;
  }
  return dlambda;

// ---- wrong: old sum as a whole number
// expects: Likely mistake: the fraction is cut off
  const int before = sum;
  sum = glm::max(before + dlambda, real(0));
  return sum - before;

// ---- right: with an if
// The same in two cases: all of dlambda, or as much as was there.
  if (sum + dlambda < 0) {
    const real given_back = -sum;
    sum = 0;
    return given_back;
  }
  sum += dlambda;
  return dlambda;

// ---- right: dlambda clamped at minus the sum
  const real g = glm::max(dlambda, -sum);
  sum += g;
  return g;

// ---- right: corrected afterwards
  sum += dlambda;
  if (sum < 0) {
    dlambda -= sum;
    sum = 0;
  }
  return dlambda;
