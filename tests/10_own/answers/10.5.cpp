// wrong "the sign of the blocks w1 and w2": -cross(two.x - one.x, n) ==> cross(two.x - one.x, n)
// wrong "the blocks w1 and w2 are missing": -cross(two.x - one.x, n) ==> vec3(0)
// wrong "the blocks v1 and w1 are missing": -n, -cross(two.x - one.x, n), n ==> vec3(0), vec3(0),
//         n
// wrong "keep in the part what C is now, and subtract it": two.x - world_point(one, r1_local), n
//         ==> two.x - one.x, n
// wrong "a part has 1 to 6 rows":
  return OwnPart{0, false, own([](const Body&, const Body&) { return real(0); },
                               [](const Body&, const Body&) { return Row{}; }).error,
                 [](const Body&, const Body&) { return std::array<Row, 6>{}; }};
// wrong "The rows are dependent at every pose":
  const vec3 n_local = to_local(body1, vec3(0, 1, 0));
  const vec3 r1_local = to_local(body1, body2.x - body1.x);
  return own(
      [=](const Body& one, const Body& two) {
        const real C = dot(two.x - world_point(one, r1_local), to_world(one, n_local));
        return Vector<2>{C, 2 * C};
      },
      [=](const Body& one, const Body& two) {
        const vec3 n = to_world(one, n_local), arm = two.x - one.x;
        return Jacobian<2>{{Row{-n, -cross(arm, n), n, vec3(0)},
                            Row{real(-2) * n, real(-2) * cross(arm, n), real(2) * n, vec3(0)}}};
      });
// right a hinge by other rows:
  const vec3 a1 = to_local(body1, vec3(0, 0, 1)), b2 = to_local(body2, vec3(1, 0, 0)),
             c2 = to_local(body2, vec3(0, 1, 0));
  const Point point{to_local(body1, body2.x - body1.x), vec3(0)};
  return own(
      [=](const Body& one, const Body& two) {
        const vec3 a = to_world(one, a1), gap = point.error(one, two);
        return Vector<5>{gap.x, gap.y, gap.z, dot(a, to_world(two, b2)), dot(a, to_world(two, c2))};
      },
      [=](const Body& one, const Body& two) {
        const vec3 a = to_world(one, a1), r1 = to_world(one, point.anchor1_local);
        const vec3 b = cross(to_world(two, b2), a), c = cross(to_world(two, c2), a);
        Jacobian<5> J;
        for (int i = 0; i < 3; ++i) {
          vec3 e(0);
          e[i] = 1;
          J[i] = {-e, -cross(r1, e), e, vec3(0)};
        }
        J[3] = {vec3(0), -b, vec3(0), b};
        J[4] = {vec3(0), -c, vec3(0), c};
        return J;
      });
// right a rod of any length:
  const real length_now = length(body2.x - body1.x);
  return own([=](const Body& one, const Body& two) { return length(two.x - one.x) - length_now; },
             [=](const Body& one, const Body& two) {
               const vec3 n = normalize(two.x - one.x);
               return Row{-n, vec3(0), n, vec3(0)};
             });
