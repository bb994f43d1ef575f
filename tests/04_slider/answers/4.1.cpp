// Known answers of exercise 4.1, each put in the place of the solution's.

// ---- wrong: C abs
// expects: Likely mistake: an absolute value: the sign is lost
  return {std::abs(dot(u, to_world(body1, n1_local))), std::abs(dot(u, to_world(body1, n2_local)))};

// ---- wrong: C from centre to centre
// expects: Likely mistake: centres in place of anchors: u is p2 - p1
  const vec3 d = body2.x - body1.x;
  return {dot(d, to_world(body1, n1_local)), dot(d, to_world(body1, n2_local))};

// ---- wrong: C index past end
// expects: an index outside an array of 2 numbers: its places run from 0 to 1
// change: return {dot(u, to_world(body1, n1_local)), dot(u, to_world(body1, n2_local))}; ==>
//         const vec3 n[2] = {to_world(body1, n1_local), to_world(body1, n2_local)}; Vector<2> C{};
//         for (int i = 0; i <= 2; ++i) C[i] = dot(u, n[i % 2]); return C;

// ---- wrong: C int
// expects: Likely mistake: 0 in every case: is it written at all, from what is given? Was it
// expects: cut off by an int, or something in it never set?
  const int one = dot(u, to_world(body1, n1_local)), two = dot(u, to_world(body1, n2_local));
  return {real(one), real(two)};

// ---- wrong: C n1 twice
// expects: Likely mistake: n1 twice: the second number belongs to n2
  return {dot(u, to_world(body1, n1_local)), dot(u, to_world(body1, n1_local))};

// ---- wrong: C n1 x n2
// expects: Likely mistake: n1 x n2 runs along the line, where the displacement is free: C holds
// expects: u.n1 and u.n2
  const vec3 a = cross(to_world(body1, n1_local), to_world(body1, n2_local));
  return {dot(u, a), dot(u, a)};

// ---- wrong: C n2 with body 2
// expects: Likely mistake: in C.2 alone: n is turned with body 2: the line rides on body 1
  return {dot(u, to_world(body1, n1_local)), dot(u, to_world(body2, n2_local))};

// ---- wrong: C normalized
// expects: Likely mistake: u is not made a unit vector: its length counts
  const vec3 n = normalize(u);
  return {dot(n, to_world(body1, n1_local)), dot(n, to_world(body1, n2_local))};

// ---- wrong: C of points
// expects: Likely mistake: n is a direction, not a point: to_world, not world_point
  return {dot(u, world_point(body1, n1_local)), dot(u, world_point(body1, n2_local))};

// ---- wrong: C one sign
// expects: Likely mistake: in C.2 alone: the sign: u runs from the point of body 1 to that of body
// expects: 2
  return {dot(u, to_world(body1, n1_local)), -dot(u, to_world(body1, n2_local))};

// ---- wrong: C p2 only
// expects: Likely mistake: the point of body 2 in the place of u: u is p2 - p1
  const vec3 p2 = world_point(body2, anchor2_local);
  return {dot(p2, to_world(body1, n1_local)), dot(p2, to_world(body1, n2_local))};

// ---- wrong: C second unset
// expects: Likely mistake: a value that was never set
  Vector<2> C;
  C[0] = dot(u, to_world(body1, n1_local));
  return C;

// ---- wrong: C swapped
// expects: Likely mistake: n1 and n2 are exchanged
  return {dot(u, to_world(body1, n2_local)), dot(u, to_world(body1, n1_local))};

// ---- wrong: C threshold
// expects: Likely mistake: what is small has become 0: no threshold belongs here
// change: return {dot(u, to_world(body1, n1_local)), dot(u, to_world(body1, n2_local))} ==>
//         real p = dot(u, to_world(body1, n1_local)), q = dot(u, to_world(body1, n2_local)); if
//         (std::abs(p) < 0.1) p = 0; if (std::abs(q) < 0.1) q = 0; return {p, q}

// ---- wrong: C turned with body 2
// expects: Likely mistake: n is turned with body 2: the line rides on body 1
  return {dot(u, to_world(body2, n1_local)), dot(u, to_world(body2, n2_local))};

// ---- wrong: C u turned too
// expects: Likely mistake: u is turned, too: u and n are both in the world
  const vec3 seen = to_local(body1, u);
  return {dot(seen, to_world(body1, n1_local)), dot(seen, to_world(body1, n2_local))};

// ---- wrong: C zero on a static body
// expects: Likely mistake: a body that is static has an error, too
// change: return ==> if (body1.is_static()) return {}; return

// ---- wrong: J bodies swapped
// region: 2
// expects: Likely mistake: bodies 1 and 2 swapped (pencil and paper, upright, turned, moved,
// expects: broken)
// change: -n ==> n[i], cross(r2, n[i]), -n
// change: , n[i], cross(r2, n[i]) ==>

