// Which joints have reduced coordinates, and which elementary motions they are made of.
#include "reduced/recognised.h"

#include <algorithm>
#include <typeinfo>
#ifdef __GNUC__
#include <cxxabi.h>
#endif

#include "joints/ball_joint.h"
#include "joints/driven_joints.h"
#include "joints/fixed_joint.h"
#include "joints/hinge_joint.h"

namespace joints {

namespace {

std::string name_of(const Joint& joint) {
  std::string name = typeid(joint).name();
#ifdef __GNUC__
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> plain(
      abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status), std::free);
  if (status == 0) name = plain.get();
#endif
  const std::string space = "joints::";
  for (auto at = name.find(space); at != std::string::npos; at = name.find(space))
    name.erase(at, space.size());
  return name;
}

template <class Coordinate>
CoordinateSource source_of(const Joint& joint, const FreeCoordinate<Coordinate>& free) {
  using Free = FreeCoordinate<Coordinate>;
  return {.free = &free, .joint = &joint,
          .position = [](const void* free, const Bodies& bodies) {
            return static_cast<const Free*>(free)->position(bodies);
          },
          .read = [](const void* free, DriveSettings& settings) {
            const Free& from = *static_cast<const Free*>(free);
            if (!from.acts()) return false;
            settings = {from.limits(), from.motor(), from.target(), from.friction(),
                        from.spring()};
            return true;
          },
          .tell = [](const void* free, real x, const std::array<real, 4>& impulses) {
            const_cast<Free*>(static_cast<const Free*>(free))->tell(x, impulses);
          }};
}

template <class Coordinate>
bool locked(const FreeCoordinate<Coordinate>& free) {
  return free.limits().lower == free.limits().upper;
}

// Six degrees of freedom, each free or locked: sliders along axes of body 1, then a rotation.
bool recognise_six(const SixDofJoint& joint, Recognised& out) {
  bool good = true;
  const auto slide = [&](const auto& free) {
    const Slide& part = free.coordinate();
    out.anchor2_local = part.anchor2_local;
    if (locked(free)) {
      out.anchor1_local += free.limits().lower * part.a1_local;
    } else {
      out.elements.push_back({Freedom::slider, part.a1_local, quat(1, 0, 0, 0),
                              source_of(joint, free)});
    }
  };
  out.anchor1_local = joint.coordinate<0>().coordinate().anchor1_local;
  slide(joint.coordinate<0>()), slide(joint.coordinate<1>()), slide(joint.coordinate<2>());
  const auto &twist = joint.coordinate<3>();
  const auto &swing2 = joint.coordinate<4>(), &swing3 = joint.coordinate<5>();
  const HingeAngle& angle = twist.coordinate();
  const bool fixed[] = {locked(twist), locked(swing2), locked(swing3)};
  const auto at_zero = [&](const auto& free) {
    return !locked(free) || free.limits().lower == 0;
  };
  good = at_zero(twist) && at_zero(swing2) && at_zero(swing3);
  const int count = fixed[0] + fixed[1] + fixed[2];
  if (count == 0) {
    good = good && !twist.acts() && !swing2.acts() && !swing3.acts();
    out.elements.push_back({Freedom::ball, vec3(0), angle.start});
  } else if (count == 3) {
    out.elements.push_back({Freedom::weld, vec3(0), angle.start});
  } else if (fixed[0] && count == 1) {
    return false;  // two components of a swing are not a chain of hinges
  } else {
    const auto swing = [&](const auto& free) {
      out.elements.push_back({Freedom::hinge, free.coordinate().n1_local, quat(1, 0, 0, 0),
                              source_of(joint, free)});
    };
    if (!fixed[1]) swing(swing2);
    if (!fixed[2]) swing(swing3);
    if (!fixed[0])
      out.elements.push_back({Freedom::hinge, angle.a1_local, quat(1, 0, 0, 0),
                              source_of(joint, twist)});
    out.elements.back().start = angle.start;
  }
  return good;
}

}  // namespace

void refuse_joint(const Joint& joint, std::size_t number, const std::string& why) {
  refuse("joint " + std::to_string(number) + " (" + name_of(joint) + ") " + why +
         "; use DirectSolver for this world");
}

bool is_driven(const Joint& joint) {
  const Joint::Stats extras = joint.stats();
  return extras.limits > 0 || extras.motors > 0 || extras.bounded;
}

Recognised Recognised::reversed() const {
  Recognised out{anchor2_local, anchor1_local, {}};
  for (auto element = elements.rbegin(); element != elements.rend(); ++element) {
    Element back = *element;
    back.start = conjugate(element->start);
    back.axis = -(back.start * element->axis);
    out.elements.push_back(back);
  }
  return out;
}

std::array<Range, 6> locks_of(const SixDofJoint& joint) {
  std::array<Range, 6> out;
  const auto lock = [&](std::size_t k, const Range& range) {
    if (range.lower == range.upper) out[k] = range;
  };
  lock(0, joint.coordinate<0>().limits()), lock(1, joint.coordinate<1>().limits());
  lock(2, joint.coordinate<2>().limits()), lock(3, joint.coordinate<3>().limits());
  lock(4, joint.coordinate<4>().limits()), lock(5, joint.coordinate<5>().limits());
  return out;
}

Recognised recognise(const Joint& joint, std::size_t number) {
  if (joint.frequency > 0)
    refuse_joint(joint, number, "is soft, and reduced coordinates hold a joint exactly");
  Recognised out;
  const auto from_to = [&](const auto& part) {
    out.anchor1_local = part.anchor1_local;
    out.anchor2_local = part.anchor2_local;
  };
  if (const auto* hinge = dynamic_cast<const HingeJoint*>(&joint)) {
    const HingeAngle& angle = hinge->coordinate();
    from_to(hinge->first);
    out.elements = {{Freedom::hinge, angle.a1_local, angle.start, source_of(joint, *hinge)}};
  } else if (const auto* slider = dynamic_cast<const SliderJoint*>(&joint)) {
    const Slide& slide = slider->coordinate();
    from_to(slide);
    out.elements = {{Freedom::slider, slide.a1_local, slider->second.start,
                     source_of(joint, *slider)}};
  } else if (const auto* weld = dynamic_cast<const FixedJoint*>(&joint)) {
    from_to(weld->weld.first);
    out.elements = {{Freedom::weld, vec3(0), weld->weld.second.start}};
  } else if (const auto* universal = dynamic_cast<const UniversalJoint*>(&joint)) {
    from_to(universal->part.first);
    const HingeAngle& one = universal->coordinate<0>().coordinate();
    const HingeAngle& two = universal->coordinate<1>().coordinate();
    out.elements = {{Freedom::hinge, one.a1_local, quat(1, 0, 0, 0),
                     source_of<HingeAngle>(joint, universal->coordinate<0>())},
                    {Freedom::hinge, two.a1_local, two.start,
                     source_of<HingeAngle>(joint, universal->coordinate<1>())}};
  } else if (const auto* six = dynamic_cast<const SixDofJoint*>(&joint)) {
    if (!recognise_six(*six, out))
      refuse_joint(joint, number, "has rotations that no chain of hinges and balls has");
  } else if (const auto* ball = dynamic_cast<const BallJoint*>(&joint)) {
    if (is_driven(joint))
      refuse_joint(joint, number, "has limits or drives of a ball joint, which reduced "
                                  "coordinates do not have");
    from_to(ball->part);
    out.elements = {{Freedom::ball, vec3(0), quat(1, 0, 0, 0)}};
  } else {
    refuse_joint(joint, number, "has no reduced coordinates");
  }
  return out;
}

}  // namespace joints
