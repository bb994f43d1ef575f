// Known answers of exercise 1.6, each put in the place of the solution's.

// ---- wrong: K body space inertia
// region: 2
// expects: Likely mistake: body-space inertia of both bodies: it must be turned into the world, R
// expects: I^-1 R^T (upright, turned, moved, broken)
// change: inverse_inertia(body1) ==> body1.inverse_inertia_local
// change: inverse_inertia(body2) ==> body2.inverse_inertia_local

// ---- wrong: K without rotation
// region: 2
// expects: Likely mistake: the share of the rotation is missing
// expects: Likely mistake: the share of the rotation is missing (upright, turned, moved, broken)
  return body1.inverse_mass + body2.inverse_mass;

// ---- wrong: bodies swapped
// expects: Likely mistake: bodies 1 and 2 swapped
// expects: Likely mistake: bodies 1 and 2 swapped (upright, turned, moved, broken)
// change: -n ==> n, cross(r2, n), -n
// change: , n, cross(r2, n) ==>

// ---- wrong: body space lever of body 1
// expects: Fails at turned, moved and broken; holds at upright.
// expects: Likely mistake: body-space lever: the lever of body 1 is not turned into the world
// expects: (turned, moved, broken)
// change: to_world(body1, anchor1_local) ==> anchor1_local

// ---- wrong: body space lever of body 2
// expects: Likely mistake: body-space lever: the lever of body 2 is not turned into the world
// expects: (upright, turned, moved, broken)
// change: r2, ==> anchor2_local,

// ---- wrong: body space arms
// expects: Likely mistake: body-space lever: the levers of both bodies are not turned into
// expects: the world (upright, turned, moved, broken)
// change: to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local) ==>
//         anchor1_local, r2 = anchor2_local

// ---- wrong: from centre to centre
// expects: Likely mistake: the direction runs from centre to centre, not from anchor to anchor
// expects: (upright, turned, moved, broken)
// change: + r2 - body1.x - r1 ==> - body1.x

// ---- wrong: order of the cross products
// expects: Likely mistake: the sign of the blocks w1 and w2: a x b is -(b x a)
// expects: Likely mistake: the sign of the blocks w1 and w2: a x b is -(b x a) (upright, turned,
// expects: moved, broken)
// change: r1, n ==> n, r1
// change: r2, n ==> n, r2

// ---- wrong: sign of w1
// expects: Likely mistake: the sign of the block w1 (upright, turned, moved, broken)
// change: -cross ==> cross

// ---- wrong: without levers
// expects: Likely mistake: the blocks w1 and w2 are missing: they hold the levers
// expects: Likely mistake: the blocks w1 and w2 are missing: they hold the levers (upright,
// expects: turned, moved, broken)
  const vec3 u = world_point(body2, anchor2_local) - world_point(body1, anchor1_local);
  const vec3 n = direction(u);
  return {-n, vec3(0), n, vec3(0)};

// ---- wrong: a sign in u
// expects: Likely mistake: a sign in u: it is x2 + r2 - x1 - r1
// change: - r1 ==> + r1

// ---- wrong: centres left out
// expects: Likely mistake: the centres are missing in u
// change: body2.x + r2 - body1.x ==> r2

// ---- wrong: points added to the centres
// expects: Likely mistake: points where levers belong
// change: to_world ==> world_point
// change: to_world ==> world_point

// ---- wrong: turned with the other body
// expects: Likely mistake: a lever is turned with the other body
// change: body1 ==> body2
// change: body2, anchor2_local ==> body1, anchor2_local

// ---- wrong: one anchor for both
// expects: Likely mistake: one anchor for both bodies
// change: anchor2_local ==> anchor1_local

// ---- wrong: turned the wrong way round
// expects: Likely mistake: the levers of both bodies are turned the wrong way round
// change: to_world ==> to_local
// change: to_world ==> to_local

// ---- wrong: levers exchanged
// expects: Likely mistake: the levers r1 and r2 are exchanged
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  return {-n, -cross(r2, n), n, cross(r1, n)};

// ---- wrong: not a unit vector
// expects: Likely mistake: not a unit vector
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = body2.x + r2 - body1.x - r1;
  return {-n, -cross(r1, n), n, cross(r2, n)};

// ---- wrong: blocks in another order
// expects: Likely mistake: the order of the blocks
// change: -n ==> -n, n
// change: n, cross ==> cross

// ---- wrong: levers times u
// expects: Likely mistake: r x n wants the unit vector n, not u
// change: r1, n ==> r1, body2.x + r2 - body1.x - r1
// change: r2, n ==> r2, body2.x + r2 - body1.x - r1

// ---- wrong: lever of body 1 left out
// expects: Likely mistake: the block w1 is missing
// change: -cross(r1, n) ==> vec3(0)

// ---- wrong: cross product in body space
// expects: Likely mistake: the cross product comes too early
// change: return ==> const vec3 a1 = to_world(body1, cross(anchor1_local, n)); return
// change: cross(r1, n), n, cross(r2, n) ==> a1, n, to_world(body2, cross(anchor2_local, n))

// ---- wrong: no direction asked for
// expects: Likely mistake: a division by zero
// change: direction ==> normalize

// ---- wrong: K inertias exchanged
// region: 2
// expects: Likely mistake: the lever of one body with the inertia of the other
// change: (body1) ==> (body2)
// change: (body2) * a2 ==> (body1) * a2

