// wrong original-for-dependent: ? 1 / pivot : 0 ==> ? 1 / pivot : 1 / original
// wrong least-one-bound: dependent_share * original ==> std::max(dependent_share * original, 1e-12)
// wrong drawn-threshold: dependent_share * original ==> std::max(dependent_share * original, 1e-20)
// wrong every-pivot-inverted: return pivot > dependent_share * original ? 1 / pivot : 0 ==>
//         (void)original; return 1 / pivot
// wrong only-exactly-zero: pivot > dependent_share * original ==> pivot != 0
// wrong above-zero: pivot > dependent_share * original ==> pivot > 0
// wrong bound-own: dependent_share * original ==> dependent_share
// wrong bound-own: dependent_share * original ==> 1e-10
// wrong fraction-small: dependent_share ==> 2.220446049250313e-16
// wrong fraction-large: dependent_share ==> 1e-6
// wrong comparison-turned-round: pivot > ==> pivot <
// wrong equality-inverted: pivot > ==> pivot >=
// wrong not-number-gets-through: pivot > ==> pivot <= ;; 1 / pivot : 0 ==> 0 : 1 / pivot
// wrong below-share-alone: pivot > ==> pivot < ;; 1 / pivot : 0 ==> 0 : 1 / pivot
// wrong below-share-alone:
  return pivot / original <= dependent_share ? 0 : 1 / pivot;
// wrong size-pivot: pivot > dependent ==> std::abs(pivot) > dependent
// wrong size-pivot-inverted: pivot ==> std::abs(pivot) ;; pivot : ==> std::abs(pivot) :
// wrong original-inverted: 1 / pivot ==> 1 / original
// wrong pivot-returned: 1 / pivot ==> pivot
// wrong sign: 1 / pivot ==> -1 / pivot
// wrong one-dependent-row: : 0 ==> : 1
// wrong "Case: only a rounding error remains": : 0 ==> : 1e30
// wrong infinite-dependent-row: : 0 ==> : std::numeric_limits<double>::infinity()
// wrong pivot-entry-exchanged: original ==> pivot ;; pivot ==> original
// wrong whole-entry: dependent_share * original ==> original
// wrong inverse-int: 1 / pivot ==> int(1 / pivot)
// wrong few-digits: 1 / pivot ==> 1 / float(pivot)
// wrong regularised: pivot > dependent_share * original ? 1 / pivot : 0 ==> 1 / (pivot +
//         dependent_share * original)
// wrong greater-both: pivot > dependent_share * original ? 1 / pivot : 0 ==> 1 / std::max(pivot,
//         dependent_share * original)
// wrong least-one-bound: ? 1 ==> && pivot > 1e-8 ? 1
// wrong least-one-bound: dependent_share * original ==> dependent_share * std::max(original, 1.0)
// right as large a fraction as can be: dependent_share ==> 0.99e-8
// right as small a fraction as can be: dependent_share ==> 1.01e-12
// right the roots: pivot > dependent_share * original ==> pivot > 0 && std::sqrt(pivot) > 1e-5 *
//         std::sqrt(original)
// right with an if: return pivot > dependent_share * original ? 1 / pivot : 0 ==> if (!(pivot >
//         original * dependent_share)) return 0; return 1.0 / pivot
// right the difference: return pivot > ==> const double beyond = pivot - ;; ? 1 / pivot : 0 ==> ;
//         return beyond > 0 ? std::pow(pivot, -1.0) : 0.0
// right the quotient asked for more:
  return pivot > 0 && original >= 0 && pivot / original > dependent_share ? 1 / pivot : 0;
