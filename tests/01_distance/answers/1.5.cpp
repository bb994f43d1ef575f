// wrong drawn-threshold: const real before ==> if (std::abs(dlambda) < real(1e-10)) return 0; const
//         real before
// wrong drawn-cut: glm::max(before + dlambda, real(0)) ==> glm::clamp(before + dlambda, real(0),
//         real(100))
// mistake "the new sum is returned instead of its growth": const real before = sum; ==> ;; before
//         ==> sum ;; - before ==>
// mistake "the sum is not kept":
  return glm::max(sum + dlambda, real(0)) - sum;
// mistake "0 is returned: the old sum must be remembered before the new one is stored": before; ==>
//         sum;
// mistake "the sign of the growth: new minus old": sum - before ==> before - sum
// mistake "nothing is clamped, or the old sum is: the new one must not become negative":
//         glm::max(before + dlambda, real(0)) ==> before + dlambda
// mistake "max and min are mixed up: the sum must not fall below 0": max ==> min
// mistake "all of dlambda is returned: return the growth of the sum": sum - before ==> dlambda
// mistake "the sum becomes dlambda: it must grow by it": before + ==>
// mistake "the sum is changed before its growth is computed, so dlambda counts twice": const real
//         before = sum; ==> ;; before ==> sum ;; sum - before ==> glm::max(sum + dlambda, real(0))
//         - sum
// mistake "the sign of dlambda: the sum grows by it": + dlambda ==> - dlambda
// mistake "the size of the sum is taken: below 0 it becomes 0": glm::max(before + dlambda, real(0))
//         ==> std::abs(before + dlambda)
// mistake "dlambda is added twice": return sum ==> sum += dlambda; return sum
// mistake "a small dlambda is left out: a light body needs only a small one": const ==> if
//         (std::abs(dlambda) < real(1e-6)) return 0; const
// wrong never-set: const real before = sum ==> real before
// mistake "the fraction is cut off: an int holds whole numbers only": glm::max(before + dlambda,
//         real(0)) ==> int(glm::max(before + dlambda, real(0)))
// mistake "the fraction is cut off: an int holds whole numbers only": real before ==> int before
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
// mistake "nothing is done": const real before ==> return 0; const real before
// mistake "0 is returned: the old sum must be remembered before the new one is stored": return sum
//         - before ==> return 0
// mistake "each impulse is clamped: it is the sum that must not push": const real before = sum; ==>
//         const real positive = glm::max(dlambda, real(0)); ;; sum = glm::max(before + dlambda,
//         real(0)); ==> sum = positive; ;; sum - before ==> positive
// mistake "each impulse is clamped: it is the sum that must not push": const real before = sum; ==>
//         const real positive = glm::max(dlambda, real(0)); ;; sum = glm::max(before + dlambda,
//         real(0)); ==> ;; sum - before ==> positive
// mistake "the new sum is returned instead of its growth, and it is not kept": const real before =
//         sum; ==> ;; sum = glm::max(before + dlambda, real(0)); ==> ;; sum - before ==>
//         glm::max(sum + dlambda, real(0))
// mistake "if the release is larger than the sum, all of the sum is released: minus the old sum":
//         sum = glm::max(before + dlambda, real(0)); ==> if (before + dlambda < 0) { sum = 0;
//         return before; } sum += dlambda;
// mistake "if the release is larger than the sum, all of the sum is released: minus the old sum":
//         sum = glm::max(before + dlambda, real(0)); ==> if (before + dlambda < 0) { sum = 0;
//         return before + 2 * dlambda; } sum += dlambda;
// mistake "the fraction is cut off: an int holds whole numbers only": return sum - before; ==>
//         const int growth = int(sum - before); return growth;
// mistake "the fraction is cut off: an int holds whole numbers only": const real before = sum; ==>
//         const real before = int(sum); const int change = int(dlambda); ;; before + dlambda ==>
//         before + change
// mistake "the sum is stored only if the release is larger than it": sum = glm::max(before +
//         dlambda, real(0)); ==> if (before + dlambda < 0) { sum = 0; return -before; } return
//         dlambda;
// mistake "dlambda must not be below minus the sum, not below the sum": glm::max(before + dlambda,
//         real(0)) ==> before + glm::max(dlambda, before)
// mistake "the sum has no upper bound": glm::max(before + dlambda, real(0)) ==>
//         glm::min(glm::max(before + dlambda, real(0)), real(1))
// mistake "a small dlambda is left out: a light body needs only a small one": const ==> if
//         (std::abs(dlambda) < real(1e-4)) return 0; const
// mistake "nothing is clamped, or the old sum is: the new one must not become negative":
//         glm::max(before + dlambda, real(0)) ==> glm::max(before, real(0)) + dlambda
// from right with an if
// mistake "each impulse is clamped: it is the sum that must not push": if (sum + dlambda < 0) {
//         const real given_back = -sum; sum = 0; return given_back; } ==> dlambda = glm::max(
//         dlambda, real(0));
// mistake "if the release is larger than the sum, all of the sum is released: minus the old sum": {
//         const real given_back = -sum; sum = 0; return given_back; } ==> return 0;
// mistake "if the release is larger than the sum, all of the sum is released: minus the old sum":
//         const real given_back = -sum; ==> ;; given_back ==> -sum
// mistake "the sum is not stored if the release is larger than it: it is 0 then": { const real
//         given_back = -sum; sum = 0; return given_back; } ==> return -sum;
