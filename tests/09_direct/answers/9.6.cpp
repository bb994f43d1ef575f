// Known answers of exercise 9.6, each put in the place of the solution's.

// ---- wrong: sign
// expects: Likely mistake: the sign: J V changes by -C/h
// change: C /= -h ==> C /= h

// ---- wrong: h missing
// expects: Likely mistake: h is missing: J V changes by -C/h
// change: C /= -h ==> C = -C

// ---- wrong: times h
// expects: Likely mistake: times h: J V changes by -C/h
// change: C /= -h ==> C *= -h

// ---- wrong: divided by h squared
// expects: Likely mistake: divided by h^2: J V changes by -C/h
// change: C /= -h ==> C /= -h * h

// ---- wrong: half of the rate
// expects: Likely mistake: half of it: J V changes by -C/h
// change: C /= -h ==> C /= -2 * h

// ---- wrong: rates not made at all
// expects: Likely mistake: h is missing, and the sign: J V changes by -C/h
// change: C /= -h; ==>

// ---- wrong: not put back
// expects: Likely mistake: the bodies are not put back: they move from where they were at first
// change: for (int slot = 0; slot < bodies.slots(); ++slot) ==>
// change: bodies.at(slot).x = start[slot].x, bodies.at(slot).q = start[slot].q; ==>

// ---- wrong: only x put back
// expects: Likely mistake: q is not put back: x and q of every body
// change: x, bodies.at(slot).q = start[slot].q ==> x

// ---- wrong: only q put back
// expects: Likely mistake: x is not put back: x and q of every body
// change: bodies.at(slot).x = start[slot].x, ==>

// ---- wrong: all put back
// expects: Likely mistake: the velocities are put back, too: their change is lost, only x and q
// change: bodies.at(slot).x = start[slot].x, bodies.at(slot).q = start[slot].q; ==>
//         bodies.at(slot) = start[slot];

// ---- wrong: first body not put back
// expects: Likely mistake: the first bodies are not put back: all slots from 0
// change: int slot = 0 ==> int slot = 2

// ---- wrong: start kept in each iteration
// expects: Likely mistake: `start` is written again in each iteration: the velocities in it are
// change: integrate_poses ==>
//         start.assign(bodies.data(), bodies.data() + bodies.slots()); integrate_poses

// ---- wrong: start kept behind the move
// expects: Likely mistake: `start` does not hold the bodies as they were: who calls puts them
// change: start.assign(bodies.data(), bodies.data() + bodies.slots()); ==>
// change: std::vector ==>
//         if (n == 0) start.assign(bodies.data(), bodies.data() + bodies.slots()); std::vector

// ---- wrong: start added to what it held
// expects: Case: a slider with a mark half a metre ahead
// change: start.assign(bodies.data(), bodies.data() + bodies.slots()) ==>
//         start.insert(start.end(), bodies.data(), bodies.data() + bodies.slots())

// ---- wrong: last not kept
// expects: Likely mistake: an iteration that leaves more than poor_contraction of the error does
// change: last = largest; ==>

// ---- wrong: last only once
// expects: Likely mistake: the first error is kept for ever: compare with that of the iteration
// change: last = largest; ==> if (n == 0) last = largest;

// ---- wrong: poor contraction not asked
// expects: Likely mistake: an iteration that leaves more than poor_contraction of the error does
// change: if (!(largest <= poor_contraction * last)) return largest <= stalled_share * first; ==>

// ---- wrong: poor goes on with a break
// expects: Likely mistake: where the error hardly becomes less the bodies move on: stop there
// change: return largest <= stalled_share * first; ==> break;

// ---- wrong: poor is true
// expects: Likely mistake: true wherever it stops: only if at most stalled_share of the first
// change: return largest <= stalled_share * first ==> return true

// ---- wrong: only growth is poor
// expects: Likely mistake: only an error that grows ends it: at most poor_contraction of the last
// change: poor_contraction * last ==> last

// ---- wrong: strictly less than poor
// expects: Likely mistake: at exactly poor_contraction it goes on: <=
// change: largest <= poor ==> largest < poor

// ---- wrong: poor before near
// expects: Likely mistake: poor_contraction is asked before negligible h^2: what is negligible is
  start.assign(bodies.data(), bodies.data() + bodies.slots());
  double first = 0, last = std::numeric_limits<double>::infinity();
  for (int n = 0; n < iterations; ++n) {
    integrate_poses(bodies, real(h));
    std::vector<double>& rates = corrector.errors();
    double largest = 0;
    for (double& C : rates) {
      largest = std::max(largest, std::abs(C));
      C /= -h;  // Eq. 9-10
    }
    if (n == 0) first = largest;
  if (!(largest <= poor_contraction * last)) return largest <= stalled_share * first;
      if (largest <= negligible * h * h) return true;
    last = largest;
    corrector.change_rates(rates);
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot).x = start[slot].x, bodies.at(slot).q = start[slot].q;
  }
  integrate_poses(bodies, real(h));
  return true;

