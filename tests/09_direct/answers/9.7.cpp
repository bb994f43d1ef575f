// wrong now-ignored:
  (void)now;
  return impulse <= lower && rate >= 0   ? Side::lower
         : impulse >= upper && rate <= 0 ? Side::upper : Side::free;
// wrong now-ignored:
  if (impulse == lower && rate >= 0) return Side::lower;
  if (impulse == upper && rate <= 0) return Side::upper;
  return now == Side::free ? now : Side::free;
// wrong now-ignored:
  if (impulse <= lower) return rate < 0 ? Side::free : Side::lower;
  if (impulse >= upper) return rate > 0 ? Side::free : Side::upper;
  return now == Side::free ? now : Side::free;
// wrong now-ignored:
  (void)now;
  if (impulse < lower || (impulse == lower && rate >= 0)) return Side::lower;
  if (impulse > upper || (impulse == upper && rate <= 0)) return Side::upper;
  return Side::free;
// wrong now-ignored:
  if (now == Side::lower && rate >= 0) return now;
  if (now == Side::upper && rate <= 0) return now;
  return impulse < lower ? Side::lower : impulse > upper ? Side::upper : Side::free;
// wrong drawn-threshold: rate < 0 ==> rate < -1e-12 ;; rate > 0 ==> rate > 1e-12
// wrong free-row-stays: impulse < lower ? Side::lower : impulse > upper ? Side::upper : ==>
// wrong upper-bound-free-row: : impulse > upper ? Side::upper ==>
// wrong lower-bound-free-row: impulse < lower ? Side::lower : ==>
// wrong lower-upper-exchanged: upper : ==> lower : ;; lower : ==> upper :
// wrong comparisons-free-row-turned: < lower ==> > lower ;; > upper ==> < upper
// wrong flips-either-bound: impulse < lower ==> impulse <= lower
// wrong flips-either-bound: impulse > upper ==> impulse >= upper
// wrong flips-either-bound: < lower ==> <= lower ;; > upper ==> >= upper
// wrong zero-lower-bound: impulse < lower ==> impulse < 0
// wrong sign-rate-lower-bound: rate < 0 ? Side::free ==> rate > 0 ? Side::free
// wrong sign-rate-upper-bound: return rate > 0 ==> return rate < 0
// wrong both-signs-rate: if (now == Side::lower) return rate < 0 ? Side::free : now; return rate >
//         0 ? Side::free : now; ==> return (now == Side::lower ? rate > 0 : rate < 0) ? Side::free
//         : now;
// wrong flips-rate-zero: rate < 0 ==> rate <= 0
// wrong flips-rate-zero: rate > 0 ==> rate >= 0
// wrong lower-upper: rate < 0 ? Side::free ==> rate < 0 ? Side::upper
// wrong upper-lower: return rate > 0 ? Side::free ==> return rate > 0 ? Side::lower
// wrong bounded-rows-stay: if (now == Side::lower) return rate < 0 ? Side::free : ==> return ;;
//         return rate > 0 ? Side::free : now; ==>
// wrong bounded-rows-are-free: if (now == Side::lower) return rate < 0 ? Side::free : now ==>
//         return Side::free ;; return rate > 0 ? Side::free : now; ==>
// wrong rate-decides-everywhere:
  (void)now, (void)impulse, (void)lower, (void)upper;
  return rate < 0 ? Side::lower : rate > 0 ? Side::upper : Side::free;
// wrong any-rate-frees: if (now == Side::lower) return rate < ==> return rate != ;; return rate > 0
//         ? Side::free : now; ==>
// wrong upper-branch-missing: return rate > 0 ? Side::free : now ==> return now
// wrong free-asks-rate-well: lower ==> lower && rate > 0 ;; upper ==> upper && rate < 0
// wrong sizes-compared: impulse > upper ==> std::abs(impulse) > std::abs(upper)
// wrong threshold-rate: rate < 0 ==> rate < -1e-6
// wrong threshold-impulse: impulse < lower ==> impulse < lower - 1e-6
// wrong upper-bound-free-row + sign-rate-upper-bound: impulse > upper ? Side::upper : ==> ;; if
//         (now == Side::lower) ==> ;; return rate > 0 ? Side::free : now; ==>
// wrong now-returned:
  (void)impulse, (void)lower, (void)upper, (void)rate;
  return now;
// wrong sum-impulse-rate:
  (void)now;
  return impulse - rate < lower ? Side::lower : impulse - rate > upper ? Side::upper : Side::free;
// wrong sum-impulse-rate:
  (void)now;
  const double sum = impulse - rate;
  return sum <= lower ? Side::lower : sum >= upper ? Side::upper : Side::free;
// wrong sum-impulse-rate: impulse < lower ==> impulse - rate < lower ;; impulse > upper ==> impulse
//         - rate > upper
// wrong sum-impulse-rate:
  if (now == Side::free)
    return impulse < lower ? Side::lower : impulse > upper ? Side::upper : Side::free;
  return impulse - rate < lower ? Side::lower : impulse - rate > upper ? Side::upper : Side::free;
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
