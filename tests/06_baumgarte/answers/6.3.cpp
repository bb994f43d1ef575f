// Known answers of exercise 6.3, each put in the place of the solution's.

// ---- wrong: point K along the gap
// expects: Likely mistake: K along the gap only: the block is solved as a whole
// change: const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2) ==>
//         const vec3 C = point.error(body1, body2), n = direction(C); const vec3 lambda =
//         -length(C) / dot(n, point.K(body1, body2) * n) * n

// ---- wrong: point K of exchanged bodies
// expects: Likely mistake: the bodies are exchanged in K: body 1 first
// change: point.K(body1, body2) ==> point.K(body2, body1)

// ---- wrong: point a share of the gap
// expects: Likely mistake: only a share of the gap is taken: a projection has no beta
// change: inverse ==> real(0.3) * inverse

// ---- wrong: point applied twice
// expects: Likely mistake: more than the gap is taken, 2 times: a projection takes it once
// change: -inverse ==> real(-2) * inverse

// ---- wrong: point body 1 not turned
// expects: rotation of 1 (upright)
// expects: Likely mistake: the rotation of body 1 is missing
// change: body1.q = turned(body1.q, move1.w, 1); ==>

// ---- wrong: point body space arms
// expects: Likely mistake: body-space lever
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  body1.x -= body1.inverse_mass * lambda;
  body2.x += body2.inverse_mass * lambda;
  const vec3 turn1 = inverse_inertia(body1) * cross(lambda, point.anchor1_local);
  const vec3 turn2 = inverse_inertia(body2) * cross(point.anchor2_local, lambda);
  body1.q = turned(body1.q, turn1, 1);
  body2.q = turned(body2.q, turn2, 1);

// ---- wrong: point brought to rest after the push
// expects: Likely mistake: nothing moves
// expects: or the copies are brought to rest after the push: before it
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  Body move1 = body1, move2 = body2;
  apply_impulse(point.jacobian(body1, body2), lambda, move1, move2);
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  body1.x += move1.v;
  body2.x += move2.v;
  body1.q = turned(body1.q, move1.w, 1);
  body2.q = turned(body2.q, move2.w, 1);

// ---- wrong: point copies exchanged
// expects: Likely mistake: the copies are exchanged in apply_impulse: the one of body 1 comes first
// change: lambda, move1, move2 ==> lambda, move2, move1

// ---- wrong: point copies not at rest
// expects: Likely mistake: v and w of both copies must be zero
// change: move1.v = move1.w = move2.v = move2.w = vec3(0); ==>

// ---- wrong: point copies of body 1
// expects: Likely mistake: both copies are copies of body 1: each body has its own
// change: move2 = body2 ==> move2 = body1

// ---- wrong: point copies written back
// expects: change of v2 (on paper)
// expects: Are those of the copies written back, too? Only x and q move
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  apply_impulse(point.jacobian(body1, body2), lambda, move1, move2);
  for (auto [move, body] : {std::pair{&move1, &body1}, std::pair{&move2, &body2}}) {
    move->x += move->v;
    move->q = turned(move->q, move->w, 1);
    *body = *move;
  }

// ---- wrong: point each row by its own K
// expects: Likely mistake: each row divided by its own K
// change: lambda = -inverse(point.K(body1, body2)) * ==> C =
// change: Body ==>
//         const mat3 K = point.K(body1, body2); const vec3 lambda(-C.x / K[0][0], -C.y / K[1][1],
//         -C.z / K[2][2]); Body

// ---- wrong: point error taken again
// expects: Likely mistake: taken again after body 1 has moved (error
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  apply_impulse(point.jacobian(body1, body2), lambda, move1, move2);
  body1.x += move1.v;
  body1.q = turned(body1.q, move1.w, 1);
  move2.v = move2.w = vec3(0);
  const vec3 again = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  apply_impulse(point.jacobian(body1, body2), again, move1, move2);
  body2.x += move2.v;
  body2.q = turned(body2.q, move2.w, 1);

// ---- wrong: point first order turn
// expects: Likely mistake: q + (0, w) q/2 is only the first term of it
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  apply_impulse(point.jacobian(body1, body2), lambda, move1, move2);
  body1.x += move1.v;
  body2.x += move2.v;
  for (auto [body, w] : {std::pair{&body1, move1.w}, std::pair{&body2, move2.w}})
    body->q = normalize(body->q + real(0.5) * (quat(0, w.x, w.y, w.z) * body->q));

