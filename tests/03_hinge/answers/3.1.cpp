// wrong drawn-threshold: return {dot(a1, b), dot(a1, c)}; ==> const auto cut = [](real a) { return
//         std::abs(a) < real(1e-6) ? real(0) : a; }; return {cut(dot(a1, b)), cut(dot(a1, c))};
// mistake "1 minus the cosine: the vectors are at right angles, so a1.b itself is 0": dot(a1, b),
//         dot(a1, c) ==> 1 - dot(a1, b), 1 - dot(a1, c)
// wrong absolute-values: dot(a1, b), dot(a1, c) ==> std::abs(dot(a1, b)), std::abs(dot(a1, c))
// mistake "nothing is turned, or all by the same body: a1 rides on body 1, b and c on body 2":
//         dot(a1, b), dot(a1, c) ==> dot(a1_local, b_local), dot(a1_local, c_local)
// wrong b-twice: dot(a1, c) ==> dot(a1, b)
// mistake "b_local and c_local are not turned into the world": dot(a1, b), dot(a1, c) ==> dot(a1,
//         b_local), dot(a1, c_local)
// mistake "the cross product of the axes: that holds a1.c and -(a1.b)": return {dot(a1, b), dot(a1,
//         c)} ==> const vec3 across = cross(a1, cross(b, c)); return {dot(across, b), dot(across,
//         c)}
// mistake "0 in every case: it is never written, or cut off by an int, or a2 stands in the place of
//         a1 (a2 is at right angles to its own b and c)":
  const vec3 a2 = cross(b, c);
  return {dot(a2, b), dot(a2, c)};
// mistake "a point where a direction belongs: to_world, not world_point":
  const vec3 p = world_point(body1, a1_local);
  return {dot(p, world_point(body2, b_local)), dot(p, world_point(body2, c_local))};
// mistake "the sign of C": , dot ==> , - dot
// mistake "0 in every case: it is never written, or cut off by an int, or a2 stands in the place of
//         a1 (a2 is at right angles to its own b and c)": , dot(a1, c) ==>
// wrong never-set: return {dot(a1, b), dot(a1, c)} ==> Vector<2> C; for (int i = 0; i < 3; ++i) {
//         C[0] += a1[i] * b[i]; C[1] += a1[i] * c[i]; } return C
// wrong written-twice: return {dot(a1, b), dot(a1, c)}; ==> Vector<2> C{}; C[0] = dot(a1, b); C[0]
//         = dot(a1, c); return C;
// right C in the axes of body 1:
  const quat q = conjugate(body1.q) * body2.q;
  return {dot(a1_local, q * b_local), dot(a1_local, q * c_local)};
// right C in the axes of body 2:
  // The same products in body 2's own axes: a1 goes there, b and c stay.
  const vec3 a1_there = to_local(body2, a1);
  return {dot(a1_there, b_local), dot(a1_there, c_local)};
// right C with matrices:
  const mat3 R1 = glm::mat3_cast(body1.q), R2 = glm::mat3_cast(body2.q);
  return {dot(R1 * a1_local, R2 * b_local), dot(R1 * a1_local, R2 * c_local)};
// mistake "c_local is not turned into the world": dot(a1, c) ==> dot(a1, c_local)
// mistake "b_local is not turned into the world": dot(a1, b) ==> dot(a1, b_local)
// mistake "the sign of C": dot(a1, b), dot(a1, c) ==> -dot(a1, b), -dot(a1, c)
// mistake "the two numbers are exchanged: first a1.b, then a1.c": dot(a1, b), dot(a1, c) ==>
//         dot(a1, c), dot(a1, b)
// mistake "a1_local is not turned into the world": dot(a1, b), dot(a1, c) ==> dot(a1_local, b),
//         dot(a1_local, c)
// mistake "bodies 1 and 2 swapped: a1 rides on body 1, b and c on body 2": dot(a1, b), dot(a1, c)
//         ==> dot(to_world(body2, a1_local), to_world(body1, b_local)), dot(to_world(body2,
//         a1_local), to_world(body1, c_local))
// mistake "turned the wrong way: to_world, not to_local": dot(a1, b), dot(a1, c) ==>
//         dot(to_local(body1, a1_local), to_local(body2, b_local)), dot(to_local(body1, a1_local),
//         to_local(body2, c_local))
// mistake "a point where a direction belongs: to_world, not world_point": dot(a1, b), dot(a1, c)
//         ==> dot(body1.x + a1, b), dot(body1.x + a1, c)
// mistake "a point where a direction belongs: to_world, not world_point": dot(a1, b), dot(a1, c)
//         ==> dot(a1, body2.x + b), dot(a1, body2.x + c)
// mistake "lengths of cross products: C holds the dot products a1.b and a1.c": dot(a1, b), dot(a1,
//         c) ==> length(cross(a1, b)), length(cross(a1, c))
// mistake "the squares: C holds a1.b and a1.c themselves": dot(a1, b), dot(a1, c) ==> dot(a1, b) *
//         dot(a1, b), dot(a1, c) * dot(a1, c)
// mistake "the angle itself: C holds the cosines a1.b and a1.c as they are": dot(a1, b), dot(a1, c)
//         ==> std::asin(dot(a1, b)), std::asin(dot(a1, c))
// mistake "the angle itself: C holds the cosines a1.b and a1.c as they are": dot(a1, b), dot(a1, c)
//         ==> std::acos(dot(a1, b)), std::acos(dot(a1, c))

