// mistake "t1 is n x sliding, at right angles to it: t1 is the direction of sliding": (across); ==>
//         (cross(n, across));
// mistake "t1 is n x sliding, at right angles to it: t1 is the direction of sliding": (across); ==>
//         (cross(across, n));
// mistake "t1 is opposite to the sliding: it is the direction of sliding, and the impulse is
//         negative": normalize ==> -normalize
// mistake "t1 is opposite to the sliding: it is the direction of sliding, and the impulse is
//         negative": {t1, ==> {-t1,
// mistake "the subtracted part is along the velocity: it is along n, (n.v) n and not (n.v) v": * n;
//         ==> * sliding;
// expects: Case: n (0, 1, 0), sliding (3, -2.49, 0) m/s.
// wrong one-stand-in: { const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1,
//         0); across = other - dot(n, other) * n; } ==> across = vec3(1, 0, 0) - n.x * n;
// expects: (at rest, n = x)
// mistake "divided by the largest entry: by the length": normalize(across) ==> across /
//         std::max({std::abs(across.x), std::abs(across.y), std::abs(across.z)})
// mistake "divided by the sum of the entries: by the length": normalize(across) ==> across /
//         (std::abs(across.x) + std::abs(across.y) + std::abs(across.z))
// mistake "divided by the square of the length: by the length": normalize(across) ==> across /
//         dot(across, across)
// mistake "t1 and t2 are exchanged: the first one is the direction of sliding": t1, cross(n, t1)
//         ==> cross(n, t1), t1
// wrong fixed-across: cross(n, t1) ==> vec3(0, 0, 1)
// mistake "half of the part along n is subtracted: subtract all of it": dot(n, sliding) * n ==>
//         real(0.5) * dot(n, sliding) * n
// mistake "the part along n is subtracted twice: once": dot(n, sliding) * n ==> real(2) * dot(n,
//         sliding) * n
// mistake "t2 = t1 x n: it is n x t1, so that n, t1 and t2 go round like x, y and z": n, t1 ==> t1,
//         n
// wrong lost-at-rest:
// expects: t1 or t2 is not a number (at rest, n = x)
  const vec3 t1 = normalize(sliding - dot(n, sliding) * n);
  return {t1, cross(n, t1)};
// mistake "normalised first, then the part along n is subtracted: the other way round":
  if (length(sliding - dot(n, sliding) * n) < real(1e-4)) {
    const vec3 t1 = normalize(cross(n, std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0)));
    return {t1, cross(n, t1)};
  }
  const vec3 s = normalize(sliding), t1 = s - dot(n, s) * n;
  return {t1, cross(n, t1)};
