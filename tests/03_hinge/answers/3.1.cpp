// Known answers of exercise 3.1, each put in the place of the solution's.

// ---- wrong: C 1 - cos
// expects: Likely mistake: 1 minus the cosine: the vectors are at right angles, so a1.b itself is 0
  const vec3 a1 = to_world(body1, a1_local);
  const vec3 b = to_world(body2, b_local), c = to_world(body2, c_local);
  return {1 - dot(a1, b), 1 - dot(a1, c)};

// ---- wrong: C absolute values
// expects: Likely mistake: an absolute value: the sign is lost
  const vec3 a1 = to_world(body1, a1_local);
  return {std::abs(dot(a1, to_world(body2, b_local))), std::abs(dot(a1, to_world(body2, c_local)))};

// ---- wrong: C all turned with body 1
// expects: Likely mistake: nothing is turned, or all by the same body: a1 rides on body 1, b and c
// expects: on body 2
  const vec3 a1 = to_world(body1, a1_local);
  return {dot(a1, to_world(body1, b_local)), dot(a1, to_world(body1, c_local))};

// ---- wrong: C b twice
// expects: Likely mistake: the first number stands in both places
// change: c_local ==> b_local

// ---- wrong: C body space b and c
// expects: Likely mistake: b_local and c_local are not turned into the world
  const vec3 a1 = to_world(body1, a1_local);
  return {dot(a1, b_local), dot(a1, c_local)};

// ---- wrong: C c not turned
// expects: Likely mistake: in C.c alone: b_local and c_local are not turned into the world
// change: to_world(body2, c_local) ==> c_local

// ---- wrong: C cross product of the axes
// expects: Likely mistake: the cross product of the axes: that holds a1.c and -(a1.b)
// change: return {dot(a1, to_world(body2, b_local)), dot(a1, to_world(body2, c_local))} ==>
//         const vec3 b = to_world(body2, b_local), c = to_world(body2, c_local); const vec3 across
//         = cross(a1, cross(b, c)); return {dot(across, b), dot(across, c)}

// ---- wrong: C int
// expects: Likely mistake: 0 in every case: it is never written, or cut off by an int, or a2 stands
// expects: in the place of a1 (a2 is at right angles to its own b and c)
  const vec3 a1 = to_world(body1, a1_local);
  const int first = dot(a1, to_world(body2, b_local)), second = dot(a1, to_world(body2, c_local));
  return {real(first), real(second)};

// ---- wrong: C its own axis
// expects: Likely mistake: 0 in every case: it is never written, or cut off by an int, or a2 stands
// expects: in the place of a1 (a2 is at right angles to its own b and c)
  const vec3 b = to_world(body2, b_local), c = to_world(body2, c_local);
  const vec3 a2 = cross(b, c);
  return {dot(a2, b), dot(a2, c)};

// ---- wrong: C of points
// expects: Likely mistake: a point where a direction belongs: to_world, not world_point
  const vec3 a1 = world_point(body1, a1_local);
  return {dot(a1, world_point(body2, b_local)), dot(a1, world_point(body2, c_local))};

// ---- wrong: C one sign
// expects: Likely mistake: in C.c alone: the sign of C
// change: , dot ==> , - dot

// ---- wrong: C second missing
// expects: Likely mistake: in C.c alone: 0 in every case: it is never written, or cut off by an
// expects: int, or a2 stands in the place of a1 (a2 is at right angles to its own b and c)
// change: , dot(a1, to_world(body2, c_local)) ==>

// ---- wrong: C unset second
// expects: Likely mistake: a value that was never set
  const vec3 a1 = to_world(body1, a1_local);
  Vector<2> C;
  C[0] = dot(a1, to_world(body2, b_local));
  return C;

// ---- wrong: C unset sum
// expects: Likely mistake: a value that was never set
// change: return {dot(a1, to_world(body2, b_local)), dot(a1, to_world(body2, c_local))} ==>
//         const vec3 b = to_world(body2, b_local), c = to_world(body2, c_local); Vector<2> C; for
//         (int i = 0; i < 3; ++i) { C[0] += a1[i] * b[i]; C[1] += a1[i] * c[i]; } return C

// ---- wrong: C written twice
// expects: Likely mistake: the first number is written twice, the second never
// change: return {dot(a1, to_world(body2, b_local)), dot(a1, to_world(body2, c_local))}; ==>
//         Vector<2> C{}; C[0] = dot(a1, to_world(body2, b_local)); C[0] = dot(a1, to_world(body2,
//         c_local)); return C;

// ---- wrong: J a copied block
// region: 2
// expects: Likely mistake: w1 of J[1] is that of J[0] (pencil and paper, upright, turned, moved,
// expects: broken)
// change: c, ==> b,

