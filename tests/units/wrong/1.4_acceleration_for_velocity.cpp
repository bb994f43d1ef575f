// expects: Units: in the step, adding m/s^2 to m/s: h is missing
  for (Body& body : bodies)
    if (!body.is_static()) body.v += settings.gravity;
