// The measures of scenes and programs, all in double.
#include "engine/instruments/measure.h"

#include <algorithm>

namespace joints {

using glm::dmat3;
using glm::dquat;
using glm::dvec3;

void poses(const Bodies& bodies, std::vector<Pose>& out) {
  out.resize(bodies.slots());
  for (int i = 0; i < bodies.slots(); ++i) {
    const Body& body = bodies.at(i);
    out[i] = {dvec3(body.x), dquat(body.q.w, body.q.x, body.q.y, body.q.z)};
  }
}

std::vector<Pose> poses(const Bodies& bodies) {
  std::vector<Pose> out;
  poses(bodies, out);
  return out;
}

std::vector<MassProperties> masses(const Bodies& bodies) {
  std::vector<MassProperties> out(bodies.slots());
  for (int i = 0; i < bodies.slots(); ++i)
    if (!bodies.at(i).is_static())
      out[i] = {1.0 / bodies.at(i).inverse_mass,
                1.0 / dvec3(bodies.at(i).inverse_inertia_local)};
  return out;
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
    const double size = gap(mark, poses);
    sum_of_squares_ += size * size;
    ++count_;
    max_ = larger(max_, size);
    axis_max_ = larger(axis_max_, axis_error(mark, poses));
  }
}

double GapMeter::rms() const {
  return count_ > 0 ? std::sqrt(sum_of_squares_ / double(count_)) : 0;
}

namespace {

dvec3 velocity(const Moment& moment, std::size_t i) {
  return (moment.after[i].x - moment.before[i].x) / (2 * moment.h);
}

// The rotation vector from the pose before to the pose after, over the time between them.
dvec3 angular_velocity(const Moment& moment, std::size_t i) {
  dquat turn = moment.after[i].q * conjugate(moment.before[i].q);
  if (turn.w < 0) turn = -turn;
  const dvec3 v(turn.x, turn.y, turn.z);
  const double size = length(v);
  const double angle_by_size = size > 0 ? 2 * std::atan2(size, turn.w) / size : 2;
  return angle_by_size / (2 * moment.h) * v;
}

dvec3 spin(const Moment& moment, const MassProperties& mass, std::size_t i) {
  const dmat3 R = mat3_cast(moment.now[i].q);
  return R * (mass.inertia * (transpose(R) * angular_velocity(moment, i)));
}

}  // namespace

double potential_energy(const std::vector<Pose>& poses, const std::vector<MassProperties>& masses,
                        const dvec3& gravity) {
  double sum = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) sum -= masses[i].mass * dot(gravity, poses[i].x);
  return sum;
}

double kinetic_energy(const Moment& moment, const std::vector<MassProperties>& masses) {
  double sum = 0;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const dvec3 v = velocity(moment, i);
    sum += 0.5 * masses[i].mass * dot(v, v) +
           0.5 * dot(angular_velocity(moment, i), spin(moment, masses[i], i));
  }
  return sum;
}

dvec3 momentum(const Moment& moment, const std::vector<MassProperties>& masses) {
  dvec3 sum(0);
  for (std::size_t i = 0; i < masses.size(); ++i) sum += masses[i].mass * velocity(moment, i);
  return sum;
}

dvec3 angular_momentum(const Moment& moment, const std::vector<MassProperties>& masses) {
  dvec3 sum(0);
  for (std::size_t i = 0; i < masses.size(); ++i)
    sum += cross(moment.now[i].x, masses[i].mass * velocity(moment, i)) +
           spin(moment, masses[i], i);
  return sum;
}

double kinetic_energy(const Body& body) {
  if (body.is_static()) return 0;
  const dvec3 v(body.v), w(to_local(body, body.w));
  return 0.5 * dot(v, v) / body.inverse_mass +
         0.5 * dot(w, w / dvec3(body.inverse_inertia_local));
}

}  // namespace joints
