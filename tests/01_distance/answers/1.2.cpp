// Known answers of exercise 1.2, each put in the place of the solution's.

// ---- wrong: effective mass
// expects: Likely mistake: the inverse of K: that is the effective mass, the solver inverts K
// expects: itself (upright, turned, moved, broken)
  return 1 / (body1.inverse_mass + body2.inverse_mass);

// ---- wrong: masses added
// expects: Likely mistake: masses where inverse masses belong: K is in 1/kg
// expects: Likely mistake: masses where inverse masses belong: K is in 1/kg (upright, turned,
// expects: moved, broken)
  return 1 / body1.inverse_mass + 1 / body2.inverse_mass;  // the thesis' m1 + m2 (E19)

// ---- wrong: one over the whole mass
// expects: Likely mistake: one over the sum of the masses: each mass is inverted first, then they
// expects: are added (upright, turned, moved, broken)
  return 1 / (1 / body1.inverse_mass + 1 / body2.inverse_mass);

// ---- right: with the square of a unit vector
// n.n = 1 may be written out, as long as K stays finite where there is no direction.
  const vec3 n = direction(body2.x - body1.x);
  if (n == vec3(0)) return body1.inverse_mass + body2.inverse_mass;
  return body1.inverse_mass * dot(n, n) + body2.inverse_mass * dot(n, n);

// ---- wrong units: masses added
// expects: Units: K is in kg and should be in 1/kg: a mass where an inverse mass belongs
  return 1 / body1.inverse_mass + 1 / body2.inverse_mass;  // the thesis' m1 + m2 (E19)
