// Packing blocks into lanes, and the step that solves them.
#include "engine/wide.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace joints {

namespace {

// Whether the first three rows hold two points together and the others only turn: then two levers
// and the axes say it all. The levers are read off the rows.
bool holds_a_point(const PreparedRow* row, int rows, vec3& r1, vec3& r2) {
  if (rows < 3) return false;
  r1 = vec3(row[2].J.w1.y, row[0].J.w1.z, row[1].J.w1.x);
  r2 = -vec3(row[2].J.w2.y, row[0].J.w2.z, row[1].J.w2.x);
  for (int i = 0; i < 3; ++i) {
    vec3 unit(0);
    unit[i] = 1;  // row i of skew(r) is unit x r
    if (row[i].J.v1 != -unit || row[i].J.v2 != unit) return false;
    if (row[i].J.w1 != cross(unit, r1) || row[i].J.w2 != -cross(unit, r2)) return false;
  }
  for (int i = 3; i < rows; ++i)
    if (row[i].J.v1 != vec3(0) || row[i].J.v2 != vec3(0) || row[i].J.w1 != -row[i].J.w2)
      return false;
  return true;
}

// What a block is like: only like blocks are solved side by side.
int kind_of(const Preparation& prepared, int number) {
  const PreparedBlock& block = prepared.blocks[number];
  vec3 r1, r2;
  return holds_a_point(&prepared.rows[block.first], block.rows, r1, r2) ? 10 + block.rows
                                                                        : block.rows;
}

}  // namespace

void WideBlocks::begin(const Bodies& from) {
  groups.clear();
  numbers.clear();
  bodies.resize(std::size_t(from.slots()) + 1);
  for (int slot = 0; slot < from.slots(); ++slot) {
    const Body& body = from.at(slot);
    bodies[std::size_t(slot)] = {{body.v.x, body.v.y, body.v.z}, body.inverse_mass,
                                 {body.w.x, body.w.y, body.w.z}, 0};
  }
  bodies.back() = {};
}

void WideBlocks::end(Bodies& to, const Preparation& prepared) const {
  for (int slot = 0; slot < to.slots(); ++slot) {
    Body& body = to.at(slot);
    if (body.is_static()) continue;
    const LaneBody& from = bodies[std::size_t(slot)];
    body.v = vec3(from.v[0], from.v[1], from.v[2]);
    body.w = vec3(from.w[0], from.w[1], from.w[2]);
  }
  for (const LaneGroup& group : groups)
    for (int lane = 0; lane < lane_count; ++lane)
      if (group.block[lane] >= 0)
        for (int i = 0; i < group.rows; ++i)
          prepared.blocks[group.block[lane]].impulse[i] = numbers[group.first + 4 + i].lane[lane];
}

void WideBlocks::sweep() {
  sweep_lanes(groups.data(), int(groups.size()), numbers.data(), bodies.data());
}

// Neighbours get different colours: each block takes the first one that none of its two moving
// bodies has yet. Within a colour, like blocks come together.
void WideBlocks::add(const Bodies& from, const Preparation& prepared, int first, Packing packing) {
  if (packing == Packing::trees && add_trees(from, prepared, first)) return;
  std::vector<std::vector<bool>> taken(std::size_t(from.slots()));
  std::vector<std::map<int, std::vector<int>>> colours;  // of each colour: kind -> blocks
  for (int k = first; k < int(prepared.blocks.size()); ++k) {
    const PreparedBlock& block = prepared.blocks[k];
    const int ends[] = {block.body1, block.body2};
    std::size_t colour = 0;
    const auto is_taken = [&](int body) {
      return !from.at(body).is_static() && colour < taken[body].size() && taken[body][colour];
    };
    while (is_taken(ends[0]) || is_taken(ends[1])) ++colour;
    for (const int body : ends) {
      if (from.at(body).is_static()) continue;
      if (taken[body].size() <= colour) taken[body].resize(colour + 1);
      taken[body][colour] = true;
    }
    if (colours.size() <= colour) colours.resize(colour + 1);
    colours[colour][kind_of(prepared, k)].push_back(k);
  }
  for (const auto& colour : colours)
    for (const auto& [kind, list] : colour)
      for (std::size_t at = 0; at < list.size(); at += lane_count)
        add_group(from, prepared, &list[at], std::min(lane_count, int(list.size() - at)));
}

