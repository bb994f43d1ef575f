// Known answers of exercise 9.7, each put in the place of the solution's.

// ---- wrong: a free row stays
// expects: Likely mistake: a free row never becomes bounded: beyond a bound it goes to that side
// change: return impulse < lower ? Side::lower : impulse > upper ? Side::upper : Side::free; ==>
//         return Side::free;

// ---- wrong: upper bound of a free row forgotten
// expects: Likely mistake: a free row never goes to its upper bound: impulse > upper is beyond it
// change: impulse < lower ? Side::lower : impulse > upper ? Side::upper : Side::free ==>
//         impulse < lower ? Side::lower : Side::free

// ---- wrong: lower bound of a free row forgotten
// expects: Likely mistake: a free row never goes to its lower bound: impulse < lower is beyond it
// change: impulse < lower ? Side::lower : impulse > upper ? Side::upper : Side::free ==>
//         impulse > upper ? Side::upper : Side::free

// ---- wrong: lower and upper exchanged
// expects: Likely mistake: lower and upper are exchanged for a free row
// change: impulse < lower ? Side::lower : impulse > upper ? Side::upper ==>
//         impulse < lower ? Side::upper : impulse > upper ? Side::lower

// ---- wrong: comparisons of a free row turned round
// expects: Likely mistake: the comparisons of a free row are turned round: below lower, or above
// change: impulse < lower ? Side::lower : impulse > upper ==>
//         impulse > lower ? Side::lower : impulse < upper

// ---- wrong: flips at the lower bound
// expects: Likely mistake: at exactly a bound nothing flips: < and >, not <= and >=
// change: impulse < lower ==> impulse <= lower

// ---- wrong: flips at the upper bound
// expects: Likely mistake: at exactly a bound nothing flips: < and >, not <= and >=
// change: impulse > upper ==> impulse >= upper

// ---- wrong: flips at either bound
// expects: Likely mistake: at exactly a bound nothing flips: < and >, not <= and >=
// change: impulse < lower ==> impulse <= lower
// change: impulse > upper ==> impulse >= upper

// ---- wrong: zero for the lower bound
// expects: Likely mistake: the sign of the impulse decides: compare it with the bounds, which
// change: impulse < lower ==> impulse < 0

// ---- wrong: sign of the rate at the lower bound
// expects: Likely mistake: the sign of the rate at the lower bound: at a negative rate a larger
// change: rate < 0 ? Side::free ==> rate > 0 ? Side::free

// ---- wrong: sign of the rate at the upper bound
// expects: Likely mistake: the sign of the rate at the upper bound: at a positive rate a smaller
// change: return rate > 0 ==> return rate < 0

// ---- wrong: both signs of the rate
// expects: Likely mistake: both signs of the rate are turned round: at the lower bound a negative
  if (now == Side::free)
    return impulse < lower ? Side::lower : impulse > upper ? Side::upper : Side::free;
  return (now == Side::lower ? rate > 0 : rate < 0) ? Side::free : now;

// ---- wrong: flips at a rate of zero
// expects: Likely mistake: at a rate of exactly 0 nothing flips: < and >, not <= and >=
// change: rate < 0 ==> rate <= 0

// ---- wrong: flips at a rate of zero, upper
// expects: Likely mistake: at a rate of exactly 0 nothing flips: < and >, not <= and >=
// change: rate > 0 ==> rate >= 0

// ---- wrong: from lower to upper
// expects: Likely mistake: from the lower bound to the upper one at once: it is free first
// change: rate < 0 ? Side::free ==> rate < 0 ? Side::upper

// ---- wrong: from upper to lower
// expects: Likely mistake: from the upper bound to the lower one at once: it is free first
// change: return rate > 0 ? Side::free ==> return rate > 0 ? Side::lower

// ---- wrong: bounded rows stay
// expects: Likely mistake: a bounded row never becomes free: at the lower bound a negative rate
// change: if (now == Side::lower) return rate < 0 ? Side::free : ==> return
// change: return rate > 0 ? Side::free : now; ==>

