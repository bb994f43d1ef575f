// Known answers of exercise 8.2, each put in the place of the solution's.

// ---- wrong: friction added then compared
// region: 2
// expects: Likely mistake: the new sum is added to the old one
  const real bound = mu * normal, next = std::clamp(sum - rate / K, -bound, bound);
  sum += next;
  return next - sum;

// ---- wrong: friction added to the sum
// region: 2
// expects: Likely mistake: the new sum is added to the old one
  const real bound = mu * normal, next = std::clamp(sum - rate / K, -bound, bound);
  const real change = next - sum;
  sum += next;
  return change;

// ---- wrong: friction always the bound
// region: 2
// expects: Likely mistake: always the same bound
// change: const real wanted = sum - rate / K, bound = mu * normal ==> (void)rate; (void)K
// change: std::clamp(wanted, -bound, bound) ==> -mu * normal

// ---- wrong: friction bound doubled
// region: 2
// expects: Case: rate 2.88 m/s, K 0.183333 1/kg, mu 0.5, normal 1.2 N s, sum 0 N s.
// expects: Likely mistake: the bound is mu normal, yours is 2 mu normal
// change: bound = mu * normal ==> bound = 2 * mu * normal

// ---- wrong: friction bound for sixty steps
// region: 2
// expects: Likely mistake: the bound is an impulse already
// change: normal ==> normal * 60

// ---- wrong: friction bound in an int
// region: 2
// expects: Likely mistake: the bound is cut to a whole number: an int has no fraction
// change: bound = mu * normal ==> bound = int(mu * normal)

// ---- wrong: friction bound in float
// region: 2
// expects: Likely mistake: right to a few digits only: is there a float among the reals
// change: bound = mu * normal ==> bound = float(mu * normal)

// ---- wrong: friction bound only outwards
// region: 2
// expects: Likely mistake: the bound moves inwards when the normal impulse becomes less
  const real wanted = sum - rate / K, bound = mu * normal;
  const real before = sum;
  sum = std::clamp(wanted, std::min(before, -bound), std::max(before, bound));
  return sum - before;

// ---- wrong: friction bound over K
// region: 2
// expects: Likely mistake: the bound is divided by K
// change: normal ==> normal / K

// ---- wrong: friction bound over h
// region: 2
// expects: Likely mistake: the bound is an impulse already
// change: normal ==> normal * 20

// ---- wrong: friction bound times h
// region: 2
// expects: Likely mistake: the bound is an impulse already
// change: normal ==> normal / 20

// ---- wrong: friction bound times the rate
// region: 2
// expects: Likely mistake: the bound is mu normal, yours is mu normal |rate|
// change: bound = mu * normal ==> bound = mu * normal * std::abs(rate)

// ---- wrong: friction copy of the sum
// region: 2
// expects: Likely mistake: the sum is not stored: the next iteration needs it
// change: const real before = sum; ==> const real before = sum; real copy = sum;
// change: sum = std::clamp ==> copy = std::clamp
// change: return sum ==> return copy

// ---- wrong: friction dropped beyond the bound
// region: 2
// expects: Likely mistake: what is too much is cut back to the edge, not dropped
// change: normal; ==> normal; if (std::abs(wanted) > bound) return 0;
// change: std::clamp(wanted, -bound, bound) ==> wanted

// ---- wrong: friction each change clamped
// region: 2
// expects: Likely mistake: each change is clamped
  const real bound = mu * normal, change = std::clamp(-rate / K, -bound, bound);
  sum += change;
  return change;

// ---- wrong: friction ends exchanged by hand
// region: 2
// expects: Likely mistake: the ends of clamp are exchanged: clamp(a, low, high)
// change: bound = mu * normal ==> low = mu * normal, high = -low
// change: std::clamp(wanted, -bound, bound) ==> wanted < low ? low : wanted > high ? high : wanted

// ---- wrong: friction ends of clamp exchanged
// region: 2
// expects: std::clamp(a, low, high) was given a high that is below low
// change: -bound, ==> bound, -

// ---- wrong: friction from zero
// region: 2
// expects: Likely mistake: the sum is kept from 0 to mu normal
// change: -bound ==> real(0)

