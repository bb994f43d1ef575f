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

// ---- wrong: inverse masses subtracted
// expects: Likely mistake: the sign of body 2's share
  return body1.inverse_mass - body2.inverse_mass;

// ---- wrong: inverse masses multiplied
// expects: Likely mistake: the inverse masses are multiplied: they are added
  return body1.inverse_mass * body2.inverse_mass;

// ---- wrong: body 1 twice
// expects: Likely mistake: the inverse mass of body 1 for both bodies
  return body1.inverse_mass + body1.inverse_mass;

// ---- wrong: body 2 alone
// expects: Likely mistake: body 1 is missing
  return body2.inverse_mass;

// ---- wrong: half of the sum
// expects: Likely mistake: a factor of 0.5
  return (body1.inverse_mass + body2.inverse_mass) / 2;

// ---- wrong: times the length
// expects: Likely mistake: times the length of the rod
  return (body1.inverse_mass + body2.inverse_mass) * length;

// ---- wrong: squared distance
// expects: Likely mistake: not a unit vector
  const vec3 u = body2.x - body1.x;
  return (body1.inverse_mass + body2.inverse_mass) * dot(u, u);

// ---- wrong: times the error
// expects: Likely mistake: times the error: K knows no error
  return error(body1, body2) * (body1.inverse_mass + body2.inverse_mass);

// ---- wrong: squares of the inverse masses
// expects: Likely mistake: the inverse masses are squared
  return body1.inverse_mass * body1.inverse_mass + body2.inverse_mass * body2.inverse_mass;

// ---- wrong: the larger one
// expects: Likely mistake: the larger inverse mass alone
  return glm::max(body1.inverse_mass, body2.inverse_mass);

// ---- wrong: nothing beside a wall
// expects: Likely mistake: K is 0 only where both bodies are static
// change: return body1 ==> if (body1.is_static() || body2.is_static()) return 0; return body1

// ---- wrong: one between two walls
// expects: Likely mistake: between two walls K is 0, and stays so
// change: return body1 ==> if (body1.is_static() && body2.is_static()) return 1; return body1

// ---- wrong: a sum that was never set
// expects: Likely mistake: a value that was never set
  real k;
  k += body1.inverse_mass + body2.inverse_mass;
  return k;

// ---- wrong: always one
// expects: Likely mistake: K is 1 always
  return 1;

// ---- wrong: whole number
// expects: Likely mistake: the fraction is cut off
  const int k = int(body1.inverse_mass + body2.inverse_mass);
  return real(k);

// ---- right: with the square of a unit vector
// n.n = 1 may be written out, as long as K stays finite where there is no direction.
  const vec3 n = direction(body2.x - body1.x);
  if (n == vec3(0)) return body1.inverse_mass + body2.inverse_mass;
  return body1.inverse_mass * dot(n, n) + body2.inverse_mass * dot(n, n);

// ---- right: nothing where there is no direction
// The row is 0 there, so that K may be 0, too.
  if (body1.x == body2.x) return 0;
  return body1.inverse_mass + body2.inverse_mass;

// ---- wrong units: masses added
// expects: Units: K is in kg and should be in 1/kg: a mass where an inverse mass belongs
  return 1 / body1.inverse_mass + 1 / body2.inverse_mass;  // the thesis' m1 + m2 (E19)
