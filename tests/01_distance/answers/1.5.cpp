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
// change: before; ==> sum;

// ---- wrong: old minus new
// expects: Likely mistake: the sign of the growth: new minus old
// change: sum - before ==> before - sum

// ---- wrong: nothing clamped
// expects: Likely mistake: nothing is clamped
// change: glm::max(before + dlambda, real(0)) ==> before + dlambda

// ---- wrong: min for max
// expects: Likely mistake: max and min are mixed up
// change: max ==> min

// ---- wrong: returns dlambda
// expects: Likely mistake: all of dlambda is returned
// change: sum - before ==> dlambda

// ---- wrong: sum set to dlambda
// expects: Likely mistake: the sum becomes dlambda: it must grow by it
// change: before + ==>

// ---- wrong: old sum taken too late
// expects: Likely mistake: the sum is changed before its growth is computed from it
  sum = glm::max(sum + dlambda, real(0));
  return glm::max(sum + dlambda, real(0)) - sum;

// ---- wrong: sign of dlambda
// expects: Likely mistake: the sign of dlambda
// change: + dlambda ==> - dlambda

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
// change: glm::max(before + dlambda, real(0)) ==> std::abs(before + dlambda)

// ---- wrong: dlambda twice
// expects: Likely mistake: dlambda is added twice
// change: return sum ==> sum += dlambda; return sum

// ---- wrong: small ones left out
// expects: Likely mistake: a small dlambda is left out
// change: const real ==> if (std::abs(dlambda) < real(1e-6)) return 0; const real

// ---- wrong: old sum never set
// expects: Likely mistake: a value that was never set
// change: const real before = sum ==> real before

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
// change: real before ==> int before

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
