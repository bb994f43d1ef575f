// wrong drawn-threshold: const vec3 lambda ==> if (length(point.error(body1, body2)) < real(1e-9))
//         return; const vec3 lambda
// wrong drawn-cut: const vec3 lambda ==> if (length(point.error(body1, body2)) > real(1)) return;
//         const vec3 lambda
// wrong k-along-gap: const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1,
//         body2) ==> const vec3 C = point.error(body1, body2), n = direction(C); const vec3 lambda
//         = -length(C) / dot(n, point.K(body1, body2) * n) * n
// wrong "the bodies are exchanged in K: body 1 first": body1, body2 ==> body2, body1
// wrong share-gap: inverse ==> real(0.3) * inverse
// wrong "more than the gap is removed, 2 times: a projection removes it once": -inverse ==>
//         real(-2) * inverse
// wrong "the rotation of body 1 is missing": body1.q = turned(body1.q, move1.w, 1); ==>
// expects: rotation of 1 (upright)
// wrong body-space-arms:
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  body1.x -= body1.inverse_mass * lambda;
  body2.x += body2.inverse_mass * lambda;
  const vec3 turn1 = inverse_inertia(body1) * cross(lambda, point.anchor1_local);
  const vec3 turn2 = inverse_inertia(body2) * cross(point.anchor2_local, lambda);
  body1.q = turned(body1.q, turn1, 1);
  body2.q = turned(body2.q, turn2, 1);
// wrong brought-rest-after-push: body2; ==> body2; apply_impulse(point.jacobian(body1, body2),
//         lambda, move1, move2); ;; (0); apply_impulse(point.jacobian(body1, body2), lambda, move1,
//         move2) ==> (0)
// wrong copies-exchanged: lambda, move1, move2 ==> lambda, move2, move1
// wrong copies-not-rest: move1.v = move1.w = move2.v = move2.w = vec3(0); ==>
// wrong copies-body-1: move2 = body2 ==> move2 = body1
// wrong each-row-own-k: lambda = -inverse(point.K(body1, body2)) * ==> C = ;; Body ==> const mat3 K
//         = point.K(body1, body2); const vec3 lambda(-C.x / K[0][0], -C.y / K[1][1], -C.z /
//         K[2][2]); Body
// wrong "taken again after body 1 has moved (error": body2.x += move2.v; ==> ;; ; body2 ==> ;
//         move2.v = move2.w = vec3(0); const vec3 again = -inverse(point.K(body1, body2)) *
//         point.error(body1, body2); apply_impulse(point.jacobian(body1, body2), again, move1,
//         move2); body2.x += move2.v; body2
// wrong first-order-turn: body1.q = turned(body1.q, move1.w, 1); body2.q = turned(body2.q, move2.w,
//         1) ==> for (auto [body, w] : {std::pair{&body1, move1.w}, std::pair{&body2, move2.w}})
//         body->q = normalize(body->q + real(0.5) * (quat(0, w.x, w.y, w.z) * body->q))
// wrong "the place of both bodies is replaced by the move: += and not =": body1.x += ==> body1.x =
//         ;; body2.x += ==> body2.x =
// wrong "only C.x counts: the gap has three numbers": point.error(body1, body2) ==>
//         vec3(point.error(body1, body2).x, 0, 0)
// wrong only-body-2: body1.x += move1.v; ==> ;; body1.q = turned(body1.q, move1.w, 1); ==>
// wrong "the orientation of body 2 is replaced by the rotation": turned(body2.q, move2.w, 1) ==>
//         rotation(move2.w)
// wrong quaternions-added: turned ==> body1.q + turned ;; = turned ==> = body2.q + turned
// wrong shared-by-masses:
  const real all = body1.inverse_mass + body2.inverse_mass;
  const vec3 gap = point.error(body1, body2);
  body1.x += body1.inverse_mass / all * gap;
  body2.x -= body2.inverse_mass / all * gap;
// wrong "the sign: lambda = -K^-1 C": -inverse ==> inverse
// expects: Likely mistake: the iteration is right and its projections are not: look at `project`
// expects: move of 2 (on paper).x
// wrong sign-moves: += move1 ==> -= move1 ;; += move2 ==> -= move2
// wrong times-h: body1.x += ==> const real h = real(1) / 60; body1.x += h * ;; += move2 ==> += h *
//         move2 ;; w, 1 ==> w, h ;; w, 1 ==> w, h
// wrong "rotation of 2 holds the value of move of 2": move2.w, ==> move2.v,
// wrong "a body turns in its own axes": turned(body1.q, move1.w, 1) ==> normalize(body1.q *
//         rotation(move1.w)) ;; turned(body2.q, move2.w, 1) ==> normalize(body2.q *
//         rotation(move2.w))
// expects: rotation of 2 (upright)
// wrong velocities-changed:
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  apply_impulse(point.jacobian(body1, body2), lambda, body1, body2);
// wrong "change of v1 holds the value of move of 1": v; ==> v; body1.v += move1.v;
// wrong "v of both bodies is lost: the velocities stay as they are": body1.x += move1.v; ==>
//         body1.x += move1.v; body1.v = body2.v = vec3(0);
// wrong "the rotations are missing": body1.q = turned(body1.q, move1.w, 1); ==> ;; body2.q =
//         turned(body2.q, move2.w, 1); ==>
// expects: rotation of 2 (on paper).z
// right point as an impulse:
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
// right point velocities put back:
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
// right point without copies:
  // The moves written out: no copies of the bodies, the levers by themselves.
  const vec3 r1 = to_world(body1, point.anchor1_local), r2 = to_world(body2, point.anchor2_local);
  const vec3 lambda = inverse(point.K(body1, body2)) * -point.error(body1, body2);
  const vec3 turn1 = inverse_inertia(body1) * cross(r1, -lambda);
  const vec3 turn2 = inverse_inertia(body2) * cross(r2, lambda);
  body1.x -= body1.inverse_mass * lambda;
  body2.x += body2.inverse_mass * lambda;
  body1.q = normalize(rotation(turn1) * body1.q);
  body2.q = normalize(rotation(turn2) * body2.q);
