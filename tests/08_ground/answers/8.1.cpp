// Known answers of exercise 8.1, each put in the place of the solution's.

// ---- wrong: C corner not turned
// expects: Likely mistake: corner_local is not turned into the world
  const vec3 p = body2.x + corner_local - radius * up(body1);
  return dot(up(body1), p - body1.x) - height;

// ---- wrong: C cut to whole numbers
// expects: Likely mistake: C is 0 everywhere: it is not measured, or cut to a whole number by
// change: return dot ==> const int C = dot
// change: - height; ==> - height; return C;

// ---- wrong: C from centre to centre
// expects: Likely mistake: from centre to centre
  return dot(up(body1), body2.x - body1.x) - height;

// ---- wrong: C height added
// expects: Likely mistake: height is added
  return dot(up(body1), point(body1, body2) - body1.x) + height;

// ---- wrong: C height forgotten
// expects: Likely mistake: height is forgotten
// expects: C, by hand 0.600000 0.100000 0.500000
  return dot(up(body1), point(body1, body2) - body1.x);

// ---- wrong: C height in the world
// expects: Likely mistake: the height of the point in the world
  return point(body1, body2).y - height;

// ---- wrong: C height in the world over a static body
// expects: 1 static
// expects: Likely mistake: over a static body it is measured in the world
// change: return dot ==> if (body1.is_static()) return point(body1, body2).y - height; return dot

// ---- wrong: C height upright
// expects: Likely mistake: height along the y axis of the world
  const vec3 top = body1.x + vec3(0, height, 0);
  return dot(up(body1), point(body1, body2) - top);

// ---- wrong: C in float
// expects: Likely mistake: right to a few digits only: is there a float among the reals
  const float C = dot(up(body1), point(body1, body2) - body1.x) - height;
  return C;

// ---- wrong: C length
// expects: Likely mistake: the length of p - x1: only what is along n counts
  return length(point(body1, body2) - body1.x) - height;

// ---- wrong: C length from the top
// expects: Likely mistake: the distance from the top: only what is along n counts
  return length(point(body1, body2) - body1.x - height * up(body1));

// ---- wrong: C lever of body 2
// expects: Likely mistake: the lever of body 2 in the place of the one of body 1
  return dot(up(body1), point(body1, body2) - body2.x) - height;

// ---- wrong: C n not turned
// expects: Likely mistake: n is not turned: up is the y axis of body 1
  return (point(body1, body2) - body1.x).y - height;

// ---- wrong: C n of body 2
// expects: Likely mistake: n is the axis of body 2
  return dot(up(body2), point(body1, body2) - body1.x) - height;

// ---- wrong: C nothing below
// expects: Likely mistake: nothing below the top
  return std::max(real(0), dot(up(body1), point(body1, body2) - body1.x) - height);

// ---- wrong: C point of body 1
// expects: Likely mistake: point(body2, body1): the other way round, the corner is one of body 2
  return dot(up(body1), point(body2, body1) - body1.x) - height;

// ---- wrong: C radius added
// expects: Likely mistake: the radius is added
  return dot(up(body1), world_point(body2, corner_local) - body1.x) + radius - height;

// ---- wrong: C radius for height
// expects: Likely mistake: the radius in the place of height
// change: - height ==> - radius

// ---- wrong: C radius forgotten
// expects: Likely mistake: the radius is forgotten: the lowest point of the ball counts
// expects: C, ball, upright
  return dot(up(body1), world_point(body2, corner_local) - body1.x) - height;

// ---- wrong: C radius twice
// expects: Likely mistake: the radius is taken away twice
  return dot(up(body1), point(body1, body2) - body1.x) - radius - height;

// ---- wrong: C radius upright
// expects: Likely mistake: the radius along the y axis of the world
  const vec3 lowest = world_point(body2, corner_local) - vec3(0, radius, 0);
  return dot(up(body1), lowest - body1.x) - height;

// ---- wrong: C sign
// expects: Likely mistake: the sign: C is positive above the top
  return height - dot(up(body1), point(body1, body2) - body1.x);

// ---- wrong: C sign of the vector
// expects: Likely mistake: the sign of p - x1: it runs from body 1 to the point
// change: point(body1, body2) - body1.x ==> body1.x - point(body1, body2)

// ---- wrong: C size
// expects: Likely mistake: the size of C: below the top it is negative
  return std::abs(dot(up(body1), point(body1, body2) - body1.x) - height);

// ---- wrong: C turned back
// expects: Likely mistake: n is turned the wrong way round
  return dot(to_local(body1, vec3(0, 1, 0)), point(body1, body2) - body1.x) - height;

// ---- wrong: C two mistakes
// expects: Likely mistake: the radius is forgotten: the lowest point of the ball counts, point();
// expects: and corner_local is not turned into the world
// change: point(body1, body2) - body1.x ==> body2.x + corner_local - body1.x

// ---- wrong: C value never set
// expects: Likely mistake: a value that was never set
  real sum;
  for (int i = 0; i < 3; ++i) sum += up(body1)[i] * (point(body1, body2) - body1.x)[i];
  return sum - height;

