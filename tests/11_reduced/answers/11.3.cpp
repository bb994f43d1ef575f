// mistake "U of a hinge without the force: the child's anchor is pushed, too": link.Uv = link.a *
//         link.H; ==> link.Uv = vec3(0);
// mistake "H in the place of its transpose: the force of a hinge is H^T a": link.Uv = link.a *
//         link.H; ==> link.Uv = link.H * link.a;
// mistake "the transpose of H in the place of H: the torque of a slider is H a": link.Uw = link.H *
//         link.a; ==> link.Uw = link.a * link.H;
// mistake "U of a slider without the torque": link.Uw = link.H * link.a; ==> link.Uw = vec3(0);
// mistake "D of a hinge with the force: S is (a, 0)": link.D = dot(link.a, link.Uw) ==> link.D =
//         dot(link.a, link.Uv)
// mistake "D of a slider with the torque: S is (0, a)": link.D = dot(link.a, link.Uv) ==> link.D =
//         dot(link.a, link.Uw)
// mistake "D is the length of U": link.D = dot(link.a, link.Uw) ==> link.D = length(link.Uw) ;;
//         link.D = dot(link.a, link.Uv) ==> link.D = length(link.Uv)
// mistake "the axis of the parent's space": link.Uw = link.J * link.a ==> link.Uw = link.J *
//         link.axis_local
// mistake "`added` is missing in over_D": link.D + link.added ==> link.D
// mistake "1/D of a subtree without mass is infinite: over_D is 0 then": D > 0 ? 1 / D : real(0)
//         ==> 1 / D
// mistake "over_D is D: it is the inverse": D > 0 ? 1 / D : real(0) ==> D
// mistake "a held joint lets inertia slip through: it passes on all": if (!link.held) ==> if (true)
// mistake "only a held joint lets inertia slip through: it is the other way round": if (!link.held)
//         ==> if (link.held)
// mistake "U U^T is added: inertia slips through, so it is less": link.J -= ==> link.J += ;; link.H
//         -= ==> link.H += ;; link.M -= ==> link.M +=
// mistake "U U^T without 1/D": link.over_D * link.Uw, v = link.over_D * link.Uv ==> link.Uw, v =
//         link.Uv
// mistake "U U^T times D in the place of its inverse": w = link.over_D * link.Uw, v = link.over_D *
//         link.Uv ==> w = D * link.Uw, v = D * link.Uv
// mistake "J keeps what slips through": link.J -= outerProduct(link.Uw, w); ==>
// mistake "H keeps what slips through": link.H -= outerProduct(link.Uw, v); ==>
// mistake "M keeps what slips through": link.M -= outerProduct(link.Uv, v); ==>
// mistake "H loses Uv Uw^T: its rows belong to the torque": outerProduct(link.Uw, v) ==>
//         outerProduct(link.Uv, w)
// mistake "what slips through takes the place of H: it is subtracted": link.H -= ==> link.H =
// mistake "what slips through takes the place of M: it is subtracted": link.M -= ==> link.M =
// mistake "what slips through takes the place of J: it is subtracted": link.J -= ==> link.J =
// right with the transpose: link.Uv = link.a * link.H; ==> link.Uv = transpose(link.H) * link.a;
// right with outer alone: link.J -= outerProduct(link.Uw, w); ==> link.J -= link.over_D *
//         outerProduct(link.Uw, link.Uw);
// wrong units "Units": link.over_D = D > 0 ? 1 / D : real(0) ==> link.over_D = D

// region 2
// mistake "H travels without M: with a lever, a force is a torque": const mat3 moved = link.H + XM
//         ==> const mat3 moved = link.H
// mistake "H travels without its own part": const mat3 moved = link.H + XM ==> const mat3 moved =
//         XM
// mistake "the sign of the lever in H": link.H + XM ==> link.H - XM
// mistake "the sign of the lever in H": parent.H += moved ==> parent.H += link.H - XM
// mistake "H in the place of its transpose, in J": transpose(crossed(d, transpose(link.H))) ==>
//         crossed(d, link.H)
// mistake "M is not added": parent.M += link.M; ==>
// mistake "H is not added": parent.H += moved; ==>
// mistake "J travels without the lever": link.J + transpose(crossed(d, transpose(link.H))) +
//         crossed(d, transpose(moved)) ==> link.J
// mistake "J without X (H + X M)^T": + crossed(d, transpose(moved)) ==>
// mistake "J without (X H^T)^T": + transpose(crossed(d, transpose(link.H))) ==>
// mistake "J without its own part": parent.J += link.J + ==> parent.J +=
// mistake "the other transpose of X H^T in J: J stays symmetric": transpose(crossed(d,
//         transpose(link.H))) ==> crossed(d, transpose(link.H))
// mistake "H in the place of its transpose, in J": crossed(d, transpose(moved)) ==> crossed(d,
//         moved)
// mistake "X H^T comes twice, X M X^T never": crossed(d, transpose(moved)) ==> crossed(d,
//         transpose(link.H))
// mistake "the sign of the last term of J": + crossed(d, transpose(moved)) ==> - crossed(d,
//         transpose(moved))
// mistake "they take the place of the parent's own: each child adds to it": parent.M += ==>
//         parent.M = ;; parent.H += ==> parent.H = ;; parent.J += ==> parent.J =
// right by matrices of the lever: const mat3 moved ==> const mat3 X = skew(d); const mat3 moved ;;
//         link.J + transpose(crossed(d, transpose(link.H))) + crossed(d, transpose(moved)) ==>
//         link.J + link.H * transpose(X) + X * transpose(moved)
// wrong units "Units": link.H + XM ==> link.H + link.M

