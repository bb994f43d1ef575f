// wrong drawn-threshold: return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, I1 * b.w1) +
//         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, I2 * b.w2); ==> const real k =
//         body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, I1 * b.w1) + body2.inverse_mass *
//         dot(a.v2, b.v2) + dot(a.w2, I2 * b.w2); return std::abs(k) < real(1e-9) ? 0 : k;
// wrong sum-that-thrown-away: return ==> real k = ;; + body2 ==> ; k + body2 ;; b.w2); ==> b.w2);
//         return k;
// wrong absolute-values: return ==> return std::abs( ;; b.w2); ==> b.w2));
// wrong body-2-alone: body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, I1 * b.w1) + ==>
// wrong mass-inverse-mass:
  return dot(a.v1, b.v1) / body1.inverse_mass + dot(a.w1, inverse_inertia(body1) * b.w1) +
         dot(a.v2, b.v2) / body2.inverse_mass + dot(a.w2, inverse_inertia(body2) * b.w2);
// wrong few-digits: return ==> return float( ;; b.w2); ==> b.w2));
// wrong inertia-turned-wrong-way: I1 = inverse_inertia(body1), I2 = inverse_inertia ==> R1 =
//         glm::mat3_cast(body1.q), R2 = glm::mat3_cast(body2.q); const auto local = [](const Body&
//         body) { const vec3 I = body.inverse_inertia_local; return mat3(I.x, 0, 0, 0, I.y, 0, 0,
//         0, I.z); }; const mat3 L1 = local(body1), L2 = local ;; I1 ==> transpose(R1) * L1 * R1 ;;
//         I2 ==> transpose(R2) * L2 * R2
// wrong int-sum: return ==> int k = 0; k += ;; + dot(a.w1 ==> ; k += dot(a.w1 ;; + body2 ==> ; k +=
//         body2 ;; + dot(a.w2 ==> ; k += dot(a.w2 ;; b.w2); ==> b.w2); return k;
// wrong only-local-side: mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2) ==> auto
//         answer = [](const Body& body, const vec3& q) { return body.inverse_inertia_local *
//         to_local(body, q); } ;; I1 * b.w1 ==> answer(body1, b.w1) ;; (a.w2, I2 * b.w2) ==> (a.w2,
//         answer(body2, b.w2))
// wrong "only the turn of body 2 is left: the blocks w2. Is an = there where += belongs?": return
//         ==> real k = ;; + dot(a.w2 ==> ; k = dot(a.w2 ;; b.w2); ==> b.w2); return k;
// wrong never-set: return ==> real k; k += ;; b.w2); ==> b.w2); return k;
// wrong without-turns: + dot(a.w1, I1 * b.w1) ==> ;; + dot(a.w2, I2 * b.w2) ==>
// wrong "0 in every case: is it computed from the arguments? Was it cut off by an int, or does it use a variable that was never set?": return ==> return 0; return
// right in body axes: mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2) ==> auto turn =
//         [](const Body& body, const vec3& p, const vec3& q) { return dot(to_local(body, p),
//         body.inverse_inertia_local * to_local(body, q)); } ;; dot(a.w1, I1 * b.w1) ==>
//         turn(body1, a.w1, b.w1) ;; dot(a.w2, I2 * b.w2) ==> turn(body2, a.w2, b.w2)
// right static left out: return ==> real k = 0; if (!body1.is_static()) k += ;; + body2 ==> ; if
//         (!body2.is_static()) k += body2 ;; b.w2); ==> b.w2); return k;
// right transposed product:
  return body1.inverse_mass * dot(b.v1, a.v1) + dot(a.w1 * inverse_inertia(body1), b.w1) +
         body2.inverse_mass * dot(b.v2, a.v2) + dot(a.w2 * inverse_inertia(body2), b.w2);
// right velocities first:
  // First what an impulse of 1 along b does to the velocities, then the rate that row a sees.
  Body one = body1, two = body2;
  one.v = body1.inverse_mass * b.v1;
  one.w = inverse_inertia(body1) * b.w1;
  two.v = body2.inverse_mass * b.v2;
  two.w = inverse_inertia(body2) * b.w2;
  return row_velocity(a, one, two);
// right in one sum:
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
// from right in body axes
// wrong local-rows: body.inverse_inertia_local ==> inverse_inertia(body)
// from right in one sum
// wrong a-copied-block: w2 ==> w1
// wrong "row a stands on both sides in the turn of body 2": b.w2 ==> a.w2
// wrong body-space-inertia: inverse_inertia(body1) ==> body1.inverse_inertia_local ;;
//         inverse_inertia(body2) ==> body2.inverse_inertia_local
// wrong crossed-v1-v2: b.w2 ==> b.w1 ;; b.v2 ==> b.v1 ;; b.w1 ==> b.w2 ;; b.v1 ==> b.v2
// wrong inertia-body-1-both: (body2) ==> (body1)
// wrong inertia-other-body: (body2) ==> (body1) ;; (body1) ==> (body2)
// wrong local-inertia-body-2: inverse_inertia(body2) ==> body2.inverse_inertia_local
// wrong mass-inverse-mass: return body1.inverse_mass ==> const auto mass = [](const Body& body) {
//         return body.is_static() ? real(0) : 1 / body.inverse_mass; }; return mass(body1) ;;
//         body2.inverse_mass ==> mass(body2)
// wrong mass-body-2-both: body1 ==> body2
// wrong max-0: return ==> const real k = ;; w2); ==> w2); return std::max(k, real(0));
// wrong minus-body-1: body1 ==> -body1 ;; + dot ==> - dot
// wrong "the sign of the turn of body 1: the blocks w1": + dot ==> - dot
// wrong "the turn of body 2 is missing": + dot(a.w2, inverse_inertia(body2) * b.w2) ==>
// wrong threshold: return ==> const real k = ;; w2); ==> w2); return std::abs(k) < 0.1 ? 0 : k;
// wrong w-terms-without-inertia: inverse_inertia(body1) * ==>
// wrong w1-for-w2: w2 ==> w1 ;; w2 ==> w1
// wrong zero-static-body: return ==> if (body1.is_static() || body2.is_static()) return 0; return
// wrong zero-static-body-2: return ==> if (body2.is_static()) return 0; return