// ---- wrong: friction full bound always
// region: 2
// expects: Likely mistake: the full bound whatever is wanted
  (void)K;
  const real before = sum, bound = mu * normal;
  sum = rate > 0 ? -bound : rate < 0 ? bound : real(0);
  return sum - before;

// ---- wrong: friction half of what is wanted
// region: 2
// expects: Likely mistake: sum - rate/K is wanted, yours is sum - 0.5 rate/K
// change: rate / K ==> rate / K / 2

// ---- wrong: friction less what was given
// region: 2
// expects: Likely mistake: what the sum has left of the bound is taken for either way
  const real left = std::max(mu * normal - std::abs(sum), real(0));
  const real change = std::clamp(-rate / K, -left, left);
  sum += change;
  return change;

// ---- wrong: friction lower bound only
// region: 2
// expects: Likely mistake: only the lower bound is there: friction is bounded either way
// change: const real wanted = sum - rate / K, bound = mu * normal; ==>
// change: clamp(wanted, -bound, bound) ==> max(sum - rate / K, -mu * normal)

// ---- wrong: friction lower end without mu
// region: 2
// expects: Likely mistake: mu is missing in the lower bound
// change: -bound, bound ==> -normal, bound

// ---- wrong: friction mu forgotten
// region: 2
// expects: Likely mistake: the bound is mu times the normal impulse: mu is missing
// change: const real ==> (void)mu; const real
// change: mu * ==>

// ---- wrong: friction mu squared
// region: 2
// expects: Likely mistake: mu is taken twice in the bound
// change: bound = mu * normal ==> bound = mu * mu * normal

// ---- wrong: friction new sum added
// region: 2
// expects: Likely mistake: the new sum is added to the old one
  const real bound = mu * normal, now = std::clamp(sum - rate / K, -bound, bound);
  sum += now;
  return now;

// ---- wrong: friction new sum plus old sum
// region: 2
// expects: Likely mistake: new sum plus old sum: the change is new sum minus old sum
// change: return sum - before ==> return sum + before

// ---- wrong: friction none at rest
// region: 2
// expects: Likely mistake: nothing is done where nothing slides
// change: const real before = sum; ==> if (rate == 0) return 0; const real before = sum;

// ---- wrong: friction none in the air
// region: 2
// expects: Likely mistake: nothing is done where nothing presses: the sum goes back to 0 then
// change: const real before = sum; ==> if (normal <= 0) return 0; const real before = sum;

// ---- wrong: friction none of slow sliding
// region: 2
// expects: Likely mistake: what slides slowly is let go: there is no threshold
// change: const real before = sum; ==>
//         if (std::abs(rate) < real(0.06)) return 0; const real before = sum;

// ---- wrong: friction normal forgotten
// region: 2
// expects: Likely mistake: the bound is mu times the normal impulse: normal is missing
// change: const real ==> (void)normal; const real
// change: * normal ==>

// ---- wrong: friction nothing beyond the bound
// region: 2
// expects: Likely mistake: nothing is done beyond the bound: the sum goes to the bound
  const real wanted = sum - rate / K, before = sum;
  sum = std::abs(wanted) > mu * normal ? real(0) : wanted;
  return sum - before;

// ---- wrong: friction nothing clamped
// region: 2
// expects: Likely mistake: nothing is clamped
  (void)mu;
  (void)normal;
  sum -= rate / K;
  return -rate / K;

// ---- wrong: friction only pushes
// region: 2
// expects: Likely mistake: this is what a row does that only pushes
// change: const real wanted = sum - rate / K, bound = mu * ==> (void)mu; (void)
// change: clamp(wanted, -bound, bound) ==> max(real(0), sum - rate / K)

// ---- wrong: friction returns the sum
// region: 2
// expects: Likely mistake: the new sum is returned instead of its change
  const real bound = mu * normal;
  sum = std::clamp(sum - rate / K, -bound, bound);
  return sum;

// ---- wrong: friction returns what was wanted
// region: 2
// expects: Likely mistake: what was wanted is returned
// change: return sum ==> return wanted

// ---- wrong: friction returns zero
// region: 2
// expects: Likely mistake: 0 is returned: keep the old sum before the new one is stored
  const real bound = mu * normal;
  sum = std::clamp(sum - rate / K, -bound, bound);
  return sum - sum;

