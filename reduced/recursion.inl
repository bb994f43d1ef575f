// What a step does with all links, whether their numbers are those of one tree or of several side
// by side. The functions of chapter 11 are called for the type of the links.
#pragma once

#include "reduced/tree.h"

namespace joints {
/// \cond

template <class Link>
bool is_scalar(const Link& link) {
  return link.freedom == Freedom::hinge || link.freedom == Freedom::slider;
}
// The orientation is a coordinate.
template <class Link>
bool has_orientation(const Link& link) {
  return link.freedom == Freedom::ball || link.freedom == Freedom::free;
}

template <class Link>
void place_links(Link* first, Link* end) {
  place(*first, *first);  // a root has neither axis nor lever
  for (Link* link = first + 1; link < end; ++link) place(*link, first[link->parent]);
}

// All accelerations from the present poses and velocities. \param inertia also eliminate it
// \param moving false: as if all velocities were 0
template <class Link>
void accelerate_links(Link* first, Link* end, bool inertia, bool moving) {
  for (Link* link = first; link < end; ++link) {
    if (inertia) begin_inertia(*link);
    if (moving && link > first) move(*link, first[link->parent]);
    begin_bias(*link);
  }
  for (Link* link = end - 1; link > first; --link) {
    Link& parent = first[link->parent];
    if (inertia) {
      eliminate(*link);
      add_inertia(*link, parent);
    }
    add_bias(*link, parent);
  }
  if (first->freedom == Freedom::free) accelerate_root(*first);
  for (Link* link = first + 1; link < end; ++link) accelerate(*link, first[link->parent]);
}

template <class Link>
StateOf<Link> state_of(const Link& link) {
  return {link.x, link.rate, link.centre, link.v, link.w, link.q};
}

// The coordinates of a link for the next of the four stages of a Runge-Kutta step, after the last
// one for the end. \param sum of the weighted slopes
template <class Link>
void advance(Link& link, const StateOf<Link>& base, StateOf<Link>& sum, int stage, real h) {
  using Number = typename Link::real;
  const bool last = stage == 3;
  const Number weight = stage == 1 || stage == 2 ? 2 : 1;
  const Number factor = last ? h / 6 : stage == 2 ? h : h / 2;
  if (stage == 0) sum = {};
  if (is_scalar(link)) {
    const Number rate = link.rate, acceleration = link.acceleration;
    sum.x += weight * rate, sum.rate += weight * acceleration;
    link.x = base.x + factor * (last ? sum.x : rate);
    link.rate = base.rate + factor * (last ? sum.rate : acceleration);
  } else if (has_orientation(link)) {
    const typename Link::quat spin(0, link.w.x, link.w.y, link.w.z);
    const StateOf<Link> slope{0, 0, link.v, link.a_A, link.alpha, Number(0.5) * (spin * link.q)};
    sum.centre += weight * slope.centre, sum.v += weight * slope.v;
    sum.w += weight * slope.w, sum.q = sum.q + weight * slope.q;
    const StateOf<Link>& use = last ? sum : slope;
    link.q = normalize(base.q + factor * use.q), link.w = base.w + factor * use.w;
    if (link.freedom == Freedom::ball) return;
    link.centre = base.centre + factor * use.centre, link.v = base.v + factor * use.v;
  }
}

/// \endcond
}  // namespace joints
