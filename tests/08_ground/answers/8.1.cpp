// mistake "corner_local is not turned into the world: point() does it": return ==> const vec3 p =
//         body2.x + corner_local - radius * up(body1); return ;; point(body1, body2) ==> p
// mistake "C is 0 everywhere: it is not measured, or cut to a whole number by an int": return dot
//         ==> const int C = dot ;; - height; ==> - height; return C;
// mistake "from centre to centre: the corner counts, point()": point(body1, body2) ==> body2.x
// mistake "height is added: it is subtracted, because it ends at the top": - height ==> + height
// mistake "height is forgotten: the top stands above the centre of body 1": - height ==>
// expects: C, by hand 0.600000 0.100000 0.500000
// mistake "height is subtracted twice: once": - height ==> - 2 * height
// mistake "half of height: the top is all of it above the centre of body 1": - height ==> - height
//         / 2
// mistake "height is cut to a whole number: an int has no fraction": - height ==> - int(height)
// mistake "the position of body 1 is subtracted, too: p - x1 contains it already": - height ==> -
//         height - body1.x.y
// mistake "the height of the point in the world: C is measured from body 1, along its n":
//         dot(up(body1), point(body1, body2) - body1.x) ==> point(body1, body2).y
// mistake "over a static body it is measured in the world: C is measured from body 1, along its n":
//         return dot ==> if (body1.is_static()) return point(body1, body2).y - height; return dot
// expects: 1 static
// mistake "height along the y axis of the world: it is along n": - height ==> ;; body1.x ==> top ;;
//         return ==> const vec3 top = body1.x + vec3(0, height, 0); return
// wrong few-digits: return ==> const float C = ;; height; ==> height; return C;
// mistake "the length of p - x1: only its part along n counts, the dot product": dot ==> length ;;
//         up(body1), ==>
// mistake "the length of a cross product: only the part along n counts, the dot product":
//         dot(up(body1), point(body1, body2) - body1.x) ==> length(cross(up(body1), point(body1,
//         body2) - body1.x))
// mistake "the distance from the top: only the part along n counts, the dot product":
//         dot(up(body1), point(body1, body2) - body1.x) - height ==> length(point(body1, body2) -
//         body1.x - height * up(body1))
// mistake "the lever of body 2 in the place of the one of body 1: p - x1": - body1 ==> - body2
// mistake "n is not turned: up is the y axis of body 1, up(body1), not that of the world": dot ==>
//         ;; up(body1), ==> ;; - height ==> .y - height
// mistake "n is the axis of body 2: up is the y axis of body 1": body1 ==> body2
// mistake "nothing below the top: C is negative there and gives the depth of the corner": dot ==>
//         std::max(real(0), dot ;; height ==> height)
// mistake "only below the top: while C > 0 it is the gap that may be used up": dot ==>
//         std::min(real(0), dot ;; height ==> height)
// mistake "point(body2, body1): the other way round, the corner is one of body 2": body1, body2 ==>
//         body2, body1
// mistake "the radius is added: the point is below the centre of the ball": point(body1, body2) ==>
//         world_point(body2, corner_local) ;; - height ==> + radius - height
// mistake "the radius in the place of height: point() has the radius in it": - height ==> - radius
// mistake "the radius is forgotten: the lowest point of the ball counts, point()": point(body1,
//         body2) ==> world_point(body2, corner_local)
// expects: C, ball, upright
// mistake "the radius is subtracted twice: point() has subtracted it already": height ==> radius -
//         height
// mistake "the radius along the y axis of the world: it is along n": return ==> const vec3 lowest =
//         world_point(body2, corner_local) - vec3(0, radius, 0); return ;; point(body1, body2) ==>
//         lowest
// mistake "the sign: C is positive above the top": dot ==> height - dot ;; - height ==>
// mistake "the sign of p - x1: it runs from body 1 to the point": point(body1, body2) - body1.x ==>
//         body1.x - point(body1, body2)
// mistake "the size of C: below the top it is negative": dot ==> std::abs(dot ;; height ==> height)
// mistake "n is turned the wrong way round: body 1 turns it into the world, up(body1)": up(body1)
//         ==> to_local(body1, vec3(0, 1, 0))
// wrong "corner_local is not turned into the world: point() does it; and the radius is forgotten:
//         the lowest point of the ball counts, point()": point(body1, body2) ==> body2.x +
//         corner_local
// wrong "height is forgotten: the top stands above the centre of body 1; and the radius is
//         forgotten: the lowest point of the ball counts, point()": point(body1, body2) ==>
//         world_point(body2, corner_local) ;; - height ==>
// mistake "n is not turned: up is the y axis of body 1, up(body1). And height is forgotten": dot
//         ==> ;; up(body1), ==> ;; - height ==> .y
// mistake "n is not turned: up is the y axis of body 1, up(body1). And the radius is forgotten":
//         dot(up(body1), point(body1, body2) - body1.x) ==> (world_point(body2, corner_local) -
//         body1.x).y
// mistake "n is not turned, and corner_local is not, either: both are turned into the world,
//         up(body1) and point()": dot(up(body1), point(body1, body2) - body1.x) ==> (body2.x +
//         corner_local - body1.x).y - radius
// wrong never-set: return dot(up(body1), point(body1, body2) - body1.x) ==> real sum; for (int i =
//         0; i < 3; ++i) sum += up(body1)[i] * (point(body1, body2) - body1.x)[i]; return sum
// mistake "a world point in the place of p - x1: C is measured from body 1": - body1.x ==>
// mistake "x1 is added: C is measured from p - x1": - body1.x ==> + body1.x
// mistake "the place of body 2 is missing in the point: point() has it in it": point(body1, body2)
//         ==> to_world(body2, corner_local) - radius * up(body1)
// mistake "only x and y count in the dot product: all three do": return dot(up(body1), point(body1,
//         body2) - body1.x) ==> real sum = 0; for (int i = 0; i < 2; ++i) sum += up(body1)[i] *
//         (point(body1, body2) - body1.x)[i]; return sum
// mistake "times height: it is taken away": - height ==> * height
// mistake "n is the z axis of body 1: up is its y axis": up(body1) ==> to_world(body1, vec3(0, 0,
//         1))
// mistake "n is the x axis of body 1: up is its y axis": up(body1) ==> to_world(body1, vec3(1, 0,
//         0))
// mistake "C is rounded to millimetres: it keeps all its digits": return dot ==> const real C = dot
//         ;; - height; ==> - height; return std::round(1000 * C) / 1000;
// wrong drawn-threshold: return dot ==> const real C = dot ;; - height; ==> - height; return
//         std::abs(C) < real(1e-3) ? 0 : C;
// expects: |C| 0.001 m
// mistake "p - x1 is turned into axes of body 1 and n is not: both in the world, or both in body
//         1": point(body1, body2) - body1.x ==> to_local(body1, point(body1, body2) - body1.x)
// mistake "the corner is taken for one of body 1: it is one of body 2": point(body1, body2) ==>
//         world_point(body1, corner_local)
// wrong drawn-cut: return dot ==> return std::min(real(50), dot ;; height; ==> height);
// expects: right up to a case with |C|
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
// mistake "n in the place of the direction: along() is called with other directions, too": return
//         {-direction, -cross(r1, direction), direction, cross(r2, direction)} ==> const vec3 d =
//         up(body1); return {-d, -cross(r1, d), d, cross(r2, d)}
// mistake "the y axis of the world in the place of the direction that is given": return
//         {-direction, -cross(r1, direction), direction, cross(r2, direction)} ==> const vec3 d(0,
//         1, 0); return {-d, -cross(r1, d), d, cross(r2, d)}
// mistake "r1 ends at the centre of body 2: the lever of body 1 is p - x1, with the same p as the
//         one of body 2": p ==> r1 = body2.x - body1.x, r2 ;; , r1 = p - body1.x, r2 = p ==>
// mistake "r1 ends at the centre of body 2, and body 2 has no lever": const vec3 p = point(body1,
//         body2), r1 = p - body1.x, r2 = p - body2.x ==> const vec3 r1 = body2.x - body1.x, r2(0)
// mistake "corner_local is not turned into the world: point() does it": point(body1, body2), ==>
//         body2.x + corner_local - radius * up(body1); const vec3
// mistake "corner_local is not turned into the world in r2: point() does it": r2 = p - body2.x ==>
//         r2 = corner_local - radius * up(body1)
// mistake "corner_local is not turned into the world in r2: point() does it": r2 = p - body2.x ==>
//         r2 = corner_local
// mistake "the direction is turned once more: it is given in the world": return {-direction,
//         -cross(r1, direction), direction, cross(r2, direction)} ==> const vec3 d =
//         to_local(body1, direction); return {-d, -cross(r1, d), d, cross(r2, d)}
// mistake "the direction is turned once more: it is given in the world": return {-direction,
//         -cross(r1, direction), direction, cross(r2, direction)} ==> const vec3 d =
//         to_world(body1, direction); return {-d, -cross(r1, d), d, cross(r2, d)}
// mistake "the direction is turned once more: it is given in the world": return {-direction,
//         -cross(r1, direction), direction, cross(r2, direction)} ==> const vec3 d =
//         to_world(body2, direction); return {-d, -cross(r1, d), d, cross(r2, d)}
// mistake "the direction is turned once more: it is given in the world": return {-direction,
//         -cross(r1, direction), direction, cross(r2, direction)} ==> const vec3 d =
//         to_local(body2, direction); return {-d, -cross(r1, d), d, cross(r2, d)}
// mistake "the part along n is subtracted from the direction: take the direction as it is given":
//         return {-direction, -cross(r1, direction), direction, cross(r2, direction)} ==> const
//         vec3 n = up(body1), d = direction - dot(direction, n) * n; return {-d, -cross(r1, d), d,
//         cross(r2, d)}
// mistake "entry times entry where the cross product belongs, in w1 and w2": -cross(r1, direction)
//         ==> -(r1 * direction) ;; cross(r2, direction) ==> r2 * direction
// mistake "entry times entry where the cross product belongs, in w2": cross(r2, direction) ==> r2 *
//         direction
// mistake "entry times entry where the cross product belongs, in w1": -cross(r1, direction) ==>
//         -(r1 * direction)
// mistake "r1 ends on the top, below the corner: the lever of body 1 is p - x1, with the same p as
//         the one of body 2": r1 = p - body1.x, ==> ;; x; ==> x; const vec3 r1 = p - error(body1,
//         body2) * up(body1) - body1.x;
// expects: Fails at pencil and paper and off the top; holds at upright, turned and moved.
// mistake "r1 ends twice as high above the top as the corner: the lever of body 1 is p - x1, with
//         the same p as the one of body 2": r1 = p - body1.x, ==> ;; x; ==> x; const vec3 r1 = p +
//         error(body1, body2) * up(body1) - body1.x;
// mistake "r1 ends in the middle of the top: the lever of body 1 is p - x1, with the same p as the
//         one of body 2": r1 = p - body1.x ==> r1 = height * up(body1)
// mistake "height is taken from r1: the lever of body 1 is p - x1, with the same p as the one of
//         body 2": r1 = p - body1.x ==> r1 = p - body1.x - height * up(body1)
// mistake "height is taken from both levers: they end at point()": p = point(body1, body2) ==> p =
//         point(body1, body2) - height * up(body1)
// wrong few-digits: vec3 p = point(body1, body2), r1 = p - body1.x, r2 = p - body2.x; return
//         {-direction, -cross(r1, direction), direction, cross(r2, direction)} ==> glm::vec3
//         r1(point(body1, body2) - body1.x), r2(point(body1, body2) - body2.x); const glm::vec3
//         d(direction); return {-direction, -vec3(cross(r1, d)), direction, vec3(cross(r2, d))}
// wrong levers-exchanged: body1.x, r2 = p - body2 ==> body2.x, r2 = p - body1
// mistake "J is in world axes: levers in axes of the bodies do not go with it": x; ==> x; const
//         vec3 l1 = to_local(body1, r1), l2 = to_local(body2, r2); ;; r1, ==> l1, ;; r2, ==> l2,
// mistake "the cross products are turned once more: levers and direction are in the world already":
//         -cross(r1, direction) ==> -to_world(body1, cross(r1, direction)) ;; cross(r2, direction)
//         ==> to_world(body2, cross(r2, direction))
// mistake "the cross products are turned into axes of the bodies: J is in world axes": -cross(r1,
//         direction) ==> -to_local(body1, cross(r1, direction)) ;; cross(r2, direction) ==>
//         to_local(body2, cross(r2, direction))
// mistake "the levers are turned once more: p - x is in the world already": x; ==> x; const vec3 l1
//         = to_world(body1, r1), l2 = to_world(body2, r2); ;; r1, ==> l1, ;; r2, ==> l2,
// mistake "the cross product in w1 is turned once more: lever and direction are in the world
//         already": -cross(r1, direction) ==> -to_world(body1, cross(r1, direction))
// mistake "the cross product in w1 is turned into axes of body 1: J is in world axes": -cross(r1,
//         direction) ==> -to_local(body1, cross(r1, direction))
// mistake "the lever in w1 is turned into axes of body 1: J is in world axes": -cross(r1,
//         direction) ==> -cross(to_local(body1, r1), direction)
// mistake "the lever in w1 is turned once more: p - x is in the world already": -cross(r1,
//         direction) ==> -cross(to_world(body1, r1), direction)
// mistake "the cross product in w2 is turned once more: lever and direction are in the world
//         already": direction, cross(r2, direction) ==> direction, to_world(body2, cross(r2,
//         direction))
// mistake "the cross product in w2 is turned into axes of body 2: J is in world axes": direction,
//         cross(r2, direction) ==> direction, to_local(body2, cross(r2, direction))
// mistake "the lever in w2 is turned once more: p - x is in the world already": direction,
//         cross(r2, direction) ==> direction, cross(to_world(body2, r2), direction)
// mistake "the lever of body 1 begins at the centre of both: p - x1": r1 = p - body1.x ==> r1 = p -
//         body1.x - body2.x
// mistake "n in the place of the direction in v1 and v2": return {-direction, -cross(r1,
//         direction), direction, cross(r2, direction)} ==> return {-up(body1), -cross(r1,
//         direction), up(body1), cross(r2, direction)}
// mistake "n in the place of the direction in w1 and w2": -cross(r1, direction) ==> -cross(r1,
//         up(body1)) ;; cross(r2, direction) ==> cross(r2, up(body1))
// mistake "n in the place of the direction in v1": return {-direction, -cross(r1, direction),
//         direction, cross(r2, direction)} ==> return {-up(body1), -cross(r1, direction),
//         direction, cross(r2, direction)}
// mistake "n in the place of the direction in w1": -cross(r1, direction) ==> -cross(r1, up(body1))
// mistake "n in the place of the direction in v2": return {-direction, -cross(r1, direction),
//         direction, cross(r2, direction)} ==> return {-direction, -cross(r1, direction),
//         up(body1), cross(r2, direction)}
// mistake "n in the place of the direction in w2": cross(r2, direction) ==> cross(r2, up(body1))
// mistake "beside a static body its blocks are left out: they stay, its inverse mass is 0 already":
//         x; ==> x; if (body1.is_static()) return {vec3(0), vec3(0), direction, cross(r2,
//         direction)};
// mistake "the lever of body 1 for both bodies: each lever begins at its own body's centre": .x, r2
//         = p - body2 ==> ;; r2 ==> r1
// mistake "the lever of body 2 for both bodies: each lever begins at its own body's centre": r1 = p
//         - body1.x, ==> ;; r1 ==> r2
// wrong order-of-blocks: -cross(r1, direction), direction ==> direction, -cross(r1, direction)
// wrong order-cross-products: r1, direction ==> direction, r1 ;; r2, direction ==> direction, r2
// mistake "a point where a lever belongs: p - x1 and p - x2, not p itself": , r1 = p - body1.x, r2
//         = p - body2.x ==> ;; r1 ==> p ;; r2 ==> p
// mistake "a point where a lever belongs: p - x1 and p - x2, not p itself, for body 1": r1 = p -
//         body1.x ==> r1 = p
// mistake "a point where a lever belongs: p - x1 and p - x2, not p itself, for body 2": r2 = p -
//         body2.x ==> r2 = p
// mistake "point(body2, body1): the other way round, the corner is one of body 2": body1, body2 ==>
//         body2, body1
// mistake "point(body2, body1): the other way round, the corner is one of body 2": body1, body2),
//         r1 = p - body1.x, r2 = p - body2.x ==> body2, body1), r1 = p - body2.x, r2 = p - body1.x
// mistake "point(body2, body1): the other way round, the corner is one of body 2": r1 = p ==> r1 =
//         point(body2, body1)
// mistake "point(body2, body1): the other way round, the corner is one of body 2": r2 = p ==> r2 =
//         point(body2, body1)
// mistake "the sign of the radius: the point is below the centre of the ball": point(body1, body2),
//         ==> world_point(body2, corner_local) + radius * up(body1); const vec3
// mistake "the radius is forgotten: the levers end at point(), the lowest point of the ball":
//         point(body1, body2) ==> world_point(body2, corner_local)
// expects: t1, w1.x
// mistake "the radius is forgotten in r1: the levers end at point(), the lowest point of the ball":
//         r1 = p ==> r1 = world_point(body2, corner_local)
// mistake "the radius is forgotten in r2: the levers end at point(), the lowest point of the ball":
//         p ==> r1 ;; , r1 = p ==> ;; p - body2.x ==> to_world(body2, corner_local)
// mistake "the radius is subtracted twice: point() has subtracted it already": , r1 ==> - radius *
//         up(body1); const vec3 r1
// wrong "the sign of the blocks v1 and w1: body 1 carries the minus sign": -direction, - ==>
//         direction,
// mistake "the sign of the whole row: J V is how fast body 2 moves along the direction":
//         -direction, - ==> direction, ;; direction, cross ==> -direction, -cross
// wrong "the sign of the block w1": -cross ==> cross
// mistake "a lever made a unit vector: it keeps its length, in w1 and w2": r1 = p - body1.x, r2 = p
//         - body2.x ==> r1 = normalize(p - body1.x), r2 = normalize(p - body2.x)
// mistake "a lever made a unit vector: it keeps its length, in w1": r1 = p - body1.x ==> r1 =
//         normalize(p - body1.x)
// mistake "a lever made a unit vector: it keeps its length, in w2": r2 = p - body2.x ==> r2 =
//         normalize(p - body2.x)
// wrong "a factor of 0.5 in the block w2": (r2, direction) ==> (r2, direction) / real(2)
// wrong without-levers:
  return {-direction, vec3(0), direction, vec3(0)};