// ---- wrong: friction sign
// region: 2
// expects: Likely mistake: the sign: friction works against J V
// change: - rate ==> + rate

// ---- wrong: friction sign of the full bound
// region: 2
// expects: Likely mistake: the full bound whatever is wanted
// change: const real wanted = sum - rate / K, bound = mu * normal ==> (void)K
// change: std::clamp(wanted, -bound, bound) ==> (rate > 0 ? -1 : 1) * mu * normal

// ---- wrong: friction size of the rate
// region: 2
// expects: Likely mistake: the sign of the rate is lost
// change: rate ==> std::abs(rate)

// ---- wrong: friction stored unclamped
// region: 2
// expects: Likely mistake: the sum that is stored is not clamped
  const real wanted = sum - rate / K, bound = mu * normal, before = sum;
  sum = wanted;
  return std::clamp(wanted, -bound, bound) - before;

// ---- wrong: friction sum forgotten
// region: 2
// expects: Likely mistake: the sum so far is missing in what is wanted
// change: sum ==>

// ---- wrong: friction sum not stored
// region: 2
// expects: Likely mistake: the sum is not stored
  const real bound = mu * normal;
  return std::clamp(sum - rate / K, -bound, bound) - sum;

// ---- wrong: friction sum over K
// region: 2
// expects: Likely mistake: the old sum is divided by K, too
// change: sum - rate ==> (sum - rate)

// ---- wrong: friction times K
// region: 2
// expects: Likely mistake: times K where it must be divided by K
// change: / K ==> * K

// ---- wrong: friction upper bound only
// region: 2
// expects: Likely mistake: only the upper bound is there: friction is bounded either way
// change: const real wanted = sum - rate / K, bound = mu * normal; ==>
// change: clamp(wanted, -bound, bound) ==> min(sum - rate / K, mu * normal)

// ---- wrong: friction value never set
// region: 2
// expects: or was what is wanted never set?
// change: const real wanted = sum - rate / K, bound = mu * normal; ==>
//         real wanted; wanted += sum - rate / K; const real bound = mu * normal,
// change: const real before ==> before

// ---- wrong: friction without K
// region: 2
// expects: Likely mistake: K is missing: an impulse is a speed divided by K
// change: const real ==> (void)K; const real
// change: / K ==>

// ---- wrong: tangents across the sliding
// expects: Likely mistake: t1 is n x sliding, at right angles to it
// change: (across); ==> (cross(n, across));

// ---- wrong: tangents against the sliding
// expects: Likely mistake: t1 looks against the sliding
// change: normalize ==> -normalize

// ---- wrong: tangents along the velocity taken away
// expects: Case: n (0, 1, 0), sliding (3, -2.49, 0) m/s.
// expects: Likely mistake: what is taken away is along the velocity: it is along n
// change: * n; ==> * sliding;

// ---- wrong: tangents always x at rest
// expects: Likely mistake: the vector that stands in for the sliding is along n here
// expects: (at rest, n = x)
  vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4)) across = vec3(1, 0, 0) - n.x * n;
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};

// ---- wrong: tangents by the largest entry
// expects: Likely mistake: divided by the largest entry: by the length
// change: normalize(across) ==>
//         across / std::max({std::abs(across.x), std::abs(across.y), std::abs(across.z)})

// ---- wrong: tangents cross of one stand in
// expects: Likely mistake: the vector that stands in for the sliding is along n here
// expects: n along the vector that stands in
  vec3 across = sliding - dot(n, sliding) * n;
  const vec3 other(real(0.3), real(-0.7), real(0.2));
  if (length(across) < real(1e-4)) across = cross(n, other);
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};

// ---- wrong: tangents exchanged
// expects: Likely mistake: t1 and t2 are exchanged
  vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4)) {
    const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
    across = other - dot(n, other) * n;
  }
  const vec3 t1 = normalize(across);
  return {cross(n, t1), t1};

// ---- wrong: tangents fixed across
// expects: Likely mistake: t2 is always the same: t2 = n x t1
// change: cross(n, t1) ==> vec3(0, 0, 1)

// ---- wrong: tangents half of n taken away
// expects: Likely mistake: half of what is along n is taken away: all of it
// change: dot(n, sliding) * n ==> real(0.5) * dot(n, sliding) * n

