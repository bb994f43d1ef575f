// mistake "H has the other sign: it is m skew(c)": m * skew(c) ==> -m * skew(c)
// mistake "H without the mass": m * skew(c) ==> skew(c)
// mistake "H is missing: the centre is not at A": m * skew(c) ==> mat3(0)
// mistake "the part of J with c has the other sign: a body is heavier about any other point":
//         link.J[k] -= (m * c[k]) * c; link.J[k][k] += m * dot(c, c); ==> link.J[k] += (m * c[k]) *
//         c; link.J[k][k] -= m * dot(c, c);
// mistake "J without c c^T: a mass on the axis resists no rotation about it": link.J[k] -= (m *
//         c[k]) * c; ==>
// mistake "J without c.c E": link.J[k][k] += m * dot(c, c); ==>
// mistake "J is the inertia about the centre": link.J[k] -= (m * c[k]) * c; link.J[k][k] += m *
//         dot(c, c); ==>
// mistake "J without the inertia about the centre": link.J = link.inertia ==> link.J = mat3(0)
// mistake "J with the inertia in body space": link.J = link.inertia; ==> link.J = mat3(0);
//         link.J[0][0] = link.inertia_local.x; link.J[1][1] = link.inertia_local.y; link.J[2][2] =
//         link.inertia_local.z;
// mistake "J without the mass beside c": link.J[k] -= (m * c[k]) * c; link.J[k][k] += m * dot(c,
//         c); ==> link.J[k] -= c[k] * c; link.J[k][k] += dot(c, c);
// mistake "the length of c in the place of its square": m * dot(c, c) ==> m * length(c)
// mistake "J with half of m c.c": m * dot(c, c) ==> m / 2 * dot(c, c)
// mistake "c from the anchor in body space: use link.c": link.H = m * skew(c) ==> link.H = m *
//         skew(link.centre_local)
// mistake "M is the inverse mass": mat3(m) ==> mat3(1 / m)
// mistake "M has one in the place of the mass": mat3(m) ==> mat3(1)
// mistake "M is filled with the mass: only its diagonal has it": mat3(m) ==> mat3(m, m, m, m, m, m,
//         m, m, m)
// mistake "the first row of J is left out: a loop begins at 0": for (int k = 0; ==> for (int k = 1;
// mistake "the last row of J is left out: k goes from 0 to 2": k < 3; ==> k < 2;
// right by skew twice: for (int k = 0; k < 3; ++k) { link.J[k] -= (m * c[k]) * c; link.J[k][k] += m
//         * dot(c, c); ==> { link.J += m * skew(c) * transpose(skew(c));
// right by outer: for (int k = 0; k < 3; ++k) { link.J[k] -= (m * c[k]) * c; link.J[k][k] += m *
//         dot(c, c); ==> { link.J += m * (mat3(dot(c, c)) - outerProduct(c, c));
// wrong units "Units": m * skew(c) ==> skew(c)

// region 2
// mistake "the force from outside has the other sign: who holds the body pushes against it": -
//         link.force ==> + link.force
// mistake "the force from outside is missing": - link.force ==>
// mistake "the mass times the acceleration on the circle is missing": link.mass * cross(w, cross(w,
//         c)) - ==> -
// mistake "the acceleration on the circle points outwards": link.mass * cross(w, cross(w, c)) ==>
//         link.mass * cross(cross(w, c), w)
// mistake "the circle is that of the anchor: c, from A to the centre": cross(w, cross(w, c)) ==>
//         cross(w, cross(w, link.d))
// mistake "the acceleration on the circle without the mass": link.mass * cross(w ==> cross(w
// mistake "the lever's torque has the other sign: c x f": link.n = cross(c, link.f) ==> link.n =
//         cross(link.f, c)
// mistake "the lever's torque is missing": cross(c, link.f) - link.torque ==> -link.torque
// mistake "the force from outside is missing in c x f": cross(c, link.f) - link.torque ==> cross(c,
//         link.f + link.force) - link.torque
// mistake "the torque from outside has the other sign": - link.torque ==> + link.torque
// mistake "the torque from outside is missing": - link.torque ==>
// mistake "w x I w is missing: a body that rotates needs a torque": link.n += cross(w, link.inertia
//         * w) ==> ;
// mistake "the sign of w x I w": link.n += cross(w, link.inertia * w) ==> link.n -= cross(w,
//         link.inertia * w)
// mistake "I w with the inertia about A: J has its part with c in c x f already": link.inertia * w)
//         ==> link.J * w)
// mistake "I w with the moments in body space": link.inertia * w) ==> link.inertia_local * w)
// mistake "n is added to what was there": link.n = ==> link.n +=
// mistake "f is added to what was there": link.f = ==> link.f +=
// mistake "n reads f before it is set: the force first": link.n = cross(c, link.f) - link.torque;
//         ==> ;; link.f = link.mass ==> link.n = cross(c, link.f) - link.torque; link.f = link.mass
// right in another order: cross(c, link.f) - link.torque ==> -link.torque + cross(c, link.f)
// right always with w x I w: if (link.rotates_inertia) ==>
// wrong units "Units": link.mass * cross(w, cross(w, c)) ==> link.mass * cross(w, c)
