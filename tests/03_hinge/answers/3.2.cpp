// wrong a-copied-block: const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2); ==> ;;
//         I1 ==> inverse_inertia(body1) ;; w2, I2 ==> w1, inverse_inertia(body2)
// wrong sum-that-thrown-away: const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
//         return ==> real k; k = ;; + dot(a.w1, I1 * b.w1) ==> ; k = k + dot(a.w1,
//         inverse_inertia(body1) * b.w1); k ;; + dot(a.w2, I2 * b.w2); ==> ; k + dot(a.w2,
//         inverse_inertia(body2) * b.w2); return k;
// wrong "row a stands on both sides in the turn of body 2":
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * a.w2);
// wrong absolute-values:
  return std::abs(body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2));
// wrong body-2-alone:
  return body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
// wrong body-space-inertia: const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
//         ==> ;; I1 ==> body1.inverse_inertia_local ;; I2 ==> body2.inverse_inertia_local
// wrong crossed-v1-v2:
  return body1.inverse_mass * dot(a.v1, b.v2) + dot(a.w1, inverse_inertia(body1) * b.w2) +
         body2.inverse_mass * dot(a.v2, b.v1) + dot(a.w2, inverse_inertia(body2) * b.w1);
// wrong mass-inverse-mass:
  return dot(a.v1, b.v1) / body1.inverse_mass + dot(a.w1, inverse_inertia(body1) * b.w1) +
         dot(a.v2, b.v2) / body2.inverse_mass + dot(a.w2, inverse_inertia(body2) * b.w2);
// wrong few-digits:
  return float(body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2));
// wrong inertia-body-1-both: const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
//         ==> ;; I1 ==> inverse_inertia(body1) ;; I2 ==> inverse_inertia(body1)
// wrong inertia-other-body: const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
//         ==> ;; I1 ==> inverse_inertia(body2) ;; I2 ==> inverse_inertia(body1)
// wrong inertia-turned-wrong-way: I1 = inverse_inertia(body1), I2 = inverse_inertia ==> R1 =
//         glm::mat3_cast(body1.q), R2 = glm::mat3_cast(body2.q); const auto local = [](const Body&
//         body) { const vec3 I = body.inverse_inertia_local; return mat3(I.x, 0, 0, 0, I.y, 0, 0,
//         0, I.z); }; const mat3 L1 = local(body1), L2 = local ;; I1 ==> transpose(R1) * L1 * R1 ;;
//         I2 ==> transpose(R2) * L2 * R2
// wrong int-sum: const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2); return ==>
//         int k = 0; k += ;; + dot(a.w1, I1 * b.w1) + ==> ; k += dot(a.w1, inverse_inertia(body1) *
//         b.w1); k += ;; + dot(a.w2, I2 * b.w2); ==> ; k += dot(a.w2, inverse_inertia(body2) *
//         b.w2); return k;
// wrong local-inertia-body-2: const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
//         ==> ;; I1 ==> inverse_inertia(body1) ;; I2 ==> body2.inverse_inertia_local
// wrong local-rows: mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2) ==> auto turn =
//         [](const Body& body, const vec3& p, const vec3& q) { return dot(to_local(body, p),
//         inverse_inertia(body) * to_local(body, q)); } ;; dot(a.w1, I1 * b.w1) ==> turn(body1,
//         a.w1, b.w1) ;; dot(a.w2, I2 * b.w2) ==> turn(body2, a.w2, b.w2)
// wrong mass-inverse-mass: mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2); return
//         body1.inverse_mass ==> auto mass = [](const Body& body) { return body.is_static() ?
//         real(0) : 1 / body.inverse_mass; }; return mass(body1) ;; I1 ==> inverse_inertia(body1)
//         ;; body2.inverse_mass ==> mass(body2) ;; I2 ==> inverse_inertia(body2)
// wrong mass-body-2-both:
  return body2.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
// wrong max-0:
  const real k = body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
  return std::max(k, real(0));
// wrong minus-body-1:
  return -body1.inverse_mass * dot(a.v1, b.v1) - dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
// wrong "the sign of the turn of body 1: the blocks w1":
  return body1.inverse_mass * dot(a.v1, b.v1) - dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
// wrong "the turn of body 2 is missing":
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2);
// wrong only-local-side: mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2) ==> auto
//         answer = [](const Body& body, const vec3& q) { return body.inverse_inertia_local *
//         to_local(body, q); } ;; I1 * b.w1 ==> answer(body1, b.w1) ;; (a.w2, I2 * b.w2) ==> (a.w2,
//         answer(body2, b.w2))
// wrong "only the turn of body 2 is left: the blocks w2. Is an = there where += belongs?": const
//         mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2); return ==> real k = ;; +
//         dot(a.w1, I1 * b.w1) + ==> ; k += dot(a.w1, inverse_inertia(body1) * b.w1); k += ;; +
//         dot(a.w2, I2 * b.w2); ==> ; k = dot(a.w2, inverse_inertia(body2) * b.w2); return k;
// wrong threshold:
  const real k = body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
  return std::abs(k) < 0.1 ? 0 : k;
// wrong never-set: const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2); return ==>
//         real k; k += ;; + dot(a.w1, I1 * b.w1) + ==> ; k += dot(a.w1, inverse_inertia(body1) *
//         b.w1); k += ;; + dot(a.w2, I2 * b.w2); ==> ; k += dot(a.w2, inverse_inertia(body2) *
//         b.w2); return k;
// wrong w-terms-without-inertia: const mat3 I1 = inverse_inertia(body1), I2 =
//         inverse_inertia(body2); ==> ;; I1 * ==> ;; I2 ==> inverse_inertia(body2)
// wrong w1-for-w2: const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2); ==> ;; I1
//         ==> inverse_inertia(body1) ;; w2, I2 * b.w2 ==> w1, inverse_inertia(body2) * b.w1
// wrong without-turns:
  return body1.inverse_mass * dot(a.v1, b.v1) + body2.inverse_mass * dot(a.v2, b.v2);
// wrong "0 in every case: is it written at all, from what is given? Was it cut off by an int, or something in it never set?":
  return 0;
// wrong zero-static-body:
  if (body1.is_static() || body2.is_static()) return 0;
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
// wrong zero-static-body-2:
  if (body2.is_static()) return 0;
  return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, inverse_inertia(body1) * b.w1) +
         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, inverse_inertia(body2) * b.w2);
// right in body axes: mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2) ==> auto turn =
//         [](const Body& body, const vec3& p, const vec3& q) { return dot(to_local(body, p),
//         body.inverse_inertia_local * to_local(body, q)); } ;; dot(a.w1, I1 * b.w1) ==>
//         turn(body1, a.w1, b.w1) ;; dot(a.w2, I2 * b.w2) ==> turn(body2, a.w2, b.w2)
// right static left out: const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
//         return ==> real k = 0; if (!body1.is_static()) k += ;; (a.w1, I1 * b.w1) + ==> (a.w1,
//         inverse_inertia(body1) * b.w1); if (!body2.is_static()) k += ;; (a.w2, I2 * b.w2); ==>
//         (a.w2, inverse_inertia(body2) * b.w2); return k;
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
