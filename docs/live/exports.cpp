// What the page calls. Texts go through one buffer, numbers through another: the page copies them
// out before its next call.
#include <cstring>

#include "docs/live/run.h"
#include "joints/distance_joint.h"
#include "joints/fixed_joint.h"
#include "joints/hinge_joint.h"
#include "joints/slider_joint.h"

using namespace joints;
using namespace joints::live;

#define EXPORT(name) extern "C" __attribute__((export_name(#name), used)) auto name

namespace {

std::unique_ptr<LiveRun> live_run;
std::string text;
std::vector<double> numbers, other_poses;
PageSettings page_settings;

// A list in JSON; `one` appends each element.
template <class List, class One>
std::string listed(const List& list, One one) {
  std::string out = "[";
  for (const auto& item : list) out += (out.size() > 1 ? "," : "") + one(item);
  return out + "]";
}
std::string quoted(const std::string& words) { return '"' + words + '"'; }
std::string decimal(double x) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.17g", x);
  return digits;
}
std::string triple(const std::array<double, 3>& a) { return listed(a, decimal); }
std::string place(const glm::dvec3& a) { return triple(std::array{a.x, a.y, a.z}); }

std::string line(int body1, const std::array<double, 3>& anchor1, int body2,
                 const std::array<double, 3>& anchor2, const std::string& length = "") {
  return "[" + std::to_string(body1) + "," + triple(anchor1) + "," + std::to_string(body2) + "," +
         triple(anchor2) + length + "]";
}

// What is drawn of a driven joint: the axis of body 1 and, for a hinge, the direction in which the
// centre of body 2 lies while the angle is 0, both in body 1; its limits and its motor.
template <class Driven>
std::string driven(const Driven& joint, const vec3& anchor1, const vec3& zero) {
  const Range range = joint.limits();
  const auto end = [](real x) { return std::abs(x) < unbounded ? decimal(double(x)) : "null"; };
  return "{\"body\":" + std::to_string(joint.body1.slot) + ",\"at\":" + place(anchor1) +
         ",\"axis\":" + place(joint.coordinate().a1_local) + ",\"zero\":" + place(zero) +
         ",\"lower\":" + end(range.lower) + ",\"upper\":" + end(range.upper) +
         ",\"speed\":" + decimal(double(joint.motor().speed)) +
         ",\"strength\":" + decimal(double(joint.motor().strength)) + "}";
}
std::vector<std::string> driven_joints(const World& world) {
  std::vector<std::string> out;
  for (const auto& joint : world.joints())
    if (const auto* hinge = dynamic_cast<const HingeJoint*>(joint.get()))
      out.push_back(driven(*hinge, hinge->first.anchor1_local,
                           hinge->coordinate().start * -hinge->first.anchor2_local));
    else if (const auto* slider = dynamic_cast<const SliderJoint*>(joint.get()))
      out.push_back(driven(*slider, slider->first.anchor1_local, vec3(0)));
  return out;
}
const auto itself = [](const std::string& one) { return one; };

}  // namespace

/// The text of the last call that gave one.
EXPORT(wb_text)() -> const char* { return text.c_str(); }
/// The numbers of the last call that gave some.
EXPORT(wb_numbers)() -> const double* { return numbers.data(); }
/// Where the page writes the settings.
EXPORT(wb_settings)() -> double* { return &page_settings.beta; }

/// Names of settings and scenes, and the initial settings of each scene, as JSON.
EXPORT(wb_about)() -> void {
  text = "{\"settings\":" + listed(setting_names, [](const char* name) { return quoted(name); });
  text += ",\"scenes\":" + listed(entries(), [](const Entry& entry) {
    const LiveRun fresh(entry);
    const PageSettings settings = fresh.settings();
    const double* first = &settings.beta;
    const std::vector<double> begin(first, first + std::size(setting_names));
    return "{\"name\":" + quoted(entry.name) + ",\"title\":" + quoted(entry.title) +
           ",\"opens\":" + listed(entry.opens, quoted) +
           ",\"watch\":" + quoted(entry.watch) +
           ",\"motor\":" + (fresh.has_motor() ? "true" : "false") +
           ",\"own\":" + (fresh.has_own() ? "true" : "false") +
           ",\"begin\":" + listed(begin, decimal) + "}";
  });
  text += "}";
}

