// wrong drawn-stops: rows.push_back(set_up(link, bodies, settings)); ==>
//         rows.push_back(set_up(link, bodies, settings)); if (rows.size() > 4) rows.resize(4); ;; k
//         < links.size() ==> k < rows.size()
// wrong "cases drawn with seed 1 are wrong": apply_impulse(rows ==> if (std::abs(lambda) >
//         real(1e-12)) apply_impulse(rows
// wrong drawn-cut: apply_impulse(rows ==> lambda = glm::clamp(lambda, real(-1e3), real(1e3));
//         apply_impulse(rows
// mistake "forces after the impulses: the rods do not react to gravity": for (Body& body : bodies)
//         if (!body.is_static()) body.v += settings.h * settings.gravity; ==> ;; body.x ==> if
//         (!body.is_static()) body.v += settings.h * settings.gravity; for (Body& body : bodies)
//         body.x
// mistake "gravity moves a static body": ) if (!body.is_static() ==>
// mistake "lambda is an impulse, not a force: it is not multiplied by h": J, lambda ==> J,
//         settings.h * lambda
// wrong "positions before the forces: the old velocity moves the body.": for (Body& body : bodies)
//         body.x += settings.h * body.v; ==> ;; for ==> for (Body& body : bodies) body.x +=
//         settings.h * body.v; for
// mistake "as if there were only one iteration: the loop over the iterations is outside, the loop
//         over the links inside": settings.iterations ==> 1
// mistake "no impulse where the error is 0: such a row is solved, too, because of its velocity":
//         real lambda ==> const real error = length(body2.x - body1.x) - links[k].length; if
//         (std::abs(error) <= epsilon) continue; real lambda
// mistake "a fixed step of 1/60 s for gravity: take settings.h": settings.h ==> real(1) / 60
// mistake "a fixed step of 1/60 s: take settings.h": settings.h * settings.gravity ==> real(1) / 60
//         * settings.gravity ;; settings.h ==> real(1) / 60
// mistake "gravity does not act. Is it a copy that falls (write Body& body), or is h 1 / 60, which
//         is 0 in whole numbers?": settings.h * settings.gravity ==> real(1 / 60) *
//         settings.gravity
// mistake "only the y of gravity acts: settings.gravity is a vector": += settings.h *
//         settings.gravity ==> .y += settings.h * settings.gravity.y
// mistake "a fixed gravity of -9.81 m/s^2: take settings.gravity": += settings.h * settings.gravity
//         ==> .y += settings.h * real(-9.81)
// mistake "the sign of gravity: the vector points to where bodies fall": v += ==> v -=
// mistake "gravity sets v, which must grow: += and not =": v += ==> v =
// mistake "v grows by g, not by h g": h * settings. ==>
// mistake "gravity is multiplied by the inverse mass: all bodies fall alike": * settings. ==> *
//         body.inverse_mass * settings.
// mistake "gravity acts in every iteration: it belongs before them": for (Body& body : bodies) if
//         (!body.is_static()) body.v += settings.h * settings.gravity; ==> ;; for (std ==> { for
//         (Body& body : bodies) if (!body.is_static()) body.v += settings.h * settings.gravity; for
//         (std ;; } for ==> } } for
// mistake "the position does not change. Is it a copy that moves (write Body& body)?": for (Body&
//         body : bodies) body.x += settings.h * body.v; ==>
// mistake "x is set, which must grow: += and not =": x += ==> x =
// mistake "x grows by v, not by h v": settings.h * body ==> body
// mistake "h h g / 2 does not belong here: x grows by h times the new v, Eq. 1-10": body.x ==> if
//         (!body.is_static()) body.x ;; v; ==> v + settings.h * settings.h / 2 * settings.gravity;
// mistake "h h g / 2 does not belong here: x grows by h times the new v, and a wall does not move
//         at all": v; ==> v + settings.h * settings.h / 2 * settings.gravity;
// mistake "positions before the impulses: they move by velocities that are not corrected yet": for
//         (Body& body : bodies) body.x += settings.h * body.v; ==> ;; (set_up(link, bodies,
//         settings)) ==> (set_up(link, bodies, settings)); for (Body& body : bodies) body.x +=
//         settings.h * body.v
// mistake "positions move in every iteration: they belong after them": } for (Body& body : bodies)
//         body ==> body1 ;; body.v; ==> body1.v; body2.x += settings.h * body2.v; }
// wrong "positions before the forces: the old velocity moves the body. Change v": for (Body& body :
//         bodies) if (!body.is_static()) body.v += settings.h * settings.gravity; ==> ;; v; ==> v;
//         for (Body& body : bodies) if (!body.is_static()) body.v += settings.h * settings.gravity;
// wrong "a fixed number of iterations, 30: take settings.iterations": settings.iterations ==> 30
// mistake "one iteration too many": settings.iterations ==> settings.iterations + 1
// mistake "one iteration too few": settings.iterations ==> settings.iterations - 1
// mistake "the first link is left out: places in a vector run from 0": k = 0; ==> k = 1;
// mistake "the last link is left out: places run from 0 to size() - 1": k < links.size() ==> k + 1
//         < links.size()
// mistake "the bodies are taken by the place of the link: use link.body1 and link.body2":
//         links[k].body1 ==> k ;; links[k].body2 ==> k + 1
// mistake "every link takes the first row: row and link have the same place": rows[k].J, rows[k].K,
//         rows[k].bias ==> rows[0].J, rows[0].K, rows[0].bias ;; rows[k].sum ==> rows[0].sum ;;
//         rows[k]. ==> rows[0].
// mistake "bodies 1 and 2 are exchanged in row_impulse": body1, body2 ==> body2, body1
// mistake "the impulse acts the wrong way: its sign, or bodies 1 and 2 are exchanged in
//         apply_impulse": lambda, body1, body2 ==> lambda, body2, body1
// mistake "the sign of the bias, or bodies 1 and 2 are exchanged in row_impulse and apply_impulse":
//         body1, body2 ==> body2, body1 ;; body1, body2 ==> body2, body1
// mistake "the bias of the row is not used": rows[k].bias ==> real(0)
// mistake "the bias is multiplied by h: it is a velocity already": rows[k].bias ==> settings.h *
//         rows[k].bias
// mistake "K is not used: row_impulse takes the K of the row": rows[k].K ==> real(1)
// mistake "a small impulse is left out: a light body needs only a small one": apply_impulse ==> if
//         (std::abs(lambda) < real(1e-9)) continue; apply_impulse
// mistake "a small impulse is left out: a light body needs only a small one": apply_impulse ==> if
//         (std::abs(lambda) < real(1e-3)) break; apply_impulse
// mistake "links to a static body are left out: the other body can move": real ==> if
//         (body1.is_static() || body2.is_static()) continue; real
// mistake "all impulses of an iteration from the same velocities: apply each one before the next is
//         computed": for (std ==> { std::vector<real> all(links.size()); for (std ;; apply_impulse
//         ==> all[k] = lambda; } for (std::size_t k = 0; k < links.size(); ++k) apply_impulse ;;
//         lambda, body1, body2 ==> all[k], bodies[links[k].body1], bodies[links[k].body2]
// mistake "the impulses are computed once, before the iterations: compute them in each iteration":
//         for (int ==> std::vector<real> once; for (std::size_t k = 0; k < links.size(); ++k)
//         once.push_back(row_impulse(rows[k].J, rows[k].K, rows[k].bias, bodies[links[k].body1],
//         bodies[links[k].body2])); for (int ;; row_impulse(rows[k].J, rows[k].K, rows[k].bias,
//         body1, body2) ==> once[k]
// mistake "where there are no links the positions do not change: is there a return before them, or
//         do only the bodies of links move?": std::vector ==> if (links.empty()) return;
//         std::vector
// wrong bodies-turn-too: body.x += settings.h * body.v; ==> { body.x += settings.h * body.v; body.q
//         = normalize(rotation(settings.h * body.w) * body.q); }
// mistake "a rod is clamped like a rope, but it pushes, too: does the condition use link.rope, and
//         the right way round?": if (links[k].rope) ==>
// mistake "the sum of a rope begins at 0 in every iteration, so each impulse is clamped separately.
//         Is the row a copy (write LinkRow& row), is set_up called within the iterations, or is the
//         sum not that of the row?": clamp_sum ==> glm::max ;; rows[k].sum ==> real(0)
// mistake "a rope pushes: its impulse is not clamped. Is clamp_sum called for a rope, before
//         apply_impulse, and does its result replace lambda?": lambda = clamp_sum ==> clamp_sum
// mistake "all ropes share one sum: each row has its own": for (int ==> real sum = 0; for (int ;;
//         rows[k].sum ==> sum
// mistake "the sum of the rope is applied: apply the result of clamp_sum, the growth of the sum":
//         apply_impulse ==> if (links[k].rope) lambda = rows[k].sum; apply_impulse
// mistake "the sum is overwritten by the result of clamp_sum: clamp_sum updates it itself":
//         clamp_sum ==> rows[k].sum = clamp_sum
// mistake "clamp_sum is called twice for an impulse": apply_impulse ==> if (links[k].rope) lambda =
//         clamp_sum(lambda, rows[k].sum); apply_impulse
// mistake "the sign of a rope's impulse: a positive one pulls the bodies together": clamp_sum ==>
//         -clamp_sum ;; lambda, ==> -lambda,
// mistake "a slack rope is left out: it may become taut within the step, so its row is solved,
//         too": real ==> if (links[k].rope && rows[k].bias > 0) continue; real
// mistake "ropes are left out": real lambda ==> if (links[k].rope) continue; real lambda
// mistake "gravity moves static bodies and no others: is the condition the wrong way round?": !body
//         ==> body
// mistake "no impulse was applied. Are the bodies copies (write Body& body1) or both the same one,
//         or is the row an empty one?": rows; ==> rows(links.size());
// mistake "only the y of gravity acts: settings.gravity is a vector": += settings.h *
//         settings.gravity ==> .y += settings.h * settings.gravity.y ;; 0; k < links.size(); ++k
//         ==> links.size(); k-- > 0;
// wrong "a fixed number of iterations, 20": settings.iterations ==> 20 ;; 0; k < links.size(); ++k
//         ==> links.size(); k-- > 0;
// mistake "the fraction of lambda is cut off: an int holds whole numbers only": real ==> int
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
// mistake "v grows by h h g, not by h g": settings.h * settings.gravity ==> settings.h * settings.h
//         * settings.gravity
// mistake "gravity is multiplied by the mass: all bodies fall alike": settings.h * settings.gravity
//         ==> settings.h / body.inverse_mass * settings.gravity
// mistake "only the first body falls, or only those before a static one: is it break where continue
//         belongs?": !body.is_static() ==> &body == &bodies[0] && !body.is_static()
// mistake "the first body does not fall: places in a vector run from 0": !body.is_static() ==>
//         &body != &bodies[0] && !body.is_static()
// mistake "the sign of the position: x grows by h v": body.x += ==> body.x -=
// mistake "h h g / 2 does not belong here: x grows by h times the new v, Eq. 1-10": body.x +=
//         settings.h * body.v ==> { body.x += settings.h * body.v; if (!body.is_static()) body.x +=
//         -settings.h * settings.h / 2 * settings.gravity; }
// mistake "positions move in every iteration: they belong after them": for (std ==> { for (std ;;
//         apply_impulse(rows[k].J, lambda, body1, body2); } for (Body& body : bodies) body.x +=
//         settings.h * body.v; ==> apply_impulse(rows[k].J, lambda, body1, body2); } for (Body&
//         body : bodies) body.x += settings.h * body.v; }
// mistake "only the first body moves": body.x += ==> if (&body == &bodies[0]) body.x +=
// mistake "the first body does not move: places in a vector run from 0": body.x += ==> if (&body !=
//         &bodies[0]) body.x +=
// mistake "a fixed step of 1/30 s: take settings.h": settings.h * settings.gravity ==> real(1) / 30
//         * settings.gravity ;; settings.h * body ==> real(1) / 30 * body
// mistake "a fixed step of 1/50 s: take settings.h": settings.h * settings.gravity ==> real(0.02) *
//         settings.gravity ;; settings.h * body ==> real(0.02) * body
// mistake "a fixed step of 1/100 s: take settings.h": settings.h * settings.gravity ==> real(0.01)
//         * settings.gravity ;; settings.h * body ==> real(0.01) * body
// mistake "a fixed step of 1/120 s: take settings.h": settings.h * settings.gravity ==> real(1) /
//         120 * settings.gravity ;; settings.h * body ==> real(1) / 120 * body
// mistake "a fixed step of 0.016 s: take settings.h": settings.h * settings.gravity ==> real(0.016)
//         * settings.gravity ;; settings.h * body ==> real(0.016) * body
// mistake "a fixed step of 0.0167 s: take settings.h": settings.h * settings.gravity ==>
//         real(0.0167) * settings.gravity ;; settings.h * body ==> real(0.0167) * body
// mistake "a fixed step of 1/60 s for the positions: take settings.h": settings.h * body ==>
//         real(1) / 60 * body
// mistake "positions before the impulses: they move by velocities that are not corrected yet": for
//         (Body& body : bodies) if (!body.is_static()) body.v += settings.h * settings.gravity; ==>
//         ;; for (Body& body : bodies) body.x += settings.h * body.v; ==>  ;; std::vector<LinkRow>
//         rows; for (const Link& link : links) rows.push_back(set_up(link, bodies, settings)); ==>
//         for (Body& body : bodies) if (!body.is_static()) body.v += settings.h * settings.gravity;
//         for (Body& body : bodies) body.x += settings.h * body.v; std::vector<LinkRow> rows; for
//         (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
// mistake "positions before the forces: the old velocity moves the body. Change v first, then x;
//         positions before the impulses: they move by velocities that are not corrected yet": for
//         (Body& body : bodies) if (!body.is_static()) body.v += settings.h * settings.gravity; ==>
//         ;; for (Body& body : bodies) body.x += settings.h * body.v; ==>  ;; std::vector<LinkRow>
//         rows; for (const Link& link : links) rows.push_back(set_up(link, bodies, settings)); ==>
//         for (Body& body : bodies) body.x += settings.h * body.v; for (Body& body : bodies) if
//         (!body.is_static()) body.v += settings.h * settings.gravity; std::vector<LinkRow> rows;
//         for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
// mistake "positions before the forces: the old velocity moves the body. Change v first, then x;
//         positions before the impulses: they move by velocities that are not corrected yet": for
//         (Body& body : bodies) if (!body.is_static()) body.v += settings.h * settings.gravity; ==>
//         ;; for (Body& body : bodies) body.x += settings.h * body.v; ==>  ;; std::vector<LinkRow>
//         rows; for (const Link& link : links) rows.push_back(set_up(link, bodies, settings)); ==>
//         std::vector<LinkRow> rows; for (const Link& link : links) rows.push_back(set_up(link,
//         bodies, settings)); for (Body& body : bodies) body.x += settings.h * body.v; for (Body&
//         body : bodies) if (!body.is_static()) body.v += settings.h * settings.gravity;
// mistake "positions before the forces: the old velocity moves the body. Change v first, then x;
//         forces after the impulses: the rods do not react to gravity": for (Body& body : bodies)
//         if (!body.is_static()) body.v += settings.h * settings.gravity; ==> ;; for (Body& body :
//         bodies) body.x += settings.h * body.v; ==> for (Body& body : bodies) body.x += settings.h
//         * body.v; for (Body& body : bodies) if (!body.is_static()) body.v += settings.h *
//         settings.gravity; ;; std::vector<LinkRow> rows; for (const Link& link : links)
//         rows.push_back(set_up(link, bodies, settings)); ==> std::vector<LinkRow> rows; for (const
//         Link& link : links) rows.push_back(set_up(link, bodies, settings));
// mistake "positions before the forces: the old velocity moves the body. Change v first, then x;
//         positions before the impulses: they move by velocities that are not corrected yet; forces
//         after the impulses: the rods do not react to gravity": for (Body& body : bodies) if
//         (!body.is_static()) body.v += settings.h * settings.gravity; ==> ;; for (Body& body :
//         bodies) body.x += settings.h * body.v; ==> for (Body& body : bodies) if
//         (!body.is_static()) body.v += settings.h * settings.gravity; ;; std::vector<LinkRow>
//         rows; for (const Link& link : links) rows.push_back(set_up(link, bodies, settings)); ==>
//         for (Body& body : bodies) body.x += settings.h * body.v; std::vector<LinkRow> rows; for
//         (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
// mistake "positions before the forces: the old velocity moves the body. Change v first, then x;
//         positions before the impulses: they move by velocities that are not corrected yet; forces
//         after the impulses: the rods do not react to gravity": for (Body& body : bodies) if
//         (!body.is_static()) body.v += settings.h * settings.gravity; ==> ;; for (Body& body :
//         bodies) body.x += settings.h * body.v; ==> for (Body& body : bodies) if
//         (!body.is_static()) body.v += settings.h * settings.gravity; ;; std::vector<LinkRow>
//         rows; for (const Link& link : links) rows.push_back(set_up(link, bodies, settings)); ==>
//         std::vector<LinkRow> rows; for (const Link& link : links) rows.push_back(set_up(link,
//         bodies, settings)); for (Body& body : bodies) body.x += settings.h * body.v;
// mistake "3 iterations, or as many as links: take settings.iterations": settings.iterations ==>
//         int(links.size())
// mistake "4 iterations, or as many as bodies: take settings.iterations": settings.iterations ==>
//         int(bodies.size())
// wrong "a fixed number of iterations, 8: take settings.iterations": settings.iterations ==> 8
// mistake "only the first link is solved": k < links.size() ==> k < links.size() && k < 1
// mistake "the impulses are computed once, before the iterations: compute them in each iteration":
//         for (int ==> std::vector<real> once(links.size()); for (int ;; real lambda =
//         row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2); ==> if (iteration == 0)
//         once[k] = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2); real lambda =
//         once[k];
// mistake "the sign of the bias, or bodies 1 and 2 are exchanged in row_impulse and apply_impulse":
//         rows[k].bias ==> -rows[k].bias
// mistake "the bias is multiplied by beta: set_up has done so": rows[k].bias ==> settings.beta *
//         rows[k].bias
// mistake "times K: row_impulse takes K and divides by it": rows[k].K ==> 1 / rows[k].K
// mistake "lambda is an impulse, not a force: it is not divided by h": J, lambda ==> J, lambda /
//         settings.h
// mistake "no impulse was applied. Are the bodies copies (write Body& body1) or both the same one,
//         or is the row an empty one?": apply_impulse(rows[k].J, lambda, body1, body2); ==>
// mistake "no impulse where the error is 0: such a row is solved, too, because of its velocity":
//         real lambda ==> if (std::abs(rows[k].bias) < real(1e-12)) continue; real lambda
// mistake "no impulse where the error is 0: such a row is solved, too, because of its velocity":
//         real lambda ==> if (std::abs(rows[k].bias) < real(1e-6)) continue; real lambda
// mistake "no impulse where the error is 0: such a row is solved, too, because of its velocity":
//         real lambda ==> if (std::abs(rows[k].bias) < real(1e-3)) continue; real lambda
// mistake "no impulse where the error is 0: such a row is solved, too, because of its velocity":
//         real lambda ==> if (std::abs(length(body2.x - body1.x) - links[k].length) < real(1e-6))
//         continue; real lambda
// mistake "no impulse where the error is 0: such a row is solved, too, because of its velocity":
//         real lambda ==> if (std::abs(length(body2.x - body1.x) - links[k].length) < real(1e-3))
//         continue; real lambda
// mistake "links to a static body are left out: the other body can move": real lambda ==> if
//         (body1.is_static()) continue; real lambda
// mistake "return where continue belongs: at a link to a static body the step ends, and the other
//         links and the positions are left out": real lambda ==> if (body1.is_static() ||
//         body2.is_static()) return; real lambda
// mistake "return where continue belongs: at a link to a static body the step ends, and the other
//         links and the positions are left out": real lambda ==> if (body1.is_static()) return;
//         real lambda
// mistake "return where continue belongs: at a static body the step ends before its links are
//         solved": if (!body.is_static()) body.v += settings.h * settings.gravity ==> { if
//         (body.is_static()) return; body.v += settings.h * settings.gravity; }
// mistake "only the first body falls, or only those before a static one: is it break where continue
//         belongs?": if (!body.is_static()) body.v += settings.h * settings.gravity ==> { if
//         (body.is_static()) break; body.v += settings.h * settings.gravity; }
// mistake "break where continue belongs: behind a link to a static body the others are left out":
//         real lambda ==> if (body1.is_static() || body2.is_static()) break; real lambda
// mistake "break where continue belongs: behind a link to a static body the others are left out":
//         real lambda ==> if (body1.is_static()) break; real lambda
// mistake "only bodies with a link fall: gravity acts on each body that is not static": if (!body
//         ==> if (std::any_of(links.begin(), links.end(), [&](const Link& link) { return
//         &bodies[link.body1] == &body || &bodies[link.body2] == &body; })) if (!body
// mistake "where there are no links the positions do not change: is there a return before them, or
//         do only the bodies of links move?": body.x += ==> if (std::any_of(links.begin(),
//         links.end(), [&](const Link& link) { return &bodies[link.body1] == &body ||
//         &bodies[link.body2] == &body; })) body.x +=
// mistake "a small impulse is left out: a light body needs only a small one": apply_impulse ==> if
//         (std::abs(lambda) < real(1e-2)) continue; apply_impulse
// mistake "a small impulse is left out: a light body needs only a small one": apply_impulse ==> if
//         (std::abs(lambda) < real(1e-3)) continue; apply_impulse
// mistake "a small impulse is left out: a light body needs only a small one": apply_impulse ==> if
//         (std::abs(lambda) < real(1e-4)) continue; apply_impulse
// mistake "a small impulse is left out: a light body needs only a small one": apply_impulse ==> if
//         (std::abs(lambda) < real(1e-6)) continue; apply_impulse
// mistake "a small impulse is left out: a light body needs only a small one": apply_impulse ==> if
//         (std::abs(lambda) < real(1e-6)) break; apply_impulse
// mistake "a small impulse is left out: a light body needs only a small one": apply_impulse ==> if
//         (std::abs(lambda) < real(1e-9)) break; apply_impulse
// mistake "a rod is clamped like a rope, but it pushes, too: does the condition use link.rope, and
//         the right way round?": (links[k].rope) ==> (!links[k].rope)
// mistake "a rod is clamped like a rope, but it pushes, too: does the condition use link.rope, and
//         the right way round?": if (links[k].rope) ==> if (!links[k].rope) lambda =
//         glm::max(lambda, real(0)); if (links[k].rope)
// mistake "a rod pushes and pulls: lambda has either sign": if (links[k].rope) ==> if
//         (!links[k].rope) lambda = glm::min(lambda, real(0)); if (links[k].rope)
// mistake "the sum of a rope begins at 0 in every iteration, so each impulse is clamped separately.
//         Is the row a copy (write LinkRow& row), is set_up called within the iterations, or is the
//         sum not that of the row?": lambda = clamp_sum ==> rows[k].sum = 0; if (links[k].rope)
//         lambda = clamp_sum
// mistake "the sign of a rope's impulse: a positive one pulls the bodies together":
//         clamp_sum(lambda, rows[k].sum) ==> glm::min(lambda, real(0))
// mistake "the sign of a rope's impulse: a positive one pulls the bodies together":
//         clamp_sum(lambda ==> -clamp_sum(lambda
