// Known answers of exercise 1.4, each put in the place of the solution's.

// ---- wrong: forces after the rows
// expects: Likely mistake: forces after the impulses: the rods cannot answer to gravity any more
  std::vector<LinkRow> rows;
  for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
  for (int iteration = 0; iteration < settings.iterations; ++iteration)
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
      real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2);
      if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
      apply_impulse(rows[k].J, lambda, body1, body2);
    }
  for (Body& body : bodies)
    if (!body.is_static()) body.v += settings.h * settings.gravity;
  for (Body& body : bodies) body.x += settings.h * body.v;

// ---- wrong: gravity moves static bodies
// expects: Likely mistake: gravity moves a static body
  for (Body& body : bodies) body.v += settings.h * settings.gravity;
  std::vector<LinkRow> rows;
  for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
  for (int iteration = 0; iteration < settings.iterations; ++iteration)
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
      real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2);
      if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
      apply_impulse(rows[k].J, lambda, body1, body2);
    }
  for (Body& body : bodies) body.x += settings.h * body.v;

// ---- wrong: lambda taken for a force
// expects: Likely mistake: lambda is an impulse, not a force: it is not multiplied by h
// change: , lambda, ==> , settings.h * lambda,

// ---- wrong: old velocity moves the positions
// expects: Likely mistake: positions before the forces: the old velocity moves the body.
  for (Body& body : bodies) body.x += settings.h * body.v;
  for (Body& body : bodies)
    if (!body.is_static()) body.v += settings.h * settings.gravity;
  std::vector<LinkRow> rows;
  for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
  for (int iteration = 0; iteration < settings.iterations; ++iteration)
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
      real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2);
      if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
      apply_impulse(rows[k].J, lambda, body1, body2);
    }

// ---- wrong: one iteration only
// expects: Likely mistake: only one iteration was done
// change: settings.iterations ==> 1

// ---- wrong: only where there is an error
// expects: Likely mistake: no impulse where the error is 0: such a row is solved all the same
// change: real lambda ==> const real error = length(body2.x - body1.x) - links[k].length; if
//         (std::abs(error) <= epsilon) continue; real lambda

// ---- wrong: fixed step for gravity
// expects: Likely mistake: a fixed step of 1/60 s for gravity: take settings.h
// change: settings.h * settings.gravity ==> real(1) / 60 * settings.gravity

// ---- wrong: fixed step
// expects: Likely mistake: a fixed step of 1/60 s: take settings.h
// change: settings.h * settings.gravity ==> real(1) / 60 * settings.gravity
// change: settings.h ==> real(1) / 60

// ---- wrong: whole numbers divided
// expects: Likely mistake: gravity does not act.
// change: settings.h * settings.gravity ==> real(1 / 60) * settings.gravity

// ---- wrong: copies fall
// expects: Likely mistake: gravity does not act.
  for (Body body : bodies)
    if (!body.is_static()) body.v += settings.h * settings.gravity;
  std::vector<LinkRow> rows;
  for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
  for (int iteration = 0; iteration < settings.iterations; ++iteration)
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
      real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2);
      if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
      apply_impulse(rows[k].J, lambda, body1, body2);
    }
  for (Body& body : bodies) body.x += settings.h * body.v;

// ---- wrong: only the y of gravity
// expects: Likely mistake: only the y of gravity acts
// change: += settings.h * settings.gravity ==> .y += settings.h * settings.gravity.y

// ---- wrong: fixed gravity
// expects: Likely mistake: a fixed gravity of -9.81 m/s^2: take settings.gravity
// change: += settings.h * settings.gravity ==> .y += settings.h * real(-9.81)

// ---- wrong: sign of gravity
// expects: Likely mistake: the sign of gravity
// change: v += ==> v -=

// ---- wrong: velocity set by gravity
// expects: Likely mistake: gravity sets v, which must grow
// change: v += ==> v =

// ---- wrong: gravity without h
// expects: Likely mistake: v grows by g, not by h g
// change: h * settings. ==>

// ---- wrong: gravity over mass
// expects: Likely mistake: gravity is multiplied by the inverse mass
// change: * settings. ==> * body.inverse_mass * settings.

// ---- wrong: gravity in every iteration
// expects: Likely mistake: gravity acts in every iteration
  std::vector<LinkRow> rows;
  for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
  for (int iteration = 0; iteration < settings.iterations; ++iteration)
    {
  for (Body& body : bodies)
    if (!body.is_static()) body.v += settings.h * settings.gravity;
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
      real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2);
      if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
      apply_impulse(rows[k].J, lambda, body1, body2);
    } }
  for (Body& body : bodies) body.x += settings.h * body.v;

