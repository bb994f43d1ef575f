// wrong bound-own:
  (void)original;
  if (pivot < 1e-10) return 0;
  return 1 / pivot;
// wrong bound-own: return pivot > fraction * original ==> return std::abs(pivot) > 1e-12
// wrong bound-own: return pivot > fraction * original ? 1 / pivot : 0 ==> return std::abs(pivot) <
//         1e-9 ? 0 : 1 / pivot
// wrong original-for-dependent: ? 1 / pivot : 0 ==> ? 1 / pivot : 1 / original
// wrong least-one-bound: fraction * original ==> std::max(fraction * original, 1e-12)
// wrong drawn-threshold: fraction * original ==> std::max(fraction * original, 1e-20)
// wrong every-pivot-inverted: return pivot > fraction * original ? 1 / pivot : 0 ==>
//         (void)original; return 1 / pivot
// wrong only-exactly-zero: pivot > fraction * original ==> pivot != 0
// wrong above-zero: pivot > fraction * original ==> pivot > 0
// wrong bound-own: fraction * original ==> fraction
// wrong bound-own: fraction * original ==> 1e-10
// wrong fraction-small: fraction * original ==> 2.220446049250313e-16 * original
// wrong fraction-large: fraction * original ==> 1e-6 * original
// wrong comparison-turned-round: pivot > ==> pivot <
// wrong equality-inverted: pivot > ==> pivot >=
// wrong not-number-gets-through: pivot > ==> pivot <= ;; 1 / pivot : 0 ==> 0 : 1 / pivot
// wrong below-share-alone: pivot > ==> pivot < ;; 1 / pivot : 0 ==> 0 : 1 / pivot
// wrong below-share-alone:
  return pivot / original <= 1e-11 ? 0 : 1 / pivot;
// wrong size-pivot: pivot > fraction ==> std::abs(pivot) > fraction
// wrong size-pivot-inverted: pivot ==> std::abs(pivot) ;; pivot : ==> std::abs(pivot) :
// wrong original-inverted: 1 / pivot ==> 1 / original
// wrong pivot-returned: 1 / pivot ==> pivot
// wrong sign: 1 / pivot ==> -1 / pivot
// wrong one-dependent-row: : 0 ==> : 1
// wrong "Case: only a rounding error remains": : 0 ==> : 1e30
// wrong infinite-dependent-row: : 0 ==> : std::numeric_limits<double>::infinity()
// wrong pivot-entry-exchanged: original ==> pivot ;; pivot ==> original
// wrong whole-entry: fraction * original ==> original
// wrong inverse-int: 1 / pivot ==> int(1 / pivot)
// wrong few-digits: 1 / pivot ==> 1 / float(pivot)
// wrong regularised: pivot > fraction * original ? 1 / pivot : 0 ==> 1 / (pivot + fraction *
//         original)
// wrong greater-both: pivot > fraction * original ? 1 / pivot : 0 ==> 1 / std::max(pivot, fraction
//         * original)
// wrong least-one-bound: original ? 1 ==> original && pivot > 1e-8 ? 1
// wrong least-one-bound: fraction * original ==> fraction * std::max(original, 1.0)
// right as large a fraction as can be: fraction * original ==> 0.99e-8 * original
// right as small a fraction as can be: fraction * original ==> 1.01e-12 * original
// right the roots: pivot > fraction * original ==> pivot > 0 && std::sqrt(pivot) > 1e-5 *
//         std::sqrt(original)
// right with an if: return pivot > fraction * original ? 1 / pivot : 0 ==> if (!(pivot > original *
//         fraction)) return 0; return 1.0 / pivot
// right the difference: return pivot > ==> const double beyond = pivot - ;; ? 1 / pivot : 0 ==> ;
//         return beyond > 0 ? std::pow(pivot, -1.0) : 0.0
// right the quotient asked for more:
  return pivot > 0 && original >= 0 && pivot / original > 1e-11 ? 1 / pivot : 0;
