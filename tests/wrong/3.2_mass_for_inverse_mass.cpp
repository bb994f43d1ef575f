// expects: Likely mistake: masses where inverse masses belong: M^-1 divides by the mass
  const auto mass = [](const Body& body) {
    return body.is_static() ? real(0) : 1 / body.inverse_mass;
  };
  return mass(body1) * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         mass(body2) * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
