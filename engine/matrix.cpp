// K of a block, and its inverse.
#include "engine/matrix.h"

#include "engine/kernels.h"

namespace joints {

void form_responses(const Row* J, int n, const Body& body1, const Body& body2, Row* response) {
  const real m1 = body1.inverse_mass, m2 = body2.inverse_mass;
  if (body1.is_isotropic() && body2.is_isotropic()) {
    const real i1 = body1.inverse_inertia_local.x, i2 = body2.inverse_inertia_local.x;
    for (int i = 0; i < n; ++i)
      response[i] = {m1 * J[i].v1, i1 * J[i].w1, m2 * J[i].v2, i2 * J[i].w2};
    return;
  }
  const mat3 I1 = inverse_inertia(body1), I2 = inverse_inertia(body2);
  for (int i = 0; i < n; ++i)
    response[i] = {m1 * J[i].v1, I1 * J[i].w1, m2 * J[i].v2, I2 * J[i].w2};
}

void form_K(const Row* J, const Row* response, int n, real* K) {
  with_size(n, [&](auto N) {
    unrolled<N>([&](auto i) {
      unrolled<i + 1>([&](auto j) {
        K[i * N + j] = K[j * N + i] = dot(twelve(J[i]), twelve(response[j]));
      });
    });
  });
}

void invert_symmetric(real* K, int n) {
  with_size(n, [&](auto N) {  // the lower triangle is inverted (kernels.h), and copied to both
    real lower[N * (N + 1) / 2];
    const auto each = [&](const auto& f) {
      unrolled<N>([&](auto i) {
        unrolled<i + 1>([&](auto j) { f(lower[lower_index(i, j)], K[i * N + j], K[j * N + i]); });
      });
    };
    each([](real& entry, real& below, real&) { entry = below; });
    invert_lower<N>(lower);
    each([](real& entry, real& below, real& above) { below = above = entry; });
  });
}

}  // namespace joints