// ---- wrong: point moves left in the velocities
// expects: change of v2 (on paper)
// expects: Likely mistake: the velocities hold the moves now: they stay as they are
// expects: Likely mistake: the iteration is right and its projections are not
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  body1.v = body1.w = body2.v = body2.w = vec3(0);
  apply_impulse(point.jacobian(body1, body2), lambda, body1, body2);
  for (Body* body : {&body1, &body2}) {
    body->x += body->v;
    body->q = turned(body->q, body->w, 1);
  }

// ---- wrong: point new places
// expects: Likely mistake: the place of both bodies is replaced by the move: += and not =
// change: body1.x += ==> body1.x =
// change: body2.x += ==> body2.x =

// ---- wrong: point one entry of the gap
// expects: Likely mistake: only C.x counts: the gap has three numbers
// change: point.error(body1, body2) ==> vec3(point.error(body1, body2).x, 0, 0)

// ---- wrong: point only body 2
// expects: Likely mistake: only body 2 moves
// change: body1.x += move1.v; ==>
// change: body1.q = turned(body1.q, move1.w, 1); ==>

// ---- wrong: point orientation replaced
// expects: Likely mistake: the orientation of body 2 is replaced by the rotation
// change: turned(body2.q, move2.w, 1) ==> rotation(move2.w)

// ---- wrong: point quaternions added
// expects: Likely mistake: a sum of quaternions is no orientation
// change: turned ==> body1.q + turned
// change: = turned ==> = body2.q + turned

// ---- wrong: point shared by masses
// expects: Likely mistake: the gap itself is shared out
  const real all = body1.inverse_mass + body2.inverse_mass;
  const vec3 gap = point.error(body1, body2);
  body1.x += body1.inverse_mass / all * gap;
  body2.x -= body2.inverse_mass / all * gap;

// ---- wrong: point sign
// expects: move of 2 (on paper).x
// expects: Likely mistake: the sign: lambda = -K^-1 C
// expects: Likely mistake: the iteration is right and its projections are not: look at `project`
// change: -inverse ==> inverse

// ---- wrong: point sign of the moves
// expects: Likely mistake: the sign of the moves: they are added to x
// change: += move1 ==> -= move1
// change: += move2 ==> -= move2

// ---- wrong: point times h
// expects: Likely mistake: times h: there is no step in it
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  apply_impulse(point.jacobian(body1, body2), lambda, move1, move2);
  const real h = real(1) / 60;
  body1.x += h * move1.v;
  body2.x += h * move2.v;
  body1.q = turned(body1.q, move1.w, h);
  body2.q = turned(body2.q, move2.w, h);

// ---- wrong: point turned by the move
// expects: Likely mistake: rotation of 2 is what belongs to move of 2
// change: turned(body2.q, move2.w, 1) ==> turned(body2.q, move2.v, 1)

// ---- wrong: point turned in body axes
// expects: rotation of 2 (upright)
// expects: Likely mistake: a body turns in its own axes
// change: turned(body1.q, move1.w, 1) ==> normalize(body1.q * rotation(move1.w))
// change: turned(body2.q, move2.w, 1) ==> normalize(body2.q * rotation(move2.w))

// ---- wrong: point velocities changed
// expects: Likely mistake: the velocities are changed, and the poses stay
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  apply_impulse(point.jacobian(body1, body2), lambda, body1, body2);

// ---- wrong: point velocities of body 1 changed, too
// expects: Likely mistake: change of v1 is what belongs to move of 1
// change: body1.x += move1.v; ==> body1.x += move1.v; body1.v += move1.v;

// ---- wrong: point velocities to rest
// expects: Likely mistake: v of both bodies is lost: the velocities stay as they are
// change: body1.x += move1.v; ==> body1.x += move1.v; body1.v = body2.v = vec3(0);

// ---- wrong: point without turns
// expects: rotation of 2 (on paper).z
// expects: Likely mistake: the rotations are missing
// change: body1.q = turned(body1.q, move1.w, 1); ==>
// change: body2.q = turned(body2.q, move2.w, 1); ==>

// ---- wrong: rope as a point
// region: 2
// expects: Likely mistake: this is the projection of a point
  if (rope.error(body1, body2) >= 0) return;
  project(Point{rope.rod.anchor1_local, rope.rod.anchor2_local}, body1, body2);

// ---- wrong: rope hardly slack is pushed
// region: 2
// expects: hardly, slack
// expects: Likely mistake: a rope that is hardly slack is pushed to its length
// change: C >= 0 ==> C >= real(0.05)

// ---- wrong: rope lambda in an int
// region: 2
// expects: Or an int cuts lambda to 0
// change: const real lambda ==> const int lambda

