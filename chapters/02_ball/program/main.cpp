// Chapter 2's program: rows against a block, a blow that travels along a chain, a chain that
// swings; all with the reader's own J, K, impulse and turn. Read it; there is nothing to edit here.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "chapters/01_distance/distance.h"
#include "chapters/02_ball/ball.h"
#include "engine/instruments/plan.h"
#include "engine/instruments/options.h"
#include "engine/instruments/record.h"
#include "engine/instruments/run.h"

using namespace joints;

namespace {

// A chain: body 0 is static, joint k holds body k to body k + 1.
struct Chain {
  std::vector<Body> bodies;
  std::vector<Point> parts;
};

// One joint, prepared for the iterations of a step.
struct Prepared {
  Jacobian<3> J;
  mat3 K;
  vec3 bias;
};

const vec3 rod_size(1, real(0.1), real(0.1)), gravity(0, real(-9.81), 0);

// `links` thin rods of 1 m and 1 kg end to end, each in the direction that `bend` gives for it.
template <class Bend>
Chain make_chain(int links, Bend bend) {
  Chain chain;
  chain.bodies.push_back(static_body(vec3(0)));
  vec3 end(0);
  for (int k = 0; k < links; ++k) {
    const quat q = bend(k);
    const vec3 along = q * vec3(1, 0, 0);
    chain.bodies.push_back(box(1, rod_size, end + along / real(2), q));
    chain.parts.push_back(point_at(chain.bodies[k], chain.bodies[k + 1], end));
    end += along;
  }
  return chain;
}

quat straight(int) { return quat(1, 0, 0, 0); }
// Each rod has another direction, so that the three rows of a joint are strongly coupled.
quat bent(int k) {
  return rotation(vec3(0, real(0.9) * real(k), 0)) * rotation(vec3(0, 0, real(-0.6)));
}

std::vector<Prepared> prepare(const Chain& chain, real feedback) {
  std::vector<Prepared> out;
  for (std::size_t k = 0; k < chain.parts.size(); ++k) {
    const Body &body1 = chain.bodies[k], &body2 = chain.bodies[k + 1];
    const Point& part = chain.parts[k];
    out.push_back({part.jacobian(body1, body2), part.K(body1, body2),
                   feedback * part.error(body1, body2)});
  }
  return out;
}

void solve_block(Chain& chain, const std::vector<Prepared>& joints, std::size_t k) {
  Body &body1 = chain.bodies[k], &body2 = chain.bodies[k + 1];
  const vec3 lambda = block_impulse(joints[k].J, joints[k].K, joints[k].bias, body1, body2);
  apply_impulse(joints[k].J, lambda, body1, body2);
}

// The same joint as three rows, one after the other, each as in chapter 1.
void solve_rows(Chain& chain, const std::vector<Prepared>& joints, std::size_t k) {
  Body &body1 = chain.bodies[k], &body2 = chain.bodies[k + 1];
  const Prepared& joint = joints[k];
  for (int i = 0; i < 3; ++i) {
    const real lambda = row_impulse(joint.J[i], joint.K[i][i], joint.bias[i], body1, body2);
    apply_impulse(joint.J[i], lambda, body1, body2);
  }
}

// The remaining velocity error of joint k [m/s], bias included.
double joint_error(const Chain& chain, const Prepared& joint, std::size_t k) {
  vec3 e = joint.bias;
  for (int i = 0; i < 3; ++i)
    e[i] += row_velocity(joint.J[i], chain.bodies[k], chain.bodies[k + 1]);
  return double(length(e));
}

double rms_error(const Chain& chain, const std::vector<Prepared>& joints) {
  double sum = 0;
  for (std::size_t k = 0; k < joints.size(); ++k)
    sum += std::pow(joint_error(chain, joints[k], k), 2);
  return std::sqrt(sum / double(joints.size()));
}

// The matrix of all rows, J M^-1 J^T: the change of the rate of row i per unit impulse of row j.
void write_system(Chain chain, const std::vector<Prepared>& joints, const std::string& path) {
  CsvFile table(path, {"row", "column", "value"});
  for (Body& body : chain.bodies) body.v = body.w = vec3(0);
  for (std::size_t column = 0; column < 3 * joints.size(); ++column) {
    Chain pushed = chain;
    const std::size_t k = column / 3;
    vec3 unit(0);
    unit[int(column % 3)] = 1;
    apply_impulse(joints[k].J, unit, pushed.bodies[k], pushed.bodies[k + 1]);
    for (std::size_t row = 0; row < 3 * joints.size(); ++row)
      table.row({double(row), double(column),
                 double(row_velocity(joints[row / 3].J[int(row % 3)], pushed.bodies[row / 3],
                                     pushed.bodies[row / 3 + 1]))});
  }
}

// One velocity solve of a bent chain: error after every iteration, rows against block.
void compare_rows_and_block(int links, const std::string& out) {
  CsvFile table(out + "/iterations.csv", {"method", "iteration", "error_m_s"});
  Chain start = make_chain(links, bent);
  for (Body& body : start.bodies)
    if (!body.is_static()) body.v = vec3(0, real(-9.81) / 60, 0);
  const std::vector<Prepared> joints = prepare(start, 0);
  write_system(start, joints, out + "/system.csv");
  for (const std::string method : {"rows", "block"}) {
    Chain chain = start;
    for (int iteration = 0; iteration <= 400; ++iteration) {
      table.row({method}, {double(iteration), rms_error(chain, joints)});
      for (std::size_t k = 0; k < joints.size(); ++k)
        method == "block" ? solve_block(chain, joints, k) : solve_rows(chain, joints, k);
    }
  }
}

// A straight chain at rest; the last rod is struck along the chain, towards the wall. The remaining
// error of each joint after every iteration, for iterations from the wall to the tip and from the
// tip to the wall.
void blow(const std::string& out) {
  CsvFile table(out + "/blow.csv", {"order", "iteration", "joint", "error_m_s"});
  for (const std::string order : {"wall to tip", "tip to wall"}) {
    Chain chain = make_chain(10, straight);
    chain.bodies.back().v = vec3(-1, 0, 0);
    const std::vector<Prepared> joints = prepare(chain, 0);
    const std::size_t n = joints.size();
    for (int iteration = 0; iteration <= 20; ++iteration) {
      for (std::size_t k = 0; k < n; ++k)
        table.row({order}, {double(iteration), double(k + 1), joint_error(chain, joints[k], k)});
      for (std::size_t k = 0; k < n; ++k)
        solve_block(chain, joints, order == "wall to tip" ? k : n - 1 - k);
    }
  }
}

// Forces, joints, iterations, positions: chapter 1's step, with a block for every joint and bodies
// that rotate.
void step(Chain& chain, int iterations, real beta, real h) {
  for (Body& body : chain.bodies) integrate_forces(body, gravity, h);
  const std::vector<Prepared> joints = prepare(chain, beta / h);
  for (int iteration = 0; iteration < iterations; ++iteration)
    for (std::size_t k = 0; k < joints.size(); ++k) solve_block(chain, joints, k);
  for (Body& body : chain.bodies) {
    if (body.is_static()) continue;
    body.x += h * body.v;
    body.q = turned(body.q, body.w, h);
  }
}

// A chain that is released straight and level.
Summary swing(int links, int iterations, real beta, double seconds, CsvFile& table,
              const std::string& motion_path) {
  const real h = real(1) / 60;
  Chain chain = make_chain(links, straight);
  Motion motion("chain", double(h));
  motion.body({"ball", {0.2, 0.2, 0.2}});
  for (int k = 0; k < links; ++k) motion.body({"box", {rod_size.x, rod_size.y, rod_size.z}});
  const auto gaps = [&](GapMeter& meter) {
    for (std::size_t k = 0; k < chain.parts.size(); ++k)
      meter.add(double(length(chain.parts[k].error(chain.bodies[k], chain.bodies[k + 1]))));
  };
  const Experiment experiment{.step = [&] { step(chain, iterations, beta, h); },
                              .bodies = [&] { return std::span<const Body>(chain.bodies); },
                              .gaps = gaps,
                              .steps = steps_in(seconds, h),
                              .gravity = gravity,
                              .energy_scale = 9.81 * 0.5 * links * links};
  const double start = energy(chain.bodies, gravity);
  const Measures measures = run(experiment, [&](int n) {
    GapMeter now;
    gaps(now);
    table.row({double(iterations), n * double(h), now.rms(), now.maximum(),
               energy(chain.bodies, gravity) - start});
    motion.frame(chain.bodies.data(), {reading_of(experiment)});
  });
  if (!motion_path.empty()) motion.write(motion_path);
  return {measures, "chain",
          std::to_string(links) + " links, " + std::to_string(iterations) + " iterations"};
}

// A brick without forces that rotates about its middle axis, moved in three ways: its energy and
// the change of its angular momentum, relative to the start, and its angular velocity about that
// axis.
void spin(const std::string& out) {
  CsvFile table(out + "/spin.csv",
                {"method", "time_s", "energy_1", "momentum_changed_1", "middle_rad_s"});
  const vec3 I(real(1.0), real(0.7), real(0.4)), start(real(0.01), 6, 0);  // the body's axes
  const real h = real(1) / 60;
  const Body made = [&] {
    Body body = body_with(1, I, vec3(0));
    body.w = start;
    return body;
  }();
  const vec3 L = angular_momentum(made);
  const auto change = [&](const vec3& w) { return -h * (cross(w, I * w) / I); };
  for (const std::string method : {"explicit", "implicit", "momentum kept"}) {
    Body body = made;
    for (int n = 0; n <= 1200; ++n) {
      const vec3 now = to_local(body, body.w), lost = angular_momentum(body) - L;
      const real twice_energy = dot(body.w, angular_momentum(body));
      table.row({method}, {n * double(h), double(twice_energy / dot(start, L)),
                           double(length(lost) / length(L)), double(now.y)});
      if (method == "momentum kept") {
        tumble(body, h);  // yours
        continue;
      }
      vec3 w = now;
      for (int k = 0; k < (method == "explicit" ? 1 : 50); ++k) w = now + change(w);
      const vec3 turned = h * to_world(body, w);
      body.q = normalize(rotation(turned) * body.q);
      body.w = to_world(body, w);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  return run_program([&] {
    Options options("Chapter 2: rows against a block, a blow, and a chain that swings",
                    {{"links", "12", "links of the bent and of the swinging chain"},
                     {"iterations", "30", "iterations per step, of the recorded motion"},
                     {"beta", "0.2", "fraction of the error fed back per step [1]"},
                     {"seconds", "5", "how long the chain swings [s]"}});
    if (!options.read(argc, argv)) return;
    const int links = options.count("links", 2), chosen = options.count("iterations", 1);
    const real beta = real(options.number("beta", 0));
    const double seconds = options.number("seconds", 0.1);
    const std::string out = options.text("out");

    Plan plan;
    plan.bodies = links + 1;
    plan.static_bodies = 1;
    plan.blocks = links;
    plan.rows = 3 * links;
    std::printf("%s: %s\n", "chain", plan.line().c_str());

    compare_rows_and_block(links, out);
    blow(out);
    spin(out);
    std::vector<int> counts{5, 10, 30, 100};
    if (std::find(counts.begin(), counts.end(), chosen) == counts.end()) counts.push_back(chosen);
    CsvFile table(out + "/chain.csv",
                  {"iterations", "time_s", "gap_rms_m", "gap_max_m", "energy_change_j"});
    std::vector<Summary> lines;
    for (int iterations : counts)
      lines.push_back(swing(links, iterations, beta, seconds, table,
                            iterations == chosen ? out + "/chain.motion.json" : ""));
    report(lines, out);
  });
}
