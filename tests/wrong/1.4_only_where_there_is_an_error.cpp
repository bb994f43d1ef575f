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
