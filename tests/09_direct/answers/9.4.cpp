// mistake "a dependent row gets 1 over its original entry: it gets 0, no impulse": ? 1 / pivot : 0
//         ==> ? 1 / pivot : 1 / original
// wrong drawn-threshold: fraction * original ==> std::max(fraction * original, 1e-20)
// mistake "every pivot is inverted: that of a dependent row is a rounding error, it gets 0": return
//         pivot > fraction * original ? 1 / pivot : 0 ==> (void)original; return 1 / pivot
// mistake "only a pivot of exactly 0 gets 0: rounding error is never that": pivot > fraction *
//         original ==> pivot != 0
// mistake "only a pivot of 0 or below gets 0: a rounding error may be positive": pivot > fraction *
//         original ==> pivot > 0
// mistake "where both are zero there is no inverse: > and not >=": pivot > ==> pivot >=
// mistake "a pivot or entry that is not a number gets through: test pivot > fraction of the entry,
//         which is false then": pivot > ==> pivot <= ;; 1 / pivot : 0 ==> 0 : 1 / pivot
// mistake "two zeros, or values that are not numbers, get an inverse: test pivot > fraction of the
//         entry, which is false then": pivot > ==> pivot < ;; 1 / pivot : 0 ==> 0 : 1 / pivot
// mistake "two zeros, or values that are not numbers, get an inverse: test pivot > fraction of the
//         entry, which is false then":
  return pivot / original <= 1e-11 ? 0 : 1 / pivot;
// mistake "the size of the pivot is inverted: a pivot below zero gets 0": pivot ==> std::abs(pivot)
//         ;; pivot : ==> std::abs(pivot) :
// mistake "the original entry is inverted: it serves only for the comparison": 1 / pivot ==> 1 /
//         original
// mistake "the pivot is returned: its inverse": 1 / pivot ==> pivot
// wrong sign: 1 / pivot ==> -1 / pivot
// mistake "a dependent row gets 1: it gets 0, no impulse": : 0 ==> : 1
// mistake "a dependent row gets a huge inverse: it gets 0, no impulse": : 0 ==> : 1e30
// mistake "a dependent row gets an infinite inverse: it gets 0, no impulse": : 0 ==> :
//         std::numeric_limits<double>::infinity()
// mistake "pivot and entry are exchanged in the comparison": original ==> pivot ;; pivot ==>
//         original
// mistake "always 0: a pivot above its fraction of the original entry has an inverse": fraction *
//         original ==> original
// mistake "1 / pivot is cut to a whole number: an int has no fraction": 1 / pivot ==> int(1 /
//         pivot)
// wrong few-digits: 1 / pivot ==> 1 / float(pivot)
// mistake "a fraction of the entry is added to every pivot: that changes all impulses. Compare, and
//         return 0": pivot > fraction * original ? 1 / pivot : 0 ==> 1 / (pivot + fraction *
//         original)
// mistake "a pivot is raised to its fraction of the entry: a smaller one gets 0, no impulse": pivot
//         > fraction * original ? 1 / pivot : 0 ==> 1 / std::max(pivot, fraction * original)
// mistake "a fixed bound for masses of any size: it is a fraction of the original entry": fraction
//         * original ==> {1e-6|1e-7|1e-8|1e-9|1e-10|1e-11|1e-12|1e-13|1e-14|1e-15|1e-16|1e-20}
// mistake "a fixed bound for masses of any size: it is a fraction of the original entry": pivot >
//         fraction * original ==> !(pivot <
//         {1e-6|1e-7|1e-8|1e-9|1e-10|1e-11|1e-12|1e-13|1e-14|1e-15|1e-16|1e-20})
// mistake "a fixed bound for masses of any size: it is a fraction of the original entry": pivot >
//         fraction * original ==> !(std::abs(pivot) <
//         {1e-6|1e-7|1e-8|1e-9|1e-10|1e-11|1e-12|1e-13|1e-14|1e-15|1e-16|1e-20})
// mistake "a fixed bound for masses of any size: it is a fraction of the original entry": pivot >
//         fraction * original ==> std::abs(pivot) >
//         {1e-6|1e-7|1e-8|1e-9|1e-10|1e-11|1e-12|1e-13|1e-14|1e-15|1e-16|1e-20}
// mistake "a bound that does not become smaller with the entry: it is a fraction of the entry,
//         however small": fraction * original ==> std::max(fraction * original,
//         {1e-6|1e-7|1e-8|1e-9|1e-10|1e-11|1e-12|1e-13|1e-14|1e-15|1e-16|2.220446049250313e-16})
// mistake "the fraction is too small: rounding errors are larger": fraction * original ==>
//         {1e-13|1e-14|1e-15|1e-16|2.220446049250313e-16|1e-20} * original
// mistake "the fraction is too large: a row that is needed gets no impulse": fraction * original
//         ==> {1e-6|1e-7} * original
// mistake "the comparison is reversed: a pivot of at most the fraction gets 0": > ==> {<|<=}
// mistake "the comparison is reversed: a pivot of at most the fraction gets 0": pivot > fraction *
//         original ==> !(pivot {>|>=} fraction * original)
// mistake "the size of the pivot is compared: a pivot below zero is an error, too, and gets 0":
//         pivot > fraction * original ==> !(std::abs(pivot) <= fraction * original)
// mistake "the pivot is divided by its entry: 1 over the pivot": 1 / pivot ==> original / pivot
// mistake "the pivot is compared with the whole entry: elimination only makes it smaller": fraction
//         * original ==> original ;; pivot > ==> pivot >=
// mistake "the size of the pivot is compared: a pivot below zero is an error, too, and gets 0":
//         pivot > fraction ==> std::abs(pivot) > fraction
// right as large a fraction as can be: fraction * original ==> 0.99e-8 * original
// right as small a fraction as can be: fraction * original ==> 1.01e-12 * original
// right the roots: fraction * original ==> 0 && std::sqrt(pivot) > 1e-5 * std::sqrt(original)
// right with an if: return pivot > fraction * original ? 1 / pivot : 0 ==> if (!(pivot > original *
//         fraction)) return 0; return 1.0 / pivot
// right the difference: return pivot > ==> const double beyond = pivot - ;; ? 1 / pivot : 0 ==> ;
//         return beyond > 0 ? std::pow(pivot, -1.0) : 0.0
// right the quotient asked for more:
  return pivot > 0 && original >= 0 && pivot / original > 1e-11 ? 1 / pivot : 0;