// mistake "the block w1 is missing: body 1 has a lever, too, p - x1": , r1 = p - body1.x ==> ;;
//         -cross(r1, direction) ==> vec3(0)
// mistake "the block w2 is missing: body 2 has a lever, too, p - x2": , r2 = p - body2.x ==> ;;
//         cross(r2, direction) ==> vec3(0)
// mistake "the levers are rounded to millimetres: they keep all their digits": x; ==> x; const vec3
//         l1 = round(real(1000) * r1) / real(1000), l2 = round(real(1000) * r2) / real(1000); ;;
//         r1, ==> l1, ;; r2, ==> l2,
// mistake "the levers are rounded to centimetres: they keep all their digits": x; ==> x; const vec3
//         l1 = round(real(100) * r1) / real(100), l2 = round(real(100) * r2) / real(100); ;; r1,
//         ==> l1, ;; r2, ==> l2,
// mistake "the levers are cut to whole numbers: an int has no fraction": x; ==> x; const glm::ivec3
//         l1(r1), l2(r2); ;; r1, ==> vec3(l1), ;; r2, ==> vec3(l2),
// wrong drawn-cut: x; ==> x; const vec3 l1 = glm::clamp(r1, vec3(-50), vec3(50)); ;; cross(r1, ==>
//         cross(l1,
// expects: lever
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
