// wrong corner-not-turned: return ==> const vec3 p = body2.x + corner_local - radius * up(body1);
//         return ;; point(body1, body2) ==> p
// wrong cut-whole-numbers: return dot ==> const int C = dot ;; - height; ==> - height; return C;
// wrong centre-centre-corner-counts: point(body1, body2) ==> body2.x
// wrong height-added: - height ==> + height
// wrong height-forgotten: - height ==>
// expects: C, by hand 0.600000 0.100000 0.500000
// wrong height-world: dot(up(body1), point(body1, body2) - body1.x) ==> point(body1, body2).y
// wrong "over a static body it is measured in the world": return dot ==> if (body1.is_static())
//         return point(body1, body2).y - height; return dot
// expects: 1 static
// wrong height-upright: - height ==> ;; body1.x ==> top ;; return ==> const vec3 top = body1.x +
//         vec3(0, height, 0); return
// wrong few-digits: return ==> const float C = ;; height; ==> height; return C;
// wrong length: dot ==> length ;; up(body1), ==>
// wrong length-top: dot(up(body1), point(body1, body2) - body1.x) - height ==> length(point(body1,
//         body2) - body1.x - height * up(body1))
// wrong lever-body-2: - body1 ==> - body2
// wrong n-not-turned: dot ==> ;; up(body1), ==> ;; - height ==> .y - height
// wrong n-body-2: body1 ==> body2
// wrong nothing-below: dot ==> std::max(real(0), dot ;; height ==> height)
// wrong point-body-1: body1, body2 ==> body2, body1
// wrong radius-added: point(body1, body2) ==> world_point(body2, corner_local) ;; - height ==> +
//         radius - height
// wrong radius-for-height: - height ==> - radius
// wrong radius-forgotten: point(body1, body2) ==> world_point(body2, corner_local)
// expects: C, ball, upright
// wrong radius-twice: height ==> radius - height
// wrong radius-upright: return ==> const vec3 lowest = world_point(body2, corner_local) - vec3(0,
//         radius, 0); return ;; point(body1, body2) ==> lowest
// wrong sign-c-positive-above: dot ==> height - dot ;; - height ==>
// wrong sign-vector: point(body1, body2) - body1.x ==> body1.x - point(body1, body2)
// wrong size: dot ==> std::abs(dot ;; height ==> height)
// wrong turned-back: up(body1) ==> to_local(body1, vec3(0, 1, 0))
// wrong radius-forgotten + corner-not-turned: point(body1, body2) ==> body2.x + corner_local
// wrong never-set: return dot(up(body1), point(body1, body2) - body1.x) ==> real sum; for (int i =
//         0; i < 3; ++i) sum += up(body1)[i] * (point(body1, body2) - body1.x)[i]; return sum
// wrong world-point: - body1.x ==>
// wrong x-y-only: return dot(up(body1), point(body1, body2) - body1.x) ==> real sum = 0; for (int i
//         = 0; i < 2; ++i) sum += up(body1)[i] * (point(body1, body2) - body1.x)[i]; return sum
// wrong z-axis: up(body1) ==> to_world(body1, vec3(0, 0, 1))
// right C from the centre of the ball: point(body1, body2) ==> world_point(body2, corner_local) ;;
//         height ==> radius - height
// right C from the middle of the top:
  // Measured from a point of the top.
  const vec3 n = up(body1), top = body1.x + height * n;
  return dot(point(body1, body2) - top, n);
// right C in axes of body 1: dot(up(body1), point(body1, body2) - body1.x) ==> to_local(body1,
//         point(body1, body2) - body1.x).y
// wrong units "in C, taking m from m^2: a lever is missing, or another length": return
//         dot(up(body1), point(body1, body2) - body1.x) ==> const vec3 r1 = point(body1, body2) -
//         body1.x; return dot(r1, r1)

