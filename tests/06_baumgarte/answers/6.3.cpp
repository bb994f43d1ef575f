// mistake "nothing moves: nothing is done yet, or the copies move and not the bodies themselves, or
//         the copies are brought to rest after the push: before it. Or an int cuts lambda to 0":
//         body1.x += move1.v; ==> ;; body2.x += move2.v; ==> ;; body1.q = turned(body1.q, move1.w,
//         1); ==> ;; body2.q = turned(body2.q, move2.w, 1); ==>
// mistake "the sign: lambda = -K^-1 C works against the gap": -inverse ==> inverse
// expects: Likely mistake: the iteration is right and its projections are not: look at `project`
// expects: move of 2 (on paper).x
// mistake "only a fraction of the gap is removed: a projection has no beta, it removes all of it":
//         inverse ==> real(0.2) * inverse
// mistake "times h: there is no step in it. lambda is an impulse times a time already": body1.x +=
//         ==> const real h = real(1) / 60; body1.x += h * ;; += move2 ==> += h * move2 ;; w, 1 ==>
//         w, h ;; w, 1 ==> w, h
// mistake "divided by h: there is no step in it, K lambda = -C": -inverse ==> real(-60) * inverse
// mistake "K is missing: lambda is -K^-1 C": inverse(point.K(body1, body2)) * ==>
// mistake "times K where its inverse belongs": inverse(point.K(body1, body2)) ==> point.K(body1,
//         body2)
// mistake "K along the gap only: the block is solved as a whole, lambda = -K^-1 C": const vec3 lambda
//         = -inverse(point.K(body1, body2)) * point.error(body1, body2) ==> const vec3 C =
//         point.error(body1, body2), n = direction(C); const vec3 lambda = -length(C) / dot(n,
//         point.K(body1, body2) * n) * n
// mistake "each row divided by its own K: the rows of a block are solved together": lambda =
//         -inverse(point.K(body1, body2)) * ==> C = ;; Body ==> const mat3 K = point.K(body1,
//         body2); const vec3 lambda(-C.x / K[0][0], -C.y / K[1][1], -C.z / K[2][2]); Body
// mistake "K without the rotations: it holds the masses only": -inverse(point.K(body1, body2)) *
//         point.error(body1, body2) ==> -point.error(body1, body2) / (body1.inverse_mass +
//         body2.inverse_mass)
// mistake "only C.x counts: the gap has three numbers": point.error(body1, body2) ==>
//         vec3(point.error(body1, body2).x, 0, 0)
// mistake "only C.y counts: the gap has three numbers": point.error(body1, body2) ==> vec3(0,
//         point.error(body1, body2).y, 0)
// mistake "only C.z counts: the gap has three numbers": point.error(body1, body2) ==> vec3(0, 0,
//         point.error(body1, body2).z)
// mistake "the bodies are exchanged in K: body 1 first": body1, body2 ==> body2, body1
// mistake "the bodies are exchanged in the error: body 1 first": point.error(body1, body2) ==>
//         point.error(body2, body1)
// mistake "the bodies are exchanged in the jacobian: body 1 first": point.jacobian(body1, body2) ==>
//         point.jacobian(body2, body1)
// mistake "the velocities are in lambda: K lambda = -C has no J V": * point.error(body1, body2) ==>
//         * (point.error(body1, body2) + body2.v + cross(body2.w, to_world(body2,
//         point.anchor2_local)) - body1.v - cross(body1.w, to_world(body1, point.anchor1_local)))
// mistake "v and w of both copies must be zero before they are given lambda": move1.v = move1.w =
//         move2.v = move2.w = vec3(0); ==>
// mistake "v of both copies must be zero, too, before they are given lambda": move1.v = move1.w =
//         move2.v = move2.w ==> move1.w = move2.w
// mistake "w of both copies must be zero, too, before they are given lambda": move1.v = move1.w =
//         move2.v = move2.w ==> move1.v = move2.v
// mistake "the copy of body 1 must be at rest, too, before it is given lambda": move1.v = move1.w =
//         move2.v ==> move2.v
// mistake "the copy of body 2 must be at rest, too, before it is given lambda": = move2.v = move2.w
//         ==>
// mistake "the copies are exchanged in apply_impulse: the one of body 1 comes first": lambda, move1,
//         move2 ==> lambda, move2, move1
// mistake "both copies are copies of body 1: each body has its own": move2 = body2 ==> move2 = body1
// mistake "both copies are copies of body 2: each body has its own": move1 = body1 ==> move1 = body2
// mistake "the rotations are missing: the other half of Eq. 6-11": body1.q = turned(body1.q,
//         move1.w, 1); ==> ;; body2.q = turned(body2.q, move2.w, 1); ==>
// expects: rotation of 2 (on paper).z
// mistake "the moves are missing: the first half of Eq. 6-11": body1.x += move1.v; ==> ;; body2.x +=
//         move2.v; ==>
// mistake "only body 2 moves: both bodies move": body1.x += move1.v; ==> ;; body1.q =
//         turned(body1.q, move1.w, 1); ==>
// mistake "only body 1 moves: both bodies move": body2.x += move2.v; ==> ;; body2.q =
//         turned(body2.q, move2.w, 1); ==>
// mistake "the move of body 1 is missing": body1.x += move1.v; ==>
// mistake "the rotation of body 1 is missing": body1.q = turned(body1.q, move1.w, 1); ==>
// expects: rotation of 1 (upright)
// mistake "the move of body 2 is missing": body2.x += move2.v; ==>
// mistake "the rotation of body 2 is missing": body2.q = turned(body2.q, move2.w, 1); ==>
// mistake "the sign of the moves: they are added to x, lambda has the sign already": += move1 ==> -=
//         move1 ;; += move2 ==> -= move2
// mistake "the moves are turned into the world: they are in world axes already": += move1.v ==> +=
//         to_world(body1, move1.v) ;; += move2.v ==> += to_world(body2, move2.v)
// mistake "the rotations are turned into the body's axes: w is in world axes": q, move1.w ==> q,
//         to_local(body1, move1.w) ;; q, move2.w ==> q, to_local(body2, move2.w)
// mistake "the sign of the rotations": q, move1.w ==> q, -move1.w ;; q, move2.w ==> q, -move2.w
// mistake "the moves of the two bodies are exchanged, their rotations are not": move1.v; ==> move0.v;
//         ;; move2.v; ==> move1.v; ;; move0 ==> move2
// mistake "the rotations of the two bodies are exchanged, their moves are not": q, move1.w ==> q,
//         move0.w ;; q, move2.w ==> q, move1.w ;; move0 ==> move2
// mistake "the moves of the two bodies are exchanged": += move1.v ==> += move0.v ;; += move2.v ==> +=
//         move1.v ;; move0 ==> move2 ;; q, move1.w ==> q, move0.w ;; q, move2.w ==> q, move1.w ;;
//         move0 ==> move2
// mistake "both moves are added to body 1: body 2 has its own": body2.x += ==> body1.x +=
// mistake "both moves are added to body 2: body 1 has its own": body1.x += ==> body2.x +=
// mistake "the move of body 2 is that of the other body": += move2.v ==> += move1.v
// mistake "the rotation of body 2 is that of the other body": q, move2.w ==> q, move1.w
// mistake "body 2 is turned from where body 1 stands: its own q, turned": body2.q = turned(body2.q
//         ==> body2.q = turned(body1.q
// mistake "half the rotation: turned(q, w, 1) halves the angle itself": move1.w, 1 ==> move1.w,
//         real(0.5) ;; move2.w, 1 ==> move2.w, real(0.5)
// mistake "twice the rotation: turned(q, w, 1) halves the angle itself": move1.w, 1 ==> move1.w, 2
//         ;; move2.w, 1 ==> move2.w, 2
// mistake "the rotation is multiplied by h: turned(q, w, 1), for w is an angle already": move1.w, 1
//         ==> move1.w, real(1) / 60 ;; move2.w, 1 ==> move2.w, real(1) / 60
// mistake "q + (0, w) q/2 is only the first term of it: take turned(q, w, 1)": body1.q =
//         turned(body1.q, move1.w, 1); body2.q = turned(body2.q, move2.w, 1) ==> for (auto [body,
//         w] : {std::pair{&body1, move1.w}, std::pair{&body2, move2.w}}) body->q =
//         normalize(body->q + real(0.5) * (quat(0, w.x, w.y, w.z) * body->q))
// mistake "a body turns in its own axes: exp(w) q and not q exp(w), w is in world axes":
//         turned(body1.q, move1.w, 1) ==> normalize(body1.q * rotation(move1.w)) ;; turned(body2.q,
//         move2.w, 1) ==> normalize(body2.q * rotation(move2.w))
// expects: rotation of 2 (upright)
// mistake "a sum of quaternions is no orientation: take turned(q, w, 1), which normalises it":
//         turned ==> body1.q + turned ;; = turned ==> = body2.q + turned
// mistake "the place of both bodies is replaced by the move: += and not =": body1.x += ==> body1.x =
//         ;; body2.x += ==> body2.x =
// mistake "the place of body 1 is replaced by the move: += and not =": body1.x += ==> body1.x =
// mistake "the place of body 2 is replaced by the move: += and not =": body2.x += ==> body2.x =
// mistake "the orientation of both bodies is replaced by the rotation: turned(q, w, 1) rotates the
//         old one": turned(body1.q, move1.w, 1) ==> rotation(move1.w) ;; turned(body2.q, move2.w,
//         1) ==> rotation(move2.w)
// mistake "the orientation of body 1 is replaced by the rotation: turned(q, w, 1) rotates the old
//         one": turned(body1.q, move1.w, 1) ==> rotation(move1.w)
// mistake "the orientation of body 2 is replaced by the rotation: turned(q, w, 1) rotates the old
//         one": turned(body2.q, move2.w, 1) ==> rotation(move2.w)
// mistake "the moves are added to v, not to x": body1.x += ==> body1.v += ;; body2.x += ==> body2.v +=
// mistake "the move of body 1 is added to its v, not to its x": body1.x += ==> body1.v +=
// mistake "the move of body 2 is added to its v, not to its x": body2.x += ==> body2.v +=
// mistake "the velocities are changed, and the poses stay: add the moves to x and turn q by them":
  const vec3 lambda = -inverse(point.K(body1, body2)) * point.error(body1, body2);
  apply_impulse(point.jacobian(body1, body2), lambda, body1, body2);