// Trees that hang together by bodies that move, alike in the kinds of their blocks, a lane each:
// then each keeps its own order. Returns false where fewer than half of the lanes would be used.
bool WideBlocks::add_trees(const Bodies& from, const Preparation& prepared, int first) {
  std::vector<int> root(std::size_t(from.slots()));
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int body) {
    while (root[body] != body) body = root[body] = root[root[body]];
    return body;
  };
  const int count = int(prepared.blocks.size());
  for (int k = first; k < count; ++k) {
    const PreparedBlock& block = prepared.blocks[k];
    if (!from.at(block.body1).is_static() && !from.at(block.body2).is_static())
      root[find(block.body1)] = find(block.body2);
  }
  std::map<int, std::vector<int>> trees;  // root -> its blocks in their order
  for (int k = first; k < count; ++k) {
    const PreparedBlock& block = prepared.blocks[k];
    trees[find(from.at(block.body1).is_static() ? block.body2 : block.body1)].push_back(k);
  }
  std::map<std::vector<int>, std::vector<const std::vector<int>*>> alike;  // kinds -> trees
  for (const auto& [body, list] : trees) {
    std::vector<int> kinds;
    for (const int k : list) kinds.push_back(kind_of(prepared, k));
    alike[kinds].push_back(&list);
  }
  std::size_t used = 0, lanes = 0;
  for (const auto& [kinds, list] : alike) {
    used += kinds.size() * list.size();
    lanes += kinds.size() * ((list.size() + lane_count - 1) / lane_count * lane_count);
  }
  if (2 * used < lanes) return false;
  for (const auto& [kinds, list] : alike)
    for (std::size_t k = 0; k < kinds.size(); ++k)
      // All trees' blocks number k, before any tree's next one: nobody has to wait for it.
      for (std::size_t at = 0; at < list.size(); at += lane_count) {
        const int n = std::min(lane_count, int(list.size() - at));
        int blocks[lane_count];
        for (int lane = 0; lane < n; ++lane) blocks[lane] = (*list[at + std::size_t(lane)])[k];
        add_group(from, prepared, blocks, n);
      }
  return true;
}

void WideBlocks::add_group(const Bodies& from, const Preparation& prepared, const int* blocks,
                           int count) {
  const int rows = prepared.blocks[blocks[0]].rows;
  LaneGroup group;
  group.rows = rows;
  group.point = kind_of(prepared, blocks[0]) >= 10;
  group.first = int(numbers.size());
  const int rest = 4 + 3 * rows + rows * rows;
  const int size = rest + (group.point ? 18 + 3 * (rows - 3) : 18 * rows);
  numbers.resize(numbers.size() + std::size_t(size), LaneNumber{});
  LaneNumber* const to = &numbers[std::size_t(group.first)];
  for (int lane = 0; lane < lane_count; ++lane) {
    group.body1[lane] = group.body2[lane] = int(bodies.size()) - 1;
    group.block[lane] = -1;
    if (lane >= count) continue;
    const PreparedBlock& block = prepared.blocks[blocks[lane]];
    group.block[lane] = blocks[lane];
    group.body1[lane] = block.body1;
    group.body2[lane] = block.body2;
    int at = 0;
    const auto put = [&](real number) { to[at++].lane[lane] = number; };
    const auto put_vector = [&](const vec3& a) { put(a.x), put(a.y), put(a.z); };
    const PreparedRow* row = &prepared.rows[block.first];
    put(block.mass_scale), put(block.impulse_scale), put(block.lower), put(block.upper);
    for (int i = 0; i < rows; ++i) put(block.impulse[i]);
    for (int i = 0; i < rows; ++i) put(row[i].bias);
    for (int i = 0; i < rows; ++i) put(row[i].answer);
    for (int i = 0; i < rows * rows; ++i) put(prepared.inverse_K[block.first_K + i]);
    if (vec3 r1, r2; group.point && holds_a_point(row, rows, r1, r2)) {
      put_vector(r1), put_vector(r2);
      for (const int body : {block.body1, block.body2}) {
        const mat3 I = inverse_inertia(from.at(body));
        put_vector(vec3(I[0][0], I[1][1], I[2][2]));
        put_vector(vec3(I[1][0], I[2][0], I[2][1]));
      }
      for (int i = 3; i < rows; ++i) put_vector(row[i].J.w2);
    } else {
      for (int i = 0; i < rows; ++i)
        for (const vec3& a : {row[i].J.v1, row[i].J.w1, row[i].J.v2, row[i].J.w2, row[i].turn1,
                              row[i].turn2})
          put_vector(a);
    }
  }
  groups.push_back(group);
}

void WideImpulses::step(World& world, real h) {
  require(finite(h) && h > 0, "h: the step must be positive and finite [s]");
  require(iterations > 0, "iterations: there must be at least one");
  require(projections >= 0, "projections: must not be negative");
  collect(world, h, blocks_);
  prepared_.clear(world.most_rows());
  prepared_.add(world.bodies, blocks_, 0, h);
  prepared_.start(world.bodies, warm_start, last_h_ > 0 ? h / last_h_ : 1);
  last_h_ = h;
  lanes_.begin(world.bodies);
  for (int known = 0; known < int(blocks_.list.size());) {
    prepared_.add(world.bodies, blocks_, int(prepared_.blocks.size()), h);
    lanes_.add(world.bodies, prepared_, known, packing);
    known = int(blocks_.list.size());
    for (int i = 0; i < iterations; ++i) lanes_.sweep();
    lanes_.end(world.bodies, prepared_);
    for (const auto& joint : world.joints()) joint->second_look(world.bodies, h, blocks_);
  }
  for (int slot = 0; slot < world.bodies.slots(); ++slot)
    integrate_pose(world.bodies.at(slot), h);
  for (int i = 0; i < projections; ++i) projection_.sweep(world);
}

}  // namespace joints
