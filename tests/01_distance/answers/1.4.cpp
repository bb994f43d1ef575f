// Known answers of exercise 1.4, each put in the place of the solution's.

// ---- wrong: forces after the rows
// expects: Likely mistake: forces after the rows: the rods cannot answer to gravity any more
// expects: Likely mistake: forces after the rows: the rod gives way
  std::vector<LinkRow> rows;
  for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
  for (int sweep = 0; sweep < settings.iterations; ++sweep)
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
  for (int sweep = 0; sweep < settings.iterations; ++sweep)
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
      real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2);
      if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
      apply_impulse(rows[k].J, lambda, body1, body2);
    }
  for (Body& body : bodies) body.x += settings.h * body.v;

// ---- wrong: lambda taken for a force
// expects: Likely mistake: lambda is an impulse, not a force: it is not multiplied by h
  for (Body& body : bodies)
    if (!body.is_static()) body.v += settings.h * settings.gravity;
  std::vector<LinkRow> rows;
  for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
  for (int sweep = 0; sweep < settings.iterations; ++sweep)
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
      real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2);
      if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
      apply_impulse(rows[k].J, settings.h * lambda, body1, body2);
    }
  for (Body& body : bodies) body.x += settings.h * body.v;

// ---- wrong: old velocity moves the places
// expects: Likely mistake: the old velocity moves the body: change v first, then x
// expects: Likely mistake: places before the velocities: the old velocity moves the body
  for (Body& body : bodies) body.x += settings.h * body.v;
  for (Body& body : bodies)
    if (!body.is_static()) body.v += settings.h * settings.gravity;
  std::vector<LinkRow> rows;
  for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
  for (int sweep = 0; sweep < settings.iterations; ++sweep)
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
      real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2);
      if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
      apply_impulse(rows[k].J, lambda, body1, body2);
    }

// ---- wrong: one sweep only
// expects: Likely mistake: only one sweep was done
  for (Body& body : bodies)
    if (!body.is_static()) body.v += settings.h * settings.gravity;
  std::vector<LinkRow> rows;
  for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
  for (std::size_t k = 0; k < links.size(); ++k) {
    Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
    real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2);
    if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
    apply_impulse(rows[k].J, lambda, body1, body2);
  }
  for (Body& body : bodies) body.x += settings.h * body.v;

// ---- wrong: only where there is an error
// expects: Likely mistake: no impulse was applied. A row whose error is 0 is solved all the same,
// expects: for the sake of its velocity
  for (Body& body : bodies)
    if (!body.is_static()) body.v += settings.h * settings.gravity;
  std::vector<LinkRow> rows;
  for (const Link& link : links) rows.push_back(set_up(link, bodies, settings));
  for (int sweep = 0; sweep < settings.iterations; ++sweep)
    for (std::size_t k = 0; k < links.size(); ++k) {
      Body &body1 = bodies[links[k].body1], &body2 = bodies[links[k].body2];
      const real error = length(body2.x - body1.x) - links[k].length;
      if (std::abs(error) <= epsilon) continue;  // the guard of the thesis' listing (E23)
      real lambda = row_impulse(rows[k].J, rows[k].K, rows[k].bias, body1, body2);
      if (links[k].rope) lambda = clamp_sum(lambda, rows[k].sum);
      apply_impulse(rows[k].J, lambda, body1, body2);
    }
  for (Body& body : bodies) body.x += settings.h * body.v;

// ---- right: in one loop
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