// mistake "the velocities are changed, too: they stay as they are, take copies of the bodies":
//         body1.x ==> apply_impulse(point.jacobian(body1, body2), lambda, body1, body2); body1.x
// mistake "v of both bodies is lost: the velocities stay as they are": body1.x += move1.v; ==>
//         body1.x += move1.v; body1.v = body2.v = vec3(0);
// mistake "w of both bodies is lost: the velocities stay as they are": body1.x ==> body1.w = body2.w
//         = vec3(0); body1.x
// mistake "the velocities are lost: only those of the copies are zero, the bodies keep theirs":
//         body1.x ==> body1.v = body1.w = body2.v = body2.w = vec3(0); body1.x
// mistake "this is two projections: one closes the gap to first order, the next does the rest": const
//         vec3 lambda = -inverse ==> for (int twice = 0; twice < 2; ++twice) { const vec3 lambda =
//         -inverse ;; w, 1); ==> w, 1) ; ;; w, 1); ==> w, 1); }
// mistake "taken again after body 1 has moved: one lambda, from the poses before the projection,
//         moves both": body2.x += move2.v; ==> ;; ; body2 ==> ; move2.v = move2.w = vec3(0); const
//         vec3 again = -inverse(point.K(body1, body2)) * point.error(body1, body2);
//         apply_impulse(point.jacobian(body1, body2), again, move1, move2); body2.x += move2.v;
//         body2
// mistake "the error is taken again after body 1 has moved: one lambda, from the poses before the
//         projection, moves both": body2.x += move2.v; ==> ;; ; body2 ==> ; Body before = body1;
//         before.x -= move1.v; before.q = turned(before.q, -move1.w, 1); move2.v = move2.w =
//         vec3(0); const vec3 again = -inverse(point.K(before, body2)) * point.error(body1, body2);
//         apply_impulse(point.jacobian(before, body2), again, before, move2); body2.x += move2.v;
//         body2
// mistake "the gap itself is divided between the bodies: they move and rotate by M^-1 J^T lambda,
//         Eq. 6-11":
  const real all = body1.inverse_mass + body2.inverse_mass;
  const vec3 gap = point.error(body1, body2);
  body1.x += body1.inverse_mass / all * gap;
  body2.x -= body2.inverse_mass / all * gap;
