// wrong drawn-threshold: return body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, I1 * b.w1) +
//         body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, I2 * b.w2); ==> const real k =
//         body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, I1 * b.w1) + body2.inverse_mass *
//         dot(a.v2, b.v2) + dot(a.w2, I2 * b.w2); return std::abs(k) < real(1e-9) ? 0 : k;
// mistake "body 2 is missing": return ==> real k = ;; + body2 ==> ; k + body2 ;; b.w2); ==> b.w2);
//         return k;
// wrong absolute-values: return ==> return std::abs( ;; b.w2); ==> b.w2));
// mistake "body 1 is missing": body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, I1 * b.w1) + ==>
// mistake "masses where inverse masses belong: M^-1 divides by the mass":
  return dot(a.v1, b.v1) / body1.inverse_mass + dot(a.w1, inverse_inertia(body1) * b.w1) +
         dot(a.v2, b.v2) / body2.inverse_mass + dot(a.w2, inverse_inertia(body2) * b.w2);
// wrong few-digits: return ==> return float( ;; b.w2); ==> b.w2));
// mistake "the inertia is turned the wrong way round: R I^-1 R^T, not R^T I^-1 R": I1 =
//         inverse_inertia(body1), I2 = inverse_inertia ==> R1 = glm::mat3_cast(body1.q), R2 =
//         glm::mat3_cast(body2.q); const auto local = [](const Body& body) { const vec3 I =
//         body.inverse_inertia_local; return mat3(I.x, 0, 0, 0, I.y, 0, 0, 0, I.z); }; const mat3
//         L1 = local(body1), L2 = local ;; I1 ==> transpose(R1) * L1 * R1 ;; I2 ==> transpose(R2) *
//         L2 * R2
// mistake "the sum is an int: it cuts the fraction off": return ==> int k = 0; k += ;; + dot(a.w1
//         ==> ; k += dot(a.w1 ;; + body2 ==> ; k += body2 ;; + dot(a.w2 ==> ; k += dot(a.w2 ;;
//         b.w2); ==> b.w2); return k;
// mistake "one side is turned into the body's axes and not the other: take inverse_inertia(body)":
//         mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2) ==> auto answer = [](const
//         Body& body, const vec3& q) { return body.inverse_inertia_local * to_local(body, q); } ;;
//         I1 * b.w1 ==> answer(body1, b.w1) ;; (a.w2, I2 * b.w2) ==> (a.w2, answer(body2, b.w2))
// wrong "only the turn of body 2 is left: the blocks w2. Is an = there where += belongs?": return
//         ==> real k = ;; + dot(a.w2 ==> ; k = dot(a.w2 ;; b.w2); ==> b.w2); return k;
// wrong never-set: return ==> real k; k += ;; b.w2); ==> b.w2); return k;
// mistake "the angular parts are missing: the blocks w1 and w2": + dot(a.w1, I1 * b.w1) ==> ;; +
//         dot(a.w2, I2 * b.w2) ==>
// wrong "0 in every case: is it computed from the arguments? Was it cut off by an int, or does it
//         use a variable that was never set?": return ==> return 0; return
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
// mistake "masses and inertias where their inverses belong": I1 = inverse_inertia(body1), I2 =
//         inverse_inertia(body2) ==> I1 = inverse(inverse_inertia(body1)), I2 =
//         inverse(inverse_inertia(body2)) ;; body1.inverse_mass * dot(a.v1, b.v1) ==> dot(a.v1,
//         b.v1) / body1.inverse_mass ;; body2.inverse_mass * dot(a.v2, b.v2) ==> dot(a.v2, b.v2) /
//         body2.inverse_mass
// mistake "masses and inertias where their inverses belong": const mat3 I1 =
//         inverse_inertia(body1), I2 = inverse_inertia(body2) ==> const auto inertia = [](const
//         Body& body) { return body.is_static() ? mat3(0) : mat3(inverse(inverse_inertia(body)));
//         }; const auto mass = [](const Body& body) { return body.is_static() ? real(0) : 1 /
//         body.inverse_mass; }; const mat3 I1 = inertia(body1), I2 = inertia(body2) ;;
//         body1.inverse_mass * ==> mass(body1) * ;; body2.inverse_mass * ==> mass(body2) *
// mistake "inertia where inverse inertia belongs: inverse_inertia(body) is inverted already": I1 =
//         inverse_inertia(body1), I2 = inverse_inertia(body2) ==> I1 =
//         inverse(inverse_inertia(body1)), I2 = inverse(inverse_inertia(body2))
// mistake "inertia where inverse inertia belongs: inverse_inertia(body) is inverted already": const
//         mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2) ==> const auto inertia =
//         [](const Body& body) { return body.is_static() ? mat3(0) :
//         mat3(inverse(inverse_inertia(body))); }; const mat3 I1 = inertia(body1), I2 =
//         inertia(body2)
// mistake "body-space inertia of body 1: take inverse_inertia(body)": I1 * b ==>
//         body1.inverse_inertia_local * b
// mistake "the inverse inertia of body 2 is missing": I2 * b ==> b
// mistake "the inertia is turned by R alone: R I^-1 R^T": I1 = inverse_inertia(body1), I2 =
//         inverse_inertia(body2) ==> I1 = inverse_inertia(body1) * glm::mat3_cast(body1.q), I2 =
//         inverse_inertia(body2) * glm::mat3_cast(body2.q)
// mistake "inverse mass where inverse inertia belongs": I1 = inverse_inertia(body1), I2 =
//         inverse_inertia(body2) ==> I1(body1.inverse_mass), I2(body2.inverse_mass)
// mistake "each product belongs to its own body's inverse mass, not to the sum of both": return
//         body1.inverse_mass ==> const real sum = body1.inverse_mass + body2.inverse_mass; return
//         sum ;; body2.inverse_mass * dot ==> sum * dot
// mistake "the inverse mass multiplies the turn, too: each product has its own factor": I1 =
//         inverse_inertia(body1), I2 = inverse_inertia(body2) ==> I1 = body1.inverse_mass *
//         inverse_inertia(body1), I2 = body2.inverse_mass * inverse_inertia(body2)
// mistake "only the diagonal of the inverse inertia is used: it has nine entries": const mat3 I1 =
//         inverse_inertia(body1), I2 = inverse_inertia(body2) ==> const auto diagonal = [](const
//         mat3& I) { return mat3(I[0][0], 0, 0, 0, I[1][1], 0, 0, 0, I[2][2]); }; const mat3 I1 =
//         diagonal(inverse_inertia(body1)), I2 = diagonal(inverse_inertia(body2))
// mistake "one moment stands for all three axes: that is right for a ball alone": I1 =
//         inverse_inertia(body1), I2 = inverse_inertia(body2) ==> I1(inverse_inertia(body1)[0][0]),
//         I2(inverse_inertia(body2)[0][0])
// mistake "one moment stands for all three axes: that is right for a ball alone": I1 =
//         inverse_inertia(body1), I2 = inverse_inertia(body2) ==>
//         I1(body1.inverse_inertia_local.x), I2(body2.inverse_inertia_local.x)
// mistake "M^-1 is missing": I1 = inverse_inertia(body1), I2 = inverse_inertia(body2) ==> I1(1),
//         I2(1) ;; body1.inverse_mass * ==> ;; body2.inverse_mass * ==>
// mistake "the inverse masses are missing": body1.inverse_mass * ==> ;; body2.inverse_mass * ==>
// mistake "the inverse inertia is missing": I1 = inverse_inertia(body1), I2 =
//         inverse_inertia(body2) ==> I1(1), I2(1)
// mistake "the linear blocks v1 and v2 are missing": body1.inverse_mass * dot(a.v1, b.v1) + ==> ;;
//         body2.inverse_mass * dot(a.v2, b.v2) + ==>
// mistake "the sign of body 2's terms: the terms of both bodies are added": + body2 ==> - body2 ;;
//         + dot(a.w2 ==> - dot(a.w2
// mistake "the sign of the rotations' terms: all four terms are added": + dot(a.w1 ==> - dot(a.w1
//         ;; + dot(a.w2 ==> - dot(a.w2
// mistake "the sign of the result": return body1 ==> return -(body1 ;; b.w2); ==> b.w2));
// mistake "the row a with itself: one side belongs to b": b.v1 ==> a.v1 ;; b.w1 ==> a.w1 ;; b.v2
//         ==> a.v2 ;; b.w2 ==> a.w2
// mistake "the row b with itself: one side belongs to a": a.v1 ==> b.v1 ;; a.w1 ==> b.w1 ;; a.v2
//         ==> b.v2 ;; a.w2 ==> b.w2
// mistake "mass and inertia of the other body": I1 = inverse_inertia(body1), I2 =
//         inverse_inertia(body2) ==> I1 = inverse_inertia(body2), I2 = inverse_inertia(body1) ;;
//         body1.inverse_mass * dot(a.v1, b.v1) ==> body2.inverse_mass * dot(a.v1, b.v1) ;;
//         body2.inverse_mass * dot(a.v2, b.v2) ==> body1.inverse_mass * dot(a.v2, b.v2)
// mistake "the inertia of body 2 for both bodies: each has its own": I1 * ==> I2 *
// mistake "the inverse mass of body 1 for both bodies: each has its own": body2.inverse_mass ==>
//         body1.inverse_mass
// mistake "mass and inertia of body 1 for both bodies: each has its own": body2.inverse_mass ==>
//         body1.inverse_mass ;; I2 * ==> I1 *
// mistake "mass and inertia of body 2 for both bodies: each has its own": body1.inverse_mass ==>
//         body2.inverse_mass ;; I1 * ==> I2 *
// mistake "b.w1 where b.w2 belongs": b.w2 ==> b.w1
// mistake "v1 where v2 belongs: body 2 takes its own blocks, a.v2 and b.v2": a.v2, b.v2 ==> a.v1,
//         b.v1
// mistake "a.v1 where a.v2 belongs": a.v2 ==> a.v1
// mistake "b.v1 where b.v2 belongs": b.v2 ==> b.v1
// mistake "one over the result: that is an effective mass": return body1 ==> return 1 / (body1 ;;
//         b.w2); ==> b.w2));
// mistake "a static body 1 has an answer, too: its own term is 0, body 2's is not": return ==> if
//         (body1.is_static()) return 0; return
// mistake "one term of body 1 and one of body 2: each body has two": dot(a.w1, I1 * b.w1) +
//         body2.inverse_mass * dot(a.v2, b.v2) + ==>
// mistake "row a stands on both sides in the push of body 1": b.v1 ==> a.v1
// mistake "row b stands on both sides in the push of body 1": a.v1 ==> b.v1
// mistake "the push of body 1 is missing: the blocks v1": body1.inverse_mass * dot(a.v1, b.v1) +
//         ==>
// mistake "the sign of the push of body 1: the blocks v1": return ==> return -1 *
// mistake "the push of body 1 is there twice: the blocks v1": body1.inverse_mass * dot(a.v1, b.v1)
//         ==> 2 * body1.inverse_mass * dot(a.v1, b.v1)
// mistake "only the push of body 1 is left: the blocks v1. Is an = there where += belongs?": +
//         dot(a.w1, I1 * b.w1) + body2.inverse_mass * dot(a.v2, b.v2) + dot(a.w2, I2 * b.w2) ==>
// mistake "row a stands on both sides in the turn of body 1": b.w1 ==> a.w1
// mistake "row b stands on both sides in the turn of body 1": a.w1 ==> b.w1
// mistake "the turn of body 1 is missing: the blocks w1": dot(a.w1, I1 * b.w1) + ==>
// mistake "the sign of the turn of body 1: the blocks w1": + dot(a.w1, I1 * b.w1) ==> - dot(a.w1,
//         I1 * b.w1)
// mistake "the turn of body 1 is there twice: the blocks w1": dot(a.w1, I1 * b.w1) ==> 2 *
//         dot(a.w1, I1 * b.w1)
// mistake "only the turn of body 1 is left: the blocks w1. Is an = there where += belongs?":
//         body1.inverse_mass * dot(a.v1, b.v1) + ==> ;; + body2.inverse_mass * dot(a.v2, b.v2) +
//         dot(a.w2, I2 * b.w2) ==>
// mistake "row a stands on both sides in the push of body 2": b.v2 ==> a.v2
// mistake "row b stands on both sides in the push of body 2": a.v2 ==> b.v2
// mistake "the push of body 2 is missing: the blocks v2": body2.inverse_mass * dot(a.v2, b.v2) +
//         ==>
// mistake "the sign of the push of body 2: the blocks v2": + body2.inverse_mass * dot(a.v2, b.v2)
//         ==> - body2.inverse_mass * dot(a.v2, b.v2)
// mistake "the push of body 2 is there twice: the blocks v2": body2.inverse_mass * dot(a.v2, b.v2)
//         ==> 2 * body2.inverse_mass * dot(a.v2, b.v2)
// mistake "only the push of body 2 is left: the blocks v2. Is an = there where += belongs?":
//         body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, I1 * b.w1) + ==> ;; + dot(a.w2, I2 *
//         b.w2) ==>
// mistake "row a stands on both sides in the turn of body 2": b.w2 ==> a.w2
// mistake "row b stands on both sides in the turn of body 2": a.w2 ==> b.w2
// mistake "the turn of body 2 is missing: the blocks w2": + dot(a.w2, I2 * b.w2) ==>
// mistake "the sign of the turn of body 2: the blocks w2": + dot(a.w2, I2 * b.w2) ==> - dot(a.w2,
//         I2 * b.w2)
// mistake "the turn of body 2 is there twice: the blocks w2": dot(a.w2, I2 * b.w2) ==> 2 *
//         dot(a.w2, I2 * b.w2)
// mistake "only the turn of body 2 is left: the blocks w2. Is an = there where += belongs?":
//         body1.inverse_mass * dot(a.v1, b.v1) + dot(a.w1, I1 * b.w1) + body2.inverse_mass *
//         dot(a.v2, b.v2) + ==>
// from right in body axes
// mistake "rows in the body's axes with an inertia in the world's: inverse_inertia(body) takes the
//         rows as they are": body.inverse_inertia_local ==> inverse_inertia(body)
// from right in one sum
// mistake "a.w1 where a.w2 belongs": w2 ==> w1
// wrong "row a stands on both sides in the turn of body 2": b.w2 ==> a.w2
// mistake "body-space inertia: take inverse_inertia(body)": inverse_inertia(body1) ==>
//         body1.inverse_inertia_local ;; inverse_inertia(body2) ==> body2.inverse_inertia_local
// mistake "blocks of body 1 with those of body 2: v1 with v1, w1 with w1": b.w2 ==> b.w1 ;; b.v2
//         ==> b.v1 ;; b.w1 ==> b.w2 ;; b.v1 ==> b.v2
// mistake "the inertia of body 1 for both bodies: each has its own": (body2) ==> (body1)
// mistake "the inertia of the other body": (body2) ==> (body1) ;; (body1) ==> (body2)
// mistake "body-space inertia of body 2: take inverse_inertia(body)": inverse_inertia(body2) ==>
//         body2.inverse_inertia_local
// mistake "masses where inverse masses belong: M^-1 divides by the mass": return body1.inverse_mass
//         ==> const auto mass = [](const Body& body) { return body.is_static() ? real(0) : 1 /
//         body.inverse_mass; }; return mass(body1) ;; body2.inverse_mass ==> mass(body2)
// mistake "the inverse mass of body 2 for both bodies: each has its own": body1 ==> body2
// wrong max-0: return ==> const real k = ;; w2); ==> w2); return std::max(k, real(0));
// mistake "the sign of body 1's terms: the terms of both bodies are added": body1 ==> -body1 ;; +
//         dot ==> - dot
// wrong "the sign of the turn of body 1: the blocks w1": + dot ==> - dot
// wrong "the turn of body 2 is missing": + dot(a.w2, inverse_inertia(body2) * b.w2) ==>
// wrong threshold: return ==> const real k = ;; w2); ==> w2); return std::abs(k) < 0.1 ? 0 : k;
// mistake "the inverse inertia of body 1 is missing": inverse_inertia(body1) * ==>
// mistake "w1 where w2 belongs: body 2 takes its own blocks, a.w2 and b.w2": w2 ==> w1 ;; w2 ==> w1
// mistake "a static body has an answer, too: its own term is 0, the other body's is not": return
//         ==> if (body1.is_static() || body2.is_static()) return 0; return
// mistake "a static body 2 has an answer, too: its own term is 0, body 1's is not": return ==> if
//         (body2.is_static()) return 0; return
