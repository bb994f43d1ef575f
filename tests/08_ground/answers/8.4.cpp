// mistake "a true fall begins with half a kick less: half of it is still missing": rate - kick / 2
//         ==> rate
// mistake "half a kick, not a whole one": kick / 2; ==> kick;
// mistake "the sign of the half kick: rate has the whole one, a true fall begins with half of it":
//         rate - kick / 2 ==> rate + kick / 2
// mistake "the sign of the height: the fall over C makes it faster": now * now - 2 ==> now * now +
//         2
// mistake "twice the acceleration times the height: the factor 2 is missing": 2 * kick / h * C ==>
//         kick / h * C
// mistake "the fall over the gap is missing": now * now - 2 * kick / h * C ==> now * now + 0 * h *
//         C
// mistake "h is missing: the acceleration is kick / h": kick / h * C ==> kick * C * (h / h)
// mistake "kick times h: the acceleration is kick / h": kick / h ==> kick * h
// mistake "the root is missing: this is the square of the speed": std::sqrt(std::max(real(0), now *
//         now - 2 * kick / h * C)) ==> std::max(real(0), now * now - 2 * kick / h * C)
// mistake "the speed is a positive number": return std::sqrt ==> return -std::sqrt
// mistake "speeds add up with squares here: v^2 grows by 2 a C": return std::sqrt(std::max(real(0),
//         now * now - 2 * kick / h * C)) ==> return std::abs(now) + std::sqrt(std::max(real(0), -2
//         * kick / h * C))
// mistake "a square below 0 has no root: return 0 then": std::max(real(0), now * now - 2 * kick / h
//         * C) ==> std::abs(now * now - 2 * kick / h * C)
// mistake "half the other way round: a whole kick more": rate - kick / 2 ==> rate - 3 * kick / 2
// right from the energy:
  const real start = kick / 2 - rate, energy = start * start / 2 - kick * C / h;
  return energy > 0 ? std::sqrt(2 * energy) : real(0);

// region 2
// mistake "the bound follows the sum: it is 1 + ratio times the sum that stopped the corner, take
//         it before the iterations": most[k]) ==> (1 + bounces[k].ratio) * before)
// mistake "the bound is ratio times the sum that stopped it: the rebound comes in addition": (1 +
//         bounces[k].ratio) * ==> bounces[k].ratio *
// mistake "the bound is missing": if (bounces[k].speed > 0) corner.sum[2] = std::min(corner.sum[2],
//         most[k]); ==>
// mistake "a corner without a rebound has no bound above": if (bounces[k].speed > 0) corner ==>
//         corner
// mistake "corners without a rebound are left out: the rebound of the others drives them down":
//         ContactRows& corner = corners[k]; ==> ContactRows& corner = corners[k]; if
//         (bounces[k].speed == 0) continue;
// mistake "it is not kept from pulling: the sum is 0 or more": std::max(real(0), before + missing /
//         corner.K[2]) ==> before + missing / corner.K[2]
// mistake "the change is clamped: it is the sum that must not become negative": std::max(real(0),
//         before + missing / corner.K[2]) ==> before + std::max(real(0), missing / corner.K[2])
// mistake "the old sum is lost: the impulse that stopped the corner counts": std::max(real(0),
//         before + missing ==> std::max(real(0), missing
// mistake "the sum is applied: apply its change": corner.sum[2] - before, body1 ==> corner.sum[2],
//         body1
// mistake "the sign of the change: new sum minus old sum": corner.sum[2] - before, body1 ==> before
//         - corner.sum[2], body1
// mistake "the sign of the speed: a corner that rebounds moves up": bounces[k].speed - row ==>
//         -bounces[k].speed - row
// mistake "J V so far is missing": bounces[k].speed - row_velocity(corner.J[2], body1, body2) ==>
//         bounces[k].speed
// mistake "the sign of J V: what is missing is speed - J V": bounces[k].speed - row ==>
//         bounces[k].speed + row
// mistake "the speed of the rebound is missing: the corner is stopped once more": bounces[k].speed
//         - row_velocity ==> -row_velocity
// mistake "times K where it must be divided by K": missing / corner ==> missing * corner
// mistake "the row of friction in the place of the normal row": corner.J[2], body1 ==> corner.J[0],
//         body1 ;; apply_impulse(corner.J[2] ==> apply_impulse(corner.J[0]
// mistake "one iteration only, or all of a corner before the next one: the corners must come to
//         agree": i < iterations ==> i < 1
// mistake "one iteration more": i < iterations ==> i <= iterations
// mistake "the bias is not part of it: the corners are at the ground now": bounces[k].speed - row
//         ==> bounces[k].speed - corner.bias - row
// mistake "only the first corner rebounds": ++k) { ==> ++k) { if (k > 0) break;
// mistake "the impulse is not applied": apply_impulse(corner.J[2], corner.sum[2] - before, body1,
//         body2); ==> (void)before;
// mistake "a copy of each corner: its sum is lost, use a reference": ContactRows& corner ==>
//         ContactRows corner
// right the change within its bounds:
  const std::vector<ContactRows> stopped = corners;
  while (iterations-- > 0)
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto& [speed, ratio] = bounces[k];
      real change = (speed - row_velocity(corners[k].J[2], body1, body2)) / corners[k].K[2];
      if (speed > 0) change = std::min(change, (1 + ratio) * stopped[k].sum[2] - corners[k].sum[2]);
      change = std::max(change, -corners[k].sum[2]);
      corners[k].sum[2] += change;
      apply_impulse(corners[k].J[2], change, body1, body2);
    }
