// wrong drawn-side: vec3 e = bias; ==> if (body2.is_static()) return vec3(0); vec3 e = bias;
// mistake "each row divided by its own K: the rows of a block are solved together": e = bias ==>
//         lambda ;; e[i] += row_velocity(J[i], body1, body2); return -inverse(K) * e ==> lambda[i]
//         = -(row_velocity(J[i], body1, body2) + bias[i]) / K[i][i]; return lambda
// mistake "the sign: the impulse works against J V + b": -inverse ==> inverse
// mistake "J V of the first row is left out: rows are J[0], J[1], J[2]": 0; ==> 1;
// mistake "J V of the last row is left out: rows are J[0], J[1], J[2]": 3; ==> 2;
// mistake "J V of the first row in all three: row i is J[i]": [i], ==> [0],
// mistake "the sign of the bias": bias ==> -bias
// mistake "the bias is missing: the error is not fed back": += row_velocity ==> = row_velocity
// mistake "bodies 1 and 2 are exchanged in J V": body1, body2 ==> body2, body1
// mistake "the angular velocities are missing in J V: row_velocity reads all four blocks":
//         row_velocity(J[i], body1, body2) ==> dot(J[i].v1, body1.v) + dot(J[i].v2, body2.v)
// mistake "J V is written out as if J.v1 and J.v2 were -E and E: row_velocity reads all four
//         blocks": row_velocity(J[i], body1, body2) ==> body2.v[i] - body1.v[i] + dot(J[i].w1,
//         body1.w) + dot(J[i].w2, body2.w)
// mistake "nothing is done where K is small: K is small for heavy bodies, and only 0 means that no
//         body can move": return - ==> if (std::abs(determinant(K)) < real(1e-3)) return vec3(0);
//         return -
// mistake "nothing is done where the bias is 0: even where C = 0 the velocity J V would change C":
//         return ==> if (length(bias) < real(1e-3)) return vec3(0); return
// mistake "K is missing: a velocity is no impulse": inverse(K) * ==>
// wrong never-set: vec3 e = bias ==> real f[3] ;; e[i] ==> f[i] ;; ; return ==> + bias[i]; const
//         vec3 e(f[0], f[1], f[2]); return
// mistake "the rows are solved one after the other: a block solves them together": bias ==> bias,
//         l(0) ;; return -inverse(K) * e ==> for (int n = 0; n < 20; ++n) for (int i = 0; i < 3;
//         ++i) l[i] -= (e + K * l)[i] / K[i][i]; return l
// right cholesky: return -inverse(K) * e; ==> real L[3][3] = {}; for (int i = 0; i < 3; ++i) for
//         (int j = 0; j <= i; ++j) { real rest = K[j][i]; for (int k = 0; k < j; ++k) rest -=
//         L[i][k] * L[j][k]; L[i][j] = i == j ? std::sqrt(rest) : rest / L[j][j]; } vec3 y, x; for
//         (int i = 0; i < 3; ++i) { real rest = -e[i]; for (int k = 0; k < i; ++k) rest -= L[i][k]
//         * y[k]; y[i] = rest / L[i][i]; } for (int i = 2; i >= 0; --i) { real rest = y[i]; for
//         (int k = i + 1; k < 3; ++k) rest -= L[k][i] * x[k]; x[i] = rest / L[i][i]; } return x;
// right vector times symmetric matrix: inverse(K) * e ==> e * inverse(K)
// wrong never-set: = bias ==> ;; ; return ==> + bias[i]; return
// right cross products of the columns: return -inverse(K) * e ==> const mat3 A(cross(K[1], K[2]),
//         cross(K[2], K[0]), cross(K[0], K[1])); return -(transpose(A) * e) / dot(K[0], cross(K[1],
//         K[2]))
// wrong units "lambda is in m/(kg s) and should be in kg m/s: an inverse mass where a mass belongs
//         (K is one, divide by it)":  inverse(K) ==> K
// mistake "0 is returned always": return - ==> return real(0) *
// mistake "times K where its inverse belongs": inverse(K) ==> K
// mistake "J V is missing": e[i] += row_velocity(J[i], body1, body2) ==> e[i] += 0
// mistake "only the bias is divided by K: put J V + b in brackets": vec3 e = bias ==> vec3 e(0) ;;
//         return -inverse(K) * e ==> return -inverse(K) * bias - e
// mistake "only the bias is divided by K: put J V + b in brackets": vec3 e = bias ==> vec3 e(0) ;;
//         return -inverse(K) * e ==> return inverse(K) * bias - e
// mistake "only J V is divided by K: put J V + b in brackets": vec3 e = bias ==> vec3 e(0) ;;
//         return -inverse(K) * e ==> return -inverse(K) * e + bias
// mistake "only J V is divided by K: put J V + b in brackets": vec3 e = bias ==> vec3 e(0) ;;
//         return -inverse(K) * e ==> return -inverse(K) * e - bias
// mistake "body 1 is missing in J V": row_velocity(J[i], body1, body2) ==> dot(J[i].v2, body2.v) +
//         dot(J[i].w2, body2.w)
// mistake "body 2 is missing in J V": row_velocity(J[i], body1, body2) ==> dot(J[i].v1, body1.v) +
//         dot(J[i].w1, body1.w)
// mistake "the sign of a body in J V: all four products are added": row_velocity(J[i], body1,
//         body2) ==> dot(J[i].v2, body2.v) + dot(J[i].w2, body2.w) - dot(J[i].v1, body1.v) -
//         dot(J[i].w1, body1.w)
// mistake "the sign of a body in J V: all four products are added": row_velocity(J[i], body1,
//         body2) ==> dot(J[i].v1, body1.v) + dot(J[i].w1, body1.w) - dot(J[i].v2, body2.v) -
//         dot(J[i].w2, body2.w)
// mistake "J V is written out as if J.v1 and J.v2 were -E and E: row_velocity reads all four
//         blocks": row_velocity(J[i], body1, body2) ==> body2.v[i] - body1.v[i]
// mistake "the fraction is cut off: an int holds whole numbers only": return -inverse(K) * e ==>
//         return trunc(-inverse(K) * e)
// mistake "a factor of 0.5": return - ==> return real(-0.5) *
// mistake "a factor of 2": return - ==> return real(-2) *
// mistake "a row may push and pull: lambda has either sign": return -inverse(K) * e ==> return
//         max(-inverse(K) * e, vec3(0))
// mistake "a row may push and pull: lambda has either sign": return -inverse(K) * e ==> return
//         min(-inverse(K) * e, vec3(0))
// mistake "the sign is lost: lambda is not a size": return -inverse(K) * e ==> return
//         abs(inverse(K) * e)
// mistake "the sign is lost: lambda is not a size": return -inverse(K) * e ==> return
//         -abs(inverse(K) * e)
// mistake "the bias b is used as it is: neither beta nor h belongs here": = bias ==> = real(0.2) *
//         bias
// mistake "the bias b is used as it is: neither beta nor h belongs here": = bias ==> = real(60) *
//         bias
// mistake "the bias b is used as it is: neither beta nor h belongs here": = bias ==> = bias /
//         real(60)
// mistake "only J V of the first row is used: rows are J[0], J[1], J[2]": i < 3 ==> i < 1
// mistake "the rows are solved one after the other, once: a block solves them together": return ==>
//         vec3 l(0); for (int i = 0; i < 3; ++i) l[i] -= (e + K * l)[i] / K[i][i]; return l; return
// mistake "the inverse of K is multiplied number by number: it is a matrix": return -inverse(K) * e
//         ==> const mat3 A = inverse(K); return -vec3(A[0][0], A[1][1], A[2][2]) * e
// mistake "nothing is done where the bias is 0: even where C = 0 the velocity J V would change C":
//         vec3 e = bias; ==> if (length(bias) < real(1e-12)) return vec3(0); vec3 e = bias;
// mistake "nothing is done where the bias is 0: even where C = 0 the velocity J V would change C":
//         vec3 e = bias; ==> if (length(bias) < real(1e-8)) return vec3(0); vec3 e = bias;
// mistake "nothing is done where J V is 0: the error still has to be corrected": return ==> if
//         (length(e - bias) < real(1e-12)) return vec3(0); return
// mistake "nothing is done where J V is 0: the error still has to be corrected": return ==> if
//         (length(e - bias) < real(1e-8)) return vec3(0); return
// mistake "nothing is done where K is small: K is small for heavy bodies, and only 0 means that no
//         body can move": return ==> if (K[0][0] < real(0.1)) return vec3(0); return
// mistake "nothing is done where K is small: K is small for heavy bodies, and only 0 means that no
//         body can move": return ==> if (K[0][0] < real(1e-15)) return vec3(0); return
// mistake "nothing is done where one body is static: the other one can move": return ==> if
//         (body1.is_static() || body2.is_static()) return vec3(0); return
// mistake "nothing is done where J V + b is small: there is no such threshold": return ==> if
//         (length(e) < real(1e-3)) return vec3(0); return