// wrong units "in the projection of a point, adding": move1.v = move1.w = move2.v = move2.w =
//         vec3(0); ==>
// expects: a velocity has got among the moves
// from right point velocities put back
// wrong "the velocities hold the moves now: they stay as they are": const Jacobian<3> J =
//         point.jacobian(body1, body2); const vec3 v1 = body1.v, w1 = body1.w, v2 = body2.v, w2 =
//         body2.w; ==> ;; J ==> point.jacobian(body1, body2) ;; body1.v = v1; body1.w = w1; body2.v
//         = v2; body2.w = w2; ==>
// expects: Likely mistake: the iteration is right and its projections are not
// expects: change of v2 (on paper)

// region 2
// wrong drawn-threshold: if (C >= 0) ==> if (C >= real(-1e-6))
// wrong as-a-point:
  if (rope.error(body1, body2) >= 0) return;
  project(Point{rope.rod.anchor1_local, rope.rod.anchor2_local}, body1, body2);
// wrong "a rope that is hardly slack is pushed to its length": C >= 0 ==> C >= real(0.05)
// expects: hardly, slack
// wrong brought-rest-after-push: const real lambda ==> const int lambda
// wrong only-body-2:
  const real C = rope.error(body1, body2);
  if (C >= 0) return;
  const real lambda = -C / rope.K(body1, body2);
  const Row J = rope.jacobian(body1, body2);
  body2.x += body2.inverse_mass * lambda * J.v2;
  body2.q = turned(body2.q, inverse_inertia(body2) * (lambda * J.w2), 1);
// wrong slack-is-pushed: C = ==> lambda = - ;; ; if (C >= 0) return; const real lambda = -C ==>
// wrong "a rope that is hardly too long is left alone: there is no threshold": >= 0 ==> >
//         real(-0.01)
// expects: move of 1 (hardly too long)
// wrong k-missing-lambda-k: const real C = rope.error(body1, body2); if (C >= 0) ==> if
//         (rope.error(body1, body2) >= 0) ;; C / rope.K ==> rope.error
// wrong wrong-way-round: const real C = rope.error(body1, body2); if (C >= 0) ==> if
//         (rope.error(body1, body2) <= 0) ;; C ==> rope.error(body1, body2)
// right rope as the rod:
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

// region 3
// wrong drawn-stops: k < chain.joints.size() ==> k < chain.joints.size() && k < 8
// wrong backwards: 0; k < ==> ;; ++k ==> k-- > 0;
// wrong bodies-exchanged: [k], chain.bodies[k + 1] ==> [k + 1], chain.bodies[k]
// wrong copy-one-body: project(chain.joints[k], chain.bodies[k], chain.bodies[k + 1]); ==> { auto
//         body = chain.bodies[k + 1]; project(chain.joints[k], chain.bodies[k], body); }
// wrong errors-first:
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
// wrong every-second-joint: ++k ==> k += 2
// wrong "the first joint is left out": 0; ==> 1;
// expects: x of body 1
// wrong body-itself: chain.bodies[k + 1] ==> chain.bodies[k]
// wrong of-copies: project(chain.joints[k], chain.bodies[k], chain.bodies[k + 1]); ==> { Body body1
//         = chain.bodies[k], body2 = chain.bodies[k + 1]; project(chain.joints[k], body1, body2); }
// wrong "an index outside a vector": joints ==> bodies
// wrong stale-poses:
  const std::vector<Body> before = chain.bodies;
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    Body one = before[k], two = before[k + 1];
    project(chain.joints[k], one, two);
    chain.bodies[k].x += one.x - before[k].x;
    chain.bodies[k + 1].x += two.x - before[k + 1].x;
    chain.bodies[k].q = one.q * conjugate(before[k].q) * chain.bodies[k].q;
    chain.bodies[k + 1].q = two.q * conjugate(before[k + 1].q) * chain.bodies[k + 1].q;
  }
// wrong "this is 50 iterations: every joint is projected once": for ==> for (int iteration = 0;
//         iteration < 50; ++iteration) for
// wrong velocities-to-rest: for ==> for (Body& body : chain.bodies) body.v = vec3(0); for
// right iteration body by body: (std::size_t k = 0; k < chain.joints.size(); ++k)
//         project(chain.joints[k], chain.bodies[k], chain.bodies[k + 1]); ==> (std::size_t k = 1; k
//         < chain.bodies.size(); ++k) { Body &before = chain.bodies[k - 1], &body =
//         chain.bodies[k]; project(chain.joints[k - 1], before, body); }