// ---- wrong: positions stay
// expects: Likely mistake: the position does not change.
// change: for (Body& body : bodies) body.x += settings.h * body.v; ==>

// ---- wrong: positions set
// expects: Likely mistake: x is set, which must grow
// change: x += ==> x =

// ---- wrong: positions without h
// expects: Likely mistake: x grows by v, not by h v
// change: settings.h * body ==> body

// ---- wrong: parabola
// expects: Likely mistake: h h g / 2 does not belong here
// change: for (Body& body : bodies) body.x += settings.h * body.v; ==> for (Body& body : bodies) if
//         (!body.is_static()) body.x += settings.h * body.v + settings.h * settings.h / 2 *
//         settings.gravity;

// ---- wrong: positions before the impulses
// expects: Likely mistake: positions before the impulses: velocities that are not right yet move them
  for (Body& body : bodies)
    if (!body.is_static()) body.v += settings.h * settings.gravity;
  std::vector<LinkRow> rows;
  for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
  for (Body& body : bodies) body.x += settings.h * body.v;
  for (int iteration = 0; iteration < settings.iterations; ++iteration)
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
      real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2);
      if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
      apply_impulse(rows[k].J, lambda, body1, body2);
    }

// ---- wrong: positions in every iteration
// expects: Likely mistake: positions move in every iteration
// change: } ==> body1.x += settings.h * body1.v; body2.x += settings.h * body2.v; }
// change: for (Body& body : bodies) body.x += settings.h * body.v; ==>

// ---- wrong: forces last
// expects: Likely mistake: positions before the forces: the old velocity moves the body. Change v
  std::vector<LinkRow> rows;
  for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
  for (int iteration = 0; iteration < settings.iterations; ++iteration)
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
      real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2);
      if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
      apply_impulse(rows[k].J, lambda, body1, body2);
    }
  for (Body& body : bodies) body.x += settings.h * body.v;
  for (Body& body : bodies)
    if (!body.is_static()) body.v += settings.h * settings.gravity;

// ---- wrong: fixed number of iterations
// expects: Likely mistake: a fixed number of iterations, 30: take settings.iterations
// change: settings.iterations ==> 30

// ---- wrong: one iteration too many
// expects: Likely mistake: one iteration too many
// change: settings.iterations ==> settings.iterations + 1

// ---- wrong: one iteration too few
// expects: Likely mistake: one iteration too few
// change: settings.iterations ==> settings.iterations - 1

// ---- wrong: loops exchanged
// expects: Likely mistake: only one iteration was done.
// change: int iteration = 0; iteration < settings.iterations; ++iteration ==> std::size_t k = 0; k <
//         links.size(); ++k
// change: for (std::size_t k = 0; k < links.size(); ++k) { ==> for (int iteration = 0; iteration <
//         settings.iterations; ++iteration) {

// ---- wrong: first link left out
// expects: Likely mistake: the first link is left out
// change: k = 0; ==> k = 1;

// ---- wrong: last link left out
// expects: Likely mistake: the last link is left out
// change: k < links.size() ==> k + 1 < links.size()

// ---- wrong: bodies by the place of the link
// expects: Likely mistake: the bodies are taken by the place of the link
// change: bodies[links[k].body1], &body2 = bodies[links[k].body2] ==> bodies[k], &body2 =
//         bodies[k + 1]

// ---- wrong: first row for all
// expects: Likely mistake: every link takes the first row
// change: rows[k].J, rows[k].K, rows[k].bias ==> rows[0].J, rows[0].K, rows[0].bias
// change: rows[k].sum ==> rows[0].sum
// change: rows[k]. ==> rows[0].

// ---- wrong: impulses on copies
// expects: Likely mistake: no impulse was applied. Are the bodies copies
// change: &body1 = bodies[links[k].body1], & ==> body1 = bodies[links[k].body1],

// ---- wrong: bodies exchanged in row_impulse
// expects: Likely mistake: bodies 1 and 2 are exchanged in row_impulse
// change: bias, body1, body2); ==> bias, body2, body1);

// ---- wrong: bodies exchanged in apply_impulse
// expects: Likely mistake: the impulse acts the wrong way
// change: lambda, body1, body2); ==> lambda, body2, body1);

// ---- wrong: bodies exchanged in both
// expects: Likely mistake: the sign of the bias, or bodies 1 and 2 are exchanged in row_impulse and
// change: bias, body1, body2); ==> bias, body2, body1);
// change: body1, body2 ==> body2, body1

// ---- wrong: bias not used
// expects: Likely mistake: the bias of the row is not used
// change: rows[k].bias ==> real(0)