// ---- wrong: rope only body 2
// region: 2
// expects: Likely mistake: only body 2 moves: body 1 has its share of the gap
  const real C = rope.error(body1, body2);
  if (C >= 0) return;
  const real lambda = -C / rope.K(body1, body2);
  const Row J = rope.jacobian(body1, body2);
  body2.x += body2.inverse_mass * lambda * J.v2;
  body2.q = turned(body2.q, inverse_inertia(body2) * (lambda * J.w2), 1);

// ---- wrong: rope slack is pushed
// region: 2
// expects: slack
// expects: Likely mistake: a slack rope is pushed to its length
  const real lambda = -rope.error(body1, body2) / rope.K(body1, body2);
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  apply_impulse(rope.jacobian(body1, body2), lambda, move1, move2);
  body1.x += move1.v;
  body2.x += move2.v;
  body1.q = turned(body1.q, move1.w, 1);
  body2.q = turned(body2.q, move2.w, 1);

// ---- wrong: rope tolerance
// region: 2
// expects: move of 1 (hardly too long)
// expects: Likely mistake: a rope that is hardly too long is left alone: there is no threshold
// change: >= 0 ==> > real(-0.01)

// ---- wrong: rope without K
// region: 2
// expects: Likely mistake: K is missing
  if (rope.error(body1, body2) >= 0) return;
  const real lambda = -rope.error(body1, body2);
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  apply_impulse(rope.jacobian(body1, body2), lambda, move1, move2);
  body1.x += move1.v;
  body2.x += move2.v;
  body1.q = turned(body1.q, move1.w, 1);
  body2.q = turned(body2.q, move2.w, 1);

// ---- wrong: rope wrong way round
// region: 2
// expects: Likely mistake: the wrong way round: C < 0 is too long
  if (rope.error(body1, body2) <= 0) return;
  const real lambda = -rope.error(body1, body2) / rope.K(body1, body2);
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  apply_impulse(rope.jacobian(body1, body2), lambda, move1, move2);
  body1.x += move1.v;
  body2.x += move2.v;
  body1.q = turned(body1.q, move1.w, 1);
  body2.q = turned(body2.q, move2.w, 1);

// ---- wrong: iteration backwards
// region: 3
// expects: Likely mistake: the iteration runs backwards
  for (std::size_t k = chain.joints.size(); k-- > 0;)
    project(chain.joints[k], chain.bodies[k], chain.bodies[k + 1]);

// ---- wrong: iteration bodies exchanged
// region: 3
// expects: Likely mistake: the bodies are exchanged: joint k holds body k to body k + 1
  for (std::size_t k = 0; k < chain.joints.size(); ++k)
    project(chain.joints[k], chain.bodies[k + 1], chain.bodies[k]);

// ---- wrong: iteration copy of one body
// region: 3
// expects: Likely mistake: body k + 1 is a copy: take it by reference
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    auto body = chain.bodies[k + 1];
    project(chain.joints[k], chain.bodies[k], body);
  }

// ---- wrong: iteration errors first
// region: 3
// expects: Likely mistake: the errors are taken before the iteration
  std::vector<vec3> C;
  for (std::size_t k = 0; k < chain.joints.size(); ++k)
    C.push_back(chain.joints[k].error(chain.bodies[k], chain.bodies[k + 1]));
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    Body &body1 = chain.bodies[k], &body2 = chain.bodies[k + 1];
    const vec3 lambda = -inverse(chain.joints[k].K(body1, body2)) * C[k];
    Body move1 = body1, move2 = body2;
    move1.v = move1.w = move2.v = move2.w = vec3(0);
    apply_impulse(chain.joints[k].jacobian(body1, body2), lambda, move1, move2);
    body1.x += move1.v;
    body2.x += move2.v;
    body1.q = turned(body1.q, move1.w, 1);
    body2.q = turned(body2.q, move2.w, 1);
  }

// ---- wrong: iteration every second joint
// region: 3
// expects: Likely mistake: every second joint is left out
// change: ++k ==> k += 2

// ---- wrong: iteration first joint left out
// region: 3
// expects: x of body 1
// expects: Likely mistake: the first joint is left out
// change: 0; ==> 1;

// ---- wrong: iteration of a body with itself
// region: 3
// expects: Likely mistake: a joint between a body and itself has no K
// change: chain.bodies[k + 1] ==> chain.bodies[k]