// mistake "n itself is subtracted: subtract the part of the velocity along it, (n.v) n": dot(n,
//         sliding) * n ==> n
// mistake "t1 is not a unit vector: divide by the length of the remaining vector": const vec3 t1 =
//         normalize(across); return {t1, cross(n, t1)} ==> return {across, cross(n, across)}
// mistake "t1 is not a unit vector: divide by the length of the remaining vector": {t1, ==>
//         {across,
// wrong not-unit-vector-rest: vec3 ==> const vec3 ;; other = ==> t1 = cross(n, ;; ; across = other
//         - dot(n, other) * n ==> ); return {t1, cross(n, t1)}
// wrong not-ground-rest: { const vec3 other ==> across ;; across = other - dot(n, other) * n; } ==>
// mistake "the part along n is subtracted along the y axis of the world: it is along n, (n.v) n":
//         dot(n, sliding) * n ==> dot(n, sliding) * vec3(0, 1, 0)
// mistake "the sign of the part along n is lost: it is (n.v) n, whatever the sign of n.v": dot(n,
//         sliding) * n ==> std::abs(dot(n, sliding)) * n
// mistake "the whole speed is subtracted along n: subtract the part of the velocity along it, (n.v)
//         n": dot(n, sliding) * n ==> length(sliding) * n
// mistake "the square of the speed is subtracted along n: subtract (n.v) n": dot(n, sliding) * n
//         ==> dot(sliding, sliding) * n
// mistake "the cross product is subtracted: subtract the part of the velocity along n, (n.v) n":
//         dot(n, sliding) * n ==> cross(n, sliding)
// mistake "entry times entry where the dot product belongs: subtract (n.v) n": dot(n, sliding) * n
//         ==> n * sliding
// mistake "absolute values: t1 has the signs of the sliding": normalize(across) ==>
//         normalize(abs(across))
// mistake "t2 is the direction of the velocity: t2 = n x t1": cross(n, t1) ==> length(sliding) > 0
//         ? normalize(sliding) : cross(n, t1)
// mistake "the part along n is not subtracted: t1 lies in the ground": - dot(n, sliding) * n ==>
// expects: by hand
// mistake "the part along n is not subtracted: t1 lies in the ground": return {t1, cross(n, t1)}
//         ==> if (length(sliding - dot(n, sliding) * n) < real(1e-4)) return {t1, cross(n, t1)};
//         return {normalize(sliding), normalize(cross(n, sliding))}
// mistake "the part along n is not subtracted: t1 lies in the ground, and it is a unit vector":
//         return {t1, cross(n, t1)} ==> if (length(sliding - dot(n, sliding) * n) < real(1e-4))
//         return {t1, cross(n, t1)}; return {sliding, cross(n, sliding)}
// mistake "slow sliding is ignored: only below 1e-4 m/s across n may t1 be any direction": if
//         (length(across) ==> if (length(across) < real(5e-4) && sliding != vec3(0)) return
//         joints::tangents(n, vec3(0)); if (length(across)
// expects: slow, 0.0002 m/s
// mistake "slow sliding is ignored: only below 1e-4 m/s across n may t1 be any direction. Or is a
//         squared length compared with it?": if (length(across) ==> if (length(across) < real(5e-3)
//         && sliding != vec3(0)) return joints::tangents(n, vec3(0)); if (length(across)
// mistake "slow sliding is ignored: only below 1e-4 m/s across n may t1 be any direction": if
//         (length(across) ==> if (length(across) < real(0.1) && sliding != vec3(0)) return
//         joints::tangents(n, vec3(0)); if (length(across)
// mistake "slow sliding is ignored: only below 1e-4 m/s across n may t1 be any direction": if
//         (length(across) ==> if (length(across) < real(1) && sliding != vec3(0)) return
//         joints::tangents(n, vec3(0)); if (length(across)
// wrong one-stand-in: if ==> const vec3 other(real(0.3), real(-0.7), real(0.2)); if ;; { const vec3
//         other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0); ==> ;; n; } ==> n;
// expects: n parallel to the substitute
// wrong one-stand-in: { const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1,
//         0); across = other - dot(n, other) * n; } ==> across = vec3(1) - dot(n, vec3(1)) * n;
// expects: (at rest, n along (
// mistake "only the part along n is kept: that is the one to subtract": sliding - ==> ;; if
//         (length(across) ==> if (length(across) < real(1e-4) && sliding != vec3(0)) return
//         joints::tangents(n, vec3(0)); if (length(across)
// mistake "the sign of the part along n: it is subtracted, s = v - (n.v) n": - dot ==> + dot
// mistake "t2 is not a unit vector: take n x t1 with the t1 that has been made one": const vec3 t1
//         = normalize(across); return {t1, cross(n, t1)} ==> return {normalize(across), cross(n,
//         across)}
// mistake "the velocity is ignored, or replaced by a variable that was never set: t1 is the
//         direction of sliding": if ==> if (sliding != vec3(0)) return joints::tangents(n,
//         vec3(0)); if
// mistake "the velocity is ignored, or replaced by a variable that was never set: t1 is the
//         direction of sliding":
  const vec3 other = std::abs(n.x) < real(0.6) ? vec3(1, 0, 0) : vec3(0, 1, 0);
  const vec3 t1 = normalize(other - dot(n, other) * n);
  return {t1, cross(n, t1)};