// ---- wrong: bias times h
// expects: Likely mistake: the bias is multiplied by h
// change: rows[k].bias ==> settings.h * rows[k].bias

// ---- wrong: K not used
// expects: Likely mistake: K is not used
// change: rows[k].K ==> real(1)

// ---- wrong: small impulses left out
// expects: Likely mistake: a small impulse is left out
// change: apply_impulse(rows ==> if (std::abs(lambda) < real(1e-3)) continue; apply_impulse(rows

// ---- wrong: smaller impulses left out
// expects: Likely mistake: a small impulse is left out
// change: apply_impulse(rows ==> if (std::abs(lambda) < real(1e-9)) continue; apply_impulse(rows

// ---- wrong: a small impulse ends the iteration
// expects: Likely mistake: a small impulse is left out
// change: apply_impulse(rows ==> if (std::abs(lambda) < real(1e-3)) break; apply_impulse(rows

// ---- wrong: links to walls left out
// expects: Likely mistake: links to a static body are left out
// change: real lambda ==> if (body1.is_static() || body2.is_static()) continue; real lambda

// ---- wrong: all at once
// expects: Likely mistake: all impulses of an iteration from the same velocities
// change: for (std::size_t k = 0; k < links.size(); ++k) { ==> { std::vector<real>
//         all(links.size()); for (std::size_t k = 0; k < links.size(); ++k) {
// change: apply_impulse(rows[k].J, lambda, body1, body2); ==> all[k] = lambda; } for (std::size_t k
//         = 0; k < links.size(); ++k) apply_impulse(rows[k].J, all[k], bodies[links[k].body1],
//         bodies[links[k].body2]);

// ---- wrong: impulses computed once
// expects: Likely mistake: the impulses are computed once, before the iterations
// change: for (int ==> std::vector<real> once; for (std::size_t k = 0; k < links.size(); ++k)
//         once.push_back(row_impulse(rows[k].J, rows[k].K, rows[k].bias, bodies[links[k].body1],
//         bodies[links[k].body2])); for (int
// change: row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2) ==> once[k]

// ---- wrong: nothing without links
// expects: Likely mistake: where there are no links the positions do not change
// change: std::vector ==> if (links.empty()) return; std::vector

// ---- wrong: bodies turn, too
// expects: Likely mistake: the step turns the body
// change: for (Body& body : bodies) body.x += settings.h * body.v; ==> for (Body& body : bodies) {
//         body.x += settings.h * body.v; body.q = normalize(rotation(settings.h * body.w) *
//         body.q); }

// ---- wrong: rods clamped like ropes
// expects: Likely mistake: a rod is clamped like a rope, but it pushes, too
// change: if (links[k].rope) ==>

// ---- wrong: rods clamped instead of ropes
// expects: Likely mistake: a rod is clamped like a rope, but it pushes, too
// change: if (links ==> if (!links

// ---- wrong: row copied in the loop
// tests: 1.5
// expects: Likely mistake: the sum of a rope begins at 0 in every iteration
// change: real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2); ==> LinkRow
//         row = rows[k]; real lambda = row_impulse(row.J, row.K, row.bias, body1, body2); if
//         (links[k].rope) lambda = clamp_sum(lambda, row.sum);
// change: if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum); ==>

// ---- wrong: set_up in the loop
// tests: 1.5
// expects: Likely mistake: the sum of a rope begins at 0 in every iteration
// change: real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2); ==> LinkRow
//         row = set_up(links[k], bodies, settings); real lambda = row_impulse(row.J, row.K,
//         row.bias, body1, body2); if (links[k].rope) lambda = clamp_sum(lambda, row.sum);
// change: if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum); ==>

// ---- wrong: sum of its own
// tests: 1.5
// expects: Likely mistake: the sum of a rope begins at 0 in every iteration
// change: if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum); ==> real sum = 0; if
//         (links[k].rope) lambda = clamp_sum(lambda, sum);

// ---- wrong: each impulse of a rope clamped
// tests: 1.5
// expects: Likely mistake: the sum of a rope begins at 0 in every iteration
// change: clamp_sum(lambda, rows[k].sum ==> glm::max(lambda, real(0)

// ---- wrong: rope not clamped
// tests: 1.5
// expects: Likely mistake: a rope pushes: its impulse is applied as it was asked for.
// change: if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum); ==>

// ---- wrong: result of clamp_sum dropped
// tests: 1.5
// expects: Likely mistake: a rope pushes: its impulse is applied as it was asked for.
// change: lambda = clamp_sum ==> clamp_sum

