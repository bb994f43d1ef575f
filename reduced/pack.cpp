// What goes to lanes and back, and the choice of the best instructions at run time.
#include "reduced/pack.h"

#include <algorithm>
#include <new>
#include <numeric>
#include <tuple>

#include "reduced/lanes.inl"

namespace joints {

#if defined(__x86_64__) && defined(JOINTS_AVX2)
void runge_kutta_avx2(void* links, int count, void* states, real h);  // lanes_avx2.cpp
#endif

namespace {

using LaneLink = TreeLinkOf<on_lanes::Lanes>;
using LaneState = StateOf<LaneLink>;

void steps_on_lanes(void* links, int count, void* states, real h) {
#if defined(__x86_64__) && defined(JOINTS_AVX2)
  static const bool has_avx2 = __builtin_cpu_supports("avx2");
  if (has_avx2) return runge_kutta_avx2(links, count, states, h);
#endif
  auto* const base = static_cast<LaneState*>(states);
  on_lanes::runge_kutta(static_cast<LaneLink*>(links), count, base, base + count, h);
}

// One lane of numbers, vectors or matrices.
template <class Wide, class One>
void to_lane(Wide& wide, int lane, const One& one) {
  static_assert(sizeof(Wide) == lane_count * sizeof(One));
  const real* const from = reinterpret_cast<const real*>(&one);
  real* const to = reinterpret_cast<real*>(&wide) + lane;
  for (std::size_t k = 0; k < sizeof(One) / sizeof(real); ++k) to[k * lane_count] = from[k];
}
template <class Wide, class One>
void from_lane(const Wide& wide, int lane, One& one) {
  const real* const from = reinterpret_cast<const real*>(&wide) + lane;
  real* const to = reinterpret_cast<real*>(&one);
  for (std::size_t k = 0; k < sizeof(One) / sizeof(real); ++k) to[k] = from[k * lane_count];
}

// Calls f with each coordinate and each rate of a link, wide and single.
template <class Wide, class One, class F>
void with_state(Wide& wide, One& one, const F& f) {
  if (is_scalar(one)) f(wide.x, one.x), f(wide.rate, one.rate);
  if (has_orientation(one) || one.parent < 0) f(wide.q, one.q), f(wide.w, one.w);
  if (one.parent < 0) f(wide.centre, one.centre), f(wide.v, one.v);
}

auto shape(const TreeLink& link) {
  return std::tuple(link.freedom, link.rotates_inertia, link.parent);
}
bool before(const Tree& a, const Tree& b) {
  return std::ranges::lexicographical_compare(a.links, b.links, {}, shape, shape);
}

}  // namespace

Pack::Pack(std::span<const Tree> trees, std::span<const std::size_t> members)
    : count_(int(members.size())) {
  members_[0] = members[0];
  if (count_ == 1) return;
  const std::vector<TreeLink>& like = trees[members[0]].links;
  links_.resize(like.size() * sizeof(LaneLink) / sizeof(Numbers));
  states_.resize(2 * like.size() * sizeof(LaneState) / sizeof(Numbers));
  for (std::size_t k = 0; k < like.size(); ++k) {
    LaneLink& wide = *new (reinterpret_cast<LaneLink*>(links_.data()) + k) LaneLink;
    wide.freedom = like[k].freedom, wide.parent = like[k].parent;
    wide.rotates_inertia = like[k].rotates_inertia;
    for (int lane = 0; lane < lane_count; ++lane) {  // idle lanes do what the first one does
      members_[std::size_t(lane)] = members[lane < count_ ? std::size_t(lane) : 0];
      const TreeLink& one = trees[members_[std::size_t(lane)]].links[k];
      to_lane(wide.axis_local, lane, one.axis_local);
      to_lane(wide.from_parent_local, lane, one.from_parent_local);
      to_lane(wide.centre_local, lane, one.centre_local);
      to_lane(wide.start, lane, one.start);
      to_lane(wide.start_axis, lane, one.start_axis);
      to_lane(wide.mass, lane, one.mass);
      to_lane(wide.inertia_local, lane, one.inertia_local);
      to_lane(wide.inertia, lane, one.inertia);
    }
  }
}

void Pack::runge_kutta(std::span<Tree> trees, real h) {
  const std::span members(members_.data(), std::size_t(count_));
  if (count_ == 1 ||
      !std::ranges::all_of(members, [&](std::size_t k) { return trees[k].plain(); })) {
    for (const std::size_t k : members) trees[k].runge_kutta(h);
    return;
  }
  auto* const wide = reinterpret_cast<LaneLink*>(links_.data());
  const std::size_t size = trees[members[0]].links.size();
  for (int lane = 0; lane < lane_count; ++lane) {
    Tree& tree = trees[members_[std::size_t(lane)]];
    if (lane < count_) tree.begin_step(h);
    for (std::size_t k = 0; k < size; ++k) {
      to_lane(wide[k].force, lane, tree.links[k].force);
      with_state(wide[k], tree.links[k],
                 [&](auto& all, const auto& one) { to_lane(all, lane, one); });
    }
  }
  steps_on_lanes(wide, int(size), states_.data(), h);
  for (int lane = 0; lane < count_; ++lane) {
    Tree& tree = trees[members[std::size_t(lane)]];
    for (std::size_t k = 0; k < size; ++k)
      with_state(wide[k], tree.links[k],
                 [&](const auto& all, auto& one) { from_lane(all, lane, one); });
    tree.end_runge_kutta(h);
  }
}

std::vector<Pack> packs_of(std::span<const Tree> trees) {
  std::vector<std::size_t> order(trees.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::ranges::stable_sort(order, [&](auto a, auto b) { return before(trees[a], trees[b]); });
  std::vector<Pack> packs;
  for (std::size_t first = 0, next = 1; first < order.size(); first = next++) {
    while (next < order.size() && next < first + lane_count &&
           !before(trees[order[first]], trees[order[next]]))
      ++next;
    packs.emplace_back(trees, std::span(order).subspan(first, next - first));
  }
  return packs;
}

}  // namespace joints
