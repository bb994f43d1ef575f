// Known answers of exercise 4.3, each put in the place of the solution's.

// ---- wrong: J axis in body space in the turns
// region: 2
// expects: Likely mistake: a direction of body 1 is not turned into the world (turned, moved,
// expects: broken)
// change: u, a ==> u, a1_local
// change: r2, a ==> r2, a1_local

// ---- wrong: J crosses reversed
// region: 2
// expects: Likely mistake: the sign of the blocks w1 and w2: a x b is -(b x a) (pencil and paper,
// expects: upright, turned, moved, broken)
// change: r1 + u, a ==> a, r1 + u
// change: r2, a ==> a, r2

// ---- wrong: J lever of x2 - x1
// region: 2
// expects: Likely mistake: centres in place of anchors: u is p2 - p1 (pencil and paper, upright,
// expects: turned, moved, broken)
// change: r1 = to_world(body1, anchor1_local), ==>
// change: r1 + u ==> body2.x - body1.x

// ---- wrong: J no w2
// region: 2
// expects: Likely mistake: the block w2 is missing (pencil and paper, upright, turned, moved,
// expects: broken)
  const vec3 a = to_world(body1, a1_local), r1 = to_world(body1, anchor1_local);
  return {-a, -cross(r1 + u, a), a, vec3(0)};

// ---- wrong: J normalize u
// region: 2
// expects: Likely mistake: the unit vector along u in the place of a: the row runs along a (pencil
// expects: and paper, upright, turned, moved, broken)
// change: to_world(body1, a1_local) ==> normalize(u)
// change: + u ==>

// ---- wrong: J order
// region: 2
// expects: Likely mistake: the order of the blocks: a row is {v1, w1, v2, w2} (pencil and paper,
// expects: upright, turned, moved, broken)
// change: -a ==> -a, a
// change: a, cross ==> cross

// ---- wrong: J r1 + u for r2
// region: 2
// expects: Likely mistake: the lever of body 1 for both bodies: each has its own (pencil and paper,
// expects: upright, turned, moved, broken)
// change: r2, ==> r1 + u,

// ---- wrong: J r2 for r1
// region: 2
// expects: Likely mistake: the lever of body 1 is r1 + u, not r2 + u (pencil and paper, upright,
// expects: turned, moved, broken)
// change: r1 + ==> r2 +

// ---- wrong: J r2 local
// region: 2
// expects: Likely mistake: body-space lever: the lever of body 2 is not turned into the world
// expects: (pencil and paper, upright, turned, moved, broken)
  const vec3 a = to_world(body1, a1_local), r1 = to_world(body1, anchor1_local), r2 = anchor2_local;
  return {-a, -cross(r1 + u, a), a, cross(r2, a)};

// ---- wrong: J u on body 2
// region: 2
// expects: Likely mistake: u belongs to the lever of body 1: a rides on body 1 (pencil and paper,
// expects: turned, moved, broken)
// change: + u ==>
// change: r2, ==> r2 + u,

// ---- wrong: J unset
// region: 2
// expects: Likely mistake: a value that was never set
  Row row;
  real f;
  f += 1;
  const vec3 a = to_world(body1, a1_local) * f;
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  return {-a, -cross(r1 + u, a), a, cross(r2, a)};

// ---- wrong: J w1 sign
// region: 2
// expects: Likely mistake: the sign of the block w1 (pencil and paper, upright, turned, moved,
// expects: broken)
// change: -cross ==> cross

// ---- wrong: as printed
// region: 2
// expects: Likely mistake: levers are missing: such a row drives the centres, not the points, and
// expects: its sign is wrong as well (upright, turned, moved, broken)
  const vec3 a = to_world(body1, a1_local);
  return {a, vec3(0), -a, vec3(0)};

// ---- wrong: axis in body space
// region: 2
// expects: Likely mistake: a is left in body space: turn it into the world with body 1 (turned,
// expects: moved, broken)
// change: to_world(body1, a1_local) ==> a1_local

// ---- wrong: u forgotten
// region: 2
// expects: Likely mistake: u is forgotten, the lever of body 1 is r1 + u, because a rides on body 1
// expects: (turned, moved, broken)
// change: + u ==>

// ---- wrong: displacement abs
// expects: Likely mistake: the displacement has a sign: it is negative behind the start
  return std::abs(dot(u, to_world(body1, a1_local)));

// ---- wrong: displacement clamp 0
// expects: Likely mistake: what is negative has become 0
  return std::max(real(0), dot(u, to_world(body1, a1_local)));

// ---- wrong: displacement cosine
// expects: Likely mistake: u is not made a unit vector: its length counts
  return dot(normalize(u), to_world(body1, a1_local));

// ---- wrong: displacement from centre to centre
// expects: Likely mistake: centres in place of anchors: u is p2 - p1
  return dot(body2.x - body1.x, to_world(body1, a1_local));

// ---- wrong: displacement from p1 to x2
// expects: Likely mistake: the anchor of body 2 is forgotten: u is p2 - p1
  return dot(body2.x - world_point(body1, anchor1_local), to_world(body1, a1_local));

// ---- wrong: displacement int
// expects: Likely mistake: the fraction is cut off: an int holds whole numbers only
  const int displacement = dot(u, to_world(body1, a1_local));
  return displacement;

// ---- wrong: displacement length
// expects: Likely mistake: the length of u: only its part along a counts
  return length(u);

// ---- wrong: displacement squared
// expects: Likely mistake: the square: the dot product of u and a itself
  const real d = dot(u, to_world(body1, a1_local));
  return d * d;

// ---- wrong: displacement threshold
// expects: Likely mistake: what is small has become 0: no threshold belongs here
  const real displacement = dot(u, to_world(body1, a1_local));
  return std::abs(displacement) < 0.2 ? 0 : displacement;

// ---- wrong: displacement unset
// expects: Likely mistake: a value that was never set
  real displacement;
  const vec3 a = to_world(body1, a1_local);
  for (int k = 0; k < 3; ++k) displacement += u[k] * a[k];
  return displacement;

// ---- wrong: displacement world_point
// expects: Likely mistake: a is a direction, not a point: to_world, not world_point
  return dot(u, world_point(body1, a1_local));

// ---- wrong: without levers
// region: 2
// expects: Likely mistake: levers are missing: such a row drives the centres, not the points
// expects: (upright, turned, moved, broken)
// expects: Likely mistake: levers are missing, or are points: push and answer act along two lines
  const vec3 a = to_world(body1, a1_local);
  return {-a, vec3(0), a, vec3(0)};

// ---- right: J from the balance of momentum
// region: 2
  const vec3 a = to_world(body1, a1_local), r2 = to_world(body2, anchor2_local);
  const vec3 w2 = cross(r2, a);
  return {-a, -(cross(body2.x - body1.x, a) + w2), a, w2};

// ---- right: J with the part of u across
// region: 2
// change: return ==> const vec3 across = u - dot(u, a) * a; return
// change: + u ==> + across

// ---- right: lever to the point of body 2
// region: 2
// Push and answer both act at the point of body 2.
  const vec3 a = to_world(body1, a1_local), p2 = world_point(body2, anchor2_local);
  return {-a, -cross(p2 - body1.x, a), a, cross(p2 - body2.x, a)};

// ---- right: displacement in axes of body 1
// The displacement is the same number, seen from body 1.
  return dot(to_local(body1, u), a1_local);
