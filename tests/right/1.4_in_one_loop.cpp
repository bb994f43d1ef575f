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