// mistake "half of the gap for each body: they move and rotate by M^-1 J^T lambda, Eq. 6-11":
  const vec3 gap = point.error(body1, body2);
  body1.x += real(0.5) * gap;
  body2.x -= real(0.5) * gap;
// mistake "body 2 is moved by the gap: both move and rotate by M^-1 J^T lambda, Eq. 6-11":
  body2.x -= point.error(body1, body2);
// mistake "beside a static body nothing is done: every gap is closed": const vec3 lambda ==> if
//         (body1.is_static() || body2.is_static()) return; const vec3 lambda
// wrong drawn-threshold: const vec3 lambda ==> if (length(point.error(body1, body2)) < real(1e-9))
//         return; const vec3 lambda
// wrong drawn-cut: const vec3 lambda ==> if (length(point.error(body1, body2)) > real(1)) return;
//         const vec3 lambda
// wrong "a factor of 0.3 in move of 1, rotation of 1, move of 2 and rotation of 2, in every case":
//         inverse ==> real(0.3) * inverse
// wrong "rotation of 2 holds the value of move of 2": move2.w, ==> move2.v,
// wrong "change of v1 holds the value of move of 1": v; ==> v; body1.v += move1.v;
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
// mistake "the velocities hold the moves now: they stay as they are. Are those of the copies written
//         back, too? Only x and q move": body1.v = v1; body1.w = w1; body2.v = v2; body2.w = w2; ==>
// expects: Likely mistake: the iteration is right and its projections are not
// expects: change of v2 (on paper)
// mistake "the bodies' own velocities are pushed and added: push copies with zero velocity": body1.v
//         = body1.w = body2.v = body2.w = vec3(0); ==> ;; body1.v = v1; body1.w = w1; body2.v = v2;
//         body2.w = w2; ==>
// from right point without copies
// mistake "body-space lever: the levers are not turned into the world": to_world(body1,
//         point.anchor1_local) ==> point.anchor1_local ;; to_world(body2, point.anchor2_local) ==>
//         point.anchor2_local
// mistake "the place of an anchor is no lever: that begins at the centre, to_world(body, anchor)":
//         to_world(body1 ==> world_point(body1 ;; to_world(body2 ==> world_point(body2
// mistake "body-space inertia: take inverse_inertia(body)": inverse_inertia(body1) ==>
//         body1.inverse_inertia_local ;; inverse_inertia(body2) ==> body2.inverse_inertia_local
// mistake "the inverse masses are missing": body1.inverse_mass * ==> ;; body2.inverse_mass * ==>
// mistake "the inverse inertias are missing": inverse_inertia(body1) * ==> ;; inverse_inertia(body2)
//         * ==>

