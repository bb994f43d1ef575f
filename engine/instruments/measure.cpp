// The measures of scenes and programs, all in double.
#include "engine/instruments/measure.h"

#include <algorithm>

namespace joints {

using glm::dquat;
using glm::dvec3;

void poses(std::span<const Body> bodies, std::vector<Pose>& out) {
  out.clear();
  for (const Body& body : bodies)
    out.push_back({dvec3(body.x), dquat(body.q.w, body.q.x, body.q.y, body.q.z)});
}

std::vector<Pose> poses(const Bodies& bodies) {
  std::vector<Pose> out;
  poses(all_of(bodies), out);
  return out;
}

std::span<const Body> all_of(const Bodies& bodies) {
  if (bodies.slots() == 0) return {};
  return {&bodies.at(0), std::size_t(bodies.slots())};
}

double gap(const Mark& mark, const std::vector<Pose>& poses) {
  const Pose &a = poses[mark.body1], &b = poses[mark.body2];
  return length(b.x + b.q * mark.anchor2_local - a.x - a.q * mark.anchor1_local);
}

double axis_error(const Mark& mark, const std::vector<Pose>& poses) {
  const dvec3 a = poses[mark.body1].q * mark.axis1_local;
  const dvec3 b = poses[mark.body2].q * mark.axis2_local;
  return std::atan2(length(cross(a, b)), dot(a, b));
}

// The larger of two numbers; a NaN gets through and stays.
static double larger(double a, double b) { return std::isnan(a) || a >= b ? a : b; }

void GapMeter::look(const std::vector<Mark>& marks, const std::vector<Pose>& poses) {
  for (const Mark& mark : marks) {
    add(gap(mark, poses));
    axis_max_ = larger(axis_max_, axis_error(mark, poses));
  }
}

void GapMeter::add(double gap) {
  sum_of_squares_ += gap * gap;
  ++count_;
  max_ = larger(max_, gap);
}

double GapMeter::rms() const {
  return count_ > 0 ? std::sqrt(sum_of_squares_ / double(count_)) : 0;
}

double kinetic_energy(const Body& body) {
  if (body.is_static()) return 0;
  const dvec3 v(body.v), w(to_local(body, body.w));
  return 0.5 * dot(v, v) / body.inverse_mass +
         0.5 * dot(w, w / dvec3(body.inverse_inertia_local));
}

double energy(std::span<const Body> bodies, const vec3& gravity) {
  double sum = 0;
  for (const Body& body : bodies)
    if (!body.is_static())
      sum += kinetic_energy(body) -
             dot(dvec3(gravity), dvec3(body.x)) / double(body.inverse_mass);
  return sum;
}

Momentum momentum(std::span<const Body> bodies) {
  Momentum sum;
  for (const Body& body : bodies) {
    if (body.is_static()) continue;
    const dvec3 p = dvec3(body.v) / double(body.inverse_mass);
    const dquat q(body.q.w, body.q.x, body.q.y, body.q.z);
    sum.linear += p;
    sum.angular += cross(dvec3(body.x), p) +
                   q * (dvec3(to_local(body, body.w)) / dvec3(body.inverse_inertia_local));
  }
  return sum;
}

bool all_finite(std::span<const Body> bodies) {
  return std::all_of(bodies.begin(), bodies.end(), [](const Body& b) {
    return finite(b.x) && finite(b.q) && finite(b.v) && finite(b.w);
  });
}

}  // namespace joints
