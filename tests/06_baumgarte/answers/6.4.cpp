// mistake "2 pi is forgotten: omega_0 is an angle per second, f counts whole periods": 2 *
//         std::numbers::pi_v<real> * frequency ==> frequency
// mistake "the 2 is forgotten: omega_0 is 2 pi f": 2 * std::numbers::pi_v<real> * ==>
//         std::numbers::pi_v<real> *
// mistake "the 2 of 2 zeta is forgotten in xi": 2 * damping + ==> damping +
// mistake "the damping is forgotten: xi is 2 zeta + h omega_0": 2 * damping + h ==> h
// mistake "h omega_0 is forgotten in xi: without it the spring is not taken at the end of the
//         step": 2 * damping + h * omega ==> 2 * damping
// mistake "h is forgotten in xi: xi has no unit, 2 zeta + h omega_0": + h * omega ==> + omega
// mistake "h is forgotten in the softness: 1/(h omega_0 xi)": (h * omega * xi) ==> (omega * xi)
// mistake "the softness upside down: a stiff spring yields little, 1/(h omega_0 xi)": 1 / (h *
//         omega * xi) ==> h * omega * xi
// mistake "xi is forgotten in the softness: 1/(h omega_0 xi)": (h * omega * xi) ==> (h * omega)
// mistake "omega_0 is forgotten in the softness: 1/(h omega_0 xi)": (h * omega * xi) ==> (h * xi)
// mistake "the rate upside down: omega_0/xi": omega / xi, ==> xi / omega,
// mistake "xi is forgotten in the rate: omega_0/xi": {omega / xi ==> {omega
// mistake "the rate is multiplied by h: it is omega_0/xi, and beta would be h times that": {omega /
//         xi ==> {h * omega / xi
// mistake "the rate is zero: that is a damper without a spring": {omega / xi ==> {0
// mistake "the softness is zero: that is Baumgarte's row, with beta = h omega_0/xi": 1 / (h * omega
//         * xi)}; ==> 0};
// mistake "1/60 in the place of h: a substep is shorter": const real omega ==> h = real(1) / 60;
//         const real omega
// mistake "rate and softness are exchanged: first the rate": {omega / xi, 1 / (h * omega * xi)} ==>
//         {1 / (h * omega * xi), omega / xi}
// mistake "this is 1/(1 + softness), the factor of the hard impulse: the softness is 1/(h omega_0
//         xi)": 1 / (h * omega * xi) ==> h * omega * xi / (1 + h * omega * xi)
// mistake "this is softness/(1 + softness), the factor of lambda: the softness is 1/(h omega_0
//         xi)": 1 / (h * omega * xi) ==> 1 / (1 + h * omega * xi)
// wrong drawn-cut: const real omega ==> if (h > 100) h = 100; const real omega
// right soft row from k and c: const real xi = 2 * damping + h * omega; return {omega / xi, 1 / (h
//         * omega * xi)}; ==> const real k = omega * omega, c = 2 * damping * omega; return {k / (c
//         + h * k), 1 / (h * (c + h * k))};
// wrong units "the softness is in s": (h * omega * xi) ==> (omega * xi)

