// mistake "the ratio is added to lambda: it is a factor": lambda *= ratio ==> lambda += vec3(ratio)
// mistake "the ratio is forgotten: half a step needs half the impulse": lambda *= ratio; ==>
// expects: lambda kept (on paper).y
// mistake "divided by the ratio: half a step needs half the impulse": *= ratio ==> /= ratio
// mistake "1 - ratio: the impulse of this step is the ratio times the last one": ratio ==> 1 - ratio
// mistake "the ratio is kept below 1: a longer step needs more": ratio ==> std::min(ratio, real(1))
// mistake "the ratio is kept above 1: a shorter step needs less": ratio ==> std::max(ratio, real(1))
// mistake "the ratio is cut to a whole number: it is a real, and half a step is 0.5": ratio ==>
//         real(int(ratio))
// mistake "the ratio is rounded: it is a real, and half a step is 0.5": ratio ==> std::round(ratio)
// mistake "the ratio is taken twice": ratio ==> ratio * ratio
// mistake "the ratio is taken twice for the applied impulse": J, lambda ==> J, ratio * lambda
// mistake "lambda is made a unit vector first: it keeps its length": *= ratio ==> = ratio *
//         direction(lambda)
// mistake "lambda begins at zero where the step has changed: it is scaled by the ratio": lambda *=
//         ratio; ==> if (ratio != 1) { lambda = vec3(0); return; }
// mistake "the old impulse is applied and the scaled one is kept: scale first, then apply": lambda
//         *= ratio; ==> ;; ; ==> ; lambda *= ratio;
// expects: change of v2 (on paper).y
// mistake "the scaled impulse is applied and the old one is kept: lambda must hold what was
//         applied": lambda *= ratio; ==> ;; lambda ==> ratio * lambda
// mistake "lambda is set to zero: it must hold what has been applied, for the iterations go on from
//         there": lambda *= ratio; ==> ;; lambda ==> ratio * lambda ;; ; ==> ; lambda = vec3(0);
// expects: lambda kept (on paper).y
// mistake "lambda is set to zero, and the ratio is forgotten": lambda *= ratio; ==> ;; ; ==> ;
//         lambda = vec3(0);
// mistake "the sign: the impulse of this step has the sign of the last one": ratio ==> -ratio
// mistake "the sign of the applied impulse: +M^-1 J^T lambda, as in apply_impulse": J, lambda ==> J,
//         -lambda
// mistake "added to the old impulse where it takes its place: = and not +=": *= ratio ==> += ratio *
//         lambda
// mistake "the scaled impulse is applied and added to the old one: = and not +=": lambda *= ratio;
//         ==> const vec3 push = ratio * lambda; lambda += push; ;; J, lambda ==> J, push
// mistake "nothing is applied: lambda is scaled, but does not act on the bodies": apply_impulse(J,
//         lambda, body1, body2); ==>
// mistake "nothing is done yet, or copies are changed: lambda is a reference, and so are the
//         bodies": lambda *= ratio; ==> ;; apply_impulse(J, lambda, body1, body2); ==>
// mistake "the impulse is applied twice: the iterations begin where it has been applied once": ; ==>
//         ; apply_impulse(J, lambda, body1, body2);
// mistake "nothing is applied where the step has not changed: lambda acts on the bodies in every
//         step": lambda ==> if (ratio == 1) return; lambda
// expects: change of v1 (equal steps)
// mistake "beside a static body nothing is done: the impulse acts on the other one": lambda *=
//         ratio; ==> if (body1.is_static() || body2.is_static()) return; lambda *= ratio;
// mistake "beside a static body lambda is scaled and not applied: it acts on the other one": ratio;
//         ==> ratio; if (body1.is_static() || body2.is_static()) return;
// mistake "the bodies are exchanged: body 1 first, then body 2": body1, body2 ==> body2, body1
// mistake "v1, w1, v2 and w2 take a new value where it is added to the old one: += and not =": ;
//         ==> ; body1.v = body1.w = body2.v = body2.w = vec3(0);
// mistake "both bodies of apply_impulse are body 1: body 2 comes second": body1, body2 ==> body1,
//         body1
// mistake "only lambda.x and lambda.y are scaled: all three are": lambda *= ratio ==> lambda.x *=
//         ratio; lambda.y *= ratio
// mistake "a negative impulse is left out: a joint pulls, too": ratio; ==> ratio; lambda =
//         glm::max(lambda, vec3(0));
// wrong drawn-threshold: lambda *= ratio; ==> if (length(lambda) < real(1e-9)) return; lambda *=
//         ratio;
// wrong drawn-cut: ratio; ==> ratio; if (length(lambda) > 1000) lambda *= 1000 / length(lambda);
// expects: |ratio lambda|
// wrong drawn-cut: ratio; ==> ratio; lambda = glm::clamp(lambda, vec3(-1000), vec3(1000));
// expects: |ratio lambda|
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
// from right applied row by row
// mistake "each row takes the place of the one before: += and not =": body1.v += ==> body1.v = ;;
//         body1.w += ==> body1.w = ;; body2.v += ==> body2.v = ;; body2.w += ==> body2.w =
// mistake "it acts on body 2 only: body 1 gets the opposite impulse, with its own lever": body1.v +=
//         body1.inverse_mass * lambda[i] * J[i].v1; ==> ;; body1.w += inverse_inertia(body1) *
//         (lambda[i] * J[i].w1); ==>
// expects: change of v1 (shorter step)
// mistake "it acts on body 1 only: +lambda acts on body 2": body2.v += body2.inverse_mass *
//         lambda[i] * J[i].v2; ==> ;; body2.w += inverse_inertia(body2) * (lambda[i] * J[i].w2);
//         ==>
// mistake "only v changes: lambda rotates the bodies, too, so w changes": body1.w +=
//         inverse_inertia(body1) * (lambda[i] * J[i].w1); ==> ;; body2.w += inverse_inertia(body2)
//         * (lambda[i] * J[i].w2); ==>
// expects: change of w1 (shorter step)
// mistake "only w changes: lambda pushes the bodies, too, so v changes": body1.v +=
//         body1.inverse_mass * lambda[i] * J[i].v1; ==> ;; body2.v += body2.inverse_mass *
//         lambda[i] * J[i].v2; ==>
// mistake "only the first two rows are applied: there are three": i < 3 ==> i < 2
// mistake "only the last two rows are applied: there are three": i = 0 ==> i = 1
// mistake "J[0] is taken for every row": J[i].v1 ==> J[0].v1 ;; J[i].w1 ==> J[0].w1 ;; J[i].v2 ==>
//         J[0].v2 ;; J[i].w2 ==> J[0].w2
// mistake "only lambda.x is scaled: all three are": lambda = ratio * lambda ==> lambda.x *= ratio
// mistake "only lambda.y is scaled: all three are": lambda = ratio * lambda ==> lambda.y *= ratio
// mistake "only lambda.z is scaled: all three are": lambda = ratio * lambda ==> lambda.z *= ratio
// mistake "the inverse mass and inertia of the other body in all four lines": body1.inverse_mass ==>
//         body0.inverse_mass ;; body2.inverse_mass ==> body1.inverse_mass ;; body0 ==> body2 ;;
//         inertia(body1) ==> inertia(body0) ;; inertia(body2) ==> inertia(body1) ;; body0 ==> body2
// mistake "the inverse mass of the other body in v1 and v2": body1.inverse_mass ==>
//         body0.inverse_mass ;; body2.inverse_mass ==> body1.inverse_mass ;; body0 ==> body2
// mistake "the inverse inertia of the other body in w1 and w2": inertia(body1) ==> inertia(body0) ;;
//         inertia(body2) ==> inertia(body1) ;; body0 ==> body2
// mistake "the inverse mass of the other body in v1": body1.inverse_mass ==> body2.inverse_mass
// mistake "the inverse mass of the other body in v2": body2.inverse_mass ==> body1.inverse_mass
// mistake "the inverse inertia of the other body in w1": inertia(body1) ==> inertia(body2)
// mistake "the inverse inertia of the other body in w2": inertia(body2) ==> inertia(body1)
// mistake "the inverse mass and inverse inertia are missing in all four lines": body1.inverse_mass *
//         ==> ;; inverse_inertia(body1) * ==> ;; body2.inverse_mass * ==> ;; inverse_inertia(body2)
//         * ==>
// mistake "the inverse mass is missing in v1 and v2": body1.inverse_mass * ==> ;;
//         body2.inverse_mass * ==>
// mistake "the inverse inertia is missing in w1 and w2": inverse_inertia(body1) * ==> ;;
//         inverse_inertia(body2) * ==>
// mistake "the inverse mass is missing in v1": body1.inverse_mass * ==>
// mistake "the inverse inertia is missing in w1": inverse_inertia(body1) * ==>
// mistake "the inverse mass is missing in v2": body2.inverse_mass * ==>
// mistake "the inverse inertia is missing in w2": inverse_inertia(body2) * ==>
// mistake "body-space inertia in w1 and w2: take inverse_inertia(body)": inverse_inertia(body1) ==>
//         body1.inverse_inertia_local ;; inverse_inertia(body2) ==> body2.inverse_inertia_local
// mistake "body-space inertia in w1: take inverse_inertia(body)": inverse_inertia(body1) ==>
//         body1.inverse_inertia_local
// mistake "body-space inertia in w2: take inverse_inertia(body)": inverse_inertia(body2) ==>
//         body2.inverse_inertia_local
// mistake "one moment of inertia for all axes: take inverse_inertia(body)": inverse_inertia(body1)
//         ==> body1.inverse_inertia_local.x ;; inverse_inertia(body2) ==>
//         body2.inverse_inertia_local.x
// mistake "each row takes the place of the one before in v1 and v2: += and not =": body1.v += ==>
//         body1.v = ;; body2.v += ==> body2.v =
// mistake "each row takes the place of the one before in w1 and w2: += and not =": body1.w += ==>
//         body1.w = ;; body2.w += ==> body2.w =
// wrong "change of w1 is zero in every case": body1.w += inverse_inertia(body1) * (lambda[i] *
//         J[i].w1); ==>
// wrong "the sign of change of v2": body2.v += ==> body2.v -=
// wrong "a factor of 2 in change of v1, in every case": body1.v += ==> body1.v += 2 *
// from right summed up first
// mistake "v1 and v2 take a new value where it is added to the old one: += and not =": body1.v +=
//         ==> body1.v = ;; body2.v += ==> body2.v =
// mistake "w1 and w2 take a new value where it is added to the old one: += and not =": body1.w +=
//         ==> body1.w = ;; body2.w += ==> body2.w =
// mistake "v1 takes a new value where it is added to the old one: += and not =": body1.v += ==>
//         body1.v =
// mistake "w1 takes a new value where it is added to the old one: += and not =": body1.w += ==>
//         body1.w =
// mistake "v2 takes a new value where it is added to the old one: += and not =": body2.v += ==>
//         body2.v =
// mistake "w2 takes a new value where it is added to the old one: += and not =": body2.w += ==>
//         body2.w =

