// wrong drawn-threshold: const vec3 now ==> if (std::max({moments.x, moments.y, moments.z}) <
//         real(1e-3)) { out.inverse_inertia_local = body.inverse_inertia_local; out.w = body.w;
//         return out; } const vec3 now
// wrong fixed-step-h: kappa * h * h ==> kappa / 3600
// wrong middle-moment: out.inverse_inertia_local = ==> vec3 sorted = moments; if (sorted.x >
//         sorted.y) std::swap(sorted.x, sorted.y); if (sorted.y > sorted.z) std::swap(sorted.y,
//         sorted.z); if (sorted.x > sorted.y) std::swap(sorted.x, sorted.y);
//         out.inverse_inertia_local = ;; real(1) / now ==> real(1) / max(vec3(sorted.y), now)
// wrong root-kappa: kappa * h * h ==> std::sqrt(kappa) * h * h
// wrong h-not-squared: kappa * h * h * force_lever ==> kappa * h * force_lever
// wrong followed-h-missing: kappa * h * h * force_lever ==> kappa * force_lever
// wrong h-cubed: kappa * h * h * force_lever ==> kappa * h * h * h * force_lever
// wrong kappa-missing: kappa * h * h * force_lever ==> h * h * force_lever
// wrong force-missing: kappa * h * h * force_lever ==> kappa * h * h
// wrong fixed-kappa: kappa * h * h * force_lever ==> real(8) * h * h * force_lever
// wrong followed-divided-h-squared: kappa * h * h * force_lever ==> kappa / (h * h) * force_lever
// wrong force-squared: kappa * h * h * force_lever ==> kappa * h * h * force_lever * force_lever
// wrong twice: kappa * h * h * force_lever ==> 2 * kappa * h * h * force_lever
// wrong inertia-added: max(moments, vec3(kappa * h * h * force_lever)) ==> moments + vec3(kappa *
//         h * h * force_lever)
// wrong lesser: max ==> min
// wrong own-moments-lost: now = max(moments, vec3(kappa * h * h * force_lever)) ==> now(kappa * h
//         * h * force_lever)
// wrong least-lacks: max(moments, vec3(kappa * h * h * force_lever)) ==> moments +
//         vec3(std::max(real(0), kappa * h * h * force_lever - std::min({moments.x, moments.y,
//         moments.z})))
// wrong first-moment-alone: force_lever ==> force_lever, 0, 0
// wrong bound-of-last-step: vec3(kappa * h * h * force_lever) ==> vec3(before)
// wrong never-smaller: vec3(kappa * h * h * force_lever) ==> vec3(std::max(before, kappa * h * h *
//         force_lever))
// wrong inverse-moments: moments = real(1) / body ==> moments = body
// wrong moments-returned: real(1) / now ==> now
// wrong last-step-forgotten: max(moments, vec3(before)) / now ==> moments / now
// wrong last-moments-lost: max(moments, vec3(before)) / now ==> vec3(before) / now
// wrong ratio-unbounded: min(vec3(1), max(moments, vec3(before)) / now) ==> max(moments,
//         vec3(before)) / now
// wrong ratio-inverted: max(moments, vec3(before)) / now ==> now / max(moments, vec3(before))
// wrong ratio-at-least-one: min ==> max
// wrong momentum-kept: sqrt(ratio) ==> ratio
// wrong ratio-squared: sqrt(ratio) ==> ratio * ratio
// wrong scaled-in-world: to_world(body, sqrt(ratio) * to_local(body, body.w)) ==> sqrt(ratio) *
//         body.w
// wrong to-world-missing: to_world(body, sqrt(ratio) * to_local(body, body.w)) ==> sqrt(ratio) *
//         to_local(body, body.w)
// wrong to-local-missing: to_local(body, body.w) ==> body.w
// wrong axes-exchanged: to_local ==> to_world ;; to_world ==> to_local
// wrong ratio-upside-down: sqrt(ratio) * ==> real(1) / sqrt(ratio) *
// wrong momentum-returned: sqrt(ratio) * ==> moments *
// wrong one-ratio: to_world(body, sqrt(ratio) * to_local(body, body.w)) ==> std::sqrt(ratio.x) *
//         body.w
// wrong mean-ratio: to_world(body, sqrt(ratio) * to_local(body, body.w)) ==> (std::sqrt(ratio.x) +
//         std::sqrt(ratio.y) + std::sqrt(ratio.z)) / 3 * body.w
// wrong linear-velocity: body.w ==> body.v
// wrong w-stays: to_world(body, sqrt(ratio) * to_local(body, body.w)) ==> body.w
// wrong w-zero: out.w = ==> (void)
// wrong kappa-squared: kappa * h * h ==> kappa * kappa * h * h
// wrong quarter-of-h-squared: kappa * h * h ==> h * h / 4
// wrong divided-by-kappa: kappa * h * h ==> h * h / kappa
// wrong first-time-not-slowed: ratio = ==> ratio = before == 0 ? vec3(1) :
// wrong one-ratio: to_world(body, sqrt(ratio) * to_local(body, body.w)) ==> std::sqrt(std::min({
//         ratio.x, ratio.y, ratio.z})) * body.w
// wrong one-ratio: out.w = ==> const vec3 own = to_local(body, body.w); const real after = dot(now
//         * own, own), first = dot(max(moments, vec3(before)) * own, own); out.w = after == 0 ?
//         body.w : std::sqrt(std::min(real(1), first / after)) * body.w; (void)
// wrong followed-half: kappa * h * h ==> kappa * h * h / 2
// wrong force-ignored: vec3(kappa * h * h * force_lever) ==> vec3(0 * kappa * h * h * force_lever)
// wrong inverse-both: moments = real(1) / body ==> moments = body ;; real(1) / now ==> now
// wrong last-step-replaced: max(moments, vec3(before)) ==> vec3(kappa * h * h * force_lever)
// wrong to-local-twice: to_world ==> to_local
// wrong units "in slowed": kappa * h * h * force_lever ==> kappa * h * force_lever
// wrong units "in slowed": kappa * h * h * force_lever ==> kappa * h * h
// wrong units "in slowed": moments = real(1) / body ==> moments = body
// wrong units "the inverse inertia is in kg m^2 and should be in 1/(kg m^2)": real(1) / now ==> now
// wrong units "the angular velocity w is in kg m^2/s and should be in 1/s": sqrt(ratio) ==> moments
// wrong units "the angular velocity w is in m/s and should be in 1/s": body.w ==> body.v
// right in the world's axes with a matrix:
  const mat3 R = mat3_cast(body.q);
  vec3 after, share;
  for (int k = 0; k < 3; ++k) {
    const real own = 1 / body.inverse_inertia_local[k];
    const real last = own > before ? own : before;
    after[k] = own;
    if (after[k] < h * h * kappa * force_lever) after[k] = h * h * kappa * force_lever;
    share[k] = last < after[k] ? std::sqrt(last / after[k]) : real(1);
  }
  out.inverse_inertia_local = real(1) / after;
  out.w = R * (share * (transpose(R) * body.w));
// right the energy by name:
  const vec3& inverse = body.inverse_inertia_local;
  const vec3 w = to_local(body, body.w), follows(kappa * h * h * force_lever);
  out.inverse_inertia_local = real(1) / max(real(1) / inverse, follows);
  const vec3 energy = w * w * max(real(1) / inverse, vec3(before));
  out.w = to_world(body, sign(w) * min(abs(w), sqrt(energy * out.inverse_inertia_local)));