// ---- wrong: tangents left handed
// expects: Likely mistake: t2 = t1 x n: it is n x t1
// change: n, t1 ==> t1, n

// ---- wrong: tangents lost at rest
// expects: Likely mistake: a zero vector has no direction
// expects: t1 or t2 is not a number (at rest, n = x)
  const vec3 t1 = normalize(sliding - dot(n, sliding) * n);
  return {t1, cross(n, t1)};

// ---- wrong: tangents made a unit vector first
// expects: Likely mistake: made a unit vector first
  if (length(sliding - dot(n, sliding) * n) < real(1e-4)) {
    const vec3 t1 = normalize(cross(n, std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0)));
    return {t1, cross(n, t1)};
  }
  const vec3 s = normalize(sliding), t1 = s - dot(n, s) * n;
  return {t1, cross(n, t1)};

// ---- wrong: tangents n taken away
// expects: Likely mistake: n itself is taken away: the part of the velocity along it, (n.v) n
// change: dot(n, sliding) * n ==> n

// ---- wrong: tangents not a unit vector
// expects: Likely mistake: t1 is not a unit vector
  vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4)) {
    const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
    across = other - dot(n, other) * n;
  }
  return {across, cross(n, across)};

// ---- wrong: tangents not a unit vector at rest
// expects: Likely mistake: the vector that stands in for the sliding is not made a unit vector
  const vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4)) {
    const vec3 t1 = cross(n, std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0));
    return {t1, cross(n, t1)};
  }
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};

// ---- wrong: tangents not in the ground at rest
// expects: Likely mistake: t1 does not lie in the ground
  vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4))
    across = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};

// ---- wrong: tangents not projected
// expects: Likely mistake: what is along n is not taken away: t1 lies in the ground
// expects: by hand
// change: - dot(n, sliding) * n ==>

// ---- wrong: tangents nothing below 1e-2
// expects: Likely mistake: what slides slowly counts as nothing
// change: -4 ==> -2

// ---- wrong: tangents nothing below 1e-3
// expects: Likely mistake: what slides slowly counts as nothing
// expects: slow, 0.0002 m/s
// change: -4 ==> -3

// ---- wrong: tangents one odd stand in
// expects: Likely mistake: the vector that stands in for the sliding is along n here
// expects: n along the vector that stands in
  vec3 across = sliding - dot(n, sliding) * n;
  const vec3 other(real(0.3), real(-0.7), real(0.2));
  if (length(across) < real(1e-4)) across = other - dot(n, other) * n;
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};

// ---- wrong: tangents one stand in
// expects: Likely mistake: the vector that stands in for the sliding is along n here
// expects: (at rest, n along (
  vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4)) across = vec3(1) - dot(n, vec3(1)) * n;
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};

// ---- wrong: tangents only along n
// expects: Likely mistake: only what is along n is kept: that is what has to go
// change: sliding - ==>

// ---- wrong: tangents sign of what is along n
// expects: Likely mistake: the sign of what is along n: it is taken away
// change: - dot ==> + dot

// ---- wrong: tangents square compared
// expects: Likely mistake: what slides slowly counts as nothing
// expects: Or is a squared length compared with it?
// change: length(across) ==> dot(across,across)

// ---- wrong: tangents t2 not a unit vector
// expects: Likely mistake: t2 is not a unit vector
  vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4)) {
    const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
    across = other - dot(n, other) * n;
  }
  return {normalize(across), cross(n, across)};

// ---- wrong: tangents velocity forgotten
// expects: Likely mistake: the velocity is not looked at
  const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
  const vec3 t1 = normalize(other - dot(n, other) * n);
  return {t1, cross(n, t1)};

// ---- wrong: tangents whole velocity asked
// expects: Likely mistake: the whole velocity is asked whether anything slides
// expects: (falling, n = x)
// change: (across) ==> (sliding)

// ---- wrong: tangents y taken away
// expects: Likely mistake: the y part of the velocity is taken away: n need not be the y axis
// change: dot(n, sliding) * n ==> vec3(0, sliding.y, 0)