/// A fresh run of a scene, with the settings; its bodies and lines as JSON.
EXPORT(wb_make)(int scene) -> void {
  live_run.reset();
  live_run = std::make_unique<LiveRun>(entries().at(std::size_t(scene)), page_settings.ratio);
  live_run->set(page_settings);
  const Scene& made = live_run->scene();
  text = "{\"bodies\":" + listed(made.shapes, [](const Shape& shape) {
    return "{\"kind\":" + quoted(shape.kind) + ",\"size\":" + triple(shape.size) + "}";
  });
  std::vector<std::string> lines;
  for (const Mark& mark : made.marks) {
    const glm::dvec3 &a = mark.anchor1_local, &b = mark.anchor2_local;
    lines.push_back(line(mark.body1, {0, 0, 0}, mark.body1, {a.x, a.y, a.z}));
    lines.push_back(line(mark.body2, {0, 0, 0}, mark.body2, {b.x, b.y, b.z}));
  }
  const auto& joints = made.world.joints();  // in the order of the marks, or of the segments
  for (std::size_t k = 0; k < made.segments.size(); ++k) {
    const Segment& segment = made.segments[k];
    const auto* rope = k < joints.size() ? dynamic_cast<const CentreRopeJoint*>(joints[k].get())
                                         : nullptr;
    lines.push_back(line(segment.body1, segment.anchor1, segment.body2, segment.anchor2,
                         rope ? "," + decimal(double(rope->part.rod.length)) : ""));
  }
  text += ",\"lines\":" + listed(lines, itself) + ",\"marks\":" +
          listed(made.marks, [&, k = std::size_t(0)](const Mark& mark) mutable {
            const bool weld = k < joints.size() &&
                              dynamic_cast<const FixedJoint*>(joints[k].get()) != nullptr;
            ++k;
            return "[" + std::to_string(mark.body1) + "," + place(mark.anchor1_local) + "," +
                   std::to_string(mark.body2) + "," + place(mark.anchor2_local) + "," +
                   place(mark.axis1_local) + "," + (weld ? "1" : "0") + "]";
          }) +
          ",\"energy_scale\":" + decimal(live_run->energy_scale()) + "}";
}

/// The settings of the page for the run that is there.
EXPORT(wb_set)() -> void { live_run->set(page_settings); }

/// The driven joints as they are set now, as JSON.
EXPORT(wb_driven)() -> void {
  text = listed(driven_joints(live_run->scene().world), itself);
}

/// So many steps.
EXPORT(wb_step)(int count) -> void {
  for (int k = 0; k < count; ++k) live_run->step();
}

/// Time, gap, energy gained, then the pose of each body; returns how many numbers.
EXPORT(wb_state)() -> int {
  numbers = {live_run->time(), live_run->gap(), live_run->energy()};
  for (std::size_t k = 0; k < live_run->scene().shapes.size(); ++k) {
    const Body& b = live_run->scene().world.bodies.at(int(k));
    for (const real x : {b.x.x, b.x.y, b.x.z, b.q.w, b.q.x, b.q.y, b.q.z})
      numbers.push_back(double(x));
  }
  return int(numbers.size());
}

/// A hand takes a body at a point, moves, lets go.
EXPORT(wb_grab)(int body, double x, double y, double z) -> void {
  live_run->grab(body, vec3(real(x), real(y), real(z)));
}
EXPORT(wb_move)(double x, double y, double z) -> void {
  live_run->move_hand(vec3(real(x), real(y), real(z)));
}
EXPORT(wb_let_go)() -> void { live_run->let_go(); }

/// The joints within the next step, 10 numbers each; returns how many numbers.
EXPORT(wb_look)(int iterations, int blocks) -> int {
  numbers.clear();
  for (const JointLook& one : live_run->look(iterations, blocks))
    numbers.insert(numbers.end(), {one.body1, one.body2, one.place.x, one.place.y, one.place.z,
                                   one.error, one.impulse.x, one.impulse.y, one.impulse.z,
                                   one.next});
  return int(numbers.size());
}
/// Where the page writes the poses of all bodies, of another run at the same time.
EXPORT(wb_poses)() -> double* {
  other_poses.resize(7 * live_run->scene().shapes.size());
  return other_poses.data();
}
/// What the rows of this code say of those poses, 9 numbers each; returns how many numbers.
EXPORT(wb_rows)() -> int {
  numbers.clear();
  for (const RowLook& one : live_run->rows_at(other_poses))
    numbers.insert(numbers.end(), {one.joint, one.row, one.body1, one.body2, one.error, one.moves,
                                   one.direction.x, one.direction.y, one.direction.z});
  return int(numbers.size());
}
/// The number of blocks of the next step.
EXPORT(wb_blocks)() -> int { return live_run->blocks(); }
/// The errors after 0, 1 ... iterations, and last the rate; returns how many numbers.
EXPORT(wb_errors)(int most) -> int {
  numbers = live_run->errors(most);
  numbers.push_back(live_run->rate(1000));
  return int(numbers.size());
}
