// wrong drawn-cut: min(vec3(1), max(moments, before) / now) ==> max(vec3(real(1e-9)),
//         min(vec3(1), max(moments, before) / now))
// wrong drawn-threshold: const vec3 now ==> if (std::max({moments.x, moments.y, moments.z}) <
//         real(1e-3)) { out.inverse_inertia_local = body.inverse_inertia_local; out.w = body.w;
//         return out; } const vec3 now
// wrong drawn-cut: const vec3 now = ==> vec3 now = ;; const vec3 ratio ==> const real most =
//         std::max({moments.x, moments.y, moments.z}); for (int k = 0; k < 3; ++k) if (moments[k] <
//         real(0.01) * most) now[k] = moments[k]; const vec3 ratio
// mistake "a fixed step of 1/60 s: take h": kappa * h * h ==> kappa / 3600
// mistake "each moment becomes at least the middle one: at least kappa h^2 |F||r|": out ==> vec3
//         sorted = moments; if (sorted.x > sorted.y) std::swap(sorted.x, sorted.y); if (sorted.y >
//         sorted.z) std::swap(sorted.y, sorted.z); if (sorted.x > sorted.y) std::swap(sorted.x,
//         sorted.y); out ;; 1) / now ==> 1) / max(vec3(sorted.y), now)
// mistake "the root of kappa: kappa h^2 |F||r|": kappa * h * h ==> std::sqrt(kappa) * h * h
// mistake "h is squared: kappa h^2 |F||r|": kappa * h * h * force_lever ==> kappa * h * force_lever
// mistake "h is missing: kappa h^2 |F||r|": kappa * h * h * force_lever ==> kappa * force_lever
// mistake "h to the third power: kappa h^2 |F||r|": force_lever ==> h * force_lever
// mistake "kappa is missing: kappa h^2 |F||r|": kappa * h * h * force_lever ==> h * h * force_lever
// mistake "the force is missing: kappa h^2 |F||r|": kappa * h * h * force_lever ==> vec3(kappa * h
//         * h)
// mistake "a fixed number: `kappa` is an argument": kappa ==> real(8)
// mistake "divided by h^2: times h^2": * h * h ==> / (h * h)
// mistake "the force is squared: it is |F||r| itself": force_lever ==> force_lever * force_lever
// mistake "twice: kappa h^2 |F||r|": kappa ==> 2 * kappa
// mistake "kappa h^2 |F||r| is added to the moments: each becomes at least that": max(moments,
//         kappa * h * h * force_lever) ==> moments + kappa * h * h * force_lever
// mistake "the lesser of the moment and kappa h^2 |F||r|: the greater": max ==> min
// mistake "the body's own moments are lost: the greater of the two": max(moments, kappa * h * h *
//         force_lever) ==> kappa * h * h * force_lever
// mistake "the difference of the least moment is added to all: each is raised separately":
//         max(moments, kappa * h * h * force_lever) ==> moments + max(vec3(0), kappa * h * h *
//         force_lever - vec3(std::min({moments.x, moments.y, moments.z})))
// mistake "only the first moment grows: all three": force_lever ==> vec3(force_lever.x, 0, 0)
// mistake "`before` is of the last step: this one has kappa h^2 |F||r|": kappa * h * h *
//         force_lever ==> before
// mistake "a moment stays as large as in the last step: it may become smaller again": kappa * h * h
//         * force_lever ==> max(before, kappa * h * h * force_lever)
// mistake "the inverse moments are taken for moments: 1 over each of them first": real(1) / ==>
// mistake "the moments are returned: 1 over each of them": real(1) / now ==> now
// mistake "the last step is forgotten: then each moment was at least `before`": max(moments,
//         before) / now ==> moments / now
// mistake "the body's own moments of the last step are lost: the greater of them and `before`":
//         max(moments, before) / now ==> before / now
// mistake "where a moment becomes smaller the angular velocity becomes larger: it stays, at most
//         1": min(vec3(1), max(moments, before) / now) ==> max(moments, before) / now
// mistake "the new moment over the old one: the old one over the new one": max(moments, before) /
//         now ==> now / max(moments, before)
// mistake "the greater of 1 and the ratio: the lesser": min ==> max
// mistake "the angular momentum is kept: it is the energy that stays, with a square root":
//         sqrt(ratio) ==> ratio
// mistake "the ratio is squared: its root": sqrt(ratio) ==> ratio * ratio
// mistake "the angular velocity is scaled in the world's axes: to_local() first, to_world() at
//         last": to_world(body, sqrt(ratio) * to_local(body, body.w)) ==> sqrt(ratio) * body.w
// mistake "to_world() is missing: w is in the world": to_world(body, sqrt(ratio) * to_local(body,
//         body.w)) ==> sqrt(ratio) * to_local(body, body.w)
// mistake "to_local() is missing: the moments are those of the body's own axes": to_local(body,
//         body.w) ==> body.w
// mistake "to_local() and to_world() are exchanged": to_local ==> to_world ;; to_world ==> to_local
// mistake "the angular velocity becomes larger: the old moment over the new one": sqrt(ratio) * ==>
//         real(1) / sqrt(ratio) *
// mistake "the angular momentum is returned: the ratio times w": sqrt(ratio) * ==> moments *
// mistake "one ratio for all three: each axis has its own": to_world(body, sqrt(ratio) *
//         to_local(body, body.w)) ==> std::sqrt(ratio.x) * body.w
// mistake "the mean ratio for all three: each axis has its own": to_world(body, sqrt(ratio) *
//         to_local(body, body.w)) ==> (std::sqrt(ratio.x) + std::sqrt(ratio.y) +
//         std::sqrt(ratio.z)) / 3 * body.w
// mistake "the linear velocity: w is the angular one": body.w ==> body.v
// mistake "the angular velocity stays: it becomes smaller where a moment grows": to_world(body,
//         sqrt(ratio) * to_local(body, body.w)) ==> body.w
// mistake "the angular velocity becomes zero: the energy stays": out.w = ==> (void)
// mistake "kappa is squared: kappa h^2 |F||r|": kappa * h * h ==> kappa * kappa * h * h
// mistake "a quarter of h^2, without kappa: that is the inertia with which h nu is 2. With kappa
//         h^2 |F||r| it is 1 / sqrt(kappa)": kappa * h * h ==> h * h / 4
// mistake "divided by kappa: h nu is 1 / sqrt(kappa) with kappa h^2 |F||r|": kappa * h * h ==> h *
//         h / kappa
// mistake "nothing is slowed where `before` is 0: then each moment was the body's own, and the
//         ratio is that over the new one": ratio = ==> ratio = before == vec3(0) ? vec3(1) :
// mistake "one ratio for all three: each axis has its own": to_world(body, sqrt(ratio) *
//         to_local(body, body.w)) ==> std::sqrt(std::min({ ratio.x, ratio.y, ratio.z})) * body.w
// mistake "one ratio for all three: each axis has its own": out.w = ==> const vec3 own =
//         to_local(body, body.w); const real after = dot(now * own, own), first = dot(max(moments,
//         before) * own, own); out.w = after == 0 ? body.w : std::sqrt(std::min(real(1), first /
//         after)) * body.w; (void)
// mistake "half of it: kappa h^2 |F||r|": kappa * h * h ==> kappa * h * h / 2
// mistake "the force is ignored, and nothing changes": kappa ==> 0 * kappa
// mistake "the inverse moments are taken for moments, and the greater is returned: 1 over each of
//         both": moments = real(1) / body ==> moments = body ;; real(1) / now ==> now
// mistake "the last step is forgotten, and its moments, too: each was at least `before`":
//         max(moments, before) ==> kappa * h * h * force_lever
// mistake "to_local() twice: to_world() at last": to_world ==> to_local
// mistake "one ratio for all three: each axis has its own": to_world(body, sqrt(ratio) *
//         to_local(body, body.w)) ==> std::sqrt(ratio.{x|y|z}) * body.w
// mistake "the linear velocity: w is the angular one": to_world(body, sqrt(ratio) * to_local(body,
//         body.w)) ==> body.v
// mistake "a fixed number: `kappa` is an argument": kappa * h * h ==> {8|16} * h * h
// mistake "the forces about one axis for all three: each axis has its own": force_lever ==>
//         vec3(force_lever.{x|y|z})
// mistake "the sum of the forces about all axes for each of them: each axis has its own":
//         force_lever ==> vec3(force_lever.x + force_lever.y + force_lever.z)
// mistake "the length of a vector for each axis: each has its own number": force_lever ==>
//         vec3(length(force_lever))
// mistake "one `before` for all axes: each has its own": before ==> vec3(before.{x|y|z})
// mistake "turned into the world: the forces are about the body's own axes": force_lever ==>
//         to_world(body, force_lever)
// mistake "turned into the body: the forces are about the body's own axes": force_lever ==>
//         to_local(body, force_lever)
// wrong units "in slowed": kappa * h * h * force_lever ==> kappa * h * force_lever
// wrong units "in slowed": kappa * h * h * force_lever ==> vec3(kappa * h * h)
// wrong units "in slowed": moments = real(1) / body ==> moments = body
// wrong units "the inverse inertia is in kg m^2 and should be in 1/(kg m^2)": real(1) / now ==> now
// wrong units "the angular velocity w is in kg m^2/s and should be in 1/s": sqrt(ratio) ==> moments
// wrong units "the angular velocity w is in m/s and should be in 1/s": body.w ==> body.v
// right in the world's axes with a matrix:
  const mat3 R = mat3_cast(body.q);
  vec3 after, share;
  for (int k = 0; k < 3; ++k) {
    const real own = 1 / body.inverse_inertia_local[k];
    const real last = own > before[k] ? own : before[k];
    after[k] = own;
    if (after[k] < h * h * kappa * force_lever[k]) after[k] = h * h * kappa * force_lever[k];
    share[k] = last < after[k] ? std::sqrt(last / after[k]) : real(1);
  }
  out.inverse_inertia_local = real(1) / after;
  out.w = R * (share * (transpose(R) * body.w));
// right the energy by name:
  const vec3& inverse = body.inverse_inertia_local;
  const vec3 w = to_local(body, body.w), follows = force_lever * (kappa * h * h);
  out.inverse_inertia_local = real(1) / max(real(1) / inverse, follows);
  const vec3 energy = w * w * max(real(1) / inverse, before);
  out.w = to_world(body, sign(w) * min(abs(w), sqrt(energy * out.inverse_inertia_local)));