// region 2
// mistake "a slack rope is pushed to its length: it is left alone where C >= 0": if (C >= 0) return;
//         ==>
// mistake "the wrong way round: C < 0 is too long, C > 0 is slack. (The error of its rod has the
//         other sign)": C >= 0 ==> C <= 0
// mistake "the error of the rod has the other sign: rope.error is negative where the rope is too
//         long": rope.error ==> rope.rod.error
// mistake "the error of the rod has the other sign: rope.error is negative where the rope is too
//         long, and a slack one is left alone": rope.error ==> rope.rod.error ;; if (C >= 0)
//         return; ==>
// mistake "this is the projection of a point, which draws the two anchors into one: a rope is drawn
//         to its length, by its own row":
  if (rope.error(body1, body2) >= 0) return;
  project(Point{rope.rod.anchor1_local, rope.rod.anchor2_local}, body1, body2);
// mistake "this is the projection of a point, which draws the two anchors into one, and a slack rope
//         is left alone":
  project(Point{rope.rod.anchor1_local, rope.rod.anchor2_local}, body1, body2);
// mistake "nothing moves: nothing is done yet, or the copies move and not the bodies themselves, or
//         the copies are brought to rest after the push: before it. Or an int cuts lambda to 0":
//         const real lambda ==> const int lambda
// mistake "the sign: lambda = -C/K works against the error of the rope (that of its rod has the
//         other sign)": -C ==> C
// mistake "only a fraction of the error is removed: a projection has no beta, it removes all of it":
//         -C ==> real(-0.2) * C
// mistake "K is missing: lambda is -K^-1 C": / rope.K(body1, body2) ==>
// mistake "times K where its inverse belongs": / rope.K ==> * rope.K
// mistake "K without the rotations: it holds the masses only": rope.K(body1, body2) ==>
//         (body1.inverse_mass + body2.inverse_mass)
// mistake "times h: there is no step in it. lambda is an impulse times a time already": -C ==> -C *
//         real(1) / 60
// mistake "divided by h: there is no step in it, K lambda = -C": -C ==> -C * 60
// mistake "the velocities are in lambda: K lambda = -C has no J V": -C ==> -(C +
//         row_velocity(rope.jacobian(body1, body2), body1, body2))
// mistake "v and w of both copies must be zero before they are given lambda": move1.v = move1.w =
//         move2.v = move2.w = vec3(0); ==>
// mistake "the copies are exchanged in apply_impulse: the one of body 1 comes first": lambda, move1,
//         move2 ==> lambda, move2, move1
// mistake "both copies are copies of body 1: each body has its own": move2 = body2 ==> move2 = body1
// mistake "both copies are copies of body 2: each body has its own": move1 = body1 ==> move1 = body2
// mistake "the bodies are exchanged in the error, K and the jacobian: body 1 first":
//         rope.jacobian(body1, body2) ==> rope.jacobian(body2, body1)
// mistake "the rotations are missing: the other half of Eq. 6-11": body1.q = turned(body1.q,
//         move1.w, 1); ==> ;; body2.q = turned(body2.q, move2.w, 1); ==>
// mistake "the moves are missing: the first half of Eq. 6-11": body1.x += move1.v; ==> ;; body2.x +=
//         move2.v; ==>
// mistake "only body 2 moves: both bodies move":
  const real C = rope.error(body1, body2);
  if (C >= 0) return;
  const real lambda = -C / rope.K(body1, body2);
  const Row J = rope.jacobian(body1, body2);
  body2.x += body2.inverse_mass * lambda * J.v2;
  body2.q = turned(body2.q, inverse_inertia(body2) * (lambda * J.w2), 1);