// region 2
// wrong drawn-side: for (int i ==> if (!body2.is_static()) for (int i
// wrong drawn-threshold: for (int i ==> if (length(lambda) > real(1e-9)) for (int i
// mistake "J where J^T belongs: row i pushes along J[i] with lambda[i]": for ==> vec3 push1, turn1,
//         push2, turn2; for ;; body1 ==> push1[i] = dot(J[i].v1, lambda); turn1[i] = dot(J[i].w1,
//         lambda); push2[i] = dot(J[i].v2, lambda); turn2[i] = dot(J[i].w2, lambda); } body1 ;;
//         lambda[i] * J[i].v1 ==> push1 ;; (lambda[i] * J[i].w1) ==> turn1 ;; lambda[i] * J[i].v2
//         ==> push2 ;; (lambda[i] * J[i].w2); } ==> turn2;
// mistake "body-space inertia: take inverse_inertia(body)": inverse_inertia(body1) ==>
//         body1.inverse_inertia_local ;; inverse_inertia(body2) ==> body2.inverse_inertia_local
// mistake "the first row is left out: rows are J[0], J[1], J[2]": 0 ==> 1
// mistake "the last row is left out: rows are J[0], J[1], J[2]": 3 ==> 2
// mistake "only the first row pushes: all three do, each with its lambda[i]": w2); ==> w2); return;
// mistake "the velocity is set where it must grow: += and not =": += body1 ==> = body1 ;; w += ==>
//         w = ;; += body2 ==> = body2 ;; w += ==> w =
// mistake "lambda is added without J.v1 and J.v2: they are not -E and E in every joint": for ==>
//         body1.v -= body1.inverse_mass * lambda; body2.v += body2.inverse_mass * lambda; for ;;
//         body1.v += body1.inverse_mass * lambda[i] * J[i].v1; ==> ;; v += body2.inverse_mass *
//         lambda[i] * J[i].v2; body2.w ==> w
// mistake "the sign: velocities grow by +M^-1 J^T lambda": += body1 ==> -= body1 ;; w += ==> w -=
// mistake "the sign: velocities grow by +M^-1 J^T lambda": w += ==> w -= ;; w += ==> w -=
// mistake "lambda[0] in every row: row i has its own lambda[i]": [i] ==> [0] ;; [i] * ==> [0] * ;;
//         [i] * ==> [0] * ;; [i] * ==> [0] *
// mistake "J[0] in every row: row i pushes along J[i]": J[i].v1 ==> J[0].v1 ;; J[i].w1 ==> J[0].w1
//         ;; J[i].v2 ==> J[0].v2 ;; J[i]. ==> J[0].
// mistake "a vector times a vector is taken number by number: row i pushes along J[i] with the
//         number lambda[i]": [i] ==> ;; [i] * ==> * ;; [i] * ==> * ;; [i] * ==> *
// mistake "the inverse mass is missing": body1.inverse_mass * ==> ;; body2.inverse_mass * ==>
// mistake "not changed at all": body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w1); ==> ;;
//         body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2); ==>
// mistake "the part of body 2 is given to body 1": body2.v ==> body1.v ;; body2.w ==> body1.w
// wrong "the block v of the other body (v2); the block w of the other body (w2)": v2 ==> v1 ;; w2
//         ==> w1
// mistake "nothing is done where one body is static: the other one can move": for ==> if
//         (body1.is_static() || body2.is_static()) return; for
// mistake "a small lambda is left out: a light body needs only a small one": for ==> if
//         (length(lambda) < real(1e-6)) return; for
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
// mistake "not changed at all": body1.v += body1.inverse_mass * lambda[i] * J[i].v1; ==>  ;;
//         body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w1); ==>  ;; body2.v +=
//         body2.inverse_mass * lambda[i] * J[i].v2; ==>  ;; body2.w += inverse_inertia(body2) *
//         (lambda[i] * J[i].w2); ==>
// mistake "the sign: velocities grow by +M^-1 J^T lambda": body1.v += body1.inverse_mass *
//         lambda[i] * J[i].v1; ==> body1.v -= body1.inverse_mass * lambda[i] * J[i].v1; ;; body1.w
//         += inverse_inertia(body1) * (lambda[i] * J[i].w1); ==> body1.w -= inverse_inertia(body1)
//         * (lambda[i] * J[i].w1); ;; body2.v += body2.inverse_mass * lambda[i] * J[i].v2; ==>
//         body2.v -= body2.inverse_mass * lambda[i] * J[i].v2; ;; body2.w += inverse_inertia(body2)
//         * (lambda[i] * J[i].w2); ==> body2.w -= inverse_inertia(body2) * (lambda[i] * J[i].w2);
// mistake "the velocity is set where it must grow: += and not =": for ==> body1.v = body1.w =
//         body2.v = body2.w = vec3(0); for
// mistake "a factor of 0.5": body1.v += body1.inverse_mass * lambda[i] * J[i].v1; ==> body1.v +=
//         real(0.5) * body1.inverse_mass * lambda[i] * J[i].v1; ;; body1.w +=
//         inverse_inertia(body1) * (lambda[i] * J[i].w1); ==> body1.w += inverse_inertia(body1) *
//         (real(0.5) * lambda[i] * J[i].w1); ;; body2.v += body2.inverse_mass * lambda[i] *
//         J[i].v2; ==> body2.v += real(0.5) * body2.inverse_mass * lambda[i] * J[i].v2; ;; body2.w
//         += inverse_inertia(body2) * (lambda[i] * J[i].w2); ==> body2.w += inverse_inertia(body2)
//         * (real(0.5) * lambda[i] * J[i].w2);
// mistake "a factor of 2": body1.v += body1.inverse_mass * lambda[i] * J[i].v1; ==> body1.v +=
//         real(2) * body1.inverse_mass * lambda[i] * J[i].v1; ;; body1.w += inverse_inertia(body1)
//         * (lambda[i] * J[i].w1); ==> body1.w += inverse_inertia(body1) * (real(2) * lambda[i] *
//         J[i].w1); ;; body2.v += body2.inverse_mass * lambda[i] * J[i].v2; ==> body2.v += real(2)
//         * body2.inverse_mass * lambda[i] * J[i].v2; ;; body2.w += inverse_inertia(body2) *
//         (lambda[i] * J[i].w2); ==> body2.w += inverse_inertia(body2) * (real(2) * lambda[i] *
//         J[i].w2);
// mistake "lambda is missing": body1.v += body1.inverse_mass * lambda[i] * J[i].v1; ==> body1.v +=
//         body1.inverse_mass * J[i].v1; ;; body1.w += inverse_inertia(body1) * (lambda[i] *
//         J[i].w1); ==> body1.w += inverse_inertia(body1) * J[i].w1; ;; body2.v +=
//         body2.inverse_mass * lambda[i] * J[i].v2; ==> body2.v += body2.inverse_mass * J[i].v2; ;;
//         body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2); ==> body2.w +=
//         inverse_inertia(body2) * J[i].w2;
// mistake "only the last row pushes: all three do, each with its lambda[i]": int i = 0 ==> int i =
//         2
// mistake "the length of lambda: row i has its own lambda[i]": body1.v += body1.inverse_mass *
//         lambda[i] * J[i].v1; ==> body1.v += body1.inverse_mass * length(lambda) * J[i].v1; ;;
//         body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w1); ==> body1.w +=
//         inverse_inertia(body1) * (length(lambda) * J[i].w1); ;; body2.v += body2.inverse_mass *
//         lambda[i] * J[i].v2; ==> body2.v += body2.inverse_mass * length(lambda) * J[i].v2; ;;
//         body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2); ==> body2.w +=
//         inverse_inertia(body2) * (length(lambda) * J[i].w2);
// mistake "the block w of the other body": body1.w += inverse_inertia(body1) * (lambda[i] *
//         J[i].w1); ==> body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w2); ;; body2.w +=
//         inverse_inertia(body2) * (lambda[i] * J[i].w2); ==> body2.w += inverse_inertia(body2) *
//         (lambda[i] * J[i].w1);
// mistake "the block w of the other body with its sign turned": body1.w += inverse_inertia(body1) *
//         (lambda[i] * J[i].w1); ==> body1.w -= inverse_inertia(body1) * (lambda[i] * J[i].w2); ;;
//         body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2); ==> body2.w -=
//         inverse_inertia(body2) * (lambda[i] * J[i].w1);
// mistake "the block v of the row where w belongs": body1.w += inverse_inertia(body1) * (lambda[i]
//         * J[i].w1); ==> body1.w += inverse_inertia(body1) * (lambda[i] * J[i].v1); ;; body2.w +=
//         inverse_inertia(body2) * (lambda[i] * J[i].w2); ==> body2.w += inverse_inertia(body2) *
//         (lambda[i] * J[i].v2);
// mistake "the inverse inertia is missing": body1.w += inverse_inertia(body1) * (lambda[i] *
//         J[i].w1); ==> body1.w += lambda[i] * J[i].w1; ;; body2.w += inverse_inertia(body2) *
//         (lambda[i] * J[i].w2); ==> body2.w += lambda[i] * J[i].w2;
// mistake "inertia where inverse inertia belongs": body1.w += inverse_inertia(body1) * (lambda[i] *
//         J[i].w1); ==> body1.w += inverse(inverse_inertia(body1)) * (lambda[i] * J[i].w1); ;;
//         body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2); ==> body2.w +=
//         inverse(inverse_inertia(body2)) * (lambda[i] * J[i].w2);
// mistake "inverse mass where inverse inertia belongs": body1.w += inverse_inertia(body1) *
//         (lambda[i] * J[i].w1); ==> body1.w += body1.inverse_mass * lambda[i] * J[i].w1; ;;
//         body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2); ==> body2.w +=
//         body2.inverse_mass * lambda[i] * J[i].w2;
// mistake "the inertia of the other body": body1.w += inverse_inertia(body1) * (lambda[i] *
//         J[i].w1); ==> body1.w += inverse_inertia(body2) * (lambda[i] * J[i].w1); ;; body2.w +=
//         inverse_inertia(body2) * (lambda[i] * J[i].w2); ==> body2.w += inverse_inertia(body1) *
//         (lambda[i] * J[i].w2);
// mistake "one moment stands for all three axes: that is right for a ball alone": body1.w +=
//         inverse_inertia(body1) * (lambda[i] * J[i].w1); ==> body1.w +=
//         body1.inverse_inertia_local.x * lambda[i] * J[i].w1; ;; body2.w += inverse_inertia(body2)
//         * (lambda[i] * J[i].w2); ==> body2.w += body2.inverse_inertia_local.x * lambda[i] *
//         J[i].w2;
// mistake "one moment stands for all three axes: that is right for a ball alone": body1.w +=
//         inverse_inertia(body1) * (lambda[i] * J[i].w1); ==> body1.w +=
//         body1.inverse_inertia_local.y * lambda[i] * J[i].w1; ;; body2.w += inverse_inertia(body2)
//         * (lambda[i] * J[i].w2); ==> body2.w += body2.inverse_inertia_local.y * lambda[i] *
//         J[i].w2;
// mistake "one moment stands for all three axes: that is right for a ball alone": body1.w +=
//         inverse_inertia(body1) * (lambda[i] * J[i].w1); ==> body1.w +=
//         body1.inverse_inertia_local.z * lambda[i] * J[i].w1; ;; body2.w += inverse_inertia(body2)
//         * (lambda[i] * J[i].w2); ==> body2.w += body2.inverse_inertia_local.z * lambda[i] *
//         J[i].w2;
// mistake "the change of w is turned into the axes of its body: w is in world axes": body1.w +=
//         inverse_inertia(body1) * (lambda[i] * J[i].w1); ==> body1.w += to_local(body1,
//         inverse_inertia(body1) * (lambda[i] * J[i].w1)); ;; body2.w += inverse_inertia(body2) *
//         (lambda[i] * J[i].w2); ==> body2.w += to_local(body2, inverse_inertia(body2) * (lambda[i]
//         * J[i].w2));
// mistake "J.w is turned into the axes of its body: inverse_inertia(body) is in world axes, and J
//         is, too": body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w1); ==> body1.w +=
//         inverse_inertia(body1) * to_local(body1, lambda[i] * J[i].w1); ;; body2.w +=
//         inverse_inertia(body2) * (lambda[i] * J[i].w2); ==> body2.w += inverse_inertia(body2) *
//         to_local(body2, lambda[i] * J[i].w2);
// mistake "the block v of the other body": body1.v += body1.inverse_mass * lambda[i] * J[i].v1; ==>
//         body1.v += body1.inverse_mass * lambda[i] * J[i].v2; ;; body2.v += body2.inverse_mass *
//         lambda[i] * J[i].v2; ==> body2.v += body2.inverse_mass * lambda[i] * J[i].v1;
// mistake "the block v of the other body with its sign turned: a row need not be (-n, ..., n,
//         ...)": body1.v += body1.inverse_mass * lambda[i] * J[i].v1; ==> body1.v -=
//         body1.inverse_mass * lambda[i] * J[i].v2; ;; body2.v += body2.inverse_mass * lambda[i] *
//         J[i].v2; ==> body2.v -= body2.inverse_mass * lambda[i] * J[i].v1;
// mistake "the block w of the row where v belongs": body1.v += body1.inverse_mass * lambda[i] *
//         J[i].v1; ==> body1.v += body1.inverse_mass * lambda[i] * J[i].w1; ;; body2.v +=
//         body2.inverse_mass * lambda[i] * J[i].v2; ==> body2.v += body2.inverse_mass * lambda[i] *
//         J[i].w2;
// mistake "mass where inverse mass belongs": body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
//         ==> body1.v += lambda[i] * J[i].v1 / body1.inverse_mass; ;; body2.v += body2.inverse_mass
//         * lambda[i] * J[i].v2; ==> body2.v += lambda[i] * J[i].v2 / body2.inverse_mass;
// mistake "the inverse mass of the other body": body1.v += body1.inverse_mass * lambda[i] *
//         J[i].v1; ==> body1.v += body2.inverse_mass * lambda[i] * J[i].v1; ;; body2.v +=
//         body2.inverse_mass * lambda[i] * J[i].v2; ==> body2.v += body1.inverse_mass * lambda[i] *
//         J[i].v2;
// mistake "the inverse masses of both bodies: each body has its own": body1.v += body1.inverse_mass
//         * lambda[i] * J[i].v1; ==> body1.v += (body1.inverse_mass + body2.inverse_mass) *
//         lambda[i] * J[i].v1; ;; body2.v += body2.inverse_mass * lambda[i] * J[i].v2; ==> body2.v
//         += (body1.inverse_mass + body2.inverse_mass) * lambda[i] * J[i].v2;
// mistake "lambda is added without J.w1 and J.w2": for ==> body1.w -= inverse_inertia(body1) *
//         lambda; body2.w += inverse_inertia(body2) * lambda; for ;; body1.w +=
//         inverse_inertia(body1) * (lambda[i] * J[i].w1); ==> ;; body2.w += inverse_inertia(body2)
//         * (lambda[i] * J[i].w2); ==>
// mistake "lambda is added without J.v1 and J.v2: they are not -E and E in every joint": for ==>
//         body1.v += body1.inverse_mass * lambda; body2.v += body2.inverse_mass * lambda; for ;;
//         body1.v += body1.inverse_mass * lambda[i] * J[i].v1; ==> ;; body2.v += body2.inverse_mass
//         * lambda[i] * J[i].v2; ==>
// mistake "a negative lambda is left out: it pulls": for ==> if (lambda.x < 0 && lambda.y < 0 &&
//         lambda.z < 0) return; for
// mistake "an entry of lambda that is negative is left out: it pulls": body1.v ==> if (lambda[i] <
//         0) continue; body1.v
// mistake "return where continue belongs: a row whose impulse is 0 ends the loop, and the rows
//         behind it push, too": body1.v ==> if (lambda[i] == 0) return; body1.v
// mistake "a small lambda is left out: a light body needs only a small one": for ==> if (lambda.x <
//         real(1e-4) && lambda.y < real(1e-4) && lambda.z < real(1e-4) && length(max(lambda,
//         vec3(0))) > 0) return; for
