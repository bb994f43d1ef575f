// Known answers of exercise 9.4, each put in the place of the solution's.

// ---- wrong: every pivot inverted
// expects: Likely mistake: every pivot is inverted: what is left of a dependent row is rounding
  (void)original;
  return 1 / pivot;

// ---- wrong: only exactly zero
// expects: Likely mistake: only a pivot of exactly 0 gets 0: rounding error is never that
// change: pivot > dependent_share * original ==> pivot != 0

// ---- wrong: above zero
// expects: Likely mistake: only what is 0 or below gets 0: rounding error may be positive
// change: pivot > dependent_share * original ==> pivot > 0

// ---- wrong: absolute threshold
// expects: Likely mistake: the share itself is the bound: it is a share of the original entry
// change: dependent_share * original ==> dependent_share

// ---- wrong: a bound of its own
// expects: Likely mistake: a fixed bound for masses of any size: a share of the original entry
// change: dependent_share * original ==> 1e-10

// ---- wrong: machine epsilon
// expects: Likely mistake: another share, smaller than dependent_share
// change: dependent_share * original ==> 2.220446049250313e-16 * original

// ---- wrong: another share
// expects: Likely mistake: another share, larger than dependent_share
// change: dependent_share * original ==> 1e-6 * original

// ---- wrong: comparison turned round
// expects: Likely mistake: the comparison is turned round: what is at most the share gets 0
// change: pivot > ==> pivot <

// ---- wrong: equality inverted
// expects: Likely mistake: at exactly the share there is no inverse: at most this share is
// change: pivot > ==> pivot >=

// ---- wrong: not a number gets through
// expects: Likely mistake: a pivot or entry that is not a number gets through: ask for pivot >
  return pivot <= dependent_share * original ? 0 : 1 / pivot;

// ---- wrong: below the share alone
// expects: Likely mistake: at exactly the share there is no inverse, and not a number gives 0
  return pivot < dependent_share * original ? 0 : 1 / pivot;

// ---- wrong: quotient
// expects: Likely mistake: pivot / original where both are zero is not a number: compare with a
  return pivot / original <= dependent_share ? 0 : 1 / pivot;

// ---- wrong: size of the pivot
// expects: Likely mistake: the size of the pivot is compared: a pivot below zero is an error
// change: pivot > dependent ==> std::abs(pivot) > dependent

// ---- wrong: size of the pivot inverted
// expects: Likely mistake: the size of the pivot is inverted: a pivot below zero gets 0
// change: pivot > dependent_share * original ? 1 / pivot ==>
//         std::abs(pivot) > dependent_share * original ? 1 / std::abs(pivot)

// ---- wrong: original inverted
// expects: Likely mistake: the original entry is inverted: it only tells what is rounding error
// change: 1 / pivot ==> 1 / original

// ---- wrong: pivot returned
// expects: Likely mistake: the pivot is returned: its inverse
// change: 1 / pivot ==> pivot

// ---- wrong: sign
// expects: Likely mistake: the sign
// change: 1 / pivot ==> -1 / pivot

// ---- wrong: one for a dependent row
// expects: Likely mistake: a dependent row gets 1: it gets 0, no impulse
// change: : 0 ==> : 1

// ---- wrong: a huge number for a dependent row
// expects: Case: nothing but rounding error is left
// change: : 0 ==> : 1e30

// ---- wrong: infinite for a dependent row
// expects: Likely mistake: a dependent row gets an infinite inverse: it gets 0, no impulse
// change: : 0 ==> : std::numeric_limits<double>::infinity()

// ---- wrong: pivot and entry exchanged
// expects: Likely mistake: pivot and entry are exchanged in the comparison
// change: pivot > dependent_share * original ==> original > dependent_share * pivot

// ---- wrong: divided by the share
// expects: Likely mistake: always 0: a pivot above its share of the original entry has an inverse
// change: dependent_share * original ==> original / dependent_share

// ---- wrong: whole entry
// expects: Likely mistake: always 0: a pivot above its share of the original entry has an inverse
// change: dependent_share * original ==> original

// ---- wrong: inverse in an int
// expects: Likely mistake: 1 / pivot is cut to a whole number: an int has no fraction
// change: 1 / pivot ==> int(1 / pivot)

// ---- wrong: inverse in float
// expects: Likely mistake: right to a few digits only: is there a float among the reals, such as
// change: 1 / pivot ==> 1 / float(pivot)

// ---- wrong: regularised
// expects: Likely mistake: a share of the entry is added to every pivot: that changes all
  return 1 / (pivot + dependent_share * original);

// ---- wrong: the greater of both
// expects: Likely mistake: a pivot is at least its share of the entry: what is not more gets 0
  return 1 / std::max(pivot, dependent_share * original);

// ---- wrong: zero for small masses
// expects: Case: just above the share
// change: pivot > dependent_share * original ==> pivot > dependent_share * original && pivot > 1e-8

// ---- wrong: root of the share
// expects: Likely mistake: another share, larger than dependent_share
// change: dependent_share * original ==> std::sqrt(dependent_share) * original

// ---- wrong: share of the pivot
// expects: Likely mistake: only what is 0 or below gets 0: rounding error may be positive
// change: dependent_share * original ==> dependent_share * pivot

// ---- wrong: sum of both
// expects: Likely mistake: always 0: a pivot above its share of the original entry has an inverse
// change: dependent_share * original ==> dependent_share + original

// ---- wrong: at least one in the bound
// expects: Likely mistake: a bound that does not become smaller with the entry: a share of the
// change: dependent_share * original ==> dependent_share * std::max(original, 1.0)

// ---- right: with an if
  if (!(pivot > original * dependent_share)) return 0;
  return 1.0 / pivot;

// ---- right: the difference
  const double beyond = pivot - dependent_share * original;
  return beyond > 0 ? std::pow(pivot, -1.0) : 0.0;

// ---- right: the quotient asked for more
  return pivot > 0 && original >= 0 && pivot / original > dependent_share ? 1 / pivot : 0;
