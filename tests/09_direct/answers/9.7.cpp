// mistake "`now` does not choose the number that decides: Eq. 9-12 says which rows are right, not
//         where a wrong one goes. A free row has no right or wrong rate, and the impulse of a row
//         at a bound is at that bound but for rounding":
  (void)now;
  return impulse <= lower && rate >= 0   ? Side::lower
         : impulse >= upper && rate <= 0 ? Side::upper : Side::free;
// mistake "`now` does not choose the number that decides: Eq. 9-12 says which rows are right, not
//         where a wrong one goes. A free row has no right or wrong rate, and the impulse of a row
//         at a bound is at that bound but for rounding":
  if (impulse == lower && rate >= 0) return Side::lower;
  if (impulse == upper && rate <= 0) return Side::upper;
  return now == Side::free ? now : Side::free;
// mistake "`now` does not choose the number that decides: Eq. 9-12 says which rows are right, not
//         where a wrong one goes. A free row has no right or wrong rate, and the impulse of a row
//         at a bound is at that bound but for rounding":
  if (impulse <= lower) return rate < 0 ? Side::free : Side::lower;
  if (impulse >= upper) return rate > 0 ? Side::free : Side::upper;
  return now == Side::free ? now : Side::free;
// mistake "`now` does not choose the number that decides: Eq. 9-12 says which rows are right, not
//         where a wrong one goes. A free row has no right or wrong rate, and the impulse of a row
//         at a bound is at that bound but for rounding":
  (void)now;
  if (impulse < lower || (impulse == lower && rate >= 0)) return Side::lower;
  if (impulse > upper || (impulse == upper && rate <= 0)) return Side::upper;
  return Side::free;
// mistake "`now` does not choose the number that decides: Eq. 9-12 says which rows are right, not
//         where a wrong one goes. A free row has no right or wrong rate, and the impulse of a row
//         at a bound is at that bound but for rounding":
  if (now == Side::lower && rate >= 0) return now;
  if (now == Side::upper && rate <= 0) return now;
  return impulse < lower ? Side::lower : impulse > upper ? Side::upper : Side::free;
// wrong drawn-threshold: rate < 0 ==> rate < -1e-12 ;; rate > 0 ==> rate > 1e-12
// mistake "a free row never becomes bounded: beyond a bound it goes to that side": impulse < lower
//         ? Side::lower : impulse > upper ? Side::upper : ==>
// mistake "a free row never goes to its upper bound: impulse > upper is beyond it": : impulse >
//         upper ? Side::upper ==>
// mistake "a free row never goes to its lower bound: impulse < lower is beyond it": impulse < lower
//         ? Side::lower : ==>
// mistake "lower and upper are exchanged for a free row": upper : ==> lower : ;; lower : ==> upper
//         :
// mistake "the comparisons of a free row are reversed: below lower, or above upper": < lower ==> >
//         lower ;; > upper ==> < upper
// mistake "at exactly a bound nothing flips: < and >, not <= and >=": < ==> <=
// mistake "at exactly a bound nothing flips: < and >, not <= and >=": > ==> >=
// mistake "at exactly a bound nothing flips: < and >, not <= and >=": < ==> <= ;; > ==> >=
// mistake "the sign of the impulse decides: compare it with the bounds, which need not be 0":
//         impulse < lower ==> impulse < 0
// mistake "the sign of the rate at the lower bound: at a negative rate a larger impulse would
//         help": rate < 0 ? Side::free ==> rate > 0 ? Side::free
// mistake "the sign of the rate at the upper bound: at a positive rate a smaller impulse would
//         help": return rate > 0 ==> return rate < 0
// mistake "both signs of the rate are reversed: at the lower bound a negative rate frees, at the
//         upper one a positive rate": if (now == Side::lower) return rate < 0 ? Side::free : now;
//         return rate > 0 ==> return (now == Side::lower ? rate > 0 : rate < 0)
// mistake "at a rate of exactly 0 nothing flips: < and >, not <= and >=": rate < 0 ==> rate <= 0
// mistake "at a rate of exactly 0 nothing flips: < and >, not <= and >=": rate > 0 ==> rate >= 0
// mistake "from the lower bound to the upper one at once: it is free first": rate < 0 ? Side::free
//         ==> rate < 0 ? Side::upper
// mistake "from the upper bound to the lower one at once: it is free first": return rate > 0 ?
//         Side::free ==> return rate > 0 ? Side::lower
// mistake "a bounded row never becomes free: at the lower bound a negative rate frees it, at the
//         upper one a positive rate": if (now == Side::lower) return rate < 0 ? Side::free : ==>
//         return ;; return rate > 0 ? Side::free : now; ==>
// mistake "the side `now` is ignored: the rate of a bounded row decides, not its impulse": if (now
//         == Side::lower) return rate < 0 ? Side::free : now ==> return Side::free ;; return rate >
//         0 ? Side::free : now; ==>
// mistake "the rate decides on every side: for a free row the impulse decides":
  (void)now, (void)impulse, (void)lower, (void)upper;
  return rate < 0 ? Side::lower : rate > 0 ? Side::upper : Side::free;
