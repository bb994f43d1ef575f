// expects: Likely mistake: the share of body 1 is missing
  return -skew(to_world(body2, point.anchor2_local)) * inverse_inertia(body2);
