// wrong k-forgotten:
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed), -bound, bound);
  return sum - before;
// wrong k-squared:
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / (K * K), -bound, bound);
  return sum - before;
// wrong step-1-60:
  const real bound = motor.strength / 60, before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;
// wrong abs-rate: const real wanted = sum - (rate - motor.speed) / K; ==> ;; strength; const real
//         ==> strength, ;; wanted ==> sum - (std::abs(rate) - motor.speed) / K
// wrong all-over-h:
  const real bound = motor.strength, before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / (h * K), -bound, bound);
  return sum - before;
// wrong speed-already-size:
  if (std::abs(rate) >= std::abs(motor.speed)) return 0;
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;
// wrong before-after:
  const real bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  const real before = sum;
  return sum - before;
// wrong bound-by-speed:
  const real before = sum, bound = h * motor.speed;
  sum = std::clamp(sum - (rate - motor.speed) / K, -std::abs(bound), std::abs(bound));
  return sum - before;
// wrong bound-one-side:
  const real bound = h * motor.strength * (motor.speed < 0 ? -1 : 1), before = sum;
  const real least = std::min(bound, real(0)), most = std::max(bound, real(0));
  sum = std::clamp(sum - (rate - motor.speed) / K, least, most);
  return sum - before;
// wrong bound-with-k:
  const real bound = h * motor.strength / K, before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;
// wrong "std::clamp(a, low, high) was given a high that is below low: are the ends exchanged, has a":
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, bound, -bound);
  return sum - before;
// wrong clamp-not-assigned: wanted = sum - ==> before = sum, bound = h * motor.strength; sum -= ;;
//         const real bound = h * motor.strength; const real before = sum; sum = std ==> std ;;
//         wanted ==> sum
// wrong clamp-the-rate:
  const real bound = h * motor.strength, before = sum;
  sum = sum - std::clamp(rate - motor.speed, -bound, bound) / K;
  return sum - before;
// wrong does-not-push-when:
  const real before = sum, bound = h * motor.strength;
  if (std::abs(sum) >= bound) return 0;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;
// wrong drops-when-exceeding: const ==> const real before = sum, bound = h * motor.strength; const
//         ;; const real bound = h * motor.strength; const real before = sum; sum =
//         std::clamp(wanted, -bound, bound) ==> if (std::abs(wanted) > bound) return 0; sum =
//         wanted
// wrong each-change-clamped: const real wanted = sum - (rate - motor.speed) / K; ==> ;; before =
//         sum; sum ==> change ;; wanted ==> -(rate - motor.speed) / K ;; return sum - before ==>
//         sum += change; return change
// wrong early-out-1e-3:
  if (std::abs(rate - motor.speed) < 1e-3) return 0;
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;
// wrong early-out-1e-3:
  if (std::abs(rate - motor.speed) < 1e-6) return 0;
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;
// wrong early-out-small-strength:
  if (motor.strength < 1e-3) return 0;
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;
// wrong early-out-speed-0:
  if (motor.speed == 0) return 0;
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;
// wrong few-digits:
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(float(sum - (rate - motor.speed) / K), float(-bound), float(bound));
  return sum - before;
// wrong if-else-keeps-old:
  const real before = sum, bound = h * motor.strength, wanted = sum - (rate - motor.speed) / K;
  if (wanted < bound && wanted > -bound) sum = wanted;
  else if (wanted >= bound) sum = bound;
  return sum - before;
// wrong if-lower-sign-lost: wanted ==> before = sum, bound = h * motor.strength; sum ;; const real
//         bound = h * motor.strength; const real before = sum; sum = std::clamp(wanted, -bound,
//         bound) ==> if (std::abs(sum) > bound) sum = bound
// wrong int-speed: const real wanted = sum - (rate - motor.speed) / K; ==> ;; ; const real before =
//         sum ==> , before = sum; const int speed = motor.speed ;; wanted ==> sum - (rate - speed)
//         / K
// wrong int-strength:
  const int bound = h * motor.strength;
  const real before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / K, real(-bound), real(bound));
  return sum - before;
// wrong lack-sum:
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(motor.speed - rate, -bound, bound);
  return sum - before;
// wrong lower-bound-0:
  const real bound = h * motor.strength, before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / K, real(0), bound);
  return sum - before;
// wrong min-max-exchanged:
  const real before = sum, bound = h * motor.strength;
  sum = std::min(std::max(sum - (rate - motor.speed) / K, bound), -bound);
  return sum - before;
// wrong minus-sum:
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(-sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;
// wrong new-sum-added: const real wanted = sum - (rate - motor.speed) / K; ==> ;; before = sum; sum
//         ==> now ;; wanted ==> sum - (rate - motor.speed) / K ;; return sum - before ==> sum +=
//         now; return now
// wrong precedence:
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - rate - motor.speed / K, -bound, bound);
  return sum - before;
// wrong returns-bound:
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return bound;
// wrong returns-the-sum:
  const real bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum;
// wrong returns-what-was-cut:
  const real bound = h * motor.strength, wanted = sum - (rate - motor.speed) / K;
  sum = std::clamp(wanted, -bound, bound);
  return wanted - sum;
// wrong sign-speed:
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate + motor.speed) / K, -bound, bound);
  return sum - before;
// wrong strength-0-unlimited: wanted = sum - ==> before = sum, bound = h * motor.strength; sum -=
//         ;; const real bound = h * motor.strength; const real before = sum; ==> if (motor.strength
//         > 0) ;; wanted ==> sum
// wrong sum-not-stored:
  const real bound = h * motor.strength;
  return std::clamp(sum - (rate - motor.speed) / K, -bound, bound) - sum;
// wrong sum-thrown-away: const real wanted = sum - (rate - motor.speed) / K; ==> ;; strength ==>
//         strength; sum = 0 ;; wanted ==> sum - (rate - motor.speed) / K
// wrong torque-impulse:
  const real before = sum;
  sum = std::clamp(sum - (rate - motor.speed) / K, -motor.strength, motor.strength);
  return sum - before;
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
  // The change is clamped to what the sum has left, up and down.
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