// ---- wrong: C world point
// expects: Likely mistake: a world point in the place of p - x1
  return dot(up(body1), point(body1, body2)) - height;

// ---- wrong: C x and y only
// expects: Likely mistake: only x and y count in the dot product: all three do
  real sum = 0;
  for (int i = 0; i < 2; ++i) sum += up(body1)[i] * (point(body1, body2) - body1.x)[i];
  return sum - height;

// ---- wrong: C z axis
// expects: Likely mistake: n is the z axis of body 1: up is its y axis
// change: up(body1) ==> to_world(body1, vec3(0, 0, 1))

// ---- wrong: J always n
// region: 2
// expects: Likely mistake: n in the place of the direction
// expects: along() is asked for other directions, too
// change: return {-direction, -cross(r1, direction), direction, cross(r2, direction)} ==>
//         const vec3 n = up(body1); return {-n, -cross(r1, n), n, cross(r2, n)}

// ---- wrong: J always y
// region: 2
// expects: Likely mistake: the y axis of the world in the place of the direction
// change: return {-direction, -cross(r1, direction), direction, cross(r2, direction)} ==>
//         const vec3 n(0, 1, 0); return {-n, -cross(r1, n), n, cross(r2, n)}

// ---- wrong: J centre of body 2
// region: 2
// expects: Likely mistake: r1 ends at the centre of body 2
  const vec3 r1 = body2.x - body1.x, r2 = point(body1, body2) - body2.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};

// ---- wrong: J corner not turned
// region: 2
// expects: Likely mistake: corner_local is not turned into the world: point() does it
// change: point(body1, body2), ==> body2.x + corner_local - radius * up(body1); const vec3

// ---- wrong: J direction turned back
// region: 2
// expects: Likely mistake: the direction is turned once more: it is given in the world
// change: return {-direction, -cross(r1, direction), direction, cross(r2, direction)} ==>
//         const vec3 d = to_local(body1, direction); return {-d, -cross(r1, d), d, cross(r2, d)}

// ---- wrong: J direction turned once more
// region: 2
// expects: Likely mistake: the direction is turned once more: it is given in the world
// change: return {-direction, -cross(r1, direction), direction, cross(r2, direction)} ==>
//         const vec3 d = to_world(body1, direction); return {-d, -cross(r1, d), d, cross(r2, d)}

// ---- wrong: J entry times entry
// region: 2
// expects: Likely mistake: entry times entry where the cross product belongs, in w2
// change: , cross(r2, direction)} ==> , r2 * direction}

// ---- wrong: J lever to the point below the corner
// region: 2
// expects: Likely mistake: r1 ends on the top, below the corner
// expects: Fails at pencil and paper and off the top; holds at upright, turned and moved.
// change: r1 = p - body1.x, ==>
// change: x; ==> x; const vec3 r1 = p - error(body1, body2) * up(body1) - body1.x;

// ---- wrong: J height taken away
// region: 2
// expects: Likely mistake: height is taken from r1
// change: x, ==> x - height * up(body1),

// ---- wrong: J height taken from both levers
// region: 2
// expects: Likely mistake: height is taken from both levers: they end at point()
// change: p = point(body1, body2) ==> p = point(body1, body2) - height * up(body1)

// ---- wrong: J in float
// region: 2
// expects: Likely mistake: right to a few digits only: is there a float among the reals
  const glm::vec3 r1(point(body1, body2) - body1.x), r2(point(body1, body2) - body2.x);
  const glm::vec3 d(direction);
  return {-direction, -vec3(cross(r1, d)), direction, vec3(cross(r2, d))};

// ---- wrong: J levers exchanged
// region: 2
// expects: Likely mistake: the levers r1 and r2 are exchanged
  const vec3 p = point(body1, body2), r1 = p - body2.x, r2 = p - body1.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};

// ---- wrong: J levers in body axes
// region: 2
// expects: Likely mistake: J is in world axes
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  const vec3 l1 = to_local(body1, r1), l2 = to_local(body2, r2);
  return {-direction, -cross(l1, direction), direction, cross(l2, direction)};

// ---- wrong: J middle of the top
// region: 2
// expects: as if r1 ended in the middle of the top
// expects: Likely mistake: r1 ends in the middle of the top
  const vec3 r1 = height * up(body1), r2 = point(body1, body2) - body2.x;
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};

// ---- wrong: J n for w1
// region: 2
// expects: Likely mistake: n in the place of the direction in w1
// change: -cross(r1, direction) ==> -cross(r1, up(body1))

// ---- wrong: J nothing of a static body
// region: 2
// expects: Likely mistake: beside a static body its blocks are left out
// change: return {-direction ==>
//         if (body1.is_static()) return {vec3(0), vec3(0), direction, cross(r2, direction)};
//         return {-direction

// ---- wrong: J one lever for both
// region: 2
// expects: Likely mistake: the lever of body 1 for both bodies
  const vec3 p = point(body1, body2), r1 = p - body1.x;
  return {-direction, -cross(r1, direction), direction, cross(r1, direction)};

