// Known answers of exercise 3.1, each put in the place of the solution's.

// ---- wrong: C body space b and c
// expects: Likely mistake: b_local and c_local are not turned into the world
  const vec3 a1 = to_world(body1, a1_local);
  return {dot(a1, b_local), dot(a1, c_local)};

// ---- wrong: C cross product of the axes
// expects: Likely mistake: the cross product of the axes: that holds a1.c and -(a1.b)
  const vec3 a1 = to_world(body1, a1_local);
  const vec3 b = to_world(body2, b_local), c = to_world(body2, c_local);
  const vec3 across = cross(a1, cross(b, c));
  return {dot(across, b), dot(across, c)};

// ---- wrong: C its own axis
// expects: Likely mistake: a2 with its own b and c is always 0: take a1, the axis of body 1
  const vec3 b = to_world(body2, b_local), c = to_world(body2, c_local);
  const vec3 a2 = cross(b, c);
  return {dot(a2, b), dot(a2, c)};

// ---- wrong: J axis of body 2
// region: 2
// expects: Likely mistake: a2 in the place of a1: b x a1, not b x a2
// expects: Fails at broken; holds at upright, turned and moved.
// expects: Likely mistake: a2 in the place of a1: b x a1, not b x a2 (broken)
  Jacobian<2> J;
  J[0] = {vec3(0), c, vec3(0), -c};
  J[1] = {vec3(0), -b, vec3(0), b};
  return J;

// ---- wrong: J body space b and c
// region: 2
// expects: Likely mistake: c_local is not turned into the world: take c above
// expects: Likely mistake: b_local and c_local are not turned into the world: take b and c above
// expects: (upright, turned, moved, broken)
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(b_local, a1), vec3(0), cross(b_local, a1)};
  J[1] = {vec3(0), -cross(c_local, a1), vec3(0), cross(c_local, a1)};
  return J;

// ---- wrong: J of the nearer half only
// region: 2
// expects: Likely mistake: take a1 as it stands above: beyond 60 degrees it holds body 2's axis
  const vec3 axis = to_world(body1, a1_local);
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(b, axis), vec3(0), cross(b, axis)};
  J[1] = {vec3(0), -cross(c, axis), vec3(0), cross(c, axis)};
  return J;

// ---- wrong: J order of the cross products
// region: 2
// expects: Likely mistake: the sign: b x a1, not a1 x b. Or the signs of the bodies exchanged
// expects: Likely mistake: the sign of the whole row, or bodies 1 and 2 swapped (upright, turned,
// expects: moved, broken)
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(a1, b), vec3(0), cross(a1, b)};
  J[1] = {vec3(0), -cross(a1, c), vec3(0), cross(a1, c)};
  return J;

// ---- wrong: J sign of body 1
// region: 2
// expects: Likely mistake: the sign: body 1 carries the minus
// expects: Likely mistake: the sign of the block w1 (upright, turned, moved, broken)
  Jacobian<2> J;
  J[0] = {vec3(0), cross(b, a1), vec3(0), cross(b, a1)};
  J[1] = {vec3(0), cross(c, a1), vec3(0), cross(c, a1)};
  return J;

// ---- wrong: first row written twice
// region: 2
// expects: Likely mistake: the two rows are exchanged
// expects: J[0] is written twice
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(b, a1), vec3(0), cross(b, a1)};
  J[0] = {vec3(0), -cross(c, a1), vec3(0), cross(c, a1)};
  return J;

// ---- right: C in the axes of body 2
// The same products in body 2's own axes: a1 goes there, b and c stay.
  const vec3 a1 = to_local(body2, to_world(body1, a1_local));
  return {dot(a1, b_local), dot(a1, c_local)};

// ---- right: J about a turned b
// region: 2
// The rows may start as those of any other pair at right angles, here halfway between b and c: what
// counts is that they are turned back to b and c.
  const real s = std::sqrt(real(0.5));
  const vec3 p = cross(s * (b + c), a1), q = cross(s * (c - b), a1);
  const vec3 first = s * (p - q), second = s * (p + q);
  return {{Row{vec3(0), -first, vec3(0), first}, Row{vec3(0), -second, vec3(0), second}}};

// ---- right: J with a matrix
// region: 2
// b x a1 = -(a1 x b): the matrix of a1 with a minus.
  const vec3 first = -skew(a1) * b, second = -skew(a1) * c;
  return {{Row{vec3(0), -first, vec3(0), first}, Row{vec3(0), -second, vec3(0), second}}};
