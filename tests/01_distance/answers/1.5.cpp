// wrong drawn-threshold: const real before ==> if (std::abs(dlambda) < real(1e-10)) return 0; const
//         real before
// wrong drawn-cut: glm::max(before + dlambda, real(0)) ==> glm::clamp(before + dlambda, real(0),
//         real(100))
// wrong returns-new-sum: const real before = sum; ==> ;; before ==> sum ;; - before ==>
// wrong sum-not-kept:
  return glm::max(sum + dlambda, real(0)) - sum;
// wrong new-sum-minus-itself: before; ==> sum;
// wrong old-minus-new: sum - before ==> before - sum
// wrong nothing-clamped: glm::max(before + dlambda, real(0)) ==> before + dlambda
// wrong min-for-max: max ==> min
// wrong returns-dlambda: sum - before ==> dlambda
// wrong sum-set-dlambda: before + ==>
// wrong old-sum-taken-too: const real before = sum; ==> ;; before ==> sum ;; sum - before ==>
//         glm::max(sum + dlambda, real(0)) - sum
// wrong sign-of-dlambda: + dlambda ==> - dlambda
// wrong size-sum: glm::max(before + dlambda, real(0)) ==> std::abs(before + dlambda)
// wrong dlambda-twice: return sum ==> sum += dlambda; return sum
// wrong small-ones-left-out: const ==> if (std::abs(dlambda) < real(1e-6)) return 0; const
// wrong never-set: const real before = sum ==> real before
// wrong cut-int: real before ==> int before
// right with an if:
  // The same in two cases: all of dlambda, or as much as was there.
  if (sum + dlambda < 0) {
    const real given_back = -sum;
    sum = 0;
    return given_back;
  }
  sum += dlambda;
  return dlambda;
// right dlambda clamped at minus the sum: before = sum; sum ==> g ;; before + ==> ;; real(0) ==>
//         -sum ;; return sum - before ==> sum += g; return g
// right corrected afterwards:
  sum += dlambda;
  if (sum < 0) {
    dlambda -= sum;
    sum = 0;
  }
  return dlambda;
// from right with an if
// wrong clamps-each-impulse: if (sum + dlambda < 0) { const real given_back = -sum; sum = 0; return
//         given_back; } ==> dlambda = glm::max( dlambda, real(0));
// wrong minus-sum-that-0: { const real given_back = -sum; sum = 0; return given_back; } ==> return
//         0;
// wrong minus-sum-that-0: const real given_back = -sum; ==> ;; given_back ==> -sum
// wrong sum-kept-where-emptied: { const real given_back = -sum; sum = 0; return given_back; } ==>
//         return -sum;
