// Known answers of exercise 2.3, each put in the place of the solution's.

// ---- wrong: J without transpose
// region: 2
// expects: Likely mistake: J where J^T belongs: row i pushes along J[i] with lambda[i]
// change: for ( ==> vec3 push1, turn1, push2, turn2; for (
// change: body1.v += body1.inverse_mass * lambda[i] * J[i].v1 ==> push1[i] = dot(J[i].v1, lambda)
// change: body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w1 ==> turn1[i] = dot(J[i].w1,
//         lambda
// change: body2.v += body2.inverse_mass * lambda[i] * J[i].v2 ==> push2[i] = dot(J[i].v2, lambda)
// change: body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2 ==> turn2[i] = dot(J[i].w2,
//         lambda
// change: } ==> } body1.v += body1.inverse_mass * push1; body1.w += inverse_inertia(body1) * turn1;
//         body2.v += body2.inverse_mass * push2; body2.w += inverse_inertia(body2) * turn2;

// ---- wrong: body space inertia
// region: 2
// expects: Likely mistake: body-space inertia: take inverse_inertia(body)
// change: inverse_inertia(body1) ==> body1.inverse_inertia_local
// change: inverse_inertia(body2) ==> body2.inverse_inertia_local

// ---- wrong: each row by its own K
// expects: Likely mistake: each row divided by its own K: the rows of a block are solved together
  vec3 lambda;
  for (int i = 0; i < 3; ++i)
    lambda[i] = -(row_velocity(J[i], body1, body2) + bias[i]) / K[i][i];
  return lambda;

// ---- wrong: sign of the impulse
// expects: Likely mistake: the sign: the impulse works against J V + b
// change: -inverse ==> inverse

// ---- wrong: first rate left out
// expects: Likely mistake: J V of the first row is left out
// change: 0; ==> 1;

// ---- wrong: last rate left out
// expects: Likely mistake: J V of the last row is left out
// change: 3; ==> 2;

// ---- wrong: first rate in all rows
// expects: Likely mistake: J V of the first row in all three
// change: [i], ==> [0],

// ---- wrong: sign of the bias
// expects: Likely mistake: the sign of the bias
// change: bias ==> -bias

// ---- wrong: bias overwritten
// expects: Likely mistake: the bias is missing: the error is not fed back
// change: += row_velocity ==> = row_velocity

// ---- wrong: bodies exchanged in J V
// expects: Likely mistake: bodies 1 and 2 are exchanged in J V
// change: body1, body2 ==> body2, body1

// ---- wrong: angular velocities left out
// expects: Likely mistake: the angular velocities are missing in J V
  vec3 e = bias;
  for (int i = 0; i < 3; ++i) e[i] += dot(J[i].v1, body1.v) + dot(J[i].v2, body2.v);
  return -inverse(K) * e;

// ---- wrong: blocks v taken for known
// expects: Likely mistake: J V is written out as if J.v1 and J.v2 were -E and E
  vec3 e = bias;
  for (int i = 0; i < 3; ++i)
    e[i] += body2.v[i] - body1.v[i] + dot(J[i].w1, body1.w) + dot(J[i].w2, body2.w);
  return -inverse(K) * e;

// ---- wrong: small K taken for singular
// expects: Likely mistake: nothing is done where K is small
// change: return - ==> if (std::abs(determinant(K)) < real(1e-3)) return vec3(0); return -

// ---- wrong: only where there is a gap
// expects: Likely mistake: nothing is done where the bias is 0
// change: return - ==> if (length(bias) < real(1e-3)) return vec3(0); return -

// ---- wrong: without K
// expects: Likely mistake: K is missing: a velocity is no impulse
// change: inverse(K) * ==>

// ---- wrong: sums that were never set
// expects: Likely mistake: a value that was never set
  real f[3];
  for (int i = 0; i < 3; ++i) f[i] += row_velocity(J[i], body1, body2) + bias[i];
  const vec3 e(f[0], f[1], f[2]);
  return -inverse(K) * e;

// ---- wrong: rows one after the other
// expects: Likely mistake: the rows are solved one after the other
// change: bias ==> bias, l(0)
// change: return -inverse(K) * e ==>
//         for (int n = 0; n < 20; ++n) for (int i = 0; i < 3; ++i) l[i] -= (e + K * l)[i] /
//         K[i][i]; return l

// ---- wrong: first row left out
// region: 2
// expects: Likely mistake: the first row is left out: rows are J[0], J[1], J[2] (v1, w1, v2 and w2)
// change: 0 ==> 1

// ---- wrong: last row left out
// region: 2
// expects: Likely mistake: the last row is left out
// change: 3 ==> 2

// ---- wrong: only the first row
// region: 2
// expects: Likely mistake: only the first row pushes
// change: } ==> return; }

// ---- wrong: velocities set
// region: 2
// expects: Likely mistake: the velocity is set where it must grow: += and not = (v1, w1, v2 and w2)
// change: .v += body1 ==> .v = body1
// change: body1.w += inverse_inertia( ==> body1.w = inverse_inertia(
// change: v += ==> v =
// change: += ==> =

// ---- wrong: lambda added to v
// region: 2
// expects: Likely mistake: lambda is added without J.v1 and J.v2
// change: for ( ==> body1.v -= body1.inverse_mass * lambda; body2.v += body2.inverse_mass * lambda;
//         for (
// change: body1.v += body1.inverse_mass * lambda[i] * J[i].v1; ==>
// change: body2.v += body2.inverse_mass * lambda[i] * J[i].v2; ==>

// ---- wrong: minus for body 1
// region: 2
// expects: Likely mistake: the sign: velocities grow by +M^-1 J^T lambda (v1 and w1)
// change: .v += body1 ==> .v -= body1
// change: body1.w += inverse_inertia( ==> body1.w -= inverse_inertia(