// region 2
// wrong "w1 of J[1] is that of J[0] (pencil and paper, upright, turned, moved, broken)": c, ==> b,
// mistake "a2 in the place of a1: b x a1, not b x a2": -cross(b, a1), vec3(0), cross(b, a1) ==> c,
//         vec3(0), -c ;; cross(c, a1), vec3(0), cross(c, a1) ==> b, vec3(0), b
// expects: (pencil and paper, broken)
// expects: Fails at broken; holds at upright, turned and moved.
// expects: Likely mistake: a2 in the place of a1: b x a1, not b x a2 (broken)
// mistake "b x c: that is a2. The rows hold b x a1 and c x a1":
// expects: (pencil and paper, upright, turned, moved, broken)
  return {{Row{vec3(0), -cross(b, c), vec3(0), cross(b, c)},
           Row{vec3(0), -cross(c, b), vec3(0), cross(c, b)}}};
// mistake "b_local and c_local are not turned into the world: take b and c above": b, a1 ==>
//         b_local, a1 ;; b, a1 ==> b_local, a1 ;; c, a1 ==> c_local, a1 ;; c, a1 ==> c_local, a1
// expects: (upright, turned, moved, broken)
// wrong "J[1], the row C.c, repeats J[0] (pencil and paper, upright, turned, moved, broken)": c,
//         ==> b, ;; c, ==> b,
// wrong "J[0] is written twice, J[1] never: the row C.c stands in the place of C.b": [1] ==> [0]
// wrong "a factor of 0.5 (pencil and paper, upright, turned, moved, broken)":
  const vec3 p = real(0.5) * cross(b, a1), q = real(0.5) * cross(c, a1);
  return {{Row{vec3(0), -p, vec3(0), p}, Row{vec3(0), -q, vec3(0), q}}};
// mistake "a1_local is not turned into the world: take a1 above":
// expects: (turned, moved, broken)
  const vec3 p = cross(b, a1_local), q = cross(c, a1_local);
  return {{Row{vec3(0), -p, vec3(0), p}, Row{vec3(0), -q, vec3(0), q}}};
// wrong "an index outside an array of 2 rows: its places run from 0 to 1":
  Jacobian<2> J;
  const vec3 d[2] = {b, c};
  for (int i = 0; i <= 2; ++i) J[i] = {vec3(0), -cross(d[i], a1), vec3(0), cross(d[i], a1)};
  return J;
// wrong few-digits: return J; ==> const auto few = [](const vec3& a) { return vec3(glm::vec3(a)); };
//         for (int i = 0; i < 2; ++i) J[i].w1 = few(J[i].w1), J[i].w2 = few(J[i].w2); return J;
// mistake "unit vectors: b x a1 becomes shorter as the axes part":
// expects: (pencil and paper, broken)
  const vec3 p = normalize(cross(b, a1)), q = normalize(cross(c, a1));
  return {{Row{vec3(0), -p, vec3(0), p}, Row{vec3(0), -q, vec3(0), q}}};
// wrong nearer-half-only: Jacobian ==> const vec3 axis = to_world(body1, a1_local); Jacobian ;; (b,
//         a1), vec3(0), cross(b, a1) ==> (b, axis), vec3(0), cross(b, axis) ;; (c, a1), vec3(0),
//         cross(c, a1) ==> (c, axis), vec3(0), cross(c, axis)
// wrong "J[1], the row C.c, is zero: was it never written? (pencil and paper, upright, turned,
//         moved, broken)":  J[1] = {vec3(0), -cross(c, a1), vec3(0), cross(c, a1)}; ==>
// wrong order-of-blocks (pencil and paper, upright, turned, moved, broken): -cross(b, a1), vec3(0)
//         ==> vec3(0), -cross(b, a1) ;; -cross(c, a1), vec3(0) ==> vec3(0), -cross(c, a1)
// mistake "the sign of the whole row: b x a1, not a1 x b; or bodies 1 and 2 swapped": b, a1 ==> a1,
//         b ;; b, a1 ==> a1, b ;; c, a1 ==> a1, c ;; c, a1 ==> a1, c
// wrong "in C.b alone: the sign of the block w2 (pencil and paper, upright, turned, moved,
//         broken)":
  const vec3 p = cross(b, a1), q = cross(c, a1);
  return {{Row{vec3(0), -p, vec3(0), -p}, Row{vec3(0), -q, vec3(0), q}}};
