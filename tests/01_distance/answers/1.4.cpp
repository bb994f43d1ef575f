// wrong drawn-stops: rows.push_back(set_up(link, bodies, settings)); ==>
//         rows.push_back(set_up(link, bodies, settings)); if (rows.size() > 4) rows.resize(4); ;; k
//         < links.size() ==> k < rows.size()
// wrong drawn-threshold: apply_impulse(rows ==> if (std::abs(lambda) > real(1e-12))
//         apply_impulse(rows
// wrong drawn-cut: apply_impulse(rows ==> lambda = glm::clamp(lambda, real(-1e3), real(1e3));
//         apply_impulse(rows
// wrong forces-after-rows: for (Body& body : bodies) if (!body.is_static()) body.v += settings.h *
//         settings.gravity; ==> ;; body.x ==> if (!body.is_static()) body.v += settings.h *
//         settings.gravity; for (Body& body : bodies) body.x
// wrong gravity-moves-static-bodies: ) if (!body.is_static() ==>
// wrong lambda-taken-force: J, lambda ==> J, settings.h * lambda
// wrong "positions before the forces: the old velocity moves the body.": for (Body& body : bodies)
//         body.x += settings.h * body.v; ==> ;; for ==> for (Body& body : bodies) body.x +=
//         settings.h * body.v; for
// wrong one-iteration-only: settings.iterations ==> 1
// wrong no-impulse-where-error: real lambda ==> const real error = length(body2.x - body1.x) -
//         links[k].length; if (std::abs(error) <= epsilon) continue; real lambda
// wrong "a fixed step of 1/60 s for gravity: take settings.h": settings.h ==> real(1) / 60
// wrong "a fixed step of 1/60 s: take settings.h": settings.h * settings.gravity ==> real(1) / 60 *
//         settings.gravity ;; settings.h ==> real(1) / 60
// wrong whole-numbers-divided: settings.h * settings.gravity ==> real(1 / 60) * settings.gravity
// wrong only-y-gravity: += settings.h * settings.gravity ==> .y += settings.h * settings.gravity.y
// wrong fixed-gravity: += settings.h * settings.gravity ==> .y += settings.h * real(-9.81)
// wrong sign-of-gravity: v += ==> v -=
// wrong velocity-set-gravity: v += ==> v =
// wrong gravity-without-h: h * settings. ==>
// wrong gravity-over-mass: * settings. ==> * body.inverse_mass * settings.
// wrong gravity-every-iteration: for (Body& body : bodies) if (!body.is_static()) body.v +=
//         settings.h * settings.gravity; ==> ;; for (std ==> { for (Body& body : bodies) if
//         (!body.is_static()) body.v += settings.h * settings.gravity; for (std ;; } for ==> } }
//         for
// wrong positions-stay: for (Body& body : bodies) body.x += settings.h * body.v; ==>
// wrong positions-set: x += ==> x =
// wrong positions-without-h: settings.h * body ==> body
// wrong parabola: body.x ==> if (!body.is_static()) body.x ;; v; ==> v + settings.h * settings.h /
//         2 * settings.gravity;
// wrong parabola-walls: v; ==> v + settings.h * settings.h / 2 * settings.gravity;
// wrong positions-before-impulses: for (Body& body : bodies) body.x += settings.h * body.v; ==> ;;
//         (set_up(link, bodies, settings)) ==> (set_up(link, bodies, settings)); for (Body& body :
//         bodies) body.x += settings.h * body.v
// wrong positions-every-iteration: } for (Body& body : bodies) body ==> body1 ;; body.v; ==>
//         body1.v; body2.x += settings.h * body2.v; }
// wrong "positions before the forces: the old velocity moves the body. Change v": for (Body& body :
//         bodies) if (!body.is_static()) body.v += settings.h * settings.gravity; ==> ;; v; ==> v;
//         for (Body& body : bodies) if (!body.is_static()) body.v += settings.h * settings.gravity;
// wrong "a fixed number of iterations, 30: take settings.iterations": settings.iterations ==> 30
// wrong one-iteration-too-many: settings.iterations ==> settings.iterations + 1
// wrong one-iteration-too-few: settings.iterations ==> settings.iterations - 1
// wrong first-link-left-out: k = 0; ==> k = 1;
// wrong last-link-left-out: k < links.size() ==> k + 1 < links.size()
// wrong bodies-place-link: links[k].body1 ==> k ;; links[k].body2 ==> k + 1
// wrong first-row-all: rows[k].J, rows[k].K, rows[k].bias ==> rows[0].J, rows[0].K, rows[0].bias ;;
//         rows[k].sum ==> rows[0].sum ;; rows[k]. ==> rows[0].
// wrong bodies-exchanged-row-impulse: body1, body2 ==> body2, body1
// wrong bodies-exchanged-apply-impulse: lambda, body1, body2 ==> lambda, body2, body1
// wrong bodies-exchanged-both: body1, body2 ==> body2, body1 ;; body1, body2 ==> body2, body1
// wrong bias-not-used: rows[k].bias ==> real(0)
// wrong bias-times-h: rows[k].bias ==> settings.h * rows[k].bias
// wrong k-not-used: rows[k].K ==> real(1)
// wrong smaller-impulses-left-out: apply_impulse ==> if (std::abs(lambda) < real(1e-9)) continue;
//         apply_impulse
// wrong smaller-impulses-left-out: apply_impulse ==> if (std::abs(lambda) < real(1e-3)) break;
//         apply_impulse
// wrong links-walls-left-out: real ==> if (body1.is_static() || body2.is_static()) continue; real
// wrong all-at-once: for (std ==> { std::vector<real> all(links.size()); for (std ;; apply_impulse
//         ==> all[k] = lambda; } for (std::size_t k = 0; k < links.size(); ++k) apply_impulse ;;
//         lambda, body1, body2 ==> all[k], bodies[links[k].body1], bodies[links[k].body2]
// wrong impulses-computed-once: for (int ==> std::vector<real> once; for (std::size_t k = 0; k <
//         links.size(); ++k) once.push_back(row_impulse(rows[k].J, rows[k].K, rows[k].bias,
//         bodies[links[k].body1], bodies[links[k].body2])); for (int ;; row_impulse(rows[k].J,
//         rows[k].K, rows[k].bias, body1, body2) ==> once[k]
// wrong nothing-without-links: std::vector ==> if (links.empty()) return; std::vector
// wrong bodies-turn-too: body.x += settings.h * body.v; ==> { body.x += settings.h * body.v; body.q
//         = normalize(rotation(settings.h * body.w) * body.q); }
// wrong rods-clamped-like-ropes: if (links[k].rope) ==>
// wrong each-impulse-rope-clamped: clamp_sum ==> glm::max ;; rows[k].sum ==> real(0)
// wrong result-clamp-sum-dropped: lambda = clamp_sum ==> clamp_sum
// wrong one-sum-all-ropes: for (int ==> real sum = 0; for (int ;; rows[k].sum ==> sum
// wrong sum-rope-applied: apply_impulse ==> if (links[k].rope) lambda = rows[k].sum; apply_impulse
// wrong sum-overwritten: clamp_sum ==> rows[k].sum = clamp_sum
// wrong clamped-twice: apply_impulse ==> if (links[k].rope) lambda = clamp_sum(lambda,
//         rows[k].sum); apply_impulse
// wrong sign-rope: clamp_sum ==> -clamp_sum ;; lambda, ==> -lambda,
// wrong slack-ropes-left-out: real ==> if (links[k].rope && rows[k].bias > 0) continue; real
// wrong ropes-left-out: real lambda ==> if (links[k].rope) continue; real lambda
// wrong only-walls-fall: !body ==> body
// wrong rows-behind-empty-ones: rows; ==> rows(links.size());
// wrong only-y-gravity: += settings.h * settings.gravity ==> .y += settings.h * settings.gravity.y
//         ;; 0; k < links.size(); ++k ==> links.size(); k-- > 0;
// wrong "a fixed number of iterations, 20": settings.iterations ==> 20 ;; 0; k < links.size(); ++k
//         ==> links.size(); k-- > 0;
// wrong impulse-whole-number: real ==> int
// wrong few-digits: real ==> float
// right in one loop:
  // The rows do not read the velocities: they may be prepared before gravity acts.
  std::vector<LinkRow> rows(links.size());
  for (std::size_t k = 0; k < links.size(); ++k) rows[k] = set_up(links[k], bodies, settings);
  for (Body& body : bodies) body.v += settings.h * (body.is_static() ? vec3(0) : settings.gravity);
  int left = settings.iterations;
  while (left-- > 0) {
    std::size_t k = 0;
    for (LinkRow& row : rows) {
      const Link& link = links[k++];
      Body &one = bodies[link.body1], &two = bodies[link.body2];
      const real wanted = row_impulse(row.J, row.K, row.bias, one, two);
      apply_impulse(row.J, link.rope ? clamp_sum(wanted, row.sum) : wanted, one, two);
    }
  }
  for (Body& body : bodies)
    if (!body.is_static()) body.x += settings.h * body.v;