// ---- wrong: clamped after it was applied
// tests: 1.5
// expects: Likely mistake: a rope pushes: its impulse is applied as it was asked for.
  for (Body& body : bodies)
    if (!body.is_static()) body.v += settings.h * settings.gravity;
  std::vector<LinkRow> rows;
  for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
  for (int iteration = 0; iteration < settings.iterations; ++iteration)
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
      real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2);
      apply_impulse(rows[k].J, lambda, body1, body2);
      if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
    }
  for (Body& body : bodies) body.x += settings.h * body.v;

// ---- wrong: one sum for all ropes
// tests: 1.5
// expects: Likely mistake: all ropes share one sum
// change: for (int ==> real sum = 0; for (int
// change: rows[k].sum ==> sum

// ---- wrong: sum of the rope applied
// tests: 1.5
// expects: Likely mistake: the sum of the rope is applied
// change: apply_impulse(rows ==> if (links[k].rope) lambda = rows[k].sum; apply_impulse(rows

// ---- wrong: sum overwritten
// tests: 1.5
// expects: Likely mistake: the sum is overwritten by what clamp_sum returns
// change: clamp_sum ==> rows[k].sum = clamp_sum

// ---- wrong: clamped twice
// tests: 1.5
// expects: Likely mistake: clamp_sum is called twice
// change: apply_impulse(rows ==> if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
//         apply_impulse(rows

// ---- wrong: sign of a rope
// tests: 1.5
// expects: Likely mistake: the sign of a rope's impulse
// change: clamp_sum( ==> -clamp_sum(-

// ---- wrong: slack ropes left out
// tests: 1.5
// expects: Likely mistake: a slack rope is left out
// change: real lambda ==> if (links[k].rope && rows[k].bias > 0) continue; real lambda

// ---- wrong: ropes left out
// tests: 1.5
// expects: Likely mistake: ropes are left out
// change: real lambda ==> if (links[k].rope) continue; real lambda

// ---- wrong: only walls fall
// expects: Likely mistake: gravity moves static bodies and no others
// change: ! ==>

// ---- wrong: rows behind empty ones
// expects: Likely mistake: no impulse was applied.
// change: rows; ==> rows(links.size());

// ---- wrong: only the y of gravity, from the last link
// expects: Likely mistake: only the y of gravity acts
// change: += settings.h * settings.gravity ==> .y += settings.h * settings.gravity.y
// change: 0; k < links.size(); ++k ==> links.size(); k-- > 0;

// ---- wrong: fixed number of iterations, from the last link
// expects: Likely mistake: a fixed number of iterations, 20
// change: settings.iterations ==> 20
// change: 0; k < links.size(); ++k ==> links.size(); k-- > 0;

// ---- wrong: impulse as a whole number
// expects: Likely mistake: the fraction of lambda is cut off
// change: real ==> int

// ---- wrong: impulse as a float
// expects: Likely mistake: right to a few digits only: is there a float among the reals
// change: real ==> float

// ---- right: in one loop
// tests: 1.5
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

// ---- right: from the last link to the first
// tests: 1.5
// Gauss-Seidel may solve the links in any order.
// change: 0; k < links.size(); ++k ==> links.size(); k-- > 0;

// ---- right: to and fro
// tests: 1.5
// change: for (std::size_t k = 0; k < links.size(); ++k) { ==> for (std::size_t n = 0; n <
//         links.size(); ++n) { const std::size_t k = iteration % 2 ? links.size() - 1 - n : n;

// ---- right: a reference to the row
// tests: 1.5
// change: real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2); ==> LinkRow&
//         row = rows[k]; real lambda = row_impulse(row.J, row.K, row.bias, body1, body2); if
//         (links[k].rope) lambda = clamp_sum(lambda, row.sum);
// change: if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum); ==>

// ---- right: impulses of 0 left out
// tests: 1.5
// change: apply_impulse(rows ==> if (lambda == 0) continue; apply_impulse(rows

// ---- wrong units: acceleration for velocity
// expects: Units: in the step, adding m/s^2 to m/s: h is missing
  for (Body& body : bodies)
    if (!body.is_static()) body.v += settings.gravity;

// ---- wrong units: error for bias
// expects: Units: in the step, adding m to m/s: a time too many: is a division by h missing?
  for (const Link& link : links) {
    Body &body1 = bodies[link.body1], &body2 = bodies[link.body2];
    const LinkRow row = set_up(link, bodies, settings);
    const real C = CentreDistance{link.length}.error(body1, body2);
    apply_impulse(row.J, row_impulse(row.J, row.K, C, body1, body2), body1, body2);
  }
