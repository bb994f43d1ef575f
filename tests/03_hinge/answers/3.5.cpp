// wrong drawn-side: const real wanted ==> sum = std::clamp(sum, -h * motor.strength, h *
//         motor.strength); const real wanted
// wrong drawn-threshold: const real wanted ==> if (std::abs(rate - motor.speed) < real(1e-9))
//         return 0; const real wanted
// wrong abs-rate: const real wanted = sum - (rate - motor.speed) / K; ==> ;; strength; const real
//         ==> strength, ;; wanted ==> sum - (std::abs(rate) - motor.speed) / K
// wrong returns-what-was-cut:
  const real bound = h * motor.strength, wanted = sum - (rate - motor.speed) / K;
  sum = std::clamp(wanted, -bound, bound);
  return wanted - sum;
// wrong never-set: const real wanted = ==> real wanted; const real before = sum; wanted += ;; const
//         real bound = h * motor.strength; const real before = sum; sum = std::clamp(wanted,
//         -bound, bound) ==> sum = wanted
// right copysign: wanted = sum - ==> before = sum, bound = h * motor.strength; sum -= ;; const real
//         bound = h * motor.strength; const real before = sum; ==> if (std::abs(sum) > bound) ;;
//         clamp(wanted, -bound, bound) ==> copysign(bound, sum)
// right nothing to do where nothing lacks:
  const real lack = motor.speed - rate, bound = h * motor.strength;
  if (lack == 0) return 0;
  const real before = sum;
  sum = std::clamp(sum + lack / K, -bound, bound);
  return sum - before;
// right off at zero strength:
  if (motor.strength == 0) { const real before = sum; sum = 0; return -before; }
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;
// right what is left of the bound:
  // The change is clamped to the distances of the sum from its bounds.
  const real bound = h * motor.strength, lack = (motor.speed - rate) / K;
  const real change = std::min(std::max(lack, -bound - sum), bound - sum);
  sum += change;
  return change;
// right with fmin and fmax: const real wanted = sum - (rate - motor.speed) / K; ==> ;; before = ==>
//         now = std::fmax(-bound, std::fmin(bound, sum + (motor.speed - rate) / K)); const real
//         change = now - ;; = std::clamp(wanted, -bound, bound) ==> += change ;; sum - before ==>
//         change
// right with ifs: wanted = sum - (rate - motor.speed) ==> before = sum; sum += (motor.speed - rate)
//         ;; const real bound ==> if (sum > h * motor.strength) sum ;; const real before = sum; sum
//         = std::clamp(wanted, -bound, bound) ==> if (sum < -h * motor.strength) sum = -h *
//         motor.strength
// wrong units "in the change of the sum, comparing kg m/s^2 with kg m/s: h is missing (an impulse is h times a force, a bias is C/h)":
//         const real bound = h * motor.strength; ==> ;; bound, bound ==> motor.strength,
//         motor.strength
// right in two lines:
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;
// from right copysign
// wrong clamp-not-assigned: if (std::abs(sum) > bound) sum = std::copysign(bound, sum) ==>
//         std::clamp(sum, -bound, bound)
// wrong drops-when-exceeding: sum -= ==> const real wanted = sum - ;; (sum) ==> (wanted) ;; sum =
//         std::copysign(bound, sum) ==> return 0; sum = wanted
// wrong if-else-keeps-old: ; sum -= ==> , wanted = sum - ;; std::abs(sum) > ==> wanted < bound &&
//         wanted > - ;; std::copysign(bound, sum) ==> wanted; else if (wanted >= bound) sum = bound
// wrong if-lower-sign-lost: sum -= ==> sum = sum - ;; std::copysign(bound, sum) ==> bound
// wrong strength-0-unlimited: std::abs(sum) > bound ==> motor.strength > 0 ;; copysign(bound, sum)
//         ==> clamp(sum, -bound, bound)
// from right in two lines
// wrong k-forgotten: / K ==>
// wrong k-squared: K ==> (K * K)
// wrong step-1-60: real ==> real bound = motor.strength / 60, ;; sum, bound = h * motor.strength
//         ==> sum
// wrong all-over-h: real ==> real bound = motor.strength, ;; sum, bound = h * motor.strength ==>
//         sum ;; K ==> (h * K)
// wrong speed-already-size: const ==> if (std::abs(rate) >= std::abs(motor.speed)) return 0; const
// wrong before-after: before = sum, ==> ;; return ==> const real before = sum; return
// wrong bound-by-speed: strength ==> speed ;; bound, bound ==> std::abs(bound), std::abs(bound)
// wrong bound-one-side: before = sum, ==> ;; strength ==> strength * (motor.speed < 0 ? -1 : 1),
//         before = sum; const real least = std::min(bound, real(0)), most = std::max(bound,
//         real(0)) ;; -bound, bound ==> least, most
// wrong bound-with-k: before = sum, ==> ;; strength ==> strength / K, before = sum
// wrong "std::clamp(a, low, high) was given a high that is below low: are the ends exchanged, has a":
//         -bound, ==> bound, -
// wrong clamp-the-rate: before = sum, bound = h * motor.strength; sum = std::clamp(sum - (rate -
//         motor.speed) / K, -bound, bound) ==> bound = h * motor.strength, before = sum; sum = sum
//         - std::clamp(rate - motor.speed, -bound, bound) / K
// wrong does-not-push-when: strength ==> strength; if (std::abs(sum) >= bound) return 0
// wrong each-change-clamped: before = sum, ==> ;; sum ==> const real change ;; sum ==> ;; return
//         sum - before ==> sum += change; return change
// wrong early-out-1e-3: const ==> if (std::abs(rate - motor.speed) < 1e-3) return 0; const
// wrong early-out-1e-3: const ==> if (std::abs(rate - motor.speed) < 1e-6) return 0; const
// wrong early-out-small-strength: const ==> if (motor.strength < 1e-3) return 0; const
// wrong early-out-speed-0: const ==> if (motor.speed == 0) return 0; const
// wrong few-digits: sum - (rate - motor.speed) / K, -bound, bound ==> float(sum - (rate -
//         motor.speed) / K), float(-bound), float(bound)
// wrong int-speed: motor.speed ==> speed ;; strength ==> strength, before = sum; const int speed =
//         motor.speed ;; before = sum, ==>
// wrong int-strength: real before = sum, ==> int ;; strength ==> strength; const real before = sum
//         ;; -bound, bound ==> real(-bound), real(bound)
// wrong lack-sum: sum - (rate - motor.speed) / K ==> motor.speed - rate
// wrong lower-bound-0: before = sum, ==> ;; strength ==> strength, before = sum ;; -bound ==>
//         real(0)
// wrong min-max-exchanged: clamp ==> min(std::max ;; -bound, ==> bound), -
// wrong minus-sum: sum - ==> -sum -
// wrong new-sum-added: before = sum, ==> ;; sum ==> const real now ;; return sum - before ==> sum
//         += now; return now
// wrong precedence: (rate - motor.speed) ==> rate - motor.speed
// wrong returns-bound: sum - before ==> bound
// wrong returns-the-sum: before = sum, ==> ;; - before ==>
// wrong sign-speed: rate - ==> rate +
// wrong sum-not-stored: before = sum, ==> ;; sum = ==> return ;; ; return sum - before; ==> - sum;
// wrong sum-thrown-away: before = sum, ==> ;; strength ==> strength; sum = 0; const real before =
//         sum
// wrong torque-impulse: sum, bound = h * motor.strength ==> sum ;; bound, bound ==> motor.strength,
//         motor.strength