// ---- wrong: bounded rows are free next
// expects: Likely mistake: the side of now is not looked at: a bounded row is asked for its rate
// change: if (now == Side::lower) return rate < 0 ? Side::free : now ==> return Side::free
// change: return rate > 0 ? Side::free : now; ==>

// ---- wrong: impulse decides everywhere
// expects: Likely mistake: the side of now is not looked at: a bounded row is asked for its rate
  (void)now, (void)rate;
  return impulse < lower ? Side::lower : impulse > upper ? Side::upper : Side::free;

// ---- wrong: rate decides everywhere
// expects: Likely mistake: the rate decides whatever the side: a free row is asked for its
  (void)now, (void)impulse, (void)lower, (void)upper;
  return rate < 0 ? Side::lower : rate > 0 ? Side::upper : Side::free;

// ---- wrong: any rate frees
// expects: Likely mistake: a bounded row is free as soon as its rate is not 0: at the lower bound
// change: if (now == Side::lower) return rate < ==> return rate !=
// change: return rate > 0 ? Side::free : now; ==>

// ---- wrong: upper branch missing
// expects: Likely mistake: a row at its upper bound stays there: at a positive rate a smaller
// change: return rate > 0 ? Side::free : now ==> return now

// ---- wrong: same branch for both
// expects: Likely mistake: the sign of the rate at the upper bound: at a positive rate a smaller
// change: if (now == Side::lower) ==>
// change: return rate > 0 ? Side::free : now; ==>

// ---- wrong: free asks the rate as well
// expects: Likely mistake: a free row is asked for its rate, too: only its impulse counts
// change: impulse < lower ? ==> impulse < lower && rate > 0 ?
// change: impulse > upper ? ==> impulse > upper && rate < 0 ?

// ---- wrong: sizes compared
// expects: Likely mistake: the sizes are compared: impulse and bounds have signs
// change: impulse < lower ? Side::lower : impulse > upper ==>
//         impulse < lower ? Side::lower : std::abs(impulse) > std::abs(upper)

// ---- wrong: a threshold for the rate
// expects: Likely mistake: a small rate is let pass at the lower bound: there is no threshold
// change: rate < 0 ==> rate < -1e-6

// ---- wrong: a threshold for the impulse
// expects: Likely mistake: a small impulse below the lower bound is let pass: there is no
// change: impulse < lower ==> impulse < lower - 1e-6

// ---- wrong: a one-sided row alone
// expects: Likely mistake: a free row never goes to its upper bound: impulse > upper is beyond
  if (now == Side::free) return impulse < lower ? Side::lower : Side::free;
  return rate < 0 ? Side::free : now;

// ---- wrong: now returned
// expects: Likely mistake: nothing ever flips: `now` is returned
  (void)impulse, (void)lower, (void)upper, (void)rate;
  return now;

// ---- wrong: the sum of impulse and rate
// expects: Likely mistake: impulse and rate are added: the one is asked of a free row, the other
  (void)now;
  return impulse - rate < lower ? Side::lower : impulse - rate > upper ? Side::upper : Side::free;

// ---- wrong: rate negative decides impulse
// expects: Likely mistake: a row at its upper bound stays there: at a positive rate a smaller
// change: rate > 0 ? Side::free : now ==> impulse < upper ? Side::free : now

// ---- right: a switch
  switch (now) {
    case Side::lower: return rate >= 0 ? Side::lower : Side::free;
    case Side::upper: return rate <= 0 ? Side::upper : Side::free;
    default: break;
  }
  if (impulse > upper) return Side::upper;
  return impulse >= lower ? Side::free : Side::lower;

// ---- right: a product of signs
  if (now != Side::free) return rate * double(static_cast<signed char>(now)) > 0 ? Side::free : now;
  return Side((impulse > upper) - (impulse < lower));
