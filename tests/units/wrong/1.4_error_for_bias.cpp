// expects: Units: in the step, adding m to m/s: a time too many: is a division by h missing?
  for (const Link& link : links) {
    Body &body1 = bodies[link.body1], &body2 = bodies[link.body2];
    const LinkRow row = set_up(link, bodies, settings);
    const real C = CentreDistance{link.length}.error(body1, body2);
    apply_impulse(row.J, row_impulse(row.J, row.K, C, body1, body2), body1, body2);
  }