// ---- wrong: J axis of body 2
// region: 2
// expects: Likely mistake: a2 in the place of a1: b x a1, not b x a2
// expects: Fails at broken; holds at upright, turned and moved.
// expects: Likely mistake: a2 in the place of a1: b x a1, not b x a2 (broken)
  Jacobian<2> J;
  J[0] = {vec3(0), c, vec3(0), -c};
  J[1] = {vec3(0), -b, vec3(0), b};
  return J;

// ---- wrong: J b x c
// region: 2
// expects: Likely mistake: b x c: that is a2. The rows hold b x a1 and c x a1 (pencil and paper,
// expects: upright, turned, moved, broken)
  return {{Row{vec3(0), -cross(b, c), vec3(0), cross(b, c)},
           Row{vec3(0), -cross(c, b), vec3(0), cross(c, b)}}};

// ---- wrong: J body space b and c
// region: 2
// expects: Likely mistake: b_local and c_local are not turned into the world: take b and c above
// expects: (upright, turned, moved, broken)
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(b_local, a1), vec3(0), cross(b_local, a1)};
  J[1] = {vec3(0), -cross(c_local, a1), vec3(0), cross(c_local, a1)};
  return J;

// ---- wrong: J c never used
// region: 2
// expects: Likely mistake: J[1], the row C.c, repeats J[0] (pencil and paper, upright, turned,
// expects: moved, broken)
// change: c, ==> b,
// change: c, ==> b,

// ---- wrong: J first row written twice
// region: 2
// expects: Likely mistake: J[0] is written twice, J[1] never: the row C.c stands in the place of
// expects: C.b
// change: [1] ==> [0]

// ---- wrong: J half
// region: 2
// expects: Likely mistake: a factor of 0.5 (pencil and paper, upright, turned, moved, broken)
  const vec3 p = real(0.5) * cross(b, a1), q = real(0.5) * cross(c, a1);
  return {{Row{vec3(0), -p, vec3(0), p}, Row{vec3(0), -q, vec3(0), q}}};

// ---- wrong: J local a1
// region: 2
// expects: Likely mistake: a1_local is not turned into the world: take a1 above (turned, moved,
// expects: broken)
  const vec3 p = cross(b, a1_local), q = cross(c, a1_local);
  return {{Row{vec3(0), -p, vec3(0), p}, Row{vec3(0), -q, vec3(0), q}}};

// ---- wrong: J loop past the end
// region: 2
// expects: an index outside an array of 2 rows: its places run from 0 to 1
  Jacobian<2> J;
  const vec3 d[2] = {b, c};
  for (int i = 0; i <= 2; ++i) J[i] = {vec3(0), -cross(d[i], a1), vec3(0), cross(d[i], a1)};
  return J;

// ---- wrong: J normalized
// region: 2
// expects: Likely mistake: unit vectors: b x a1 becomes shorter as the axes part (pencil and paper,
// expects: broken)
  const vec3 p = normalize(cross(b, a1)), q = normalize(cross(c, a1));
  return {{Row{vec3(0), -p, vec3(0), p}, Row{vec3(0), -q, vec3(0), q}}};

// ---- wrong: J of the nearer half only
// region: 2
// expects: Likely mistake: take a1 as it stands above: beyond 60 degrees it holds body 2's axis
  const vec3 axis = to_world(body1, a1_local);
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(b, axis), vec3(0), cross(b, axis)};
  J[1] = {vec3(0), -cross(c, axis), vec3(0), cross(c, axis)};
  return J;

// ---- wrong: J one row only
// region: 2
// expects: Likely mistake: J[1], the row C.c, is zero: was it never written? (pencil and paper,
// expects: upright, turned, moved, broken)
// change: J[1] = {vec3(0), -cross(c, a1), vec3(0), cross(c, a1)}; ==>

// ---- wrong: J order of blocks
// region: 2
// expects: Likely mistake: the order of the blocks: a row is {v1, w1, v2, w2} (pencil and paper,
// expects: upright, turned, moved, broken)
  Jacobian<2> J;
  J[0] = {vec3(0), vec3(0), -cross(b, a1), cross(b, a1)};
  J[1] = {vec3(0), vec3(0), -cross(c, a1), cross(c, a1)};
  return J;

// ---- wrong: J order of the cross products
// region: 2
// expects: Likely mistake: the sign of the whole row: b x a1, not a1 x b; or bodies 1 and 2 swapped
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(a1, b), vec3(0), cross(a1, b)};
  J[1] = {vec3(0), -cross(a1, c), vec3(0), cross(a1, c)};
  return J;

// ---- wrong: J row b's w2 sign
// region: 2
// expects: Likely mistake: in C.b alone: the sign of the block w2 (pencil and paper, upright,
// expects: turned, moved, broken)
  const vec3 p = cross(b, a1), q = cross(c, a1);
  return {{Row{vec3(0), -p, vec3(0), -p}, Row{vec3(0), -q, vec3(0), q}}};