// ---- wrong: tangents zero at rest
// expects: Likely mistake: a zero vector: friction needs two directions at rest, too
  const vec3 across = sliding - dot(n, sliding) * n;
  if (length(across) < real(1e-4)) return {vec3(0), vec3(0)};
  const vec3 t1 = normalize(across);
  return {t1, cross(n, t1)};

// ---- right: friction by size and sign
// region: 2
// The size is bounded, the sign is put back.
  const real before = sum, wanted = sum - rate / K;
  sum = std::copysign(std::min(std::abs(wanted), mu * normal), wanted);
  return sum - before;

// ---- right: friction change clamped between what is left
// region: 2
// What the sum may still change, either way.
  const real bound = mu * normal, change = std::clamp(-rate / K, -bound - sum, bound - sum);
  sum += change;
  return change;

// ---- right: friction with ifs
// region: 2
// One bound after the other.
  const real before = sum, bound = mu * normal;
  sum -= rate / K;
  if (sum > bound) sum = bound;
  if (sum < -bound) sum = -bound;
  return sum - before;

// ---- right: friction with smaller and larger
// region: 2
// The larger of -bound and the smaller of what is wanted and the bound.
  const real before = sum;
  sum = std::max(-mu * normal, std::min(mu * normal, sum - rate / K));
  return sum - before;

// ---- right: friction with what is left of the bound
// region: 2
// The change is clamped, between what is left of the bound on both sides.
  const real bound = mu * normal;
  const real change = std::clamp(-rate / K, -bound - sum, bound - sum);
  sum += change;
  return change;

// ---- right: tangents at rest by a turn
// At rest: n with two of its parts exchanged, which is never along n.
  const vec3 across = sliding - dot(n, sliding) * n;
  const vec3 aside = std::abs(n.x) > std::abs(n.z) ? vec3(-n.y, n.x, 0) : vec3(0, -n.z, n.y);
  const vec3 t1 = normalize(length(across) < real(1e-4) ? aside : across);
  return {t1, cross(n, t1)};

// ---- right: tangents by the lesser of two entries
// change: std::abs(n.x) < real(0.6) ==> std::abs(n.x) < std::abs(n.y)

// ---- right: tangents by two cross products
// t2 first: n x sliding has no part along n.
  vec3 side = cross(n, sliding);
  if (length(side) < real(1e-4))
    side = cross(n, std::abs(n.y) < real(0.9) ? vec3(0, 1, 0) : vec3(0, 0, 1));
  const vec3 t2 = normalize(side);
  return {cross(t2, n), t2};

// ---- right: tangents from the smallest part of n
// At rest: the axis that is farthest from n.
  const auto in_the_ground = [&](const vec3& a) { return a - dot(n, a) * n; };
  vec3 across = in_the_ground(sliding);
  if (dot(across, across) < real(1e-8)) {
    int least = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(n[k]) < std::abs(n[least])) least = k;
    vec3 axis(0);
    axis[least] = 1;
    across = in_the_ground(axis);
  }
  across /= length(across);
  return {across, cross(n, across)};

// ---- right: tangents square of the threshold
// change: length(across) ==> dot(across,across)
// change: -4 ==> -8

// ---- wrong units: bound over K
// region: 2
// expects: Units: in the change of the sum, comparing kg^2 m/s with kg m/s
// change: normal; ==> normal/ K,
// change: const real before ==> before

// ---- wrong units: not a unit vector
// expects: Units: t1 is in m/s and should be a pure number
  const vec3 across = sliding - dot(n, sliding) * n;
  return {across, cross(n, across)};

// ---- wrong units: times K
// region: 2
// expects: Units: in the change of the sum, taking m/(kg s) from kg m/s
  const real wanted = sum - rate * K, bound = mu * normal, before = sum;
  sum = std::clamp(wanted, -bound, bound);
  return sum - before;

// ---- wrong units: velocity for n
// expects: Units: in t1, t2, taking m^2/s^2 from m/s
  const vec3 t1 = normalize(sliding - dot(n, sliding) * sliding);
  return {t1, cross(n, t1)};

// ---- wrong units: without K
// region: 2
// expects: Units: in the change of the sum, taking m/s from kg m/s: the inverse mass is missing
  const real wanted = sum - rate, bound = mu * normal, before = sum;
  sum = std::clamp(wanted, -bound, bound);
  (void)K;
  return sum - before;