// ---- wrong: iteration of copies
// region: 3
// expects: Likely mistake: nothing moves: nothing is done yet, or copies move: take the bodies
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    Body body1 = chain.bodies[k], body2 = chain.bodies[k + 1];
    project(chain.joints[k], body1, body2);
  }

// ---- wrong: iteration one joint too many
// region: 3
// expects: an index outside a vector
// change: joints ==> bodies

// ---- wrong: iteration stale poses
// region: 3
// expects: Likely mistake: the poses are stale
  const std::vector<Body> before = chain.bodies;
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    Body one = before[k], two = before[k + 1];
    project(chain.joints[k], one, two);
    chain.bodies[k].x += one.x - before[k].x;
    chain.bodies[k + 1].x += two.x - before[k + 1].x;
    chain.bodies[k].q = one.q * conjugate(before[k].q) * chain.bodies[k].q;
    chain.bodies[k + 1].q = two.q * conjugate(before[k + 1].q) * chain.bodies[k + 1].q;
  }

// ---- wrong: iteration until closed
// region: 3
// expects: Likely mistake: this is 50 iterations: every joint is projected once
// change: for (std::size_t k ==> for (int iteration = 0; iteration < 50; ++iteration) for (std::size_t k

// ---- wrong: iteration velocities to rest
// region: 3
// expects: Likely mistake: the velocities of the bodies change: an iteration moves and turns them
// change: for (std::size_t k ==>
//         for (Body& body : chain.bodies) body.v = vec3(0); for (std::size_t k

// ---- right: point as an impulse
// The impulse of a block at rest with the gap for its bias.
  Body move1 = body1, move2 = body2;
  move1.v = move1.w = move2.v = move2.w = vec3(0);
  const Jacobian<3> J = point.jacobian(body1, body2);
  const vec3 C = point.error(body1, body2);
  apply_impulse(J, block_impulse(J, point.K(body1, body2), C, move1, move2), move1, move2);
  move1.x += move1.v;
  move2.x += move2.v;
  move1.q = turned(body1.q, move1.w, 1);
  move2.q = turned(body2.q, move2.w, 1);
  for (auto [moved, body] : {std::pair{&move1, &body1}, std::pair{&move2, &body2}}) {
    body->x = moved->x;
    body->q = moved->q;
  }

// ---- right: point velocities put back
// The bodies themselves in the place of copies; their velocities are put back at the end.
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  const Jacobian<3> J = point.jacobian(body1, body2);
  const vec3 v1 = body1.v, w1 = body1.w, v2 = body2.v, w2 = body2.w;
  body1.v = body1.w = body2.v = body2.w = vec3(0);
  apply_impulse(J, lambda, body1, body2);
  for (Body* body : {&body1, &body2}) {
    body->x += body->v;
    body->q = turned(body->q, body->w, 1);
  }
  body1.v = v1;
  body1.w = w1;
  body2.v = v2;
  body2.w = w2;

// ---- right: point without copies
// The moves written out: no copies of the bodies, the levers by themselves.
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  const vec3 lambda = inverse(point.K(body1, body2)) * -point.error(body1, body2);
  const vec3 turn1 = inverse_inertia(body1) * cross(r1, -lambda);
  const vec3 turn2 = inverse_inertia(body2) * cross(r2, lambda);
  body1.x -= body1.inverse_mass * lambda;
  body2.x += body2.inverse_mass * lambda;
  body1.q = normalize(rotation(turn1) * body1.q);
  body2.q = normalize(rotation(turn2) * body2.q);

// ---- right: rope as the rod
// region: 2
// The rod of the rope, which has both signs turned.
  const real C = rope.rod.error(body1, body2);
  if (C > 0) {
    const Row J = rope.rod.jacobian(body1, body2);
    Body move1 = body1, move2 = body2;
    move1.v = move1.w = move2.v = move2.w = vec3(0);
    apply_impulse(J, row_impulse(J, rope.rod.K(body1, body2), C, move1, move2), move1, move2);
    body1.x += move1.v;
    body2.x += move2.v;
    body1.q = turned(body1.q, move1.w, 1);
    body2.q = turned(body2.q, move2.w, 1);
  }

// ---- right: iteration body by body
// region: 3
// Counted by the second body of each joint.
  for (std::size_t k = 1; k < chain.bodies.size(); ++k) {
    Body &before = chain.bodies[k - 1], &body = chain.bodies[k];
    project(chain.joints[k - 1], before, body);
  }

// ---- wrong units: velocities for moves
// expects: Units: in the projection of a point, adding
// expects: a velocity has got among the moves
// change: move1.v = move1.w = move2.v = move2.w = vec3(0); ==>
