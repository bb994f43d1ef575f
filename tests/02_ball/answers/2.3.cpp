// wrong drawn-side: vec3 e = bias; ==> if (body2.is_static()) return vec3(0); vec3 e = bias;
// wrong each-row-own-k: e = bias ==> lambda ;; e[i] += row_velocity(J[i], body1, body2); return
//         -inverse(K) * e ==> lambda[i] = -(row_velocity(J[i], body1, body2) + bias[i]) / K[i][i];
//         return lambda
// wrong sign-impulse: -inverse ==> inverse
// wrong first-rate-left-out: 0; ==> 1;
// wrong last-rate-left-out: 3; ==> 2;
// wrong first-rate-all-rows: [i], ==> [0],
// wrong sign-bias: bias ==> -bias
// wrong without-bias: += row_velocity ==> = row_velocity
// wrong bodies-exchanged-j-v: body1, body2 ==> body2, body1
// wrong angular-velocities-left-out: row_velocity(J[i], body1, body2) ==> dot(J[i].v1, body1.v) +
//         dot(J[i].v2, body2.v)
// wrong blocks-v-taken-known: row_velocity(J[i], body1, body2) ==> body2.v[i] - body1.v[i] +
//         dot(J[i].w1, body1.w) + dot(J[i].w2, body2.w)
// wrong small-k-taken-none: return - ==> if (std::abs(determinant(K)) < real(1e-3)) return vec3(0);
//         return -
// wrong nothing-done-where-bias: return ==> if (length(bias) < real(1e-3)) return vec3(0); return
// wrong without-k: inverse(K) * ==>
// wrong never-set: vec3 e = bias ==> real f[3] ;; e[i] ==> f[i] ;; ; return ==> + bias[i]; const
//         vec3 e(f[0], f[1], f[2]); return
// wrong rows-one-after-other: bias ==> bias, l(0) ;; return -inverse(K) * e ==> for (int n = 0; n <
//         20; ++n) for (int i = 0; i < 3; ++i) l[i] -= (e + K * l)[i] / K[i][i]; return l
// right cholesky: return -inverse(K) * e; ==> real L[3][3] = {}; for (int i = 0; i < 3; ++i) for
//         (int j = 0; j <= i; ++j) { real rest = K[j][i]; for (int k = 0; k < j; ++k) rest -=
//         L[i][k] * L[j][k]; L[i][j] = i == j ? std::sqrt(rest) : rest / L[j][j]; } vec3 y, x; for
//         (int i = 0; i < 3; ++i) { real rest = -e[i]; for (int k = 0; k < i; ++k) rest -= L[i][k]
//         * y[k]; y[i] = rest / L[i][i]; } for (int i = 2; i >= 0; --i) { real rest = y[i]; for
//         (int k = i + 1; k < 3; ++k) rest -= L[k][i] * x[k]; x[i] = rest / L[i][i]; } return x;
// right vector times symmetric matrix: inverse(K) * e ==> e * inverse(K)
// right vec3 begins at zero: = bias ==> ;; ; return ==> + bias[i]; return
// right cross products of the columns: return -inverse(K) * e ==> const mat3 A(cross(K[1], K[2]),
//         cross(K[2], K[0]), cross(K[0], K[1])); return -(transpose(A) * e) / dot(K[0], cross(K[1],
//         K[2]))
// wrong units "lambda is in m/(kg s) and should be in kg m/s: an inverse mass where a mass belongs (K is one, divide by it)":
//         inverse(K) ==> K