// wrong "the rows C.b and C.c are exchanged (pencil and paper, upright, turned, moved, broken)":
//          [0] ==> [0] = {vec3(0), -cross(c, a1), vec3(0), cross(c, a1)}; J[1] ;; J[1] = {vec3(0),
//         -cross(c, a1), vec3(0), cross(c, a1)}; ==>
// wrong "the sign of the block w1 (pencil and paper, upright, turned, moved, broken)": -cross ==>
//         cross ;; -cross ==> cross
// mistake "the sign of the whole row: b x a1, not a1 x b; or bodies 1 and 2 swapped": -cross(c,
//         a1), vec3(0), ==> cross(c, a1), vec3(0), -
// expects: (pencil and paper, upright, turned, moved, broken)
// wrong static-body-left-out (pencil and paper): J; ==> J; const real one = body1.is_static() ? 0 :
//         1; ;; cross ==> one * cross ;; -cross ==> -one * cross
// wrong never-set: Jacobian<2> J ==> real k; Jacobian<2> J; for (int i = 0; i < 3; ++i) k += b[i] *
//         a1[i] ;; , vec3 ==> * k, vec3
// mistake "the cross products stand in v1 and v2: they belong to w1 and w2": vec3(0), ==> ;; ,
//         cross(b, a1) ==> , cross(b, a1), vec3(0) ;; vec3(0), - ==> - ;; , cross(c, a1) ==> ,
//         cross(c, a1), vec3(0)
// expects: (pencil and paper, upright, turned, moved, broken)
// wrong "the block w1 is missing (pencil and paper, upright, turned, moved, broken)": -cross(b, a1)
//         ==> vec3(0) ;; -cross(c, a1) ==> vec3(0)
// right J about a turned b:
  // The rows may start as those of any other pair at right angles, here halfway between b and c: what
  // counts is that they are turned back to b and c.
  const real s = std::sqrt(real(0.5));
  const vec3 p = cross(s * (b + c), a1), q = cross(s * (c - b), a1);
  const vec3 first = s * (p - q), second = s * (p + q);
  return {{Row{vec3(0), -first, vec3(0), first}, Row{vec3(0), -second, vec3(0), second}}};
// right J by components: J[0] ==> const vec3 d[2] ;; {vec3(0), -cross(b, a1), vec3(0), cross(b,
//         a1)} ==> {b, c}; for (int i = 0; i < 2; ++i) { J[i].w2.x = d[i].y * a1.z - d[i].z * a1.y
//         ;; [1] = {vec3(0), -cross(c, a1), vec3(0), cross(c, a1)}; ==> [i].w2.y = d[i].z * a1.x -
//         d[i].x * a1.z; J[i].w2.z = d[i].x * a1.y - d[i].y * a1.x; J[i].w1 = -J[i].w2; }
// right J with a matrix:
  // b x a1 = -(a1 x b): the matrix of a1 with a minus.
  const vec3 first = -skew(a1) * b, second = -skew(a1) * c;
  return {{Row{vec3(0), -first, vec3(0), first}, Row{vec3(0), -second, vec3(0), second}}};
// right J with a1 x b and the other signs: -cross(b, a1), vec3(0), cross(b, a1) ==> cross(a1, b),
//         vec3(0), -cross(a1, b) ;; -cross(c, a1), vec3(0), cross(c, a1) ==> cross(a1, c), vec3(0),
//         -cross(a1, c)
// mistake "nothing is turned into the world: take a1, b and c above": Jacobian ==> const vec3 p =
//         cross(b_local, a1_local), q = cross(c_local, a1_local); Jacobian ;; -cross(b, a1),
//         vec3(0), cross(b, a1) ==> -p, vec3(0), p ;; -cross(c, a1), vec3(0), cross(c, a1) ==> -q,
//         vec3(0), q
// mistake "b x c: that is a2. The rows hold b x a1 and c x a1": -cross(b, a1), vec3(0), cross(b,
//         a1) ==> -cross(b, c), vec3(0), cross(b, c) ;; -cross(c, a1), vec3(0), cross(c, a1) ==>
//         -cross(b, c), vec3(0), cross(b, c)
// mistake "b and c themselves: the rows hold their cross products with a1": -cross(b, a1), vec3(0),
//         cross(b, a1) ==> -b, vec3(0), b ;; -cross(c, a1), vec3(0), cross(c, a1) ==> -c, vec3(0),
//         c
// mistake "a1 itself: the rows hold b x a1 and c x a1": -cross(b, a1), vec3(0), cross(b, a1) ==>
//         -a1, vec3(0), a1 ;; -cross(c, a1), vec3(0), cross(c, a1) ==> -a1, vec3(0), a1