// region 2
// wrong always-n: return {-direction, -cross(r1, direction), direction, cross(r2, direction)} ==>
//         const vec3 n = up(body1); return {-n, -cross(r1, n), n, cross(r2, n)}
// wrong always-y: return {-direction, -cross(r1, direction), direction, cross(r2, direction)} ==>
//         const vec3 n(0, 1, 0); return {-n, -cross(r1, n), n, cross(r2, n)}
// wrong centre-body-2: p ==> r1 = body2.x - body1.x, r2 ;; , r1 = p - body1.x, r2 = p ==>
// wrong corner-not-turned: point(body1, body2), ==> body2.x + corner_local - radius * up(body1);
//         const vec3
// wrong direction-turned-back: return {-direction, -cross(r1, direction), direction, cross(r2,
//         direction)} ==> const vec3 d = to_local(body1, direction); return {-d, -cross(r1, d), d,
//         cross(r2, d)}
// wrong "entry times entry where the cross product belongs, in w2": cross(r2, direction) ==> r2 *
//         direction
// wrong "r1 ends on the top, below the corner": r1 = p - body1.x, ==> ;; x; ==> x; const vec3 r1 =
//         p - error(body1, body2) * up(body1) - body1.x;
// expects: Fails at pencil and paper and off the top; holds at upright, turned and moved.
// wrong height-taken-away: x, ==> x - height * up(body1),
// wrong height-taken-both-levers: p = point(body1, body2) ==> p = point(body1, body2) - height *
//         up(body1)
// wrong few-digits: vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x; return
//         {-direction, -cross(r1, direction), direction, cross(r2, direction)} ==> glm::vec3
//         r1(point(body1, body2) - body1.x), r2(point(body1, body2) - body2.x); const glm::vec3
//         d(direction); return {-direction, -vec3(cross(r1, d)), direction, vec3(cross(r2, d))}
// wrong levers-exchanged: body1.x, r2 = p - body2 ==> body2.x, r2 = p - body1
// wrong levers-body-axes: x; ==> x; const vec3 l1 = to_local(body1, r1), l2 = to_local(body2, r2);
//         ;; r1, ==> l1, ;; r2, ==> l2,
// wrong "n in the place of the direction in w1": -cross(r1, direction) ==> -cross(r1, up(body1))
// wrong nothing-static-body (pencil and paper): x; ==> x; if (body1.is_static()) return {vec3(0),
//         vec3(0), direction, cross(r2, direction)};
// wrong one-lever-both: .x, r2 = p - body2 ==> ;; r2 ==> r1
// wrong order-of-blocks: -cross(r1, direction), direction ==> direction, -cross(r1, direction)
// wrong order-cross-products: r1, direction ==> direction, r1 ;; r2, direction ==> direction, r2
// wrong point-for-levers: , r1 = p - body1.x, r2 = p - body2.x ==> ;; r1 ==> p ;; r2 ==> p
// wrong point-body-1: body1, body2 ==> body2, body1
// wrong sign-radius-point-below: point(body1, body2), ==> world_point(body2, corner_local) + radius
//         * up(body1); const vec3
// wrong "the radius is forgotten: the levers end at point(), the lowest point of the ball":
//         point(body1, body2) ==> world_point(body2, corner_local)
// expects: t1, w1.x
// wrong radius-forgotten-r2: p ==> r1 ;; , r1 = p ==> ;; p - body2.x ==> to_world(body2,
//         corner_local)
// wrong radius-twice: , r1 ==> - radius * up(body1); const vec3 r1
// wrong "the sign of the blocks v1 and w1: body 1 carries the minus sign": -direction, - ==>
//         direction,
// wrong sign-whole-row-c: -direction, - ==> direction, ;; direction, cross ==> -direction, -cross
// expects: Likely mistake: the sign of the whole row: J V is how fast body 2 moves along the
// wrong "the sign of the block w1": -cross ==> cross
// wrong "a lever made a unit vector: it keeps its length, in w1": r1 = p - body1.x ==> r1 =
//         normalize(p - body1.x)
// wrong "a factor of 0.5 in the block w2": (r2, direction) ==> (r2, direction) / real(2)
// wrong without-levers:
  return {-direction, vec3(0), direction, vec3(0)};
// wrong "w1 is zero, as if r1 ended in the middle": , r1 = p - body1.x ==> ;; -cross(r1, direction)
//         ==> vec3(0)
// expects: Likely mistake: the block w1 is missing
// right J block by block: const vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x;
//         return {-direction, -cross(r1, direction), direction, cross(r2, direction)}; ==> Row J;
//         const vec3 r2 = to_world(body2, corner_local) - radius * up(body1); J.v2 = direction;
//         J.v1 = -J.v2; J.w2 = cross(r2, direction); J.w1 = cross(body1.x - body2.x - r2,
//         direction); return J;
// right J with the order turned round: -cross(r1, direction) ==> cross(direction, r1) ;; cross(r2,
//         direction) ==> -cross(direction, r2)
// wrong units "the blocks of J along n are in another order: a row is {v1, w1, v2, w2}": -cross(r1,
//         direction), direction ==> direction, -cross(r1, direction)
// wrong units "J along n.w1 is a pure number and should be in m: a lever is missing":
  return {-direction, -direction, direction, direction};
