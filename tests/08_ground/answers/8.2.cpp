// wrong across-the-sliding: (across); ==> (cross(n, across));
// wrong against-the-sliding: normalize ==> -normalize
// wrong "the subtracted part is along the velocity: it is along n": * n; ==> * sliding;
// expects: Case: n (0, 1, 0), sliding (3, -2.49, 0) m/s.
// wrong one-stand-in: { const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1,
//         0); across = other - dot(n, other) * n; } ==> across = vec3(1, 0, 0) - n.x * n;
// expects: (at rest, n = x)
// wrong largest-entry: normalize(across) ==> across / std::max({std::abs(across.x),
//         std::abs(across.y), std::abs(across.z)})
// wrong exchanged: t1, cross(n, t1) ==> cross(n, t1), t1
// wrong fixed-across: cross(n, t1) ==> vec3(0, 0, 1)
// wrong half-n-taken-away: dot(n, sliding) * n ==> real(0.5) * dot(n, sliding) * n
// wrong left-handed: n, t1 ==> t1, n
// wrong lost-at-rest:
// expects: t1 or t2 is not a number (at rest, n = x)
  const vec3 t1 = normalize(sliding - dot(n, sliding) * n);
  return {t1, cross(n, t1)};
// wrong made-unit-vector-first:
  if (length(sliding - dot(n, sliding) * n) < real(1e-4)) {
    const vec3 t1 = normalize(cross(n, std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0)));
    return {t1, cross(n, t1)};
  }
  const vec3 s = normalize(sliding), t1 = s - dot(n, s) * n;
  return {t1, cross(n, t1)};
// wrong n-taken-away: dot(n, sliding) * n ==> n
// wrong t1-not-unit-vector: const vec3 t1 = normalize(across); return {t1, cross(n, t1)} ==> return
//         {across, cross(n, across)}
// wrong not-unit-vector-rest: vec3 ==> const vec3 ;; other = ==> t1 = cross(n, ;; ; across = other
//         - dot(n, other) * n ==> ); return {t1, cross(n, t1)}
// wrong not-ground-rest: { const vec3 other ==> across ;; across = other - dot(n, other) * n; } ==>
// wrong not-projected: - dot(n, sliding) * n ==>
// expects: by hand
// wrong "slow sliding is ignored": -4 ==> -2
// wrong "slow sliding is ignored": -4 ==> -3
// expects: slow, 0.0002 m/s
// wrong one-stand-in: if ==> const vec3 other(real(0.3), real(-0.7), real(0.2)); if ;; { const vec3
//         other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0); ==> ;; n; } ==> n;
// expects: n parallel to the substitute
// wrong one-stand-in: { const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1,
//         0); across = other - dot(n, other) * n; } ==> across = vec3(1) - dot(n, vec3(1)) * n;
// expects: (at rest, n along (
// wrong only-along-n: sliding - ==>
// wrong sign-what-along-n: - dot ==> + dot
// wrong t2-not-unit-vector: const vec3 t1 = normalize(across); return {t1, cross(n, t1)} ==> return
//         {normalize(across), cross(n, across)}
// wrong velocity-forgotten:
  const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
  const vec3 t1 = normalize(other - dot(n, other) * n);
  return {t1, cross(n, t1)};
// wrong whole-velocity-asked: (across) ==> (sliding)
// expects: (falling, n = x)
// wrong y-taken-away: dot(n, sliding) * n ==> vec3(0, sliding.y, 0)
// wrong zero-at-rest: vec3 ==> const vec3 ;; { const vec3 other = std::abs(n.x) < real(0.6) ?
//         vec3(1, 0, 0) : vec3(0, 1, 0); across = other - dot(n, other) * n; } ==> return {vec3(0),
//         vec3(0)};
// right tangents at rest by a turn: vec3 ==> const vec3 ;; if ==> const vec3 aside = std::abs(n.x)
//         > std::abs(n.z) ? vec3(-n.y, n.x, 0) : vec3(0, -n.z, n.y); const vec3 t1 = normalize ;; )
//         { const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0); across =
//         other - dot(n, other) * n; } const vec3 t1 = normalize( ==> ? aside :
// right tangents by the lesser of two entries: std::abs(n.x) < real(0.6) ==> std::abs(n.x) <
//         std::abs(n.y)
// right tangents by two cross products:
  // t2 first: n x sliding has no part along n.
  vec3 side = cross(n, sliding);
  if (length(side) < real(1e-4))
    side = cross(n, std::abs(n.y) < real(0.9) ? vec3(0, 1, 0) : vec3(0, 0, 1));
  const vec3 t2 = normalize(side);
  return {cross(t2, n), t2};
