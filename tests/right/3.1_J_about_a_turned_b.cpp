// region: 2
// The rows may start as those of any other pair at right angles, here halfway between b and c: what
// counts is that they are turned back to b and c.
  const real s = std::sqrt(real(0.5));
  const vec3 p = cross(s * (b + c), a1), q = cross(s * (c - b), a1);
  const vec3 first = s * (p - q), second = s * (p + q);
  return {{Row{vec3(0), -first, vec3(0), first}, Row{vec3(0), -second, vec3(0), second}}};