// region 2
// mistake "the impulse that it has already is forgotten: softness times lambda is subtracted":
//         (hard - soft.softness * lambda) ==> hard
// mistake "the sign of lambda: the row yields, so softness times lambda is subtracted": (hard - ==>
//         (hard +
// mistake "all of it is divided by 1 + softness: the factor of lambda is softness/(1 + softness)":
//         (hard - soft.softness * lambda) / (1 + soft.softness) ==> hard / (1 + soft.softness) -
//         soft.softness * lambda
// mistake "only the part of lambda is divided by 1 + softness: the hard impulse is as well": (hard
//         - soft.softness * lambda) / (1 + soft.softness) ==> hard - soft.softness * lambda / (1 +
//         soft.softness)
// mistake "the division by 1 + softness is forgotten": / (1 + soft.softness) ==>
// mistake "times 1 + softness: it is divided by it": / (1 + soft.softness) ==> * (1 +
//         soft.softness)
// mistake "1 - softness: it is divided by 1 + softness": (1 + soft.softness) ==> (1 -
//         soft.softness)
// mistake "the softness is forgotten: this is an iteration of a hard block": (hard - soft.softness
//         * lambda) / (1 + soft.softness) ==> hard
// mistake "the bias is forgotten: it is rate times C": soft.rate * rows.C ==> vec3(0)
// mistake "the rate is forgotten: the bias is rate times C": soft.rate * rows.C ==> rows.C
// mistake "the sign of the bias: it has the sign of C, block_impulse turns it round": = soft.rate
//         ==> = -soft.rate
// mistake "the impulse is not applied: the bodies get dlambda, too": apply_impulse(rows.J, dlambda,
//         body1, body2); ==>
// mistake "the impulse is not kept: lambda grows by dlambda": lambda += dlambda; ==>
// mistake "lambda is replaced by its change: += and not =": lambda += dlambda ==> lambda = dlambda
// mistake "all of lambda is applied: it acts already, only dlambda is new": apply_impulse(rows.J,
//         dlambda, body1, body2); lambda += dlambda ==> lambda += dlambda; apply_impulse(rows.J,
//         lambda, body1, body2)
// mistake "the sign of what is applied: dlambda, as it is": apply_impulse(rows.J, dlambda ==>
//         apply_impulse(rows.J, -dlambda
// mistake "the sign of what is kept: lambda grows by dlambda": lambda += ==> lambda -=
// mistake "the hard impulse is applied: the block is soft, apply dlambda": apply_impulse(rows.J,
//         dlambda ==> apply_impulse(rows.J, hard
// mistake "the bodies are exchanged in block_impulse: body 1 first": bias, body1, body2 ==> bias,
//         body2, body1
// mistake "the bodies are exchanged in apply_impulse: body 1 first": dlambda, body1, body2 ==>
//         dlambda, body2, body1
// wrong drawn-cut: const vec3 bias ==> if (soft.softness > 100) return; const vec3 bias
// right soft iteration with two factors: const vec3 dlambda = (hard - soft.softness * lambda) / (1
//         + soft.softness); ==> const real mass_scale = 1 / (1 + soft.softness); const vec3 dlambda
//         = mass_scale * hard - (1 - mass_scale) * lambda;
// right soft iteration with a softer K:
  // The softness in K and in the bias.
  const mat3 K = (1 + soft.softness) * rows.K;
  const vec3 b = soft.rate * rows.C + soft.softness * (rows.K * lambda);
  const vec3 change = block_impulse(rows.J, K, b, body1, body2);
  lambda += change;
  apply_impulse(rows.J, change, body1, body2);
// wrong units "in the soft iteration, adding": soft.rate * rows.C ==> rows.C