// right tangents from the smallest part of n:
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
// right tangents square of the threshold: length(across) ==> dot(across,across) ;; -4 ==> -8
// wrong units "t1 is in m/s and should be a pure number":
  const vec3 across = sliding - dot(n, sliding) * n;
  return {across, cross(n, across)};
// wrong units "in t1, t2, taking m^2/s^2 from m/s":
  const vec3 t1 = normalize(sliding - dot(n, sliding) * sliding);
  return {t1, cross(n, t1)};

// region 2
// wrong clamped-early: const real wanted ==> sum = std::clamp(sum, -mu * normal, mu * normal);
//         const real wanted
// wrong clamped-early: const real wanted = sum - rate / K, bound = mu * normal; ==> const real
//         bound = mu * normal, wanted = std::clamp(sum, -bound, bound) - rate / K;
// wrong drawn-threshold: const real wanted ==> if (normal < real(1e-9)) normal = 0; const real
//         wanted
// wrong always-the-bound: const real wanted = sum - rate / K, bound = mu * normal ==> (void)rate;
//         (void)K ;; std::clamp(wanted, -bound, bound) ==> -mu * normal
// wrong "the bound is mu normal, yours is 2 mu normal": mu ==> 2 * mu
// expects: Case: rate 2.88 m/s, K 0.183333 1/kg, mu 0.5, normal 1.2 N s, sum 0 N s.
// wrong bound-over-h: normal ==> normal * 60
// wrong bound-int: bound = mu * normal ==> bound = int(mu * normal)
// wrong few-digits: bound = mu * normal ==> bound = float(mu * normal)
// wrong bound-only-outwards: -bound, bound ==> std::min(before, -bound), std::max(before, bound)
// wrong bound-over-k: normal ==> normal / K
// wrong bound-over-h: normal ==> normal * 20
// wrong bound-over-h: normal ==> normal / 20
// wrong "the bound is mu normal, yours is mu normal |rate|": normal ==> normal * std::abs(rate)
// wrong copy-sum: sum; sum ==> sum; real copy = sum; copy ;; return sum ==> return copy
// wrong dropped-beyond-bound: normal; ==> normal; if (std::abs(wanted) > bound) return 0; ;;
//         std::clamp(wanted, -bound, bound) ==> wanted
// wrong ends-exchanged-hand: bound = mu * normal ==> low = mu * normal, high = -low ;;
//         std::clamp(wanted, -bound, bound) ==> wanted < low ? low : wanted > high ? high : wanted
// wrong "std::clamp(a, low, high) was given a high that is below low": -bound, ==> bound, -
// wrong from-zero: -bound ==> real(0)
// wrong full-bound-always: const real wanted = sum - rate / K ==> (void)K; const real before = sum
//         ;; const real before = sum; sum = std::clamp(wanted, -bound, bound) ==> sum = rate > 0 ?
//         -bound : rate < 0 ? bound : real(0)
// wrong "sum - rate/K is wanted, yours is sum - 0.5 rate/K": rate / K ==> rate / K / 2
// wrong "only the lower bound is there: friction is bounded either way": const real wanted = sum -
//         rate / K, bound = mu * normal; ==> ;; clamp(wanted, -bound, bound) ==> max(sum - rate /
//         K, -mu * normal)
// wrong lower-end-without-mu: -bound, bound ==> -normal, bound
// wrong mu-forgotten: const real ==> (void)mu; const real ;; mu * ==>
// wrong mu-squared: bound = mu * normal ==> bound = mu * mu * normal
// wrong new-sum-plus-old: return sum - before ==> return sum + before
// wrong none-at-rest: normal ==> normal; if (rate == 0) return 0
// wrong none-air: const real before = sum; ==> if (normal <= 0) return 0; const real before = sum;
// wrong none-slow-sliding: normal ==> normal; if (std::abs(rate) < real(0.06)) return 0
// wrong normal-forgotten: const real ==> (void)normal; const real ;; * normal ==>
// wrong nothing-beyond-bound: bound = mu * normal; const real ==> ;; clamp(wanted, -bound, bound)
//         ==> abs(wanted) > mu * normal ? real(0) : wanted
// wrong only-pushes: const real wanted = sum - rate / K, bound = mu * ==> (void)mu; (void) ;;
//         clamp(wanted, -bound, bound) ==> max(real(0), sum - rate / K)
// wrong returns-what-was-wanted: return sum ==> return wanted
// wrong sign-friction-works-against: - rate ==> + rate
// wrong full-bound-always: const real wanted = sum - rate / K, bound = mu * normal ==> (void)K ;;
//         std::clamp(wanted, -bound, bound) ==> (rate > 0 ? -1 : 1) * mu * normal
// wrong size-rate: rate ==> std::abs(rate)
// wrong sum-forgotten: sum ==>
// wrong sum-over-k: sum - rate ==> (sum - rate)
// wrong times-k-where-must: / K ==> * K
// wrong "only the upper bound is there: friction is bounded either way": const real wanted = sum -
//         rate / K, bound = mu * normal; ==> ;; clamp(wanted, -bound, bound) ==> min(sum - rate /
//         K, mu * normal)
// wrong k-missing-impulse-speed: const real ==> (void)K; const real ;; / K ==>
// right friction by size and sign: real ==> real before = sum, ;; K, bound = mu * normal; const
//         real before = sum ==> K ;; clamp(wanted, -bound, bound) ==>
//         copysign(std::min(std::abs(wanted), mu * normal), wanted)
// right friction change clamped between what is left:
  // What the sum may still change, either way.
  const real bound = mu * normal, change = std::clamp(-rate / K, -bound - sum, bound - sum);
  sum += change;
  return change;