// ---- wrong: J rows exchanged
// region: 2
// expects: Likely mistake: the rows C.b and C.c are exchanged (pencil and paper, upright, turned,
// expects: moved, broken)
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(c, a1), vec3(0), cross(c, a1)};
  J[1] = {vec3(0), -cross(b, a1), vec3(0), cross(b, a1)};
  return J;

// ---- wrong: J sign of body 1
// region: 2
// expects: Likely mistake: the sign of the block w1 (pencil and paper, upright, turned, moved,
// expects: broken)
// change: -cross ==> cross
// change: -cross ==> cross

// ---- wrong: J sign of one row
// region: 2
// expects: Likely mistake: in one row alone: the sign of the whole row: b x a1, not a1 x b; or
// expects: bodies 1 and 2 swapped (pencil and paper, upright, turned, moved, broken)
  Jacobian<2> J;
  J[0] = {vec3(0), -cross(b, a1), vec3(0), cross(b, a1)};
  J[1] = {vec3(0), cross(c, a1), vec3(0), -cross(c, a1)};
  return J;

// ---- wrong: J static body left out
// region: 2
// expects: Likely mistake: a static body has its blocks in J, too: it is K that its mass leaves out
// expects: (pencil and paper)
  Jacobian<2> J;
  const real one = body1.is_static() ? 0 : 1;
  J[0] = {vec3(0), -one * cross(b, a1), vec3(0), cross(b, a1)};
  J[1] = {vec3(0), -one * cross(c, a1), vec3(0), cross(c, a1)};
  return J;

// ---- wrong: J unset vector
// region: 2
// expects: Likely mistake: a value that was never set
  real k;
  Jacobian<2> J;
  for (int i = 0; i < 3; ++i) k += b[i] * a1[i];
  J[0] = {vec3(0), -cross(b, a1) * k, vec3(0), cross(b, a1)};
  J[1] = {vec3(0), -cross(c, a1), vec3(0), cross(c, a1)};
  return J;

// ---- wrong: J v and w exchanged
// region: 2
// expects: Likely mistake: the cross products stand in v1 and v2: they belong to w1 and
// expects: w2 (pencil and paper, upright, turned, moved, broken)
  Jacobian<2> J;
  J[0] = {-cross(b, a1), vec3(0), cross(b, a1), vec3(0)};
  J[1] = {-cross(c, a1), vec3(0), cross(c, a1), vec3(0)};
  return J;

// ---- wrong: J w1 missing
// region: 2
// expects: Likely mistake: the block w1 is missing (pencil and paper, upright, turned, moved,
// expects: broken)
// change: -cross(b, a1) ==> vec3(0)
// change: -cross(c, a1) ==> vec3(0)

// ---- right: C in the axes of body 1
  const quat q = conjugate(body1.q) * body2.q;
  return {dot(a1_local, q * b_local), dot(a1_local, q * c_local)};

// ---- right: C in the axes of body 2
// The same products in body 2's own axes: a1 goes there, b and c stay.
  const vec3 a1 = to_local(body2, to_world(body1, a1_local));
  return {dot(a1, b_local), dot(a1, c_local)};

// ---- right: C with matrices
  const mat3 R1 = glm::mat3_cast(body1.q), R2 = glm::mat3_cast(body2.q);
  return {dot(R1 * a1_local, R2 * b_local), dot(R1 * a1_local, R2 * c_local)};

// ---- right: J about a turned b
// region: 2
// The rows may start as those of any other pair at right angles, here halfway between b and c: what
// counts is that they are turned back to b and c.
  const real s = std::sqrt(real(0.5));
  const vec3 p = cross(s * (b + c), a1), q = cross(s * (c - b), a1);
  const vec3 first = s * (p - q), second = s * (p + q);
  return {{Row{vec3(0), -first, vec3(0), first}, Row{vec3(0), -second, vec3(0), second}}};

// ---- right: J by components
// region: 2
  Jacobian<2> J;
  const vec3 d[2] = {b, c};
  for (int i = 0; i < 2; ++i) {
    J[i].w2.x = d[i].y * a1.z - d[i].z * a1.y;
    J[i].w2.y = d[i].z * a1.x - d[i].x * a1.z;
    J[i].w2.z = d[i].x * a1.y - d[i].y * a1.x;
    J[i].w1 = -J[i].w2;
  }
  return J;

// ---- right: J with a matrix
// region: 2
// b x a1 = -(a1 x b): the matrix of a1 with a minus.
  const vec3 first = -skew(a1) * b, second = -skew(a1) * c;
  return {{Row{vec3(0), -first, vec3(0), first}, Row{vec3(0), -second, vec3(0), second}}};

// ---- right: J with a1 x b and the other signs
// region: 2
  Jacobian<2> J;
  J[0] = {vec3(0), cross(a1, b), vec3(0), -cross(a1, b)};
  J[1] = {vec3(0), cross(a1, c), vec3(0), -cross(a1, c)};
  return J;