// region 2
// wrong drawn-side: for (int i ==> if (!body2.is_static()) for (int i
// wrong drawn-threshold: for (int i ==> if (length(lambda) > real(1e-9)) for (int i
// wrong j-without-transpose (v1, w1, v2 and w2): for ==> vec3 push1, turn1, push2, turn2; for ;;
//         body1 ==> push1[i] = dot(J[i].v1, lambda); turn1[i] = dot(J[i].w1, lambda); push2[i] =
//         dot(J[i].v2, lambda); turn2[i] = dot(J[i].w2, lambda); } body1 ;; lambda[i] * J[i].v1 ==>
//         push1 ;; (lambda[i] * J[i].w1) ==> turn1 ;; lambda[i] * J[i].v2 ==> push2 ;; (lambda[i] *
//         J[i].w2); } ==> turn2;
// wrong body-space-inertia (w1 and w2): inverse_inertia(body1) ==> body1.inverse_inertia_local ;;
//         inverse_inertia(body2) ==> body2.inverse_inertia_local
// wrong first-row-left-out (v1, w1, v2 and w2): 0 ==> 1
// wrong last-row-left-out (v1, w1, v2 and w2): 3 ==> 2
// wrong only-first-row (v1, w1, v2 and w2): w2); ==> w2); return;
// wrong velocities-set (v1, w1, v2 and w2): += body1 ==> = body1 ;; w += ==> w = ;; += body2 ==> =
//         body2 ;; w += ==> w =
// wrong lambda-added-v (v1 and v2): for ==> body1.v -= body1.inverse_mass * lambda; body2.v +=
//         body2.inverse_mass * lambda; for ;; body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
//         ==> ;; v += body2.inverse_mass * lambda[i] * J[i].v2; body2.w ==> w
// wrong one-sign-too-many (v1 and w1): += body1 ==> -= body1 ;; w += ==> w -=
// wrong one-sign-too-many (w1 and w2): w += ==> w -= ;; w += ==> w -=
// wrong lambda-0-every-row (v1, w1, v2 and w2): [i] ==> [0] ;; [i] * ==> [0] * ;; [i] * ==> [0] *
//         ;; [i] * ==> [0] *
// wrong j-0-every-row (v1, w1, v2 and w2): J[i].v1 ==> J[0].v1 ;; J[i].w1 ==> J[0].w1 ;; J[i].v2
//         ==> J[0].v2 ;; J[i]. ==> J[0].
// wrong lambda-times-j-number (v1, w1, v2 and w2): [i] ==> ;; [i] * ==> * ;; [i] * ==> * ;; [i] *
//         ==> *
// wrong without-inverse-masses (v1 and v2): body1.inverse_mass * ==> ;; body2.inverse_mass * ==>
// wrong not-changed (w1 and w2): body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w1); ==> ;;
//         body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2); ==>
// wrong both-shares-body-1: body2.v ==> body1.v ;; body2.w ==> body1.w
// wrong "the block v of the other body (v2); the block w of the other body (w2)": v2 ==> v1 ;; w2
//         ==> w1
// wrong nothing-done-where-one: for ==> if (body1.is_static() || body2.is_static()) return; for
// wrong small-impulses-left-out: for ==> if (length(lambda) < real(1e-6)) return; for
// right with transposed matrices:
  // J^T lambda with J^T as a matrix: its columns are the rows of J.
  const mat3 v1(J[0].v1, J[1].v1, J[2].v1), w1(J[0].w1, J[1].w1, J[2].w1);
  const mat3 v2(J[0].v2, J[1].v2, J[2].v2), w2(J[0].w2, J[1].w2, J[2].w2);
  body1.v += body1.inverse_mass * (v1 * lambda);
  body1.w += inverse_inertia(body1) * (w1 * lambda);
  body2.v += body2.inverse_mass * (v2 * lambda);
  body2.w += inverse_inertia(body2) * (w2 * lambda);
// right summed up first: for ( ==> vec3 a(0), b(0), c(0), d(0); for ( ;; body1.v +=
//         body1.inverse_mass * ==> a += ;; body1.w += inverse_inertia(body1) * (lambda[i] *
//         J[i].w1) ==> b += lambda[i] * J[i].w1 ;; body2.v += body2.inverse_mass * ==> c += ;;
//         body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2) ==> d += lambda[i] * J[i].w2 ;;
//         } ==> } body1.v += a * body1.inverse_mass; body1.w += inverse_inertia(body1) * b; body2.v
//         += c * body2.inverse_mass; body2.w += inverse_inertia(body2) * d;