// right friction with ifs: wanted = sum - rate / K ==> before = sum ;; const real before = sum; sum
//         = std::clamp(wanted, -bound, bound) ==> sum -= rate / K; if (sum > bound) sum = bound; if
//         (sum < -bound) sum = -bound
// right friction with smaller and larger: const real wanted = sum - rate / K, bound = mu * normal;
//         ==> ;; clamp(wanted, -bound, bound) ==> max(-mu * normal, std::min(mu * normal, sum -
//         rate / K))
// right friction with the rest of the bound:
  // The change is clamped, between what is left of the bound on both sides.
  const real bound = mu * normal;
  const real change = std::clamp(-rate / K, -bound - sum, bound - sum);
  sum += change;
  return change;
// wrong units "in the change of the sum, comparing kg^2 m/s with kg m/s": normal; ==> normal/ K, ;;
//         const real before ==> before
// wrong units "in the change of the sum, taking m/(kg s) from kg m/s": / K ==> * K ;; normal; const
//         real ==> normal,
// wrong units "in the change of the sum, taking m/s from kg m/s: the inverse mass is missing": / K
//         ==> ;; normal; const real ==> normal, ;; return ==> (void)K; return
// right in two lines:
  const real bound = mu * normal, before = sum;
  sum = std::clamp(sum - rate / K, -bound, bound);
  return sum - before;
// from right friction change clamped between what is left
// wrong each-change-clamped: - sum ==> ;; - sum ==>
// wrong less-what-was-given: bound = mu * normal, ==> left = std::max(mu * normal - std::abs(sum),
//         real(0)); const real ;; bound - sum, bound - sum ==> left, left
// wrong nothing-clamped: const real bound = mu * normal, change = std::clamp(-rate / K, -bound -
//         sum, bound - sum); sum += change; return change; ==> (void)mu; (void)normal; sum -= rate
//         / K; return -rate / K;
// wrong stored-unclamped: real ==> real wanted = sum - rate / K, ;; change = std::clamp(-rate / K,
//         -bound - sum, bound - sum); sum += change; return change; ==> before = sum; sum = wanted;
//         return std::clamp(wanted, -bound, bound) - before;
// from right in two lines
// wrong new-sum-added: before = sum; sum ==> next ;; return sum - before ==> sum += next; return
//         next - sum
// wrong new-sum-added: before = sum; sum ==> next ;; return sum - before ==> const real change =
//         next - sum; sum += next; return change
// wrong new-sum-added: before = sum; sum ==> now ;; return sum - before ==> sum += now; return now
// wrong returns-the-sum: , before = sum ==> ;; - before ==>
// wrong returns-zero: , before = sum ==> ;; before ==> sum
