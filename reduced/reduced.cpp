// The trees of a world, and their step.
#include "reduced/reduced.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "engine/kept/input.h"
#include "reduced/recognised.h"

namespace joints {

namespace {

int used_slots(const Bodies& bodies) { return bodies.size(); }

TreeLink link_of(const Body& body, int slot) {
  TreeLink link;
  link.slot = slot;
  if (body.is_static()) return link;
  link.mass = 1 / body.inverse_mass;
  link.inertia_local = real(1) / body.inverse_inertia_local;
  link.rotates_inertia = !body.is_isotropic();
  link.inertia = mat3(link.inertia_local.x);
  return link;
}

// Grows trees along the joints.
struct Grower {
  const World& world;
  std::vector<std::vector<std::size_t>> joints_of{};  // of each slot
  std::vector<bool> used{};                           // joints that are in a tree

  explicit Grower(const World& world)
      : world(world), joints_of(std::size_t(world.bodies.slots())),
        used(world.joints().size(), false) {
    std::vector<int> group(std::size_t(world.bodies.slots()));  // of connected bodies
    std::iota(group.begin(), group.end(), 0);
    int ground = -1;  // all bodies that no joint moves are one
    const auto root_of = [&](int slot) {
      if (world.bodies.at(slot).is_static()) slot = ground = ground < 0 ? slot : ground;
      while (group[slot] != slot) slot = group[slot] = group[group[slot]];
      return slot;
    };
    for (std::size_t number = 0; number < world.joints().size(); ++number) {
      const Joint& joint = *world.joints()[number];
      const int slots[] = {int(joint.body1.slot), int(joint.body2.slot)};
      if (world.bodies.at(slots[0]).is_static() && world.bodies.at(slots[1]).is_static())
        continue;
      const int roots[] = {root_of(slots[0]), root_of(slots[1])};
      if (roots[0] == roots[1])
        refuse_joint(joint, number, "closes a loop, and reduced coordinates need trees");
      group[roots[0]] = roots[1];
      for (const int slot : slots) joints_of[slot].push_back(number);
    }
  }

