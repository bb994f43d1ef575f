// wrong drawn-threshold: lambda *= ratio; ==> if (length(lambda) < real(1e-9)) return; lambda *=
//         ratio;
// wrong added-to-lambda: lambda *= ratio ==> lambda += vec3(ratio)
// wrong "the old impulse is applied and the scaled one is kept": lambda *= ratio; ==> ;; ; ==> ;
//         lambda *= ratio;
// expects: change of v2 (on paper).y
// wrong "body-space inertia in w1 and w2: take inverse_inertia(body)": apply_impulse(J, lambda,
//         body1, body2); ==> for (int i = 0; i < 3; ++i) { body1.v += body1.inverse_mass *
//         lambda[i] * J[i].v1; body1.w += body1.inverse_inertia_local * (lambda[i] * J[i].w1);
//         body2.v += body2.inverse_mass * lambda[i] * J[i].v2; body2.w +=
//         body2.inverse_inertia_local * (lambda[i] * J[i].w2); }
// wrong divided-ratio: *= ratio ==> /= ratio
// wrong kept-below-one: ratio ==> std::min(ratio, real(1))
// wrong "the inverse mass and inertia of the other body in all four lines": apply_impulse(J,
//         lambda, body1, body2); ==> for (int i = 0; i < 3; ++i) { body1.v += body2.inverse_mass *
//         lambda[i] * J[i].v1; body1.w += inverse_inertia(body2) * (lambda[i] * J[i].w1); body2.v
//         += body1.inverse_mass * lambda[i] * J[i].v2; body2.w += inverse_inertia(body1) *
//         (lambda[i] * J[i].w2); }
// wrong "v1, w1, v2 and w2 take a new value where it is added to the old one": lambda *= ratio; ==>
//         lambda *= ratio; body1.v = body1.w = body2.v = body2.w = vec3(0);
// wrong nothing-beside-static-body: lambda *= ratio; ==> if (body1.is_static() ||
//         body2.is_static()) return; lambda *= ratio;
// wrong "nothing is applied where the step has not changed": lambda ==> if (ratio == 1) return;
//         lambda
// expects: change of v1 (equal steps)
// wrong nothing-last-step-kept: lambda *= ratio; ==> if (ratio != 1) { lambda = vec3(0); return; }
// wrong one-minus-ratio: ratio ==> 1 - ratio
// wrong "it acts on body 2 only": apply_impulse(J, lambda, body1, body2); ==> for (int i = 0; i < 3;
//         ++i) { body2.v += body2.inverse_mass * lambda[i] * J[i].v2; body2.w +=
//         inverse_inertia(body2) * (lambda[i] * J[i].w2); }
// expects: change of v1 (shorter step)
// wrong only-scaled: apply_impulse(J, lambda, body1, body2); ==>
// wrong "only v changes: lambda rotates the bodies, too": apply_impulse(J, lambda, body1, body2); ==>
//         for (int i = 0; i < 3; ++i) { body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
//         body2.v += body2.inverse_mass * lambda[i] * J[i].v2; }
// expects: change of w1 (shorter step)
// wrong "the ratio is forgotten": lambda *= ratio; ==>
// expects: lambda kept (on paper).y
// wrong ratio-int: ratio ==> real(int(ratio))
// wrong rows-take-each-other: apply_impulse(J, lambda, body1, body2); ==> for (int i = 0; i < 3;
//         ++i) { body1.v = body1.inverse_mass * lambda[i] * J[i].v1; body1.w =
//         inverse_inertia(body1) * (lambda[i] * J[i].w1); body2.v = body2.inverse_mass * lambda[i]
//         * J[i].v2; body2.w = inverse_inertia(body2) * (lambda[i] * J[i].w2); }
// wrong scaled-only-where-applied: lambda *= ratio; ==> ;; lambda ==> ratio * lambda
// wrong "lambda is set to zero: it must hold what has been applied": lambda *= ratio; ==> ;; lambda
//         ==> ratio * lambda ;; ; ==> ; lambda = vec3(0);
// expects: lambda kept (on paper).y
// wrong "the inverse inertia is missing in w1 and w2": apply_impulse(J, lambda, body1, body2); ==>
//         for (int i = 0; i < 3; ++i) { body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
//         body1.w += lambda[i] * J[i].w1; body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
//         body2.w += lambda[i] * J[i].w2; }
// right applied row by row:
  // M^-1 J^T lambda row by row.
  lambda = ratio * lambda;
  for (int i = 0; i < 3; ++i) {
    body1.v += body1.inverse_mass * lambda[i] * J[i].v1;
    body1.w += inverse_inertia(body1) * (lambda[i] * J[i].w1);
    body2.v += body2.inverse_mass * lambda[i] * J[i].v2;
    body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2);
  }
// right summed up first:
  // The push and the turn of all rows, then the bodies.
  lambda = lambda * ratio;
  vec3 push1(0), turn1(0), push2(0), turn2(0);
  for (int i = 0; i < 3; ++i) {
    push1 += J[i].v1 * lambda[i];
    turn1 += J[i].w1 * lambda[i];
    push2 += J[i].v2 * lambda[i];
    turn2 += J[i].w2 * lambda[i];
  }
  body1.v += push1 * body1.inverse_mass;
  body1.w += inverse_inertia(body1) * turn1;
  body2.v += push2 * body2.inverse_mass;
  body2.w += inverse_inertia(body2) * turn2;
// wrong units "in the warm start, adding kg m/s to m/s": apply_impulse(J, lambda, body1, body2);
//         ==> for (int i = 0; i < 3; ++i) { body1.v += lambda[i] * J[i].v1; body2.v += lambda[i] *
//         J[i].v2; }

// region 2
// wrong drawn-stops: real(iterations) ==> real(std::min(iterations, 100))
// wrong drawn-threshold: < 1; ==> < real(0.999999);
// wrong "at the bound the error does not decay": < 1 ==> <= 1
// expects: rho 0.5 iterations 1 beta 1
// wrong "beta is cut to a whole number: an int has no fraction": beta ==> share ;; return ==> const
//         int share = beta; return
// wrong by-a-sum: * (1 + beta) ==> + beta
// wrong by-the-rest: rho ==> 1 - rho
// wrong "1 is forgotten": * (1 + beta) < 1 ==> < 1 / beta
// expects: rho 0.975528 iterations 4 beta 0.15
// wrong one-iteration-less: return std::pow(rho, real(iterations)) ==> real left = 1; for (int
//         iteration = 1; iteration < iterations; ++iteration) left *= rho; return left
// wrong other-side: * (1 + beta) < 1 ==> < 1 + beta
// wrong rho-int: return std::pow(rho, real(iterations)) ==> const int share = rho; return
//         std::pow(share, iterations)
// wrong rho-times-iterations: std::pow(rho, real(iterations)) ==> rho * real(iterations)
// wrong "the iterations are forgotten": std::pow(rho, real(iterations)) ==> rho
// expects: rho 0.975528 iterations 6 beta 0.15
// wrong with-a-reserve: < 1 ==> < real(0.9)
// right safe by logarithms:
  return rho <= 0 || real(iterations) * std::log(rho) + std::log1p(beta) < 0;
// right safe in a loop: return std::pow(rho, real(iterations)) * (1 + beta) < 1 ==> real left = 1;
//         for (int iteration = 0; iteration < iterations; ++iteration) left *= rho; return left < 1
//         / (1 + beta)
// right safe with its parts: return ==> const real left = ;; * (1 + beta) < 1 ==> ; return !(left +
//         beta * left >= 1)