// mistake "only body 1 moves: both bodies move": body2.x += move2.v; ==> ;; body2.q =
//         turned(body2.q, move2.w, 1); ==>
// mistake "the sign of the moves: they are added to x, lambda has the sign already": += move1 ==> -=
//         move1 ;; += move2 ==> -= move2
// mistake "the sign of the rotations": q, move1.w ==> q, -move1.w ;; q, move2.w ==> q, -move2.w
// mistake "q + (0, w) q/2 is only the first term of it: take turned(q, w, 1)": body1.q =
//         turned(body1.q, move1.w, 1); body2.q = turned(body2.q, move2.w, 1) ==> for (auto [body,
//         w] : {std::pair{&body1, move1.w}, std::pair{&body2, move2.w}}) body->q =
//         normalize(body->q + real(0.5) * (quat(0, w.x, w.y, w.z) * body->q))
// mistake "a body turns in its own axes: exp(w) q and not q exp(w), w is in world axes":
//         turned(body1.q, move1.w, 1) ==> normalize(body1.q * rotation(move1.w)) ;; turned(body2.q,
//         move2.w, 1) ==> normalize(body2.q * rotation(move2.w))
// mistake "the velocities are changed, and the poses stay: add the moves to x and turn q by them":
  const real C = rope.error(body1, body2);
  if (C >= 0) return;
  apply_impulse(rope.jacobian(body1, body2), -C / rope.K(body1, body2), body1, body2);
// mistake "the velocities are changed, too: they stay as they are, take copies of the bodies":
//         body1.x ==> apply_impulse(rope.jacobian(body1, body2), lambda, body1, body2); body1.x
// wrong "a rope that is hardly slack is pushed to its length": C >= 0 ==> C >= real(0.05)
// expects: hardly, slack
// wrong "a rope that is hardly too long is left alone: there is no threshold": >= 0 ==> >
//         real(-0.01)
// expects: move of 1 (hardly too long)
// wrong drawn-threshold: if (C >= 0) ==> if (C >= real(-1e-6))
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
// mistake "the poses are stale: each joint needs the poses after the one before it, else both move
//         their body for the same gap":
  const std::vector<Body> before = chain.bodies;
  for (std::size_t k = 0; k < chain.joints.size(); ++k) {
    Body one = before[k], two = before[k + 1];
    project(chain.joints[k], one, two);
    chain.bodies[k].x += one.x - before[k].x;
    chain.bodies[k + 1].x += two.x - before[k + 1].x;
    chain.bodies[k].q = one.q * conjugate(before[k].q) * chain.bodies[k].q;
    chain.bodies[k + 1].q = two.q * conjugate(before[k + 1].q) * chain.bodies[k + 1].q;
  }