// ---- wrong: near enough not asked
// expects: Likely mistake: whether the error is negligible is not asked: nothing more is to be
// change: if (largest <= negligible * h * h) return true; ==>

// ---- wrong: strictly nearer than near_enough
// expects: Likely mistake: at exactly negligible h^2 it is enough: <=
// change: largest <= negligible ==> largest < negligible

// ---- wrong: near enough is false
// expects: Likely mistake: false where the error is negligible: that is true
// change: negligible * h * h) return true ==> negligible * h * h) return false

// ---- wrong: near enough breaks and moves again
// expects: Likely mistake: where the error is negligible the bodies move once more: they are
// change: negligible * h * h) return true ==> negligible * h * h) break

// ---- wrong: sign not taken away
// expects: Likely mistake: the largest error counts, by its size: of all rows max |C|. The sign
// change: std::abs(C) ==> C

// ---- wrong: sum of the errors
// expects: Likely mistake: the largest error counts, by its size: of all rows max |C|, not the
// change: largest = std::max(largest, std::abs(C)) ==> largest += std::abs(C)

// ---- wrong: last row alone
// expects: Likely mistake: the largest error counts, by its size: of all rows max |C|. Only the
// change: largest = std::max(largest, std::abs(C)) ==> largest = std::abs(C)

// ---- wrong: size asked after the division
// expects: Likely mistake: the size is taken of -C/h, not of C: ask before you divide
  start.assign(bodies.data(), bodies.data() + bodies.slots());
  double first = 0, last = std::numeric_limits<double>::infinity();
  for (int n = 0; n < iterations; ++n) {
    integrate_poses(bodies, real(h));
    std::vector<double>& rates = corrector.errors();
    double largest = 0;
    for (double& C : rates) {
  C /= -h; largest = std::max(largest, std::abs(C));
    }
    if (n == 0) first = largest;
    if (largest <= negligible * h * h) return true;
    if (!(largest <= poor_contraction * last)) return largest <= stalled_share * first;
    last = largest;
    corrector.change_rates(rates);
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot).x = start[slot].x, bodies.at(slot).q = start[slot].q;
  }
  integrate_poses(bodies, real(h));
  return true;

// ---- wrong: smallest error
// expects: Likely mistake: the largest error counts, by its size: of all rows max |C|, not the
// change: double largest = 0 ==> double largest = 1e9
// change: std::max(largest ==> std::min(largest

// ---- wrong: largest not begun anew
// expects: Likely mistake: the largest error is not begun anew in each iteration: from 0
  start.assign(bodies.data(), bodies.data() + bodies.slots());
  double first = 0, last = std::numeric_limits<double>::infinity();
  double largest = 0; for (int n = 0; n < iterations; ++n) {
    integrate_poses(bodies, real(h));
    std::vector<double>& rates = corrector.errors();
    for (double& C : rates) {
      largest = std::max(largest, std::abs(C));
      C /= -h;  // Eq. 9-10
    }
    if (n == 0) first = largest;
    if (largest <= negligible * h * h) return true;
    if (!(largest <= poor_contraction * last)) return largest <= stalled_share * first;
    last = largest;
    corrector.change_rates(rates);
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot).x = start[slot].x, bodies.at(slot).q = start[slot].q;
  }
  integrate_poses(bodies, real(h));
  return true;

// ---- wrong: square root of the squares
// expects: Likely mistake: the largest error counts, by its size: of all rows max |C|, not the
// change: largest = std::max(largest, std::abs(C)); ==> largest = std::hypot(largest, C);

// ---- wrong: no final move
// expects: Likely mistake: after the last iteration the bodies stay where they began
  start.assign(bodies.data(), bodies.data() + bodies.slots());
  double first = 0, last = std::numeric_limits<double>::infinity();
  for (int n = 0; n < iterations; ++n) {
    integrate_poses(bodies, real(h));
    std::vector<double>& rates = corrector.errors();
    double largest = 0;
    for (double& C : rates) {
      largest = std::max(largest, std::abs(C));
      C /= -h;  // Eq. 9-10
    }
    if (n == 0) first = largest;
    if (largest <= negligible * h * h) return true;
    if (!(largest <= poor_contraction * last)) return largest <= stalled_share * first;
    last = largest;
    corrector.change_rates(rates);
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot).x = start[slot].x, bodies.at(slot).q = start[slot].q;
  }
  return true;