// ---- wrong: K levers for arms
// region: 2
// expects: Likely mistake: the levers themselves stand beside the inertia
// change: cross(r1, n), a2 = cross(r2, n) ==> r1, a2 = r2

// ---- wrong: K sign of a rotation
// region: 2
// expects: Likely mistake: the sign of the rotation of body 2
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  const vec3 a1 = cross(r1, n), a2 = cross(r2, n);
  return body1.inverse_mass + body2.inverse_mass + dot(a1, inverse_inertia(body1) * a1) -
         dot(a2, inverse_inertia(body2) * a2);

// ---- wrong: K rotation of body 2 left out
// region: 2
// expects: Likely mistake: the rotation of body 2 is missing
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  const vec3 a1 = cross(r1, n), a2 = cross(r2, n);
  return body1.inverse_mass + body2.inverse_mass + dot(a1, inverse_inertia(body1) * a1);

// ---- wrong: K rotation of body 1 twice
// region: 2
// expects: Likely mistake: the rotation of body 1 is counted twice
// change: a2, inverse_inertia(body2) * a2 ==> a1, inverse_inertia(body1) * a1

// ---- wrong: K without inertia
// region: 2
// expects: Likely mistake: the inverse inertia is missing
// change: inverse_inertia(body1) * ==>
// change: inverse_inertia(body2) * ==>

// ---- wrong: K mass for inertia
// region: 2
// expects: Likely mistake: inverse mass where inverse inertia belongs
// change: dot(a1, inverse_inertia(body1) * a1) ==> body1.inverse_mass * dot(a1, a1)
// change: dot(a2, inverse_inertia(body2) * a2) ==> body2.inverse_mass * dot(a2, a2)

// ---- wrong: K without masses
// region: 2
// expects: Likely mistake: the inverse masses are missing
// change: body1.inverse_mass + body2.inverse_mass + ==>

// ---- wrong: K inverted
// region: 2
// expects: Likely mistake: the inverse of K: that is the effective mass
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  const vec3 a1 = cross(r1, n), a2 = cross(r2, n);
  return 1 / (body1.inverse_mass + body2.inverse_mass + dot(a1, inverse_inertia(body1) * a1) +
         dot(a2, inverse_inertia(body2) * a2));

// ---- wrong: K body space levers
// region: 2
// expects: Likely mistake: body-space lever: the levers of both bodies
// change: to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local) ==>
//         anchor1_local, r2 = anchor2_local

// ---- wrong: K from centre to centre
// region: 2
// expects: Likely mistake: the direction runs from centre to centre
// change: + r2 - body1.x - r1 ==> - body1.x

// ---- wrong: K inertia for its inverse
// region: 2
// expects: Likely mistake: inertia where inverse inertia belongs
// change: inverse_inertia(body1) ==> inverse(inverse_inertia(body1))
// change: inverse_inertia(body2) ==> inverse(inverse_inertia(body2))

// ---- wrong: K world inertia half turned
// region: 2
// expects: Likely mistake: the world inertia lacks R^T on its right
  const auto world = [](const Body& body) {
    const vec3 i = body.inverse_inertia_local;
    const mat3 R = mat3_cast(body.q), local(i.x, 0, 0, 0, i.y, 0, 0, 0, i.z);
    return R * local;
  };
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  const vec3 a1 = cross(r1, n), a2 = cross(r2, n);
  return body1.inverse_mass + body2.inverse_mass + dot(a1, world(body1) * a1) +
         dot(a2, world(body2) * a2);

// ---- wrong: K never set
// region: 2
// expects: Likely mistake: a value that was never set
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 n = direction(body2.x + r2 - body1.x - r1);
  const vec3 a1 = cross(r1, n), a2 = cross(r2, n);
  real k;
  k += body1.inverse_mass + body2.inverse_mass + dot(a1, inverse_inertia(body1) * a1) +
         dot(a2, inverse_inertia(body2) * a2);
  return k;

// ---- right: lever to the other end
// r1 + u in the place of r1: the difference u x n is zero, since n lies along u.
  const vec3 r1 = to_world(body1, anchor1_local), r2 = to_world(body2, anchor2_local);
  const vec3 u = body2.x + r2 - body1.x - r1, n = direction(u);
  return {-n, -cross(r1 + u, n), n, cross(r2, n)};

// ---- right: K from the row
// region: 2
  if (direction(world_point(body2, anchor2_local) - world_point(body1, anchor1_local)) == vec3(0))
    return body1.inverse_mass + body2.inverse_mass;
  const Row J = jacobian(body1, body2);
  return body1.inverse_mass * dot(J.v1, J.v1) + dot(J.w1, inverse_inertia(body1) * J.w1) +
         body2.inverse_mass * dot(J.v2, J.v2) + dot(J.w2, inverse_inertia(body2) * J.w2);

// ---- wrong units: K arms forgotten
// region: 2
// expects: Units: in K, adding 1/(kg m^2) to 1/kg: the levers are missing
  const vec3 n = direction(world_point(body2, anchor2_local) - world_point(body1, anchor1_local));
  return body1.inverse_mass + body2.inverse_mass + dot(n, inverse_inertia(body1) * n) +
         dot(n, inverse_inertia(body2) * n);
