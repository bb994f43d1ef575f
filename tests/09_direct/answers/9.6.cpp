// mistake "one iteration too few: the velocities are changed `iterations` times, and the errors are
//         evaluated once more than that, also where `iterations` is 0": n == iterations ==> n ==
//         iterations - 1
// mistake "one iteration too few: the velocities are changed `iterations` times, and the errors are
//         evaluated once more than that, also where `iterations` is 0": int n = 0;; ==> int n = 1;;
// wrong drawn-stops: largest = std ==> if (&C - rates.data() < 3) largest = std
// mistake "the error of the iteration before is compared with the tolerance: the present one": if
//         (largest <= tolerance ==> if (last <= tolerance
// mistake "60/s in the place of 1/h: J V changes by -C/h": C /= -h; ==> C *= -60.0;
// mistake "the sign: J V changes by -C/h": C /= -h ==> C /= h
// mistake "h is missing: J V changes by -C/h": C /= -h ==> C = -C
// mistake "times h: J V changes by -C/h": C /= -h ==> C *= -h
// mistake "divided by h^2: J V changes by -C/h": C /= -h ==> C /= -h * h
// mistake "half of it: J V changes by -C/h": C /= -h ==> C /= -2 * h
// mistake "h is missing, and the sign: J V changes by -C/h": C /= -h; ==>
// mistake "the bodies are not put back: they move from their first places each time":
//         std::copy(start.begin(), start.end(), bodies.data()); ==>
// mistake "only x is put back: every body as it was": std::copy(start.begin(), start.end(),
//         bodies.data()); ==> for (int slot = 0; slot < bodies.slots(); ++slot) bodies.at(slot).x =
//         start[slot].x;
// mistake "only q is put back: every body as it was": std::copy(start.begin(), start.end(),
//         bodies.data()); ==> for (int slot = 0; slot < bodies.slots(); ++slot) bodies.at(slot).q =
//         start[slot].q;
// mistake "only the poses are put back: the move has changed the angular velocities, too":
//         std::copy(start.begin(), start.end(), bodies.data()); ==> for (int slot = 0; slot <
//         bodies.slots(); ++slot) bodies.at(slot).x = start[slot].x, bodies.at(slot).q =
//         start[slot].q;
// mistake "the bodies are put back after their velocities were changed: the change is lost, put
//         them back first": std::copy(start.begin(), start.end(), bodies.data()); ==> ;; (rates);
//         ==> (rates); std::copy(start.begin(), start.end(), bodies.data());
// mistake "the first bodies are not put back: all slots from 0": std::copy(start.begin(),
//         start.end(), bodies.data()); ==> for (int slot = 2; slot < bodies.slots(); ++slot)
//         bodies.at(slot) = start[slot];
// mistake "the first body is not put back: all slots from 0": std::copy(start.begin(), start.end(),
//         bodies.data()); ==> for (int slot = 1; slot < bodies.slots(); ++slot) bodies.at(slot) =
//         start[slot];
// mistake "the last body is not put back: all slots": std::copy(start.begin(), start.end(),
//         bodies.data()); ==> for (int slot = 0; slot < bodies.slots() - 1; ++slot) bodies.at(slot)
//         = start[slot];
// mistake "`start` is written once: before each move, so that the corrections add up": start.assign
//         ==> if (n == 0) start.assign
// mistake "`start` is written after the bodies have moved: before, as they were":
//         start.assign(bodies.data(), bodies.data() + bodies.slots()); ==> ;; std::vector ==>
//         start.assign(bodies.data(), bodies.data() + bodies.slots()); std::vector
// mistake "an iteration after which more than poor_contraction of the error remains does not end
//         it: is `last` stored, and is it used?": last = largest; ==>
// mistake "the first error is kept for ever: compare with that of the iteration before": last =
//         largest; ==> if (n == 0) last = largest;
// mistake "true where the error hardly becomes less: that is false, the joints are not closed":
//         iterations || ==> iterations) return false; if ( ;; )) return false ==> )) return true
// mistake "only an error that grows ends it: at most poor_contraction of the last one may remain":
//         poor_contraction * last ==> last
// mistake "at exactly poor_contraction it goes on: <=": largest <= poor ==> largest < poor
// mistake "poor_contraction is tested before the tolerance: an error below it is good in any case":
//         largest < ==> !(largest <= poor_contraction * last)) return false; if (largest <
// mistake "the number of iterations is tested before the tolerance: the last correction may have
//         closed the joints, so test first whether the error is at most that": largest < ==> n ==
//         iterations) return false; if (largest <
// mistake "the number of iterations and poor_contraction are tested before the tolerance: an error
//         that is at most that is good in any case": if (largest <= tolerance) return true; ==> ;;
//         return false; ==> return false; if (largest <= tolerance) return true;
// mistake "it is not tested whether the error is at most the tolerance: return true then": if
//         (largest ==> if (n == iterations && largest
// mistake "at exactly the tolerance it is enough: <=": largest <= tolerance ==> largest < tolerance
// mistake "false where the error is at most the tolerance: that is true": true ==> false
// mistake "where the error is at most the tolerance the bodies move once more: they are there
//         already, return": return true; ==> { integrate_poses(bodies, real(h)); return true; }
// mistake "the largest error counts, by its size: of all rows max |C|. The sign is not removed":
//         std::abs(C) ==> C
// mistake "the largest error counts, by its size: of all rows max |C|, not the sum": largest =
//         std::max(largest, std::abs(C)) ==> largest += std::abs(C)
// mistake "the largest error counts, by its size: of all rows max |C|. Only the last row is used":
//         largest = std::max(largest, std::abs(C)) ==> largest = std::abs(C)
// mistake "the size is taken of -C/h, not of C: compare before you divide": largest = std ==> C /=
//         -h; largest = std ;; ; C /= -h ==>
// mistake "the largest error counts, by its size: of all rows max |C|, not the smallest": 0; for
//         ==> 1e9; for ;; max ==> min
// mistake "the largest error is not begun anew in each iteration: from 0": double largest = 0; ==>
//         ;; for ==> double largest = 0; for
// mistake "the largest error counts, by its size: of all rows max |C|, not the length of all of
//         them": largest = std::max(largest, std::abs(C)); ==> largest = std::hypot(largest, C);
// mistake "after the last correction the bodies stay where they began: they move, and the errors
//         are evaluated once more": integrate_poses ==> if (n == iterations) return true;
//         integrate_poses
// mistake "after the last correction the errors are not evaluated: true only if they are at most
//         the tolerance": std::vector ==> if (n == iterations) return true; std::vector
// mistake "false after the last correction: evaluate the errors once more, it may have closed the
//         joints": std::vector ==> if (n == iterations) return false; std::vector
// mistake "true after the last correction although its errors are above the tolerance: that is
//         false": n == iterations || ==> n == iterations) return true; if (
// mistake "one iteration too many: n < iterations": n == iterations ==> n > iterations
// mistake "one iteration too few: from 0 while n < iterations": == iterations ==> >= iterations - 1
// mistake "the errors are computed before the bodies move: C is that at the new poses":
//         integrate_poses(bodies, real(h)); ==> ;; double largest ==> integrate_poses(bodies,
//         real(h)); double largest
// mistake "the errors are computed before the bodies move: C is that at the new poses":
//         integrate_poses(bodies, real(h)); ==>
// mistake "the bodies move for half of h: for all of it": real(h) ==> real(h / 2)
// mistake "change_rates() is never called": corrector.change_rates(rates); ==>
// mistake "change_rates() is called twice in an iteration: once": corrector.change_rates(rates);
//         ==> corrector.change_rates(rates); corrector.change_rates(rates);
// mistake "the errors are computed more than once in an iteration: store them": double largest = 0;
//         ==> double largest = 0; corrector.errors();
// mistake "with no iterations the bodies do not move: they do, by the velocities that they have":
//         double last ==> if (iterations == 0) return true; double last
// mistake "the last error is 0 at first: in the first iteration any error is accepted":
//         std::numeric_limits<double>::infinity() ==> 0
// mistake "the first error is compared with a number: in the first iteration any error is accepted,
//         use infinity": std::numeric_limits<double>::infinity() ==> 0.5
// mistake "the velocities are changed before poor_contraction is tested: then they are not
//         restored": return false; ==> { if (n < iterations) corrector.change_rates(rates); return
//         false; }
// mistake "divided by poor_contraction: at most that fraction of the last error may remain":
//         poor_contraction * last ==> last / poor_contraction
// mistake "the tolerance is the argument, not a number of your own": tolerance ==> 1e-7
// mistake "where the error hardly decreases the bodies move on: stop there, they have moved": if (n
//         == iterations || !(largest <= poor_contraction * last)) return false; ==> if (n ==
//         iterations) return false; if (!(largest <= poor_contraction * last)) {
//         integrate_poses(bodies, real(h)); for (const double C : corrector.errors()) if
//         (std::abs(C) > tolerance) return false; return true; }
// mistake "the largest error counts, by its size: of all rows max |C|. Only the first row is used":
//         largest = std::max(largest, std::abs(C) ==> if (&C == rates.data()) largest = std::abs(C
// mistake "the largest error counts, by its size: of all rows max |C|, not the sum of the squares":
//         largest = std::max(largest, std::abs(C)) ==> largest += C * C
// mistake "twice: J V changes by -C/h": C /= -h ==> C /= -h / 2
// mistake "errors below the tolerance are not corrected: one row above it corrects all of them": C
//         /= -h ==> C = std::abs(C) <= tolerance ? 0 : -C / h
// mistake "the sizes of the errors: J V changes by -C/h": C /= -h ==> C = -std::abs(C) / h
// mistake "`start` does not hold the bodies as they were: the caller restores them from it if there
//         is no such pose": start.assign ==> std::vector<Body> own; own.assign ;; start.begin(),
//         start.end() ==> own.begin(), own.end()
// mistake "the bodies move for half of h in each iteration: for all of it": real(h) ==> real(n <
//         iterations ? h / 2 : h)
// mistake "the first error is compared with a number: in the first iteration any error is accepted,
//         use infinity": std::numeric_limits<double>::infinity() ==> 1
// right put back in a loop: std::copy(start.begin(), start.end(), bodies.data()) ==> for (int slot
//         = 0; slot < bodies.slots(); ++slot) bodies.at(slot) = start[std::size_t(slot)]
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