// region 3
// mistake "gamma is left out of the torque: J and H belong to the bias, too": n += link.H *
//         link.gamma; ==>
// mistake "gamma is left out of the force": f += link.M * link.gamma; ==>
// mistake "gamma is left out: J and H belong to the bias, too": n += link.H * link.gamma; ==> ;; f
//         += link.M * link.gamma; ==>
// mistake "gamma and zeta are left out": n += link.H * link.gamma; ==> ;; f += link.M * link.gamma;
//         ==> ;; n += link.J * link.zeta; f += link.zeta * link.H; ==>
// mistake "zeta is left out": n += link.J * link.zeta; f += link.zeta * link.H; ==>
// mistake "zeta is left out of the force": f += link.zeta * link.H; ==>
// mistake "H in the place of its transpose: the force of zeta is H^T zeta": f += link.zeta * link.H
//         ==> f += link.H * link.zeta
// mistake "the transpose of H in the place of H: the torque of gamma is H gamma": n += link.H *
//         link.gamma ==> n += link.gamma * link.H
// mistake "k of a hinge with the force: S is (a, 0)": link.tau - dot(link.a, link.n) ==> link.tau -
//         dot(link.a, link.f)
// mistake "k of a slider with the torque: S is (0, a)": link.tau - dot(link.a, link.f) ==> link.tau
//         - dot(link.a, link.n)
// mistake "k without tau": link.tau - dot ==> -dot ;; link.tau - dot ==> -dot
// mistake "the sign of the bias in k": link.k = link.tau - dot(link.a, link.n) ==> link.k =
//         link.tau + dot(link.a, link.n) ;; link.k = link.tau - dot(link.a, link.f) ==> link.k =
//         link.tau + dot(link.a, link.f)
// mistake "k with the terms of gamma and zeta: they come when the parent's acceleration is known":
//         n += link.J * link.zeta; f += link.zeta * link.H; ==> n += link.J * link.zeta; f +=
//         link.zeta * link.H; link.k = link.tau - dot(link.a, n); ;; link.k = link.tau -
//         dot(link.a, link.f) ==> link.k = link.tau - dot(link.a, f)
// mistake "a held joint passes on over_D k: its acceleration is known": link.held ?
//         link.acceleration : link.over_D * link.k ==> link.over_D * link.k
// mistake "a joint that is not held passes on its last acceleration": link.held ? link.acceleration
//         : link.over_D * link.k ==> link.acceleration
// mistake "held and not held exchanged": link.held ? ==> !link.held ?
// mistake "k without 1/D": link.over_D * link.k ==> link.k
// mistake "U is left out: what the free motion answers belongs to the bias": n += along * link.Uw;
//         ==> ;; f += along * link.Uv; ==>
// mistake "U has the other sign": n += along * link.Uw ==> n -= along * link.Uw ;; f += along *
//         link.Uv ==> f -= along * link.Uv
// mistake "U is left out of the force": f += along * link.Uv; ==>
// mistake "U is left out of the torque": n += along * link.Uw; ==>
// mistake "a weld is left out: it passes on what gamma needs, too": n += link.H * link.gamma ==> if
//         (hinge || slider) n += link.H * link.gamma ;; f += link.M * link.gamma ==> if (hinge ||
//         slider) f += link.M * link.gamma
// right with zeta for all kinds: n += link.J * link.zeta; f += link.zeta * link.H; ==> ;; n +=
//         link.H * link.gamma; ==> n += link.J * link.zeta + link.H * link.gamma; f += link.zeta *
//         link.H;
// wrong units "Units": link.over_D * link.k ==> link.k