// wrong whole-velocity-asked: (across) ==> (sliding)
// expects: (falling, n = x)
// mistake "the y part of the velocity is subtracted: n may be another axis": dot(n, sliding) * n
//         ==> vec3(0, sliding.y, 0)
// mistake "the x part of the velocity is subtracted: n may be another axis": dot(n, sliding) * n
//         ==> vec3(sliding.x, 0, 0) ;; if (length(across) ==> if (length(across) < real(1e-4) &&
//         sliding != vec3(0)) return joints::tangents(n, vec3(0)); if (length(across)
// mistake "t1 twice: t2 = n x t1": cross(n, t1) ==> t1
// mistake "t2 is at right angles to the velocity, not to n: t2 = n x t1": cross(n, t1) ==>
//         normalize(cross(sliding, t1))
// mistake "t2 is missing: t2 = n x t1": cross(n, t1) ==> vec3(0)
// mistake "n is among the two: both directions lie in the ground": cross(n, t1) ==> n
// wrong drawn-cut: (across) < real(1e-4) ==> (across) <= real(1e-4) * length(sliding) ||
//         length(across) < real(1e-4)
// expects: speed along n over sliding
// wrong "cases drawn with seed 1 are wrong": vec3 across = sliding - dot(n, sliding) * n ==>
//         const vec3 up = n.y > real(0.9999) ? vec3(0, 1, 0) : n; vec3 across = sliding -
//         dot(up, sliding) * up
// expects: angle between n and y
// wrong one-stand-in: std::abs(n.x) < real(0.6) ==> n.x == 0
// expects: n hardly off
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
// mistake "the old sum is clamped as well: only the new one is": const real wanted ==> sum =
//         std::clamp(sum, -mu * normal, mu * normal); const real wanted
// mistake "the old sum is clamped as well: only the new one is": const real wanted = sum - rate /
//         K, bound = mu * normal; ==> const real bound = mu * normal, wanted = std::clamp(sum,
//         -bound, bound) - rate / K;
// wrong drawn-threshold: const real wanted ==> if (normal < real(1e-9)) normal = 0; const real
//         wanted
// wrong drawn-threshold: const real wanted ==> if (mu < real(0.01)) mu = 0; const real wanted
// expects: mu 0.0
// wrong drawn-side: std::clamp(wanted, -bound, bound) ==> std::abs(wanted) < bound * real(1.0001) ?
//         wanted : std::clamp(wanted, -bound, bound)
// expects: just beyond its bound
// wrong drawn-threshold: std::clamp(wanted, -bound, bound) ==> std::abs(wanted) < bound +
//         real(1e-4) ? wanted : std::clamp(wanted, -bound, bound)
// wrong drawn-cut: bound = mu * normal ==> bound = std::min(mu * normal, real(1e4))
// expects: mu normal
// wrong drawn-threshold: const real wanted ==> if (std::abs(sum) < real(1e-6)) sum = 0; const real
//         wanted
// expects: |old sum|
// mistake "always the same bound: are the ends of clamp exchanged, clamp(a, low, high), or was a
//         variable never set?": const real wanted = sum - rate / K, bound = mu * normal ==>
//         (void)rate; (void)K ;; std::clamp(wanted, -bound, bound) ==> -mu * normal
// mistake "always the same bound: are the ends of clamp exchanged, clamp(a, low, high), or was a
//         variable never set?": std::clamp(wanted, -bound, bound) ==> bound
// wrong "the bound is mu normal, yours is 2 mu normal": mu ==> 2 * mu
// expects: Case: rate 2.88 m/s, K 0.183333 1/kg, mu 0.5, normal 1.2 N s, sum 0 N s.
// mistake "the bound is an impulse already: mu normal, without h": normal ==> normal * 60
// mistake "the bound is an impulse already: mu normal, without h": normal ==> normal / 60
// mistake "the bound is an impulse already: mu normal, without h": normal ==> normal * 20
// mistake "the bound is an impulse already: mu normal, without h": normal ==> normal / 20
// mistake "the bound is an impulse already: mu normal, without h": normal ==> normal * 50
// mistake "the bound is an impulse already: mu normal, without h": normal ==> normal / 50
// mistake "the bound is an impulse already: mu normal, without h": normal ==> normal * 100
// mistake "the bound is an impulse already: mu normal, without h": normal ==> normal / 100
// mistake "the bound is mu times the normal impulse, not mu times the sum of this row": mu * normal
//         ==> mu * std::abs(sum)
// mistake "mu is kept below 1: a rough ground has more": mu ==> std::min(mu, real(1))
// mistake "mu is a factor of the required impulse: it is one of the bound alone": - rate / K ==> -
//         mu * rate / K
// mistake "the old sum is taken twice in the required sum: sum - rate/K": sum - rate ==> sum + sum
//         - rate
// mistake "below -mu normal the sum becomes +mu normal: it becomes -mu normal": std::clamp(wanted,
//         -bound, bound) ==> std::abs(wanted) > bound ? bound : wanted
// mistake "the old sum is returned: return the change of the sum": return sum - before ==> return
//         before
// mistake "what the bound has cut off is returned: return the change of the sum": return sum -
//         before ==> return wanted - sum
// mistake "nothing is done where the sum is 0: there friction begins": const real wanted ==> if
//         (sum == 0) return 0; const real wanted
// mistake "an old sum below 0 is forgotten: friction acts either way": const real wanted ==> sum =
//         std::max(sum, real(0)); const real wanted
// mistake "nothing is done where the rate is negative: friction acts against sliding either way":
//         const real wanted ==> if (rate < 0) return 0; const real wanted
// mistake "nothing is done where the rate is positive: friction acts against sliding either way":
//         const real wanted ==> if (rate > 0) return 0; const real wanted
// mistake "the bound is cut to a whole number: an int has no fraction": bound = mu * normal ==>
//         bound = int(mu * normal)
// mistake "the required impulse is cut to a whole number: an int has no fraction": wanted = sum -
//         rate / K ==> wanted = int(sum - rate / K)
// mistake "the sum is cut to a whole number: an int has no fraction": = std::clamp(wanted, -bound,
//         bound) ==> = int(std::clamp(wanted, -bound, bound))
// mistake "mu is cut to a whole number: an int has no fraction": mu ==> int(mu)
// mistake "normal is cut to a whole number: an int has no fraction": normal ==> int(normal)
// mistake "rate is cut to a whole number: an int has no fraction": rate ==> int(rate)
// mistake "the old sum is cut to a whole number: an int has no fraction": = sum - rate ==> =
//         int(sum) - rate
// mistake "rate / K is cut to a whole number: an int has no fraction": rate / K ==> int(rate / K)
// mistake "the old sum is cut to a whole number: an int has no fraction": const real before ==>
//         const int before
// wrong few-digits: bound = mu * normal ==> bound = float(mu * normal)
// mistake "the bound moves inwards when the normal impulse becomes less, and the sum goes with it:
//         clamp the sum anew in each iteration": -bound, bound ==> std::min(before, -bound),
//         std::max(before, bound)
// mistake "the bound moves inwards when the normal impulse becomes less, and the sum goes with it:
//         clamp the sum anew in each iteration": sum = ==> if (std::abs(sum) >= bound) return 0;
//         sum =
// mistake "the bound is divided by K: it is an impulse already": normal ==> normal / K
// mistake "the bound is mu times the normal impulse: times, not divided by mu": mu * normal ==>
//         normal / mu
// mistake "mu plus normal: the bound is mu times the normal impulse": mu * normal ==> mu + normal
// mistake "a half of the bound: it is mu normal either way": normal ==> normal / 2
// wrong "the bound is mu normal, yours is mu normal |rate|": normal ==> normal * std::abs(rate)
// mistake "the sum is not stored: the next iteration needs it": sum; sum ==> sum; real copy = sum;
//         copy ;; return sum ==> return copy
// mistake "nothing where the required sum exceeds the bound: the sum becomes -mu normal or +mu
//         normal": normal; ==> normal; if (std::abs(wanted) > bound) return 0; ;;
//         std::clamp(wanted, -bound, bound) ==> wanted
// mistake "the ends of clamp are exchanged: clamp(a, low, high), -mu normal is the low one": bound
//         = mu * normal ==> low = mu * normal, high = -low ;; std::clamp(wanted, -bound, bound) ==>
//         wanted < low ? low : wanted > high ? high : wanted
// wrong "std::clamp(a, low, high) was given a high that is below low": -bound, ==> bound, -
// mistake "the sum is kept from 0 to mu normal: friction is bounded either way, -mu normal and +mu
//         normal": -bound ==> real(0)
// mistake "the sum is kept from -mu normal to 0: friction is bounded either way, -mu normal and +mu
//         normal": -bound, bound ==> -bound, real(0)
// mistake "the size of the required impulse is clamped: friction is bounded either way, -mu normal
//         and +mu normal": clamp(wanted, -bound, bound) ==> min(std::abs(wanted), bound)
// mistake "always the full bound: friction gives no more than the impulse that stops the sliding":
//         std::clamp(wanted, -bound, bound) ==> rate > 0 ? -bound : rate < 0 ? bound : real(0)
// mistake "always the full bound: friction gives no more than the impulse that stops the sliding":
//         std::clamp(wanted, -bound, bound) ==> rate > 0 ? -bound : bound
// mistake "always the full bound: friction gives no more than the impulse that stops the sliding":
//         std::clamp(wanted, -bound, bound) ==> rate < 0 ? bound : -bound
// mistake "always the full bound: friction gives no more than the impulse that stops the sliding":
//         std::clamp(wanted, -bound, bound) ==> wanted < 0 ? -bound : bound
// mistake "always the full bound: friction gives no more than the impulse that stops the sliding":
//         std::clamp(wanted, -bound, bound) ==> wanted > 0 ? bound : -bound
// mistake "always the full bound: friction gives no more than the impulse that stops the sliding,
//         and works against J V": std::clamp(wanted, -bound, bound) ==> rate < 0 ? -bound : bound
// mistake "always the full bound: friction gives no more than the impulse that stops the sliding,
//         and works against J V": std::clamp(wanted, -bound, bound) ==> rate > 0 ? bound : -bound
// wrong "sum - rate / K is wanted, yours is sum - 0.5 rate / K": rate / K ==> rate / K / 2
// wrong "sum - rate / K is wanted, yours is -sum - rate / K": wanted = sum ==> wanted = -sum
// mistake "only the lower bound is there: friction is bounded either way, -mu normal and +mu
//         normal": clamp(wanted, -bound, bound) ==> max(wanted, -bound)
// mistake "only the upper bound is there: friction is bounded either way, -mu normal and +mu
//         normal": clamp(wanted, -bound, bound) ==> min(wanted, bound)
// mistake "mu is missing in the lower bound: -mu normal and +mu normal": -bound, bound ==> -normal,
//         bound
// mistake "mu is missing in the upper bound: -mu normal and +mu normal": -bound, bound ==> -bound,
//         normal
// mistake "the bound is mu times the normal impulse: mu is missing": const real ==> (void)mu; const
//         real ;; mu * ==>
// mistake "the bound is mu times the normal impulse: normal is missing": const real ==>
//         (void)normal; const real ;; * normal ==>
// mistake "mu is taken twice in the bound": bound = mu * normal ==> bound = mu * mu * normal
// mistake "normal is taken twice in the bound": bound = mu * normal ==> bound = mu * normal *
//         normal
// mistake "new sum plus old sum: the change is new sum minus old sum": return sum - before ==>
//         return sum + before
// mistake "the sign of the change: new sum minus old sum": return sum - before ==> return before -
//         sum
// mistake "the change is added to the sum twice": return sum - before ==> const real change = sum -
//         before; sum += change; return change
// mistake "nothing is done where nothing slides: the bound may have moved inwards all the same":
//         normal; ==> normal; if (rate == 0) return 0;
// mistake "nothing is done where nothing presses: the sum goes back to 0 then": const real before =
//         sum; ==> if (normal <= 0) return 0; const real before = sum;
// mistake "nothing is done where nothing presses, or where nothing slides: the sum is clamped all
//         the same": const real before = sum; ==> if (normal <= 0 || rate == 0) return 0; const
//         real before = sum;
// mistake "without friction the sliding is stopped all the same: the bound is 0 then": const real
//         before = sum; ==> if (mu == 0) return -rate / K; const real before = sum;
// mistake "slow sliding is ignored: there is no threshold, friction stops slow bodies, too":
//         normal; ==> normal; if (std::abs(rate) < real(0.06)) return 0;
// mistake "nothing is done beyond the bound: the sum goes to the bound": clamp(wanted, -bound,
//         bound) ==> abs(wanted) > bound ? real(0) : wanted
// mistake "this is a row that only pushes, sum >= 0: friction has the bound mu normal":
//         clamp(wanted, -bound, bound) ==> max(real(0), wanted)
// mistake "the required impulse is returned: return the change of the sum": return sum - before ==>
//         return wanted
// mistake "the required impulse is returned: return the change of the sum": return sum - before ==>
//         return -rate / K
// mistake "the sign: friction works against J V, wanted = sum - rate/K": - rate ==> + rate
// mistake "the sign of the rate is lost: friction works against J V, which may have either sign":
//         rate ==> std::abs(rate)
// mistake "the sign of the rate is lost: friction works against J V, which may have either sign": -
//         rate ==> + std::abs(rate)
// mistake "the sum so far is missing in the required sum: sum - rate/K": = sum - ==> = -
// mistake "the old sum is divided by K, too": sum - rate ==> (sum - rate)
// mistake "times K where it must be divided by K": / K ==> * K
// mistake "K is missing: an impulse is a speed divided by K": const real ==> (void)K; const real ;;
//         / K ==>
// mistake "nothing is clamped": std::clamp(wanted, -bound, bound) ==> wanted
// mistake "nothing is clamped, and the sum is not stored": sum = std::clamp(wanted, -bound, bound);
//         ==> ;; return sum - before ==> return wanted - before
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
// mistake "each change is clamped: it is the accumulated impulse that stays within +-mu normal": -
//         sum ==> ;; - sum ==>
// mistake "each change is clamped: it is the accumulated impulse that stays within +-mu normal": -
//         sum ==> ;; - sum ==> ;; sum += ==> sum =
// mistake "the remaining part of the bound is used for both directions: the sum itself stays within
//         +-mu normal": bound = mu * normal, ==> left = std::max(mu * normal - std::abs(sum),
//         real(0)); const real ;; bound - sum, bound - sum ==> left, left
// mistake "the sum that is stored is not clamped": real ==> real wanted = sum - rate / K, ;; change
//         = std::clamp(-rate / K, -bound - sum, bound - sum); sum += change; return change; ==>
//         before = sum; sum = wanted; return std::clamp(wanted, -bound, bound) - before;
// from right in two lines
// mistake "the new sum is added to the old one: it takes its place": before = sum; sum ==> next ;;
//         return sum - before ==> sum += next; return next - sum
// mistake "the new sum is added to the old one: it takes its place": before = sum; sum ==> next ;;
//         return sum - before ==> const real change = next - sum; sum += next; return change
// mistake "the new sum is added to the old one: it takes its place": before = sum; sum ==> now ;;
//         return sum - before ==> sum += now; return now
// mistake "the new sum is returned instead of its change": , before = sum ==> ;; - before ==>
// mistake "0 is returned: keep the old sum before the new one is stored": , before = sum ==> ;;
//         before ==> sum