// region 3
// mistake "h is not divided by the substeps: each of them lasts h/substeps": const real part = h /
//         real(how.substeps) ==> const real part = h
// mistake "the spring is that of the whole step: give soft_row the length of a substep":
//         how.damping, part) ==> how.damping, h)
// mistake "gravity acts for the whole step in every substep": gravity, part) ==> gravity, h)
// mistake "gravity acts in the first substep only": for (Body& body : bodies) integrate_forces ==>
//         if (substep == 0) for (Body& body : bodies) integrate_forces
// mistake "gravity is forgotten": for (Body& body : bodies) integrate_forces(body, gravity, part);
//         ==>
// mistake "the bodies move by the whole step in every substep": move(chain, part) ==> move(chain,
//         h)
// mistake "the bodies do not move": move(chain, part); ==>
// mistake "the warm start is forgotten: the impulses of the last substep do not act": for
//         (std::size_t k = 0; k < rows.size(); ++k) warm_start(rows[k].J, 1, impulses[k],
//         bodies[k], bodies[k + 1]); ==>
// mistake "a cold start: the impulses begin with those of the last substep": warm_start(rows[k].J,
//         1, impulses[k], bodies[k], bodies[k + 1]); ==> impulses[k] = vec3(0);
// mistake "the warm start happens once in a step: it belongs into every substep": for (std::size_t
//         k = 0; k < rows.size(); ++k) warm_start ==> if (substep == 0) for (std::size_t k = 0; k <
//         rows.size(); ++k) warm_start
// mistake "the warm start is scaled by 1/substeps: all substeps are equally long": J, 1, ==> J, 1 /
//         real(how.substeps),
// mistake "there are no relax iterations": n < how.relax ==> n < 0
// mistake "there is one relax iteration, whatever relax is": n < how.relax ==> n < 1
// mistake "the relax iterations are soft: SoftRow{} has neither rate nor softness": SoftRow{}, ==>
//         spring,
// mistake "the relax iterations have the rate of the spring: SoftRow{} has no bias": SoftRow{}, ==>
//         SoftRow{spring.rate, 0},
// mistake "the relax iterations have the softness of the spring: SoftRow{} is hard": SoftRow{}, ==>
//         SoftRow{0, spring.softness},
// mistake "the relax iterations come before the move: their velocities would move the bodies":
//         move(chain, part); ==> ;; bodies[k + 1]); // Eq. 6-17 ==> bodies[k + 1]); move(chain,
//         part);
// mistake "the relax iterations have impulses of their own: they continue from the same lambda":
//         for (int n = 0; ==> std::vector<vec3> own(rows.size(), vec3(0)); for (int n = 0; ;;
//         SoftRow{}, impulses[k] ==> SoftRow{}, own[k]
// mistake "the soft iteration is forgotten": for (std::size_t k = 0; k < rows.size(); ++k)
//         soft_iteration(rows[k], spring, impulses[k], bodies[k], bodies[k + 1]); ==>
// mistake "there are two soft iterations per substep: one is enough": for (std::size_t k = 0; k <
//         rows.size(); ++k) soft_iteration(rows[k], spring ==> for (int twice = 0; twice < 2;
//         ++twice) for (std::size_t k = 0; k < rows.size(); ++k) soft_iteration(rows[k], spring
// mistake "there is a single substep: the loop needs how.substeps of them": substep < how.substeps
//         ==> substep < 1
// mistake "the rows are those of the beginning of the step: prepare them anew in every substep":
//         const std::vector<JointRows> rows = rows_of(chain); ==> ;; for (int substep ==> const
//         std::vector<JointRows> rows = rows_of(chain); for (int substep
// mistake "the relax iterations come once, after all substeps: they belong into every one": for
//         (int n = 0; n ==> if (substep + 1 == how.substeps) for (int n = 0; n
// wrong "an index outside a vector": k < rows.size(); ++k) warm_start ==> k <= rows.size(); ++k)
//         warm_start
// right soft step with the joints in pairs:
  // One function for a pass over all joints.
  const real h_sub = h / real(how.substeps);
  for (int left = how.substeps; left > 0; --left) {
    for (std::size_t k = 1; k < chain.bodies.size(); ++k)
      integrate_forces(chain.bodies[k], gravity, h_sub);
    const auto rows = rows_of(chain);
    const auto pass = [&](const SoftRow& soft) {
      for (std::size_t k = 0; k < rows.size(); ++k)
        soft_iteration(rows[k], soft, impulses[k], chain.bodies[k], chain.bodies[k + 1]);
    };
    for (std::size_t k = 0; k < rows.size(); ++k)
      apply_impulse(rows[k].J, impulses[k], chain.bodies[k], chain.bodies[k + 1]);
    pass(soft_row(how.frequency, how.damping, h_sub));
    move(chain, h_sub);
    for (int n = 0; n < how.relax; ++n) pass({0, 0});
  }
// wrong units "in the soft step, adding": J, 1, impulses[k], ==> J, part, impulses[k],
