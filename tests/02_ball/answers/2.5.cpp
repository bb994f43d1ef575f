// mistake "the body stays: nothing has been rotated": body.q = turned(body.q, rate * axis, time);
//         ==> ;; body.q = turned(body.q, inverse[m] * L, h); ==>
// mistake "the rotation about L is missing: it is the first term of Eq. 2-11": body.q =
//         turned(body.q, inverse[m] * L, h); ==>
// mistake "the rotations about the body's own axes are missing": body.q = turned(body.q, rate *
//         axis, time); ==>
// mistake "w is kept, or computed before the rotation, and L is lost: w follows from L and the new
//         orientation": body.w = inverse_inertia(body) * L; ==>
// mistake "the moments are forgotten: the rate is L_a (1/I_a - 1/I_m)": (inverse[i] - inverse[m])
//         ==> inverse[i]
// mistake "the sign of the difference: 1/I_a - 1/I_m": (inverse[i] - inverse[m]) ==> (inverse[m] -
//         inverse[i])
// mistake "the moments are subtracted: it is the difference of their inverses": (inverse[i] -
//         inverse[m]) ==> (1 / inverse[i] - 1 / inverse[m])
// mistake "about L the rate is L/I_m: here it is divided by I_a": inverse[m] * L ==> inverse[a] * L
// mistake "about L the rate is L/I_m: here it is divided by I_b": inverse[m] * L ==> inverse[b] * L
// mistake "about L the rate is L/I_m: the moment is forgotten": inverse[m] * L ==> L
// mistake "w in the place of L/I_m: the last rotation is about L": inverse[m] * L ==> body.w
// mistake "this is exp(h w) q, all at once: L is held, but the rotation is that of a constant w":
//         for (const auto& [i, time] : {std::pair(a, h / 2), std::pair(b, h), std::pair(a, h / 2)})
//         { ==> body.q = turned(body.q, body.w, h); for (const auto& [i, time] : {std::pair(a,
//         real(0)), std::pair(b, real(0)), std::pair(m, real(0))}) { ;; body.q = turned(body.q,
//         inverse[m] * L, h); ==>
// mistake "all about a, then all about b: half, all and half make it symmetric": std::pair(a, h /
//         2), std::pair(b, h), std::pair(a, h / 2) ==> std::pair(a, h), std::pair(b, h)
// mistake "all about b, then all about a: half about a, all about b, half about a": std::pair(a, h
//         / 2), std::pair(b, h), std::pair(a, h / 2) ==> std::pair(b, h), std::pair(a, h)
// mistake "a and b are exchanged: half about a, all about b, half about a": std::pair(a, h / 2),
//         std::pair(b, h), std::pair(a, h / 2) ==> std::pair(b, h / 2), std::pair(a, h),
//         std::pair(b, h / 2)
// mistake "all of the rotation about a is done twice: half of it before b and half after":
//         std::pair(a, h / 2), std::pair(b, h), std::pair(a, h / 2) ==> std::pair(a, h),
//         std::pair(b, h), std::pair(a, h)
// mistake "the second half about a is missing": std::pair(b, h), std::pair(a, h / 2) ==>
//         std::pair(b, h)
// mistake "the last half is about b: it is the other half about a": std::pair(b, h), std::pair(a, h
//         / 2) ==> std::pair(b, h), std::pair(b, h / 2)
// mistake "only half of the rotation about b is done": std::pair(b, h) ==> std::pair(b, h / 2)
// mistake "the axes are in the world's directions: to_world(body, e) is the body's axis there":
//         axis = to_world(body, axis); ==>
// mistake "the axes, or the components of L along them, are those of the start: each rotation
//         changes them, so take each when its turn comes": const auto [a, m, b] =
//         axes_by_moment(body); ==> const auto [a, m, b] = axes_by_moment(body); const vec3 start =
//         to_local(body, L); ;; dot(L, axis) * ==> start[i] *
// mistake "the component of w in the place of that of L": dot(L, axis) ==> dot(body.w, axis)
// mistake "the axes are x, y, z as they come: axes_by_moment(body) has them by their moments": =
//         axes_by_moment(body) ==> = std::array<int, 3>{0, 1, 2}
// mistake "the centre is moved, too: only q and w change": body.w = inverse_inertia(body) * L; ==>
//         body.w = inverse_inertia(body) * L; body.x += h * body.v;
// wrong drawn-side: const vec3 L ==> if (h < 0) return; const vec3 L
// right tumble with the rotation about L first:
  // The rotation about L changes neither L_a nor L_b, so it may come first.
  const vec3 L = angular_momentum(body);
  const std::array<int, 3> axes = axes_by_moment(body);
  const real of_middle = body.inverse_inertia_local[axes[1]];
  body.q = turned(body.q, of_middle * L, h);
  const auto rotate = [&](int i, real time) {
    const vec3 along = i == 0 ? vec3(1, 0, 0) : i == 1 ? vec3(0, 1, 0) : vec3(0, 0, 1);
    const real size = to_local(body, L)[i];
    const real excess = body.inverse_inertia_local[i] - of_middle;
    body.q = turned(body.q, to_world(body, size * excess * along), time);
  };
  rotate(axes[0], real(0.5) * h);
  rotate(axes[2], h);
  rotate(axes[0], real(0.5) * h);
  set_angular_momentum(body, L);
// right tumble on the right side of q:
  // The rotations about the body's own axes as right factors; L rotates the other way in the body.
  const vec3 L = angular_momentum(body);
  const auto [a, m, b] = axes_by_moment(body);
  vec3 inside = to_local(body, L);
  const auto rotate = [&](int i, real time, int middle) {
    vec3 phi(0);
    const vec3& inverse = body.inverse_inertia_local;
    phi[i] = time * inside[i] * (inverse[i] - inverse[middle]);
    body.q = body.q * rotation(phi);
    inside = conjugate(rotation(phi)) * inside;
  };
  rotate(a, h / 2, m);
  rotate(b, h, m);
  rotate(a, h / 2, m);
  body.q = normalize(rotation(h * body.inverse_inertia_local[m] * L) * body.q);
  set_angular_momentum(body, L);
// wrong units "in the free rotation": inverse[m] * L ==> L
