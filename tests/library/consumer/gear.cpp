// A gear with a mistake in its row, and the report of the checker. Exit status 1 unless the
// checker rejects this gear and accepts the one without the mistake.
#include <cstdio>

#include <checker/check_part.h>
#include <joints.h>

namespace mine {
using namespace joints;

/// Two wheels on axles of a fixed housing: wheel 2 turns `ratio` times as fast as wheel 1.
/// C = angle2 - ratio angle1 [rad]; J = (0, -ratio g1^T, 0, g2^T).
struct Gear {
  HingeAngle angle1, angle2;  ///< of each wheel against the housing
  real ratio = 1;             ///< negative for two wheels that mesh
  bool mistake = true;        ///< divide by the ratio in J

  static constexpr int rows = 1;
  static constexpr bool one_sided = false;
  static constexpr Form form = Form::any;
  static inline const Body housing = static_body(vec3(0));
  real error(const Body& wheel1, const Body& wheel2) const {
    return angle2.error(housing, wheel2) - ratio * angle1.error(housing, wheel1);
  }
  Row jacobian(const Body& wheel1, const Body& wheel2) const {
    const vec3 g1 = angle1.jacobian(housing, wheel1).w2, g2 = angle2.jacobian(housing, wheel2).w2;
    return {vec3(0), -(mistake ? 1 / ratio : ratio) * g1, vec3(0), g2};
  }
};
void check(const Gear& gear) { check(gear.angle1), check(gear.angle2); }

}  // namespace mine

int main() {
  using namespace joints;
  const vec3 axle1(0, 0, 1), axle2(0, real(0.6), real(0.8));
  const mine::Gear wrong{{axle1}, {axle2}, -2}, right{{axle1}, {axle2}, -2, false};

  // Poses at which the axles hold: each wheel is rotated about its own.
  const auto on_their_axles = [&](PoseRandom& random) {
    PosePair pair = any_pose(random);
    pair.body1.q = rotation(random.uniform(-1, 1) * axle1);
    pair.body2.q = rotation(random.uniform(-1, 1) * axle2);
    return pair;
  };
  const PartReport report = check_part(wrong, on_their_axles);
  std::printf("%s", report.text().c_str());
  return !report["J"].holds && check_part(right, on_their_axles).good() ? 0 : 1;
}