  // Adds everything that a joint connects to a link, parents before children; chains may be long.
  void grow(Tree& tree, int root, std::size_t number) {
    std::vector<std::pair<int, std::size_t>> ahead{{root, number}};
    while (!ahead.empty()) {
      const auto [parent, joint] = ahead.back();
      ahead.pop_back();
      const int child = add(tree, parent, joint);
      const auto& next = joints_of[std::size_t(tree.links[child].slot)];
      for (auto joint = next.rbegin(); joint != next.rend(); ++joint)
        if (!used[*joint]) ahead.emplace_back(child, *joint);
    }
  }
  int add(Tree& tree, int parent, std::size_t number) {
    used[number] = true;
    const Joint& joint = *world.joints()[number];
    const int from = tree.links[parent].slot;
    const bool forward = int(joint.body1.slot) == from;
    const int to = int(forward ? joint.body2.slot : joint.body1.slot);
    Recognised recognised = recognise(joint, number);
    if (!forward) recognised = recognised.reversed();
    const auto& elements = recognised.elements;
    for (std::size_t k = 0; k < elements.size(); ++k) {
      const Element& element = elements[k];
      const bool first = k == 0, last = k + 1 == elements.size();
      TreeLink link = last ? link_of(world.bodies.at(to), to) : TreeLink{};
      link.freedom = element.freedom;
      link.parent = first ? parent : int(tree.links.size()) - 1;
      link.axis_local = element.axis;
      if (first)
        link.from_parent_local = tree.links[parent].centre_local + recognised.anchor1_local;
      if (last) link.centre_local = -recognised.anchor2_local;
      link.start = element.start;
      const vec3& a = element.axis;
      link.start_axis = quat(0, a.x, a.y, a.z) * element.start;
      tree.links.push_back(link);
      tree.sources.push_back(element.source);
      tree.sources.back().joint = &joint;
      tree.sources.back().number = number;
    }
    return int(tree.links.size()) - 1;
  }
  Tree root(int slot) const {
    Tree tree;
    const Body& body = world.bodies.at(slot);
    tree.links.push_back(link_of(body, slot));
    tree.links[0].freedom = body.is_static() ? Freedom::fixed : Freedom::free;
    tree.sources.emplace_back();
    return tree;
  }
};

}  // namespace

Reduced::Reduced(const World& world, real most_gap) : most_gap_(most_gap) {
  require(most_gap >= 0, "most_gap", most_gap, "must not be negative [rad or 1]");
  build(world);
}

void Reduced::build(const World& world) {
  check_input(world, 1);
  Grower grower(world);
  std::vector<Tree> trees;
  for (const bool fixed : {true, false})
    for (int slot = 0; slot < world.bodies.slots(); ++slot) {
      if (!world.bodies.used(slot) || world.bodies.at(slot).is_static() != fixed) continue;
      const auto& joints = grower.joints_of[std::size_t(slot)];
      if (fixed) {
        for (const std::size_t number : joints) {  // each joint at a static body begins a tree
          trees.push_back(grower.root(slot));
          grower.grow(trees.back(), 0, number);
        }
      } else if (std::ranges::none_of(joints, [&](auto number) { return grower.used[number]; })) {
        trees.push_back(grower.root(slot));
        for (const std::size_t number : joints)
          if (!grower.used[number]) grower.grow(trees.back(), 0, number);
      }
    }
  for (Tree& tree : trees) tree.read(world.bodies, most_gap_);
  trees_ = std::move(trees);
  packs_ = packs_of(trees_);
  locks_.clear();
  for (const auto& joint : world.joints())
    if (const auto* six = dynamic_cast<const SixDofJoint*>(joint.get()))
      locks_.emplace_back(six, locks_of(*six));
  joint_count_ = world.joints().size();
  last_joint_ = joint_count_ > 0 ? world.joints().back()->number() : 0;
  bodies_ = used_slots(world.bodies);
}

void Reduced::refresh(const World& world) {
  const auto& joints = world.joints();
  bool rebuild = joints.size() != joint_count_ || used_slots(world.bodies) != bodies_ ||
                 (joint_count_ > 0 && joints.back()->number() != last_joint_);
  for (const auto& [joint, locks] : locks_) {
    if (rebuild) break;
    const std::array<Range, 6> now = locks_of(*joint);
    for (std::size_t k = 0; k < 6; ++k)
      if (now[k].lower != locks[k].lower || now[k].upper != locks[k].upper) rebuild = true;
  }
  for (Tree& tree : trees_) {
    if (rebuild) break;
    if (!tree.unchanged(world.bodies, rebuild) && !rebuild) tree.read(world.bodies, most_gap_);
  }
  if (rebuild) build(world);
}

void Reduced::step(World& world, real h) {
  require(h >= shortest_step && h <= longest_step, "h", h, "must be from 1e-9 to 1e9 [s]");
  require(iterations >= 1 && iterations <= 50, "iterations", real(iterations),
          "must be from 1 to 50 [1]");
  require_finite("gravity", world.gravity, "must be finite [m/s^2]");
  refresh(world);
  for (Tree& tree : trees_)
    if (tree.read_forces(world.bodies, world.gravity) && method == Method::runge_kutta)
      require(tree.only_springs(), "method: Runge-Kutta steps need coordinates without limits, "
                                   "motors and friction");
  for (Tree& tree : trees_) {
    tree.begin_impulses();
    if (method == Method::leapfrog) leapfrog(tree, world, h);
  }
  if (method == Method::runge_kutta)
    for (Pack& pack : packs_) pack.runge_kutta(trees_, h);
  for (int slot = 0; slot < world.bodies.slots(); ++slot)
    if (world.bodies.at(slot).kinematic) integrate_pose(world.bodies.at(slot), h);
  for (const Tree& tree : trees_) tree.write(world.bodies);
  for (const Tree& tree : trees_) tree.tell_joints(h);
  world.last_h = 0;  // the velocities belong to the time of the poses
}

Reduced::Report Reduced::report() const {
  Report out;
  for (const Tree& tree : trees_) {
    if (!(tree.changed() <= out.changed)) out.changed = tree.changed();  // also NaN
    out.wrong = std::max(out.wrong, tree.wrong());
  }
  return out;
}

std::vector<std::string> Reduced::Report::sentences() const {
  constexpr double much = 0.4;
  std::vector<std::string> out;
  if (!(changed <= much))
    out.push_back("The energy of a tree changed by more than its forces and drives did: a motion "
                  "is too fast for the step. Take a shorter step.");
  if (wrong > 0)
    out.push_back("A limit, motor or friction is on the wrong side of its bounds. Take a shorter "
                  "step.");
  return out;
}

void Reduced::satisfy(World& world) {
  refresh(world);
  for (const Tree& tree : trees_) tree.write(world.bodies);
}

// A step of a tree, divided as often as its forces require.
void Reduced::leapfrog(Tree& tree, const World& world, real h) {
  for (int parts = 1; parts <= most_parts; parts *= 2) {
    if (parts > 1) {  // once more from the bodies, which have not moved yet
      tree.read(world.bodies, most_gap_);
      tree.read_forces(world.bodies, world.gravity);
    }
    tree.begin_impulses();
    bool good = true;
    for (int k = 0; k < parts && good; ++k) good = tree.leapfrog(h / real(parts), iterations);
    if (good) return;
  }
  throw std::runtime_error("h: the forces of a fast top or a tight chain change too much within "
                           "the step; take a shorter one");
}

int Reduced::degrees_of_freedom() const {
  int sum = 0;
  for (const Tree& tree : trees_)
    for (const TreeLink& link : tree.links)
      sum += link.freedom == Freedom::free ? 6
             : link.freedom == Freedom::ball ? 3
             : link.freedom == Freedom::hinge || link.freedom == Freedom::slider ? 1 : 0;
  return sum;
}

Reduced::Place Reduced::find(const Joint& joint) const {
  for (std::size_t t = 0; t < trees_.size(); ++t) {
    const auto& sources = trees_[t].sources;
    const auto is = [&](const CoordinateSource& source) { return source.joint == &joint; };
    const auto first = std::ranges::find_if(sources, is);
    if (first == sources.end()) continue;
    const auto last = std::find_if_not(first, sources.end(), is);
    return {t, std::size_t(first - sources.begin()), std::size_t(last - sources.begin()) - 1};
  }
  refuse("joint: no tree has it: is it between static bodies, or of another world?");
}

Reaction Reduced::load(const Joint& joint) {
  const Place at = find(joint);
  Tree& tree = trees_[at.tree];
  const bool forward = tree.links[at.last].slot == int(joint.body2.slot);
  Reaction out = tree.reaction(forward ? at.last : at.first);
  if (forward) return out;
  const TreeLink& link = tree.links[at.first];  // about the anchor of body 2 instead of body 1
  if (link.freedom == Freedom::slider) out.torque += cross(link.x * link.a, out.force);
  return {-out.force, -out.torque};
}

std::vector<Reduced::Acceleration> Reduced::accelerations(const World& world) {
  refresh(world);
  std::vector<Acceleration> out(std::size_t(world.bodies.slots()));
  for (Tree& tree : trees_) {
    tree.read_forces(world.bodies, world.gravity);
    tree.find_accelerations();
    for (const TreeLink& link : tree.links) {
      if (link.slot < 0 || link.freedom == Freedom::fixed) continue;
      out[std::size_t(link.slot)] = {
          link.a_A + cross(link.alpha, link.c) + cross(link.w, cross(link.w, link.c)),
          link.alpha};
    }
  }
  return out;
}

}  // namespace joints