// ---- wrong: J direction u
// region: 2
// expects: Likely mistake: the unit vector along u in the place of n: the row runs along n (pencil
// expects: and paper, upright, turned, moved, broken)
// change: Jacobian ==> const vec3 d = normalize(u); Jacobian
// change: n[i], -cross(r1 + u, n[i]), n[i], cross(r2, n[i]) ==>
//         d, -cross(r1 + u, d), d, cross(r2, d)

// ---- wrong: J doubled u
// region: 2
// expects: Likely mistake: u belongs to the lever of body 1 once (pencil and paper, turned, moved,
// expects: broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i)
    J[i] = {-n[i], -cross(r1 + u, n[i]) - cross(u, n[i]), n[i], cross(r2, n[i])};
  return J;

// ---- wrong: J first row written twice
// region: 2
// expects: Likely mistake: J[0] is written twice, J[1] never: the row C.2 stands in the place of
// expects: C.1 (pencil and paper, upright, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  J[0] = {-n[0], -cross(r1 + u, n[0]), n[0], cross(r2, n[0])};
  J[0] = {-n[1], -cross(r1 + u, n[1]), n[1], cross(r2, n[1])};
  return J;

// ---- wrong: J index past the end
// region: 2
// expects: an index outside an array of 2 rows: its places run from 0 to 1
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i <= 2; ++i) {
    const vec3 m = n[i % 2];
    J[i] = {-m, -cross(r1 + u, m), m, cross(r2, m)};
  }
  return J;

// ---- wrong: J lever 1 with body 2
// region: 2
// expects: Likely mistake: the lever of body 1 is turned with the other body: each body turns its
// expects: own (pencil and paper, upright, turned, moved, broken)
// change: body1 ==> body2

// ---- wrong: J n[0] in both rows
// region: 2
// expects: Likely mistake: J[1], the row C.2, repeats J[0] (pencil and paper, upright, turned,
// expects: moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) J[i] = {-n[0], -cross(r1 + u, n[0]), n[0], cross(r2, n[0])};
  return J;

// ---- wrong: J no arms, n in the turns
// region: 2
// expects: Likely mistake: the levers are missing: w1 and w2 hold r x n, not n (pencil and paper,
// expects: upright, turned, moved, broken)
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) J[i] = {-n[i], -n[i], n[i], n[i]};
  return J;

// ---- wrong: J no w1
// region: 2
// expects: Likely mistake: the block w1 is missing (pencil and paper, upright, turned, moved,
// expects: broken)
// change: r1 = to_world(body1, anchor1_local), ==>
// change: -cross(r1 + u, n[i]) ==> vec3(0)

// ---- wrong: J normalised levers
// region: 2
// expects: Likely mistake: a lever has its length: it is no unit vector (pencil and paper, upright,
// expects: turned, moved, broken)
// change: to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local) ==>
//         normalize(to_world(body1, anchor1_local) + u); const vec3 r2 = normalize(to_world(body2,
//         anchor2_local))
// change: + u, ==> ,

// ---- wrong: J order v v w w
// region: 2
// expects: Likely mistake: the order of the blocks: a row is {v1, w1, v2, w2} (pencil and paper,
// expects: upright, turned, moved, broken)
// change: -cross ==> n[i], -cross
// change: n[i], cross ==> cross

// ---- wrong: J points
// region: 2
// expects: Likely mistake: a point where a lever belongs: the lever of body 1 is r1 + u (pencil and
// expects: paper, upright, turned, moved, broken)
// change: to_world ==> world_point
// change: to_world ==> world_point

// ---- wrong: J r1 - u
// region: 2
// expects: Likely mistake: the sign of u or of r1, the lever of body 1 is r1 + u (pencil and paper,
// expects: turned, moved, broken)
// change: + u ==> - u

// ---- wrong: J r1 for both
// region: 2
// expects: Likely mistake: the lever of body 1 for both bodies: each has its own (pencil and paper,
// expects: upright, turned, moved, broken)
// change: r2, ==> r1 + u,

// ---- wrong: J r1 plain in place of r2
// region: 2
// expects: Likely mistake: the lever of body 2 is r2, not r1 (pencil and paper, upright, turned,
// expects: moved, broken)
// change: r2, ==> r1,

// ---- wrong: J row 1 without u
// region: 2
// expects: Likely mistake: in one row alone: u is forgotten, the lever of body 1 is r1 + u, because
// expects: n rides on body 1 (pencil and paper, turned, moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  J[0] = {-n[0], -cross(r1 + u, n[0]), n[0], cross(r2, n[0])};
  J[1] = {-n[1], -cross(r1, n[1]), n[1], cross(r2, n[1])};
  return J;