// ---- wrong: minus for the turns
// region: 2
// expects: Likely mistake: the sign: velocities grow by +M^-1 J^T lambda (w1 and w2)
// change: body1.w += inverse_inertia( ==> body1.w -= inverse_inertia(
// change: w += ==> w -=

// ---- wrong: lambda[0] in every row
// region: 2
// expects: Likely mistake: lambda[0] in every row
// change: body1.inverse_mass * lambda[i] * J[i] ==> body1.inverse_mass * lambda[0] * J[i]
// change: body1) * (lambda[i] * J[i] ==> body1) * (lambda[0] * J[i]
// change: * lambda[i] * ==> * lambda[0] *
// change: lambda[i] ==> lambda[0]

// ---- wrong: J[0] in every row
// region: 2
// expects: Likely mistake: J[0] in every row
// change: J[i].v1 ==> J[0].v1
// change: J[i].w1 ==> J[0].w1
// change: J[i].v2 ==> J[0].v2
// change: J[i]. ==> J[0].

// ---- wrong: lambda times J number by number
// region: 2
// expects: Likely mistake: a vector times a vector is taken number by number
// change: body1.inverse_mass * lambda[i] * J[i] ==> body1.inverse_mass * lambda * J[i]
// change: body1) * (lambda[i] * J[i] ==> body1) * (lambda * J[i]
// change: * lambda[i] * ==> * lambda *
// change: lambda[i] ==> lambda

// ---- wrong: without inverse masses
// region: 2
// expects: Likely mistake: the inverse mass is missing (v1 and v2)
// change: body1.inverse_mass * ==>
// change: body2.inverse_mass * ==>

// ---- wrong: turns forgotten
// region: 2
// expects: Likely mistake: not changed at all (w1 and w2)
// change: body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w1); ==>
// change: body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2); ==>

// ---- wrong: both shares to body 1
// region: 2
// expects: Likely mistake: the share of body 2 is given to body 1
// change: body2.v ==> body1.v
// change: body2.w ==> body1.w

// ---- wrong: blocks of body 1 for both
// region: 2
// expects: Likely mistake: the block v of the other body (v2); the block w of the other body (w2)
// change: v2 ==> v1
// change: w2 ==> w1

// ---- wrong: nothing moves beside a wall
// region: 2
// expects: Likely mistake: nothing is done where one body is static
// change: for ( ==> if (body1.is_static() || body2.is_static()) return; for (

// ---- wrong: small impulses left out
// region: 2
// expects: Likely mistake: a small lambda is left out
// change: for ( ==> if (length(lambda) < real(1e-6)) return; for (

// ---- right: cholesky
// K = L L^T: two triangular systems in the place of an inverse.
// change: return -inverse(K) * e; ==> real L[3][3] = {}; for (int i = 0; i < 3; ++i) for (int j =
//         0; j <= i; ++j) { real rest = K[j][i]; for (int k = 0; k < j; ++k) rest -= L[i][k] *
//         L[j][k]; L[i][j] = i == j ? std::sqrt(rest) : rest / L[j][j]; } vec3 y, x; for (int i =
//         0; i < 3; ++i) { real rest = -e[i]; for (int k = 0; k < i; ++k) rest -= L[i][k] * y[k];
//         y[i] = rest / L[i][i]; } for (int i = 2; i >= 0; --i) { real rest = y[i]; for (int k = i
//         + 1; k < 3; ++k) rest -= L[k][i] * x[k]; x[i] = rest / L[i][i]; } return x;

// ---- right: with transposed matrices
// region: 2
// J^T lambda with J^T as a matrix: its columns are the rows of J.
  const mat3 v1(J[0].v1, J[1].v1, J[2].v1), w1(J[0].w1, J[1].w1, J[2].w1);
  const mat3 v2(J[0].v2, J[1].v2, J[2].v2), w2(J[0].w2, J[1].w2, J[2].w2);
  body1.v += body1.inverse_mass * (v1 * lambda);
  body1.w += inverse_inertia(body1) * (w1 * lambda);
  body2.v += body2.inverse_mass * (v2 * lambda);
  body2.w += inverse_inertia(body2) * (w2 * lambda);

// ---- right: vector times symmetric matrix
// change: inverse(K) * e ==> e * inverse(K)

// ---- right: summed up first
// region: 2
// change: for ( ==> vec3 a(0), b(0), c(0), d(0); for (
// change: body1.v += body1.inverse_mass * ==> a +=
// change: body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w1) ==> b += lambda[i] * J[i].w1
// change: body2.v += body2.inverse_mass * ==> c +=
// change: body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2) ==> d += lambda[i] * J[i].w2
// change: } ==> } body1.v += a * body1.inverse_mass; body1.w += inverse_inertia(body1) * b; body2.v
//         += c * body2.inverse_mass; body2.w += inverse_inertia(body2) * d;

// ---- right: vec3 begins at zero
  vec3 e;
  for (int i = 0; i < 3; ++i) e[i] += row_velocity(J[i], body1, body2) + bias[i];
  return -inverse(K) * e;

// ---- right: cross products of the columns
// change: return -inverse(K) * e ==>
//         const mat3 A(cross(K[1], K[2]), cross(K[2], K[0]), cross(K[0], K[1])); return
//         -(transpose(A) * e) / dot(K[0], cross(K[1], K[2]))

// ---- wrong units: times K
// expects: Units: lambda is in m/(kg s) and should be in kg m/s: an inverse mass where a mass
// expects: belongs (K is one, divide by it)
// change: inverse(K) ==> K
