// wrong last-iteration-missing: n == iterations ==> n == iterations - 1
// wrong last-iteration-missing: int n = 0;; ==> int n = 1;;
// wrong drawn-stops: largest = std ==> if (&C - rates.data() < 3) largest = std
// wrong tolerance-of-last: if (largest <= tolerance ==> if (last <= tolerance
// wrong rate-fixed-step: C /= -h; ==> C *= -60.0;
// wrong sign-j-v-changes: C /= -h ==> C /= h
// wrong h-missing: C /= -h ==> C = -C
// wrong times-h: C /= -h ==> C *= -h
// wrong divided-h-squared: C /= -h ==> C /= -h * h
// wrong half-rate: C /= -h ==> C /= -2 * h
// wrong rates-not-made-all: C /= -h; ==>
// wrong not-put-back: std::copy(start.begin(), start.end(), bodies.data()); ==>
// wrong only-x-put-back: std::copy(start.begin(), start.end(), bodies.data()); ==> for
//         (int slot = 0; slot < bodies.slots(); ++slot) bodies.at(slot).x = start[slot].x;
// wrong only-q-put-back: std::copy(start.begin(), start.end(), bodies.data()); ==> for
//         (int slot = 0; slot < bodies.slots(); ++slot) bodies.at(slot).q = start[slot].q;
// wrong only-poses-put-back: std::copy(start.begin(), start.end(), bodies.data()); ==> for
//         (int slot = 0; slot < bodies.slots(); ++slot) bodies.at(slot).x = start[slot].x,
//         bodies.at(slot).q = start[slot].q;
// wrong all-put-back: std::copy(start.begin(), start.end(), bodies.data()); ==> ;; (rates); ==>
//         (rates); std::copy(start.begin(), start.end(), bodies.data());
// wrong first-body-not-put: std::copy(start.begin(), start.end(), bodies.data()); ==> for (int slot
//         = 2; slot < bodies.slots(); ++slot) bodies.at(slot) = start[slot];
// wrong static-body-taken-first: std::copy(start.begin(), start.end(), bodies.data()); ==> for (int
//         slot = 1; slot < bodies.slots(); ++slot) bodies.at(slot) = start[slot];
// wrong last-body-not-put: std::copy(start.begin(), start.end(), bodies.data()); ==> for (int slot
//         = 0; slot < bodies.slots() - 1; ++slot) bodies.at(slot) = start[slot];
// wrong start-written-once: start.assign ==> if (n == 0) start.assign
// wrong start-written-after-bodies: start.assign(bodies.data(), bodies.data() +
//         bodies.slots()); ==> ;; std::vector ==> start.assign(bodies.data(), bodies.data() +
//         bodies.slots()); std::vector
// wrong last-not-kept: last = largest; ==>
// wrong last-only-once: last = largest; ==> if (n == 0) last = largest;
// wrong poor-is-true: n == iterations || ==> n == iterations) return false; if ( ;; * last)) return
//         false ==> * last)) return true
// wrong only-growth-poor: poor_contraction * last ==> last
// wrong strictly-less-than-poor: largest <= poor ==> largest < poor
// wrong poor-before-near: if (largest <= tolerance) return true; ==> if (!(largest <=
//         poor_contraction * last)) return false; if (largest <= tolerance) return true;
// wrong count-before-tolerance: if (largest <= tolerance) return true; ==> if (n == iterations)
//         return false; if (largest <= tolerance) return true;
// wrong both-before-tolerance: if (largest <= tolerance) return true; ==> ;; return false; ==>
//         return false; if (largest <= tolerance) return true;
// wrong near-enough-not-asked: if (largest ==> if (n == iterations && largest
// wrong strictly-nearer-than-near: largest <= tolerance ==> largest < tolerance
// wrong near-enough-false: true ==> false
// wrong near-enough-breaks-moves: return true; ==> { integrate_poses(bodies, real(h)); return true;
//         }
// wrong "the largest error counts, by its size: of all rows max |C|. The sign": std::abs(C) ==> C
// wrong "the largest error counts, by its size: of all rows max |C|, not the": largest =
//         std::max(largest, std::abs(C)) ==> largest += std::abs(C)
// wrong "the largest error counts, by its size: of all rows max |C|. Only the": largest =
//         std::max(largest, std::abs(C)) ==> largest = std::abs(C)
// wrong size-asked-after-division: largest = std ==> C /= -h; largest = std ;; ; C /= -h ==>
// wrong "the largest error counts, by its size: of all rows max |C|, not the": 0; for ==> 1e9; for
//         ;; max ==> min
// wrong largest-not-begun-anew: double largest = 0; ==> ;; for ==> double largest = 0; for
// wrong "the largest error counts, by its size: of all rows max |C|, not the": largest =
//         std::max(largest, std::abs(C)); ==> largest = std::hypot(largest, C);
// wrong no-final-move: integrate_poses ==> if (n == iterations) return true; integrate_poses
// wrong last-correction-unseen: std::vector ==> if (n == iterations) return true; std::vector
// wrong false-end: std::vector ==> if (n == iterations) return false; std::vector
// wrong used-up-is-true: n == iterations || ==> n == iterations) return true; if (
// wrong one-iteration-too-many: n == iterations ==> n > iterations
// wrong one-iteration-too-few: n == iterations ==> n >= iterations - 1
// wrong errors-before-move: integrate_poses(bodies, real(h)); ==> ;; double largest ==>
//         integrate_poses(bodies, real(h)); double largest
// wrong errors-before-move: integrate_poses(bodies, real(h)); ==>
// wrong "the bodies move for half of h: for all of it": real(h) ==> real(h / 2)
// wrong rates-never-changed: corrector.change_rates(rates); ==>
// wrong changed-twice: corrector.change_rates(rates); ==> corrector.change_rates(rates);
//         corrector.change_rates(rates);
// wrong errors-asked-twice: double largest = 0; ==> double largest = 0; corrector.errors();
// wrong zero-iterations-do-nothing: double last ==> if (iterations == 0) return true; double last
// wrong last-begun-zero: std::numeric_limits<double>::infinity() ==> 0
// wrong last-begun-one: std::numeric_limits<double>::infinity() ==> 0.5
// wrong returned-once-when-poor: return false; ==> { if (n < iterations)
//         corrector.change_rates(rates); return false; }
// wrong error-times-share: poor_contraction * last ==> last / poor_contraction
// wrong tolerance-not-used: largest <= tolerance ==> largest <= 1e-7
// wrong poor-goes-break: if (n == iterations || !(largest <= poor_contraction * last))
//         return false; ==> if (n == iterations) return false; if (!(largest <= poor_contraction *
//         last)) { integrate_poses(bodies, real(h)); for (const double C : corrector.errors()) if
//         (std::abs(C) > tolerance) return false; return true; }
// right put back in a loop: std::copy(start.begin(), start.end(), bodies.data()); ==> for
//         (int slot = 0; slot < bodies.slots(); ++slot) bodies.at(slot) =
//         start[std::size_t(slot)];
// right one loop with a move before it:
  const auto move = [&] {
    start.resize(std::size_t(bodies.slots()));
    for (int slot = 0; slot < bodies.slots(); ++slot) start[std::size_t(slot)] = bodies.at(slot);
    integrate_poses(bodies, real(h));
  };
  double before = 0;
  move();
  for (int n = 0; n <= iterations; ++n) {
    std::vector<double> rates = corrector.errors();
    double largest = 0;
    for (const double C : rates) largest = std::abs(C) > largest ? std::abs(C) : largest;
    if (!(largest > tolerance)) return true;
    if (n > 0 && largest > poor_contraction * before) break;
    if (n == iterations) break;
    before = largest;
    for (double& C : rates) C *= -1 / h;
    for (int slot = 0; slot < bodies.slots(); ++slot) bodies.at(slot) = start[std::size_t(slot)];
    corrector.change_rates(rates);
    move();
  }
  return false;