// ---- wrong: J rows exchanged
// region: 2
// expects: Likely mistake: the rows C.1 and C.2 are exchanged (pencil and paper, upright, turned,
// expects: moved, broken)
// change: [i] ==> [1 - i]

// ---- wrong: J second row never
// region: 2
// expects: Likely mistake: J[1], the row C.2, is zero: was it never written? (pencil and paper,
// expects: upright, turned, moved, broken)
// change: 2; ==> 1;

// ---- wrong: J second row w2 from n0
// region: 2
// expects: Likely mistake: w2 of J[1] is that of J[0] (pencil and paper, upright, turned, moved,
// expects: broken)
// change: r2, n[i] ==> r2, n[0]

// ---- wrong: J swapped r1 r2
// region: 2
// expects: Likely mistake: the levers r1 and r2 are exchanged (pencil and paper, upright, turned,
// expects: moved, broken)
// change: r1 = ==> r1 = to_world(body2, anchor2_local), r2 =
// change: , r2 = to_world(body2, anchor2_local) ==>

// ---- wrong: J to_local levers
// region: 2
// expects: Likely mistake: the levers of both bodies are turned the wrong way round: to_world, not
// expects: to_local (pencil and paper, upright, turned, moved, broken)
// change: to_world ==> to_local
// change: to_world ==> to_local

// ---- wrong: J u in both
// region: 2
// expects: Likely mistake: u belongs to the lever of body 1 alone (pencil and paper, turned, moved,
// expects: broken)
// change: r2, ==> r2 + u,

// ---- wrong: J unset sum
// region: 2
// expects: Likely mistake: a value that was never set
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) {
    real k[3];
    for (int j = 0; j < 3; ++j) k[j] += cross(r2, n[i])[j];
    J[i] = {-n[i], -cross(r1 + u, n[i]), n[i], vec3(k[0], k[1], k[2])};
  }
  return J;

// ---- wrong: body space lever
// region: 2
// expects: Likely mistake: body-space lever: the lever of body 1 is not turned into the world
// expects: (turned, moved, broken)
// change: to_world(body1, anchor1_local) ==> anchor1_local

// ---- wrong: n in body space
// region: 2
// expects: Likely mistake: n is left in body space: turn it into the world with body 1 (turned,
// expects: moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) {
    const vec3 m = i == 0 ? n1_local : n2_local;
    J[i] = {-m, -cross(r1 + u, m), m, cross(r2, m)};
  }
  return J;

// ---- wrong: n turned with body 2
// region: 2
// expects: Likely mistake: n is turned with body 2 here, but n rides on body 1
// expects: Likely mistake: n is turned with body 2 here, but n rides on body 1 (upright, turned,
// expects: moved, broken)
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) {
    const vec3 m = to_world(body2, i == 0 ? n1_local : n2_local);
    J[i] = {-m, -cross(r1 + u, m), m, cross(r2, m)};
  }
  return J;

// ---- wrong: u forgotten
// region: 2
// expects: Likely mistake: u is forgotten, the lever of body 1 is r1 + u, because n rides on body 1
// expects: (turned, moved, broken)
// expects: Likely mistake: u belongs to the lever of body 1 and to no other: push and answer act
// change: + u ==>

// ---- right: C in axes of body 1
// The same two numbers, seen from body 1: u is turned and n1 and n2 stay.
  const vec3 seen = to_local(body1, u);
  return {dot(seen, n1_local), dot(seen, n2_local)};

// ---- right: J skew
// region: 2
  const mat3 L1 = skew(to_world(body1, anchor1_local) + u);
  const mat3 L2 = skew(to_world(body2, anchor2_local));
  Jacobian<2> J;
  for (int i = 0; i < 2; ++i) {
    J[i].v1 = -n[i];
    J[i].w1 = n[i] * L1;
    J[i].v2 = n[i];
    J[i].w2 = L2 * n[i];
  }
  return J;

// ---- right: J with n first in the products
// region: 2
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const Row rows[] = {
      Row{-n[0], cross(n[0], r1 + u), n[0], -cross(n[0], r2)},
      Row{-n[1], cross(n[1], r1) + cross(n[1], u), n[1], cross(r2, n[1])}};
  return {{rows[0], rows[1]}};

// ---- right: lever to the point of body 2
// region: 2
// r1 + u is the vector from the centre of body 1 to the point of body 2.
  const vec3 p2 = world_point(body2, anchor2_local);
  return {{Row{-n[0], cross(n[0], p2 - body1.x), n[0], cross(p2 - body2.x, n[0])},
           Row{-n[1], cross(n[1], p2 - body1.x), n[1], cross(p2 - body2.x, n[1])}}};

// ---- wrong units: arms forgotten
// region: 2
// expects: Units: J.w1 is a pure number and should be in m: a lever is missing
  return {{Row{-n[0], -n[0], n[0], n[0]}, Row{-n[1], -n[1], n[1], n[1]}}};