// ---- wrong: J order of the blocks
// region: 2
// expects: Likely mistake: the order of the blocks: a row is {v1, w1, v2, w2}
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, direction, -cross(r1, direction), cross(r2, direction)};

// ---- wrong: J order of the cross products
// region: 2
// expects: Likely mistake: the sign of the blocks w1 and w2
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, -cross(direction, r1), direction, cross(direction, r2)};

// ---- wrong: J point for levers
// region: 2
// expects: Likely mistake: a point where a lever belongs: p - x1 and p - x2, not p itself
  const vec3 p = point(body1, body2);
  return {-direction, -cross(p, direction), direction, cross(p, direction)};

// ---- wrong: J point of body 1
// region: 2
// expects: Likely mistake: point(body2, body1): the other way round, the corner is one of body 2
// change: body1, body2 ==> body2, body1

// ---- wrong: J radius added
// region: 2
// expects: Likely mistake: the sign of the radius
// change: point(body1, body2), ==>
//         world_point(body2, corner_local) + radius * up(body1); const vec3

// ---- wrong: J radius forgotten
// region: 2
// expects: Likely mistake: the radius is forgotten: the levers end at point(), the
// expects: lowest point of the ball
// expects: t1, w1.x
// change: point(body1, body2) ==> world_point(body2, corner_local)

// ---- wrong: J radius forgotten in r2
// region: 2
// expects: Likely mistake: the radius is forgotten in r2
  const vec3 r1 = point(body1, body2) - body1.x, r2 = to_world(body2, corner_local);
  return {-direction, -cross(r1, direction), direction, cross(r2, direction)};

// ---- wrong: J radius twice
// region: 2
// expects: Likely mistake: the radius is taken away twice
// change: , r1 ==> - radius * up(body1); const vec3 r1

// ---- wrong: J sign of body 1
// region: 2
// expects: Likely mistake: the sign of the blocks v1 and w1: body 1 carries the minus sign
// change: -direction, - ==> direction,

// ---- wrong: J sign of the row
// region: 2
// expects: Likely mistake: the sign of the whole row
// expects: Likely mistake: the sign of the whole row: J V is how fast body 2 moves along the
// expects: the sign of the whole row: C grows when body 2 moves up
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  return {direction, cross(r1, direction), -direction, -cross(r2, direction)};

// ---- wrong: J sign of w1
// region: 2
// expects: Likely mistake: the sign of the block w1
// change: -cross ==> cross

// ---- wrong: J unit lever
// region: 2
// expects: Likely mistake: a lever made a unit vector: it keeps its length, in w1
// change: r1 = p - body1.x ==> r1 = normalize(p - body1.x)

// ---- wrong: J w2 halved
// region: 2
// expects: Likely mistake: a factor of 0.5 in the block w2
// change: (r2, direction) ==> (r2, direction) / real(2)

// ---- wrong: J without levers
// region: 2
// expects: Likely mistake: the blocks w1 and w2 are missing: they hold the levers
  return {-direction, vec3(0), direction, vec3(0)};

// ---- wrong: J without w1
// region: 2
// expects: Likely mistake: w1 is zero, as if r1 ended in the middle
// expects: Likely mistake: the block w1 is missing
  const vec3 p = point(body1, body2), r2 = p - body2.x;
  return {-direction, vec3(0), direction, cross(r2, direction)};

// ---- right: C from the centre of the ball
// The centre of the ball has its own height, and the radius is taken from it.
  return dot(up(body1), world_point(body2, corner_local) - body1.x) - radius - height;

// ---- right: C from the middle of the top
// Measured from a point of the top.
  const vec3 n = up(body1), top = body1.x + height * n;
  return dot(point(body1, body2) - top, n);

// ---- right: C in axes of body 1
// The point seen from body 1: its y is the height above the centre.
  return to_local(body1, point(body1, body2) - body1.x).y - height;

// ---- right: J block by block
// region: 2
// The levers from the turned corner, one block after the other.
  Row J;
  const vec3 r2 = to_world(body2, corner_local) - radius * up(body1);
  J.v2 = direction;
  J.v1 = -J.v2;
  J.w2 = cross(r2, direction);
  J.w1 = cross(body1.x - body2.x - r2, direction);
  return J;

// ---- right: J with the order turned round
// region: 2
// a x b is -(b x a).
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, cross(direction, r1), direction, -cross(direction, r2)};

// ---- wrong units: order of the blocks
// region: 2
// expects: Units: the blocks of J along n are in another order: a row is {v1, w1, v2, w2}
  const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
  return {-direction, direction, -cross(r1, direction), cross(r2, direction)};

// ---- wrong units: square for length
// expects: Units: in C, taking m from m^2: a lever is missing, or another length
  const vec3 r1 = point(body1, body2) - body1.x;
  return dot(r1, r1) - height;

// ---- wrong units: without levers
// region: 2
// expects: Units: J along n.w1 is a pure number and should be in m: a lever is missing
  return {-direction, -direction, direction, direction};