// mistake "a bounded row is free as soon as its rate is not 0: at the lower bound a negative one,
//         at the upper one a positive one": if (now == Side::lower) return rate < ==> return rate
//         != ;; return rate > 0 ? Side::free : now; ==>
// mistake "a row at its upper bound stays there: at a positive rate a smaller impulse would help":
//         return rate > 0 ? Side::free : now ==> return now
// mistake "the rate of a free row is tested, too: only its impulse counts": lower ==> lower && rate
//         > 0 ;; upper ==> upper && rate < 0
// mistake "the sizes are compared: impulse and bounds have signs": impulse > upper ==>
//         std::abs(impulse) > std::abs(upper)
// mistake "a small rate is accepted at the lower bound: there is no threshold": 0 ==> -1e-6
// mistake "a small impulse below the lower bound is accepted: there is no threshold": impulse <
//         lower ==> impulse < lower - 1e-6
// wrong "a free row never goes to its upper bound: impulse > upper is beyond it; and the sign of
//         the rate at the upper bound": impulse > upper ? Side::upper : ==> ;; if (now ==
//         Side::lower) ==> ;; return rate > 0 ? Side::free : now; ==>
// mistake "nothing ever flips: `now` is returned":
  (void)impulse, (void)lower, (void)upper, (void)rate;
  return now;
// mistake "impulse and rate are combined into one number: the impulse alone decides for a free row,
//         the rate alone for a bounded one":
  (void)now;
  return impulse - rate < lower ? Side::lower : impulse - rate > upper ? Side::upper : Side::free;
// mistake "impulse and rate are combined into one number: the impulse alone decides for a free row,
//         the rate alone for a bounded one":
  (void)now;
  const double sum = impulse - rate;
  return sum <= lower ? Side::lower : sum >= upper ? Side::upper : Side::free;
// mistake "impulse and rate are combined into one number: the impulse alone decides for a free row,
//         the rate alone for a bounded one": < ==> - rate < ;; > ==> - rate >
// mistake "impulse and rate are combined into one number: the impulse alone decides for a free row,
//         the rate alone for a bounded one":
  if (now == Side::free)
    return impulse < lower ? Side::lower : impulse > upper ? Side::upper : Side::free;
  return impulse - rate < lower ? Side::lower : impulse - rate > upper ? Side::upper : Side::free;
// mistake "the sign of the impulse decides: compare it with the bounds, which need not be 0": lower
//         ? Side::lower : impulse > upper ? Side::upper ==> 0 ? Side::lower
// mistake "the sizes are compared: impulse and bounds have signs": impulse < lower ? Side::lower :
//         impulse > upper ? Side::upper : Side::free ==> std::abs(impulse) > std::abs(upper) ?
//         Side::upper : impulse < lower ? Side::lower : Side::free
// mistake "a small impulse beyond a bound is accepted: there is no threshold": impulse < lower ==>
//         impulse < lower - 1e-7 ;; impulse > upper ==> impulse > upper + 1e-7
// mistake "a small impulse above the upper bound is accepted: there is no threshold": impulse >
//         upper ==> impulse > upper + 1e-7
// mistake "a small rate is accepted at the upper bound: there is no threshold": > 0 ==> > 1e-7
// mistake "the rate of a free row is tested: only its impulse counts, its rate is zero already":
//         impulse < lower ? Side::lower : impulse > upper ? Side::upper : Side::free ==> rate {<|>}
//         0 ? Side::lower : rate {>|<} 0 ? Side::upper : Side::free
// mistake "a row at its lower bound stays there: at a negative rate a larger impulse would help":
//         return rate < 0 ? Side::free : now; ==> return now;
// mistake "a row at its lower bound is always free next: only at a negative rate": return rate < 0
//         ? Side::free : now; ==> return Side::free;
// mistake "a row at its upper bound is always free next: only at a positive rate": return rate > 0
//         ? Side::free : now ==> return Side::free
// mistake "the impulse of a row at its lower bound is tested: it is at the bound, the rate counts":
//         rate < 0 ? ==> impulse {> lower|>= lower} ?
// mistake "the impulse of a row at its upper bound is tested: it is at the bound, the rate counts":
//         rate > 0 ? ==> impulse {< upper|<= upper} ?
// mistake "a row that leaves its upper bound goes to the lower one's branch: both have their own":
//         return rate > 0 ? Side::free : now ==> return rate > 0 ? Side::free : Side::lower
// mistake "at a rate of exactly 0 nothing flips: < and >, not <= and >=, at either bound": rate < 0
//         ==> rate <= 0 ;; rate > 0 ==> rate >= 0
// mistake "the side `now` is ignored: the rate of a bounded row decides, not its impulse": if (now
//         == Side::free) ==> if (now != Side(5))
// mistake "the side `now` is ignored: the rate of a bounded row decides, not its impulse": if (now
//         == Side::free) ==> ;; < ==> <= ;; > ==> >=
// mistake "the rate decides on every side: for a free row the impulse decides": if (now ==
//         Side::free) ==> ;; impulse < lower ? Side::lower : impulse > upper ? Side::upper :
//         Side::free ==> rate > 0 ? Side::lower : rate < 0 ? Side::upper : Side::free
// mistake "always free: beyond its bounds an impulse must not be": if (now == Side::free) ==> ;;
//         impulse < lower ? Side::lower : impulse > upper ? Side::upper : Side::free ==> Side::free
// mistake "always the {lower|upper} bound": if (now == Side::free) ==> ;; impulse < lower ?
//         Side::lower : impulse > upper ? Side::upper : Side::free ==> Side::{lower|upper}
// mistake "impulse and rate are combined into one number: the impulse alone decides for a free row,
//         the rate alone for a bounded one": if (now == Side::free) ==> const double sum = impulse
//         + rate; ;; impulse < lower ? Side::lower : impulse ==> sum < lower ? Side::lower : sum
// right a switch:
  switch (now) {
    case Side::lower: return rate >= 0 ? Side::lower : Side::free;
    case Side::upper: return rate <= 0 ? Side::upper : Side::free;
    default: break;
  }
  if (impulse > upper) return Side::upper;
  return impulse >= lower ? Side::free : Side::lower;
// right a product of signs:
  if (now != Side::free) return rate * double(static_cast<signed char>(now)) > 0 ? Side::free : now;
  return Side((impulse > upper) - (impulse < lower));
