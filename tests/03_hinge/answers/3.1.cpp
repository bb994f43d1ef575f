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
// expects: Likely mistake: 0 in every case: it is never written, or cut off by an int, or a2 stands
// expects: in the place of a1 (a2 is at right angles to its own b and c)
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
// expects: Likely mistake: the sign of the whole row: b x a1, not a1 x b; or bodies 1 and 2 swapped
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(a1, b), vec3(0), cross(a1, b)};
  J[1] = {vec3(0), -cross(a1, c), vec3(0), cross(a1, c)};
  return J;

// ---- wrong: J sign of body 1
// region: 2
// expects: Likely mistake: the sign of the block w1 (pencil and paper, upright, turned, moved,
// expects: broken)
  Jacobian<2> J;
  J[0] = {vec3(0), cross(b, a1), vec3(0), cross(b, a1)};
  J[1] = {vec3(0), cross(c, a1), vec3(0), cross(c, a1)};
  return J;

// ---- wrong: first row written twice
// region: 2
// expects: Likely mistake: J[0] is written twice, J[1] never: the row C.c stands in the place of C.b
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