// mistake "the errors are computed before the iteration: each joint needs its error at the poses
//         after the one before it":
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
// mistake "the iteration runs backwards: from the first joint to the last": 0; k < ==> ;; ++k ==>
//         k-- > 0;
// mistake "the first joint is left out: it holds body 0 to body 1": 0; ==> 1;
// expects: x of body 1
// mistake "the last joint is left out: there is one joint less than bodies": k < ==> k + 1 <
// mistake "only the first joint is projected": chain.joints.size() ==> std::min(chain.joints.size(),
//         std::size_t(1))
// mistake "this is two iterations: every joint is projected once": for ==> for (int iteration = 0;
//         iteration < 2; ++iteration) for
// mistake "there and back: every joint is projected once": chain.bodies[k + 1]); ==> chain.bodies[k
//         + 1]); for (std::size_t k = chain.joints.size(); k-- > 0;) project(chain.joints[k],
//         chain.bodies[k], chain.bodies[k + 1]);
// mistake "every second joint is left out": ++k ==> k += 2
// mistake "every second joint, then the others: from the first joint to the last": std::size_t k = 0;
//         ==> std::size_t first : {0, 1}) for (std::size_t k = first; ;; ++k ==> k += 2
// mistake "nothing moves: nothing is done yet, or copies move: take the bodies of the chain by
//         reference, auto& and not auto": project(chain.joints[k], chain.bodies[k], chain.bodies[k
//         + 1]); ==> { Body body1 = chain.bodies[k], body2 = chain.bodies[k + 1];
//         project(chain.joints[k], body1, body2); }
// mistake "body k + 1 is a copy: take it by reference, auto& and not auto": project(chain.joints[k],
//         chain.bodies[k], chain.bodies[k + 1]); ==> { auto body = chain.bodies[k + 1];
//         project(chain.joints[k], chain.bodies[k], body); }
// mistake "body k is a copy: take it by reference, auto& and not auto": project(chain.joints[k],
//         chain.bodies[k], chain.bodies[k + 1]); ==> { auto body = chain.bodies[k];
//         project(chain.joints[k], body, chain.bodies[k + 1]); }
// mistake "the bodies are exchanged: joint k holds body k to body k + 1": [k], chain.bodies[k + 1]
//         ==> [k + 1], chain.bodies[k]
// mistake "a joint between a body and itself has no K: joint k holds body k to body k + 1":
//         chain.bodies[k + 1] ==> chain.bodies[k]
// mistake "bodies k - 1 and k: joint k holds body k to body k + 1": project ==> if (k > 0) project ;;
//         chain.bodies[k], chain.bodies[k + 1] ==> chain.bodies[k - 1], chain.bodies[k]
// mistake "bodies k + 1 and k + 2: joint k holds body k to body k + 1": project ==> if (k + 2 <
//         chain.bodies.size()) project ;; chain.bodies[k], chain.bodies[k + 1] ==> chain.bodies[k +
//         1], chain.bodies[k + 2]
// mistake "every joint holds its body to body 0: joint k holds body k to body k + 1":
//         chain.bodies[k], ==> chain.bodies[0],
// mistake "every joint is given bodies 0 and 1: joint k holds body k to body k + 1": chain.bodies[k],
//         chain.bodies[k + 1] ==> chain.bodies[0], chain.bodies[1]
// mistake "joint 0 is taken for all of them: joint k holds body k to body k + 1": chain.joints[k],
//         ==> chain.joints[0],
// mistake "the iteration ends at a closed joint: those behind it may be open": project ==> { if
//         (chain.joints[k].error(chain.bodies[k], chain.bodies[k + 1]) == vec3(0)) return; project
//         ;; + 1]); ==> + 1]); }
// mistake "the iteration ends at a joint that is hardly open: there is no such threshold": project
//         ==> { if (length(chain.joints[k].error(chain.bodies[k], chain.bodies[k + 1])) < 1e-6)
//         return; project ;; + 1]); ==> + 1]); }
// mistake "a joint that is hardly open is left out: there is no such threshold": project ==> if
//         (length(chain.joints[k].error(chain.bodies[k], chain.bodies[k + 1])) > 1e-4) project
// mistake "the velocities of the bodies change: an iteration moves and turns them": for ==> for (Body&
//         body : chain.bodies) body.v = vec3(0); for
// wrong drawn-stops: k < chain.joints.size() ==> k < chain.joints.size() && k < 8
// wrong drawn-side: project ==> if (length(chain.joints[k].error(chain.bodies[k],
//         chain.bodies[k + 1])) > 1e-8) project
// wrong "this is 50 iterations: every joint is projected once": for ==> for (int iteration = 0;
//         iteration < 50; ++iteration) for
// wrong "an index outside a vector": joints ==> bodies
// right iteration body by body: (std::size_t k = 0; k < chain.joints.size(); ++k)
//         project(chain.joints[k], chain.bodies[k], chain.bodies[k + 1]); ==> (std::size_t k = 1; k
//         < chain.bodies.size(); ++k) { Body &before = chain.bodies[k - 1], &body =
//         chain.bodies[k]; project(chain.joints[k - 1], before, body); }
