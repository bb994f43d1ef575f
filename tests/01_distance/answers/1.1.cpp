// mistake "not a unit vector: take direction(...) of the difference":
// expects: (pencil and paper, upright, turned, moved, broken)
// expects: Likely mistake: not a unit vector: take direction(...) of the difference (upright,
  const vec3 u = body2.x - body1.x;  // the thesis' J, meant for C = (|u|^2 - d^2)/2 (E20)
  return {-u, vec3(0), u, vec3(0)};
// mistake "divided by the length of the rod: that is the distance only while C = 0":
//         direction(body2.x - body1.x) ==> (body2.x - body1.x) / length
// expects: (pencil and paper, broken)
// expects: Fails at broken; holds at upright, turned and moved.
// expects: (broken)
// wrong sign-row (pencil and paper, upright, turned, moved, broken): body2.x - body1 ==> body1.x -
//         body2
// expects: Likely mistake: the sign of the whole row, or bodies 1 and 2 swapped (upright, turned,
// wrong "the sign of the block v1": -n ==> n
// expects: Likely mistake: the sign of the block v1 (upright, turned, moved, broken)
// wrong "the sign of the block v2": , n ==> , - n
// wrong order-of-blocks: vec3(0), n ==> n, vec3(0)
// wrong "the block v1 is missing": -n ==> vec3(0)
// mistake "the positions are added: the direction is their difference": - body1 ==> + body1
// mistake "the position of body 1 is missing in the direction": - body1.x ==>
// wrong division-by-zero: direction ==> normalize
// mistake "the row is multiplied by the length of the rod": direction ==> length * direction
// mistake "the row is 0 where the error is 0: a row constrains velocities, also there": return ==>
//         if (std::abs(error(body1, body2)) < real(1e-6)) return Row{}; return
// mistake "the row is 0 where the error is 0: a row constrains velocities, also there": return ==>
//         if (std::abs(error(body1, body2)) < real(1e-3)) return Row{}; return
// mistake "the row is multiplied by the error: the error belongs to the bias": direction ==>
//         error(body1, body2) * direction
// wrong "a factor of 0.5": direction ==> real(0.5) * direction
// mistake "divided by the distance twice: n is a unit vector already": direction(body2.x - body1.x)
//         ==> (body2.x - body1.x) / dot(body2.x - body1.x, body2.x - body1.x)
// wrong close-centres-taken-one: return ==> if (glm::length(body2.x - body1.x) < real(1e-3)) return
//         Row{}; return
// mistake "the row is 0 while the rod is too short: a rod pushes, too": return ==> if (error(body1,
//         body2) < 0) return Row{}; return
// mistake "the sign of the error is in the row: it belongs to the bias, and J is independent of
//         it": direction ==> (error(body1, body2) < 0 ? real(-1) : real(1)) * direction
// wrong nothing-wall: -n ==> body1.is_static() ? vec3(0) : -n
// wrong "the z of the direction is left out": return {-n, vec3(0), n, vec3(0)} ==> const vec3
//         n2(n.x, n.y, 0); return {-n2, vec3(0), n2, vec3(0)}
// mistake "n is turned with a body: positions are in the world already": direction ==> body1.q *
//         direction
// wrong inverse-masses-row: -n ==> -n * body1.inverse_mass ;; n, ==> n * body2.inverse_mass,
// mistake "the sign of each number of the direction is lost": direction(body2.x - body1.x) ==>
//         abs(direction(body2.x - body1.x))
// mistake "the blocks w1 and w2 should be zero: nothing turns": vec3(0), n, vec3(0) ==> -n, n, n
// wrong all-zero: direction ==> real(1 / 2) * direction
// wrong zero-at-some: direction(body2.x - body1.x) ==> direction(body2.v - body1.v)
// right normalize with a guard: n = direction(body2.x - body1.x) ==> u = body2.x - body1.x; const
//         vec3 n = dot(u, u) > 0 ? normalize(u) : vec3(0)
// right block by block: return {-n, vec3(0), n, vec3(0)}; ==> Row J; J.v1 = -n; J.v2 = n; return J;
// wrong units "J.v1 is in m and should be a pure number: a length too many: a lever, or a direction
//         that is not a unit vector":
  const vec3 u = body2.x - body1.x;
  return {-u, vec3(0), u, vec3(0)};
// mistake "the x of the direction is left out": n = direction(body2.x - body1.x) ==> m =
//         direction(body2.x - body1.x), n(0, m.y, m.z)
// mistake "the x of the direction is left out": n = direction(body2.x - body1.x) ==> m = body2.x -
//         body1.x, n = direction(vec3(0, m.y, m.z))
// mistake "the y of the direction is left out": n = direction(body2.x - body1.x) ==> m =
//         direction(body2.x - body1.x), n(m.x, 0, m.z)
// mistake "the y of the direction is left out": n = direction(body2.x - body1.x) ==> m = body2.x -
//         body1.x, n = direction(vec3(m.x, 0, m.z))
// mistake "the z of the direction is left out": n = direction(body2.x - body1.x) ==> m =
//         direction(body2.x - body1.x), n(m.x, m.y, 0)
// mistake "the z of the direction is left out": n = direction(body2.x - body1.x) ==> m = body2.x -
//         body1.x, n = direction(vec3(m.x, m.y, 0))
// mistake "n is turned with a body: positions are in the world already": direction ==> body2.q *
//         direction
// mistake "n is turned with a body: positions are in the world already": direction ==>
//         conjugate(body1.q) * direction
// mistake "n is turned with a body: positions are in the world already": direction ==>
//         conjugate(body2.q) * direction