// right from the last link to the first: 0; k < links.size(); ++k ==> links.size(); k-- > 0;
// right to and fro: for (std::size_t k = 0; k < links.size(); ++k) { ==> for (std::size_t n = 0; n
//         < links.size(); ++n) { const std::size_t k = iteration % 2 ? links.size() - 1 - n : n;
// right a reference to the row: real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias,
//         body1, body2); ==> LinkRow& row = rows[k]; real lambda = row_impulse(row.J, row.K,
//         row.bias, body1, body2); if (links[k].rope) lambda = clamp_sum(lambda, row.sum); ;; if
//         (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum); ==>
// right impulses of 0 left out: apply_impulse(rows ==> if (lambda == 0) continue;
//         apply_impulse(rows
// wrong units "in the step, adding m/s^2 to m/s: h is missing":
  for (Body& body : bodies)
    if (!body.is_static()) body.v += settings.gravity;
// wrong units "in the step, adding m to m/s: a time too many: is a division by h missing?":
  for (const Link& link : links) {
    Body &body1 = bodies[link.body1], &body2 = bodies[link.body2];
    const LinkRow row = set_up(link, bodies, settings);
    const real C = CentreDistance{link.length}.error(body1, body2);
    apply_impulse(row.J, row_impulse(row.J, row.K, C, body1, body2), body1, body2);
  }
