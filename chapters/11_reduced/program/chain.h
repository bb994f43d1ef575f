// The loop of chapter 11's program: a chain of bars on hinges, moved by your own recursion. The
// whole articulated-body algorithm is in accelerations(). Given, there is nothing to edit here.
#pragma once

#include <array>
#include <vector>

#include "chapters/11_reduced/reduced.h"

/// Chapter 11's program.
namespace joints::chapter11 {

inline const vec3 bar_size(1, real(0.1), real(0.1));  ///< [m]

/// Bars of 1 kg and 1 m in a row along x, on hinges that are turned against each other.
struct Chain {
  std::vector<TreeLink> links;      ///< the wall, then bar after bar, each the parent of the next
  vec3 gravity{0, real(-9.81), 0};  ///< [m/s^2]

  /// Level and at rest. \param place of the first hinge [m]
  Chain(int bars, const vec3& place) : links(std::size_t(bars) + 1) {
    links[0].freedom = Freedom::fixed;
    links[0].centre = place;
    const Body like = box(1, bar_size, vec3(0));
    for (std::size_t k = 1; k < links.size(); ++k) {
      TreeLink& link = links[k];
      const real tilt = real(0.4) * real(k - 1);
      link.freedom = Freedom::hinge;
      link.rotates_inertia = true;
      link.parent = int(k) - 1;
      link.axis_local = vec3(0, std::sin(tilt), std::cos(tilt));
      link.start_axis = quat(0, link.axis_local.x, link.axis_local.y, link.axis_local.z);
      link.from_parent_local = vec3(k == 1 ? real(0) : bar_size.x, 0, 0);
      link.centre_local = vec3(bar_size.x / 2, 0, 0);
      link.mass = 1 / like.inverse_mass;
      link.inertia_local = real(1) / like.inverse_inertia_local;
    }
    pose();
  }

  /// Poses and velocities from the angles and their rates: outward.
  void pose() {
    place(links[0], links[0]);
    for (std::size_t k = 1; k < links.size(); ++k) {
      TreeLink &link = links[k], &parent = links[k - 1];
      place(link, parent);
      move(link, parent);
      locate(link, parent);
    }
  }
  /// The accelerations of all angles: inward with inertia and bias, outward with accelerations.
  void accelerations() {
    for (TreeLink& link : links) {
      link.force = link.mass * gravity;
      begin_inertia(link);
      begin_bias(link);
    }
    for (std::size_t k = links.size() - 1; k > 0; --k) {
      eliminate(links[k]);
      add_inertia(links[k], links[k - 1]);
      add_bias(links[k], links[k - 1]);
    }
    for (std::size_t k = 1; k < links.size(); ++k) accelerate(links[k], links[k - 1]);
  }

  /// Euler's step: first the rates, then the angles. \param h [s]
  void euler(real h) {
    accelerations();
    for (TreeLink& link : links) {
      link.rate += h * link.acceleration;
      link.x += h * link.rate;
    }
    pose();
  }
  /// The classical Runge-Kutta step of order 4, as any differential equation would take it.
  void runge_kutta(real h) {
    const std::vector<TreeLink> start = links;
    std::vector<std::array<real, 2>> sum(links.size());
    const real time[] = {h / 2, h / 2, h, h / 6}, weight[] = {1, 2, 2, 1};
    for (int stage = 0; stage < 4; ++stage) {
      accelerations();
      for (std::size_t k = 1; k < links.size(); ++k) {
        TreeLink& link = links[k];
        const std::array<real, 2> slope{link.rate, link.acceleration};
        for (int i : {0, 1}) sum[k][i] += weight[stage] * slope[i];
        const std::array<real, 2>& use = stage == 3 ? sum[k] : slope;
        link.x = start[k].x + time[stage] * use[0];
        link.rate = start[k].rate + time[stage] * use[1];
      }
      pose();
    }
  }

  /// The free end of the last bar [m].
  vec3 tip() const { return links.back().centre + links.back().c; }
  /// The bodies as they are, the wall first.
  std::vector<Body> bodies() const {
    std::vector<Body> out;
    for (const TreeLink& link : links) {
      Body body =
          link.parent < 0 ? static_body(link.centre) : box(link.mass, bar_size, link.centre);
      body.q = link.q, body.v = link.v, body.w = link.w;
      out.push_back(body);
    }
    return out;
  }
};

}  // namespace joints::chapter11
