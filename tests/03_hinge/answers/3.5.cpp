// wrong drawn-side: const real wanted ==> sum = std::clamp(sum, -h * motor.strength, h *
//         motor.strength); const real wanted
// wrong drawn-threshold: const real wanted ==> if (std::abs(rate - motor.speed) < real(1e-9))
//         return 0; const real wanted
// mistake "no absolute value of the rate: it has a direction": const real wanted = sum - (rate -
//         motor.speed) / K; ==> ;; strength; const real ==> strength, ;; wanted ==> sum -
//         (std::abs(rate) - motor.speed) / K
// mistake "the part that was cut off is returned: return the change of the sum":
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
// wrong units "in the change of the sum, comparing kg m/s^2 with kg m/s: h is missing (an impulse
//         is h times a force, a bias is C/h)":  const real bound = h * motor.strength; ==> ;;
//         bound, bound ==> motor.strength, motor.strength
// right in two lines:
  const real before = sum, bound = h * motor.strength;
  sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound);
  return sum - before;
// mistake "the sign: the impulse works against J V - speed": sum - (rate ==> sum + (rate
// mistake "the bound is h strength: times h, not divided by h": h * motor.strength ==>
//         motor.strength / h
// mistake "each change is clamped: it is the accumulated impulse of a step that stays within h
//         strength": sum = std::clamp(wanted, -bound, bound); ==> ;; return sum - before ==> return
//         std::clamp(wanted - sum, -bound, bound)
// mistake "each change is clamped, and h is missing: it is the sum that stays within h strength": h
//         * motor ==> motor ;; sum = std::clamp(wanted, -bound, bound); ==> const real change =
//         std::clamp(wanted - sum, -bound, bound); sum += change; ;; return sum - before ==> return
//         change
// mistake "a factor of 0.5 in the required impulse": / K ==> / K / 2
// mistake "always the full impulse: the motor gives (speed - rate) / K, at most h strength": (rate
//         - motor.speed) / K ==> std::copysign(real(1e30), rate - motor.speed)
// mistake "the bound is h strength: h is used twice": h * motor ==> h * h * motor
// mistake "the required impulse is cut off to a whole number: an int has no fraction": const real
//         wanted ==> const int wanted ;; clamp(wanted ==> clamp(real(wanted)
// mistake "only the upper bound is there: the torque is bounded either way": std::clamp(wanted,
//         -bound, bound) ==> std::min(wanted, bound)
// mistake "only the lower bound is there: the torque is bounded either way": std::clamp(wanted,
//         -bound, bound) ==> std::max(wanted, -bound)
// mistake "the sum is always at its upper bound: are min and max exchanged, or is a variable never
//         set?": std::clamp(wanted, -bound, bound) ==> std::max(std::min(wanted, -bound), bound)
// mistake "the sum that is stored is not clamped": sum = std::clamp(wanted, -bound, bound); ==> sum
//         = wanted; ;; return sum - before ==> return std::clamp(wanted, -bound, bound) - before
// mistake "the required impulse is returned: return the change of the sum": return sum - before ==>
//         return (motor.speed - rate) / K
// mistake "the required impulse is returned: return the change of the sum": return sum - before ==>
//         return wanted
// mistake "the sum is returned and not stored: store it and return its change": sum =
//         std::clamp(wanted, -bound, bound) ==> return std::clamp(wanted, -bound, bound)
// mistake "old and new sum are added: return the change of the sum": sum - before ==> sum + before
// mistake "the sign of the change: new sum minus old sum": sum - before ==> before - sum
// mistake "the sum so far is missing in the required sum": wanted = sum - ==> wanted = -
// mistake "the change is added to the sum twice": return ==> const real change = sum - before; sum
//         += change; return change; return
// mistake "times K where it must be divided by K": / K ==> * K
// mistake "the bracket in (rate - speed) / K: all of the difference is divided": (rate -
//         motor.speed) / K ==> (rate - motor.speed / K)
// mistake "the bracket in (rate - speed) / K: all of the difference is divided": (rate -
//         motor.speed) / K ==> rate / K - motor.speed
// mistake "the bracket in (rate - speed) / K: all of the difference is divided": (rate -
//         motor.speed) / K ==> rate / K + motor.speed
// mistake "the old sum is divided by K, too": sum - (rate - motor.speed) / K ==> (sum - (rate -
//         motor.speed)) / K
// mistake "the speed of the motor is missing: this is a brake": rate - motor.speed ==> rate
// mistake "the rate is missing: the motor adds only the missing speed": rate - motor.speed ==>
//         -motor.speed
// mistake "the impulse is multiplied by h: it is an impulse already, not a torque": (rate -
//         motor.speed) / K ==> h * (rate - motor.speed) / K
// mistake "a motor that runs too fast brakes: its impulse may have either sign": const ==> if (rate
//         >= motor.speed) return 0; const
// mistake "a motor that runs too fast brakes: its impulse may have either sign": const ==> if (rate
//         > motor.speed) return 0; const
// mistake "a motor that runs too fast brakes: its impulse may have either sign": const ==> if
//         (std::abs(rate) > std::abs(motor.speed)) return 0; const
// mistake "a slow motor is one, too: no threshold on its speed": const ==> if
//         (std::abs(motor.speed) < 1e-3) return 0; const
// mistake "a motor pushes until its speed is reached: no threshold on the missing impulse": const
//         ==> if (std::abs(rate - motor.speed) < 1e-2) return 0; const
// mistake "a motor pushes until its speed is reached: no threshold on the missing impulse": const
//         ==> if (std::abs(rate - motor.speed) < 1e-4) return 0; const
// mistake "a motor pushes until its speed is reached: no threshold on the missing impulse": const
//         ==> if (std::abs(rate - motor.speed) < 1e-5) return 0; const
// mistake "a motor pushes until its speed is reached: no threshold on the missing impulse": const
//         ==> if (std::abs(rate - motor.speed) < 1e-7) return 0; const
// mistake "a motor pushes until its speed is reached: no threshold on the missing impulse": const
//         ==> if (std::abs((rate - motor.speed) / K) < 1e-2) return 0; const
// mistake "a motor pushes until its speed is reached: no threshold on the missing impulse": const
//         ==> if (std::abs((rate - motor.speed) / K) < 1e-3) return 0; const
// mistake "a motor pushes until its speed is reached: no threshold on the missing impulse": const
//         ==> if (std::abs((rate - motor.speed) / K) < 1e-4) return 0; const
// mistake "a motor pushes until its speed is reached: no threshold on the missing impulse": const
//         ==> if (std::abs((rate - motor.speed) / K) < 1e-5) return 0; const
// from right copysign
// mistake "nothing is clamped, or the old sum is: the new one stays within h strength": if
//         (std::abs(sum) > bound) sum = std::copysign(bound, sum) ==> std::clamp(sum, -bound,
//         bound)
// mistake "no impulse where the required one exceeds the bound: the motor gives its bound there":
//         sum -= ==> const real wanted = sum - ;; (sum) ==> (wanted) ;; sum = std::copysign(bound,
//         sum) ==> return 0; sum = wanted
// mistake "below the lower bound the sum is that bound: it is not left as it was": ; sum -= ==> ,
//         wanted = sum - ;; std::abs(sum) > ==> wanted < bound && wanted > - ;;
//         std::copysign(bound, sum) ==> wanted; else if (wanted >= bound) sum = bound
// mistake "below the lower bound the sum is the lower bound, not the upper one": sum -= ==> sum =
//         sum - ;; std::copysign(bound, sum) ==> bound
// mistake "strength 0 is a motor that is off, not one without a bound": std::abs(sum) > bound ==>
//         motor.strength > 0 ;; copysign(bound, sum) ==> clamp(sum, -bound, bound)
// from right in two lines
// mistake "K is missing: divide by it": / K ==>
// mistake "K is used twice: (rate - speed) / K": K ==> (K * K)
// mistake "the bound is h strength: h is the argument, not 1/60": real ==> real bound =
//         motor.strength / 60, ;; sum, bound = h * motor.strength ==> sum
// mistake "an impulse does not contain h: (rate - speed) / K, and the bound is h strength": real
//         ==> real bound = motor.strength, ;; sum, bound = h * motor.strength ==> sum ;; K ==> (h *
//         K)
// mistake "a motor that runs too fast brakes: its impulse may have either sign": const ==> if
//         (std::abs(rate) >= std::abs(motor.speed)) return 0; const
// mistake "0 is returned: keep the old sum before the new one is stored": before = sum, ==> ;;
//         return ==> const real before = sum; return
// mistake "the bound is h strength: it is independent of the speed": strength ==> speed ;; bound,
//         bound ==> std::abs(bound), std::abs(bound)
// mistake "the sum is kept between 0 and the bound on the side of the speed: a motor brakes, too":
//         before = sum, ==> ;; strength ==> strength * (motor.speed < 0 ? -1 : 1), before = sum;
//         const real least = std::min(bound, real(0)), most = std::max(bound, real(0)) ;; -bound,
//         bound ==> least, most
// mistake "the bound is h strength: it is independent of K": before = sum, ==> ;; strength ==>
//         strength / K, before = sum
// wrong "std::clamp(a, low, high) was given a high that is below low: are the ends exchanged, has
//         a":  -bound, ==> bound, -
// mistake "the rate is clamped: it is the sum that stays within h strength": before = sum, bound =
//         h * motor.strength; sum = std::clamp(sum - (rate - motor.speed) / K, -bound, bound) ==>
//         bound = h * motor.strength, before = sum; sum = sum - std::clamp(rate - motor.speed,
//         -bound, bound) / K
// mistake "nothing is done for a sum at its bound: it may become smaller again": strength ==>
//         strength; if (std::abs(sum) >= bound) return 0
// mistake "each change is clamped: it is the accumulated impulse of a step that stays within h
//         strength": before = sum, ==> ;; sum ==> const real change ;; sum ==> ;; return sum -
//         before ==> sum += change; return change
// mistake "a motor pushes until its speed is reached: no threshold on the missing impulse": const
//         ==> if (std::abs(rate - motor.speed) < 1e-3) return 0; const
// mistake "a motor pushes until its speed is reached: no threshold on the missing impulse": const
//         ==> if (std::abs(rate - motor.speed) < 1e-6) return 0; const
// mistake "a weak motor is one, too: no threshold on its strength": const ==> if (motor.strength <
//         1e-3) return 0; const
// mistake "a motor whose speed is 0 is a brake: it pushes until nothing moves": const ==> if
//         (motor.speed == 0) return 0; const
// wrong few-digits: sum - (rate - motor.speed) / K, -bound, bound ==> float(sum - (rate -
//         motor.speed) / K), float(-bound), float(bound)
// mistake "the speed is cut off to a whole number: an int has no fraction": motor.speed ==> speed
//         ;; strength ==> strength, before = sum; const int speed = motor.speed ;; before = sum,
//         ==>
// mistake "the bound is cut off to a whole number: an int has no fraction": real before = sum, ==>
//         int ;; strength ==> strength; const real before = sum ;; -bound, bound ==> real(-bound),
//         real(bound)
// mistake "the missing speed is divided by K and added to the sum": sum - (rate - motor.speed) / K
//         ==> motor.speed - rate
// mistake "the sum is kept from 0 to h strength: the torque is bounded either way": before = sum,
//         ==> ;; strength ==> strength, before = sum ;; -bound ==> real(0)
// mistake "the sum is always at its lower bound: are min and max exchanged, or is a variable never
//         set?": clamp ==> min(std::max ;; -bound, ==> bound), -
// mistake "the sign of the sum so far: the required impulse is added to it": sum - ==> -sum -
// mistake "the new sum is added to the old one: it takes its place": before = sum, ==> ;; sum ==>
//         const real now ;; return sum - before ==> sum += now; return now
// mistake "the bracket in (rate - speed) / K: all of the difference is divided": (rate -
//         motor.speed) ==> rate - motor.speed
// mistake "the bound is returned: return the change of the sum": sum - before ==> bound
// mistake "the new sum is returned instead of its change": before = sum, ==> ;; - before ==>
// mistake "the sign of the speed: the row is J V - speed = 0, not J V + speed = 0": rate - ==> rate
//         +
// mistake "the sum is not stored": before = sum, ==> ;; sum = ==> return ;; ; return sum - before;
//         ==> - sum;
// mistake "the sum so far is thrown away: it grows over all iterations of a step": before = sum,
//         ==> ;; strength ==> strength; sum = 0; const real before = sum
// mistake "the bound is h strength: an impulse is a torque times a time, and h is missing": sum,
//         bound = h * motor.strength ==> sum ;; bound, bound ==> motor.strength, motor.strength