// ---- wrong: false at the end
// expects: Likely mistake: false after the last iteration: only a poor one is false
  start.assign(bodies.data(), bodies.data() + bodies.slots());
  double first = 0, last = std::numeric_limits<double>::infinity();
  for (int n = 0; n < iterations; ++n) {
    integrate_poses(bodies, real(h));
    std::vector<double>& rates = corrector.errors();
    double largest = 0;
    for (double& C : rates) {
      largest = std::max(largest, std::abs(C));
      C /= -h;  // Eq. 9-10
    }
    if (n == 0) first = largest;
    if (largest <= negligible * h * h) return true;
    if (!(largest <= poor_contraction * last)) return largest <= stalled_share * first;
    last = largest;
    corrector.change_rates(rates);
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot).x = start[slot].x, bodies.at(slot).q = start[slot].q;
  }
  integrate_poses(bodies, real(h)); return false;

// ---- wrong: one iteration too many
// expects: Likely mistake: one iteration too many: n < iterations
// change: n < iterations ==> n <= iterations

// ---- wrong: one iteration too few
// expects: Likely mistake: one iteration too few: from 0 while n < iterations; and false wherever
// change: int n = 0; ==> int n = 1;

// ---- wrong: errors before the move
// expects: Likely mistake: the errors are asked before the bodies move: C is that at the new
// change: integrate_poses(bodies, real(h)); ==>
// change: double largest ==> integrate_poses(bodies, real(h)); double largest

// ---- wrong: no move in the iteration
// expects: Likely mistake: the errors are asked before the bodies move: C is that at the new
// change: integrate_poses(bodies, real(h)); ==>

// ---- wrong: moves for half of h
// expects: Likely mistake: the bodies move for half of h in each iteration: for all of it
// change: h ==> h / 2

// ---- wrong: rates never changed
// expects: Likely mistake: change_rates() is never called
// change: corrector.change_rates(rates); ==>

// ---- wrong: changed twice
// expects: Likely mistake: change_rates() is called twice in an iteration: once
// change: corrector.change_rates(rates); ==>
//         corrector.change_rates(rates); corrector.change_rates(rates);

// ---- wrong: errors asked twice
// expects: Likely mistake: the errors are asked more than once in an iteration: they are yours to
// change: double largest = 0; ==> double largest = 0; corrector.errors();

// ---- wrong: errors asked at the end
// expects: Likely mistake: the errors are asked once more after the last iteration: that costs
  start.assign(bodies.data(), bodies.data() + bodies.slots());
  double first = 0, last = std::numeric_limits<double>::infinity();
  for (int n = 0; n < iterations; ++n) {
    integrate_poses(bodies, real(h));
    std::vector<double>& rates = corrector.errors();
    double largest = 0;
    for (double& C : rates) {
      largest = std::max(largest, std::abs(C));
      C /= -h;  // Eq. 9-10
    }
    if (n == 0) first = largest;
    if (largest <= negligible * h * h) return true;
    if (!(largest <= poor_contraction * last)) return largest <= stalled_share * first;
    last = largest;
    corrector.change_rates(rates);
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot).x = start[slot].x, bodies.at(slot).q = start[slot].q;
  }
  integrate_poses(bodies, real(h));
      for (const double C : corrector.errors()) if (std::abs(C) > negligible * h * h) return
      false; return true;

// ---- wrong: zero iterations do nothing
// expects: Likely mistake: with no iterations the bodies do not move: they do, by the velocities
// change: start.assign ==> if (iterations == 0) return true; start.assign

// ---- wrong: last begun with zero
// expects: Likely mistake: the last error is 0 at first: in the first iteration any error will do
// change: std::numeric_limits<double>::infinity() ==> 0

// ---- wrong: last begun with one
// expects: Likely mistake: the first error is compared with a number: in the first iteration any
// change: std::numeric_limits<double>::infinity() ==> 0.5

// ---- wrong: returned at once when poor after the change
// expects: Likely mistake: the velocities are changed before poor_contraction is asked: then they
  start.assign(bodies.data(), bodies.data() + bodies.slots());
  double first = 0, last = std::numeric_limits<double>::infinity();
  for (int n = 0; n < iterations; ++n) {
    integrate_poses(bodies, real(h));
    std::vector<double>& rates = corrector.errors();
    double largest = 0;
    for (double& C : rates) {
      largest = std::max(largest, std::abs(C));
      C /= -h;  // Eq. 9-10
    }
    if (n == 0) first = largest;
    if (largest <= negligible * h * h) return true;
  corrector.change_rates(rates);
      if (!(largest <= poor_contraction * last)) return largest <= stalled_share * first;
      last = largest;
    for (int slot = 0; slot < bodies.slots(); ++slot)
      bodies.at(slot).x = start[slot].x, bodies.at(slot).q = start[slot].q;
  }
  integrate_poses(bodies, real(h));
  return true;

