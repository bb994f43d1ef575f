// What a tree reads from the bodies and writes to them.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "reduced/recognised.h"
#include "reduced/tree.h"

namespace joints {

void Tree::read(const Bodies& bodies, real most_gap) {
  masses_.resize(links.size());
  std::vector<TreeLink> at_bodies = links;  // with the poses of the bodies, to measure gaps
  for (std::size_t k = 0; k < links.size(); ++k) {
    TreeLink &link = links[k], &there = at_bodies[k];
    link.held = false, link.added = link.tau = link.acceleration = 0;
    if (k == 0 || link.freedom == Freedom::ball) {
      std::size_t body = k;
      while (links[body].slot < 0) ++body;  // between them are sliders of the same joint
      link.q = bodies.at(links[body].slot).q;
    }
    if (k == 0) link.centre = bodies.at(link.slot).x;
    if (sources[k].position) link.x = sources[k].position(sources[k].free, bodies);
    there = link;
    if (k > 0) {
      place(there, at_bodies[link.parent]);
      locate(there, at_bodies[link.parent]);
    }
    if (link.slot < 0) continue;
    const Body& body = bodies.at(link.slot);
    masses_[k] = {body.inverse_mass, body.inverse_inertia_local};
    if (k > 0) {
      real levers = length(there.c) + length(there.d);
      for (int up = link.parent; links[up].slot < 0; up = links[up].parent)
        levers += length(at_bodies[up].d);
      const real gap = length(there.centre - there.c - world_point(body, -link.centre_local));
      const real cosine = std::abs(dot(there.q, body.q));
      const real angle = 2 * std::acos(std::min(cosine, real(1)));
      const auto refuse = [&](real error, const char* unit) {
        refuse_joint(*sources[k].joint, sources[k].number,
                     "has an error of " + std::to_string(error) + unit +
                         " at the present poses, more than most_gap permits");
      };
      if (!(gap <= most_gap * levers)) refuse(gap, " m");
      if (!(angle <= std::max(most_gap, 8 * std::sqrt(epsilon)))) refuse(angle, " rad");
    }
    there.q = body.q;
    there.R = mat3_cast(body.q);
    there.c = there.R * link.centre_local;
    there.centre = body.x;
  }
  place_all();

  // The velocities: the motion that the bodies' momenta, as impulses, give to the tree at rest.
  TreeLink& root = links[0];
  root.alpha = root.a_A = vec3(0);
  if (root.freedom == Freedom::fixed) {
    const Body& body = bodies.at(root.slot);
    root.alpha = body.kinematic ? body.w : vec3(0);
    root.a_A = body.kinematic ? body.v : vec3(0);
  }
  for (TreeLink& link : links) {
    link.w = link.zeta = link.gamma = link.force = link.torque = vec3(0);
    if (link.mass == 0) continue;
    const Body& body = bodies.at(link.slot);
    link.force = link.mass * body.v;
    link.torque = link.inertia * body.w;
  }
  recursion(true, false);
  for (TreeLink& link : links) {
    link.rate = link.acceleration;
    link.acceleration = 0;
    link.w = link.alpha;
  }
  root.v = root.a_A;
  root.alpha = root.a_A = vec3(0);
  locate_all();
  fresh_ = true;
}

bool Tree::unchanged(const Bodies& bodies, bool& changed) const {
  for (std::size_t k = 0; k < links.size(); ++k) {
    const TreeLink& link = links[k];
    if (link.slot < 0) continue;
    const Body& body = bodies.at(link.slot);
    if (const Joint* const joint = sources[k].joint) {
      if (joint->frequency > 0) changed = true;
      if (link.freedom == Freedom::ball && is_driven(*joint)) changed = true;
    }
    if (body.inverse_mass != masses_[k].inverse_mass ||
        body.inverse_inertia_local != masses_[k].inverse_inertia)
      changed = true;
    if (link.freedom == Freedom::fixed && !body.kinematic) {
      if (body.x != link.centre || body.q != link.q) return false;
    } else if (body.x != link.centre || body.q != link.q || body.v != link.v ||
               body.w != link.w) {
      return false;
    }
  }
  return true;
}

bool Tree::read_forces(const Bodies& bodies, const vec3& gravity) {
  forced_ = false;
  gravity_ = length(gravity);
  std::size_t known = 0;
  for (std::size_t k = 0; k < links.size(); ++k) {
    TreeLink& link = links[k];
    if (link.mass > 0) {
      const Body& body = bodies.at(link.slot);
      link.force = link.mass * gravity + body.force;
      link.torque = body.torque;
      if (body.force != vec3(0) || body.torque != vec3(0)) forced_ = true;
    }
    if (!sources[k].read) continue;
    const bool listed = known < drives_.size() && drives_[known].link == int(k);
    DriveSettings settings;
    if (sources[k].read(sources[k].free, settings)) {
      settings.beta = sources[k].joint->beta;
      if (!listed)
        drives_.insert(drives_.begin() + long(known), Drive{.link = int(k), .settings{}});
      drives_[known++].settings = settings;
    } else if (listed) {
      drives_.erase(drives_.begin() + long(known));
      link.held = false;
      link.added = link.tau = 0;
      fresh_ = true;
    }
  }
  return !drives_.empty();
}

bool Tree::only_springs() const {
  return std::ranges::all_of(drives_, [](const Drive& drive) {
    const DriveSettings& s = drive.settings;
    return s.motor.strength == 0 && s.friction == 0 && s.limits.lower == -unbounded &&
           s.limits.upper == unbounded;
  });
}

void Tree::write(Bodies& bodies) const {
  for (const TreeLink& link : links) {
    if (link.slot < 0 || link.freedom == Freedom::fixed) continue;
    Body& body = bodies.at(link.slot);
    body.x = link.centre, body.q = link.q, body.v = link.v, body.w = link.w;
    if (!finite(sum(body.x) + sum(body.q) + sum(body.v) + sum(body.w)))
      throw std::overflow_error("body " + std::to_string(link.slot) +
                                ": a number has overflowed; take a shorter step");
  }
}

void Tree::tell_joints(real h) const {
  for (const Drive& drive : drives_) {
    const CoordinateSource& source = sources[std::size_t(drive.link)];
    source.tell(source.free, links[std::size_t(drive.link)].x, drive.impulse);
    const_cast<Joint*>(source.joint)->set_impulse_duration(h);
  }
}

}  // namespace joints
