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