// ---- wrong: the error times the share
// expects: Likely mistake: divided by poor_contraction: at most that share of the last error may
// change: poor_contraction * last ==> last / poor_contraction

// ---- wrong: velocities put back at poor
// expects: Likely mistake: the angular velocity is put back, too: its change is lost, only x and
// change: bodies.at(slot).q = start[slot].q; ==>
//         bodies.at(slot).q = start[slot].q, bodies.at(slot).w = start[slot].w;

// ---- wrong: static body taken for the first
// expects: Likely mistake: the first body is not put back: all slots from 0
// change: int slot = 0 ==> int slot = 1

// ---- wrong: last body not put back
// expects: Likely mistake: the last body is not put back: all slots
// change: slot < bodies.slots() ==> slot < bodies.slots() - 1

// ---- wrong: false wherever it stops
// expects: Likely mistake: false wherever it stops: true if at most stalled_share of the first
// change: return largest <= stalled_share * first ==> return false

// ---- wrong: last instead of first
// expects: Likely mistake: false wherever it stops: true if at most stalled_share of the first
// change: return largest <= stalled_share * first ==> return largest <= stalled_share * last

// ---- wrong: first error itself the bound
// expects: Likely mistake: where it stops the first error itself is the bound: stalled_share of
// change: return largest <= stalled_share * first ==> return largest <= first

// ---- wrong: first kept in each iteration
// expects: Likely mistake: false wherever it stops: true if at most stalled_share of the first
// change: if (n == 0) first = largest; ==> first = largest;

// ---- wrong: first never kept
// expects: Likely mistake: false wherever it stops: true if at most stalled_share of the first
// change: if (n == 0) first = largest; ==>

// ---- wrong: first kept in the second iteration
// expects: Likely mistake: false wherever it stops: true if at most stalled_share of the first
// change: n == 0 ==> n == 1

// ---- wrong: stop turned round
// expects: Likely mistake: where it stops true and false are exchanged: true if at most
// change: return largest <= stalled_share * first ==> return largest > stalled_share * first

// ---- wrong: negligible without h squared
// expects: Likely mistake: h^2 is missing: an error of at most negligible h^2 needs no more
// change: negligible * h * h ==> negligible

// ---- wrong: negligible times h
// expects: Likely mistake: h is squared: an error of at most negligible h^2 needs no more
// change: negligible * h * h ==> negligible * h

// ---- wrong: strictly less at the first
// expects: Exercise 9.6: Newton's method on the positions Holds in 36 of 37 cases
// change: return largest <= stalled ==> return largest < stalled

// ---- wrong: poor share of the first
// expects: Likely mistake: where it stops poor_contraction of the first error is the bound
// change: return largest <= stalled_share ==> return largest <= poor_contraction

// ---- right: put back before the change
  start.assign(bodies.data(), bodies.data() + bodies.slots());
  double first = 0, last = std::numeric_limits<double>::infinity();
  for (int n = 0; n < iterations; ++n) {
    integrate_poses(bodies, real(h));
    std::vector<double>& rates = corrector.errors();
    double largest = 0;
    for (double& C : rates) {
      largest = std::max(largest, std::abs(C));
      C /= -h;  // Eq. 9-10
    }
    if (n == 0) first = largest;
    if (largest <= negligible * h * h) return true;
    if (!(largest <= poor_contraction * last)) return largest <= stalled_share * first;
    last = largest;
  for (int slot = 0; slot < bodies.slots();
      ++slot) bodies.at(slot).x = start[slot].x, bodies.at(slot).q = start[slot].q;
      corrector.change_rates(rates);
  }
  integrate_poses(bodies, real(h));
  return true;

// ---- right: poses kept apart
  start.resize(std::size_t(bodies.slots()));
  for (int slot = 0; slot < bodies.slots(); ++slot) start[std::size_t(slot)] = bodies.at(slot);
  double before = 0, first = 0;
  integrate_poses(bodies, real(h));
  for (int n = 0; n < iterations; ++n) {
    std::vector<double> rates = corrector.errors();
    double largest = 0;
    for (const double C : rates) largest = std::abs(C) > largest ? std::abs(C) : largest;
    if (n == 0) first = largest;
    if (largest / (h * h) <= negligible) break;
    if (n > 0 && largest > poor_contraction * before) return largest <= stalled_share * first;
    before = largest;
    for (double& C : rates) C *= -1 / h;
    corrector.change_rates(rates);
    for (int slot = 0; slot < bodies.slots(); ++slot) {
      bodies.at(slot).x = start[std::size_t(slot)].x;
      bodies.at(slot).q = start[std::size_t(slot)].q;
    }
    integrate_poses(bodies, real(h));
  }
  return true;