// region 2
// mistake "rho times k: each iteration multiplies the error by rho, that is rho to the power k":
//         std::pow(rho, real(iterations)) ==> rho * real(iterations)
// mistake "rho over k: each iteration multiplies the error by rho, that is rho to the power k":
//         std::pow(rho, real(iterations)) ==> rho / real(iterations)
// mistake "the iterations are forgotten: k of them multiply by rho to the power k. Or 1 + beta has
//         the power k, too: only rho has it": std::pow(rho, real(iterations)) ==> rho
// expects: rho 0.975528 iterations 6 beta 0.15
// mistake "the square root: rho is the factor of a whole iteration": real(iterations) ==>
//         real(iterations) / 2
// mistake "twice the iterations: rho is the factor of a whole iteration": real(iterations) ==> 2 *
//         real(iterations)
// mistake "one iteration less: k iterations multiply by rho to the power k, the first one counts,
//         too": return std::pow(rho, real(iterations)) ==> real left = 1; for (int iteration = 1;
//         iteration < iterations; ++iteration) left *= rho; return left
// mistake "one iteration more: k iterations multiply by rho to the power k": iterations ==>
//         iterations + 1
// mistake "1 - rho to the power k: rho itself is the factor of an iteration": rho ==> 1 - rho
// mistake "e to the power -rho k: an iteration multiplies by rho, so k multiply by rho to the power
//         k": std::pow(rho, real(iterations)) ==> std::exp(-rho * real(iterations))
// mistake "divided by 1 - beta: rho^k is multiplied by 1 + beta": * (1 + beta) ==> / (1 - beta)
// mistake "1 is forgotten: 1 + beta and not beta": (1 + beta) ==> beta
// expects: rho 0.975528 iterations 4 beta 0.15
// mistake "the sign of beta, or 1 + beta stands on the other side: rho^k times (1 + beta) is
//         compared with 1. (1 - beta is the factor of an error in a cold step)": 1 + beta ==> 1 -
//         beta
// mistake "twice beta: it comes once a step": beta ==> 2 * beta
// mistake "rho^k + beta < 1, that is rho^k < 1 - beta: rho^k is multiplied by 1 + beta": * (1 +
//         beta) ==> + beta
// mistake "rho^k + rho beta < 1: rho^k is multiplied by 1 + beta": * (1 + beta) ==> + rho * beta
// mistake "beta is forgotten, or rho is cut to 0 by an int: feedback adds to the factor": * (1 +
//         beta) ==>
// mistake "beta is cut to a whole number: an int has no fraction": beta ==> share ;; return ==>
//         const int share = beta; return
// mistake "compared with beta: Eq. 6-9 compares rho^k (1 + beta) with 1": * (1 + beta) < 1 ==> <
//         beta
// mistake "a factor of 2: rho^k (1 + beta) is compared with 1": < 1; ==> < real(0.5);
// mistake "a bound below 1: rho^k (1 + beta) is compared with 1 itself": < 1 ==> < real(0.9)
// mistake "at the bound the error does not decay: < and not <=": < 1 ==> <= 1
// expects: rho 0.5 iterations 1 beta 1
// mistake "the other way round: true means safe": < 1 ==> > 1
// mistake "it is always safe: is anything compared, or is a variable never set?": std::pow(rho,
//         real(iterations)) * (1 + beta) < 1 ==> true
// mistake "it is never safe. Are base and exponent exchanged? rho to the power k": std::pow(rho,
//         real(iterations)) * (1 + beta) < 1 ==> false
// wrong drawn-stops: real(iterations) ==> real(std::min(iterations, 100))
// wrong drawn-threshold: < 1; ==> < real(0.999999);
// right safe by logarithms:
  return rho <= 0 || real(iterations) * std::log(rho) + std::log1p(beta) < 0;
// right safe in a loop: return std::pow(rho, real(iterations)) * (1 + beta) < 1 ==> real left = 1;
//         for (int iteration = 0; iteration < iterations; ++iteration) left *= rho; return left < 1
//         / (1 + beta)
// right safe with its parts: return ==> const real left = ;; * (1 + beta) < 1 ==> ; return !(left +
//         beta * left >= 1)
