// MuJoCo: reduced coordinates, its Euler, implicit and Runge-Kutta steps. A loop is closed by its
// soft constraints, a motor is a servo on the speed whose torque is bounded.
#include "bench/peers/peer.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstring>
#include <sstream>

namespace joints::bench {

namespace {

// What is set in it.
struct Choice {
  int integrator = mjINT_EULER;
  int substeps = 1;
  // Of a servo: its joint's inertia over h, times this. 0: its torque reaches the bound at rest,
  // which is the most that the implicit step can take, for it forgets the bound in its derivatives.
  double gain = 0.5;
  double time_constant = 0.02;  // of its soft constraints [s]
};

std::size_t at(int slot) { return std::size_t(slot); }

// The scene in its own language.
class Model {
 public:
  explicit Model(const PeerScene& scene) : scene_(scene), trees_(trees_of(scene)) {
    children_.resize(scene.bodies.size());
    for (const int slot : trees_.order)
      if (const int parent = trees_.parent[at(slot)]; parent >= 0)
        children_[at(parent)].push_back(slot);
    text_.precision(17);
    text_ << "<mujoco><compiler angle='radian' inertiafromgeom='false'/><option gravity='"
          << words(scene.gravity) << "'/><worldbody>";
    for (const int slot : trees_.order)
      if (trees_.parent[at(slot)] < 0) write(slot);
    text_ << "</worldbody>";
    write_loops();
    write_motors();
    text_ << "</mujoco>";
    files_[0] = text_.str();
  }
  /// The file that is read, then those that it includes.
  const std::vector<std::string>& files() const { return files_; }
  static std::string name(std::size_t file) { return "part" + std::to_string(file) + ".xml"; }
  std::vector<int> slots;    ///< of its bodies from 1 on
  std::vector<int> driven;   ///< joints of ours that its actuators drive

 private:
  static std::string words(const glm::dvec3& a) {
    std::ostringstream out;
    out.precision(17);
    out << a.x << ' ' << a.y << ' ' << a.z;
    return out.str();
  }
  static std::string words(const glm::dquat& q) {
    std::ostringstream out;
    out.precision(17);
    out << q.w << ' ' << q.x << ' ' << q.y << ' ' << q.z;
    return out.str();
  }
  void write(int slot) {
    const Body& body = scene_.bodies[at(slot)];
    glm::dvec3 x(body.x);
    glm::dquat q(body.q);
    if (const int parent = trees_.parent[at(slot)]; parent >= 0) {
      const Body& before = scene_.bodies[at(parent)];
      x = conjugate(glm::dquat(before.q)) * (x - glm::dvec3(before.x));
      q = conjugate(glm::dquat(before.q)) * q;
    }
    slots.push_back(slot);
    text_ << "<body name='b" << slot << "' pos='" << words(x) << "' quat='" << words(q) << "'>";
    if (!body.is_static()) {
      text_ << "<inertial pos='0 0 0' mass='" << 1 / double(body.inverse_mass)
            << "' diaginertia='" << words(1.0 / glm::dvec3(body.inverse_inertia_local)) << "'/>";
      write_joint(slot);
    }
    write(scene_.shapes[at(slot)]);
    // Its reader takes a hundred elements inside each other and no more: deeper ones are included.
    const bool is_deep = ++depth_ % most_depth == 0;
    std::ostringstream before;
    const std::size_t file = files_.size();
    if (is_deep) {
      text_ << "<include file='" << name(file) << "'/>";
      files_.emplace_back();
      std::swap(before, text_);
      text_.precision(17);
      text_ << "<mujocoinclude>";
    }
    for (const int child : children_[at(slot)]) write(child);
    if (is_deep) {
      text_ << "</mujocoinclude>";
      files_[file] = text_.str();
      std::swap(before, text_);
    }
    --depth_;
    text_ << "</body>";
  }
  void write_joint(int slot) {
    const int k = trees_.joint[at(slot)];
    if (k < 0) {
      text_ << "<freejoint/>";
      return;
    }
    const PeerJoint& joint = scene_.joints[at(k)];
    if (joint.kind == PeerJoint::Kind::fixed) return;
    const Body& body = scene_.bodies[at(slot)];
    const glm::dquat back = conjugate(glm::dquat(body.q));
    const double sign = joint.body2 == slot ? 1 : -1;
    text_ << "<joint name='j" << k << "' pos='" << words(back * (joint.anchor - glm::dvec3(body.x)))
          << "' type='";
    if (joint.kind == PeerJoint::Kind::ball) {
      text_ << "ball'/>";
      return;
    }
    text_ << (joint.kind == PeerJoint::Kind::hinge ? "hinge" : "slide") << "' axis='"
          << words(back * (sign * joint.axis)) << "'";
    if (joint.limited())
      text_ << " limited='true' range='" << double(joint.limits.lower) << ' '
            << double(joint.limits.upper) << "'";
    text_ << "/>";
    if (joint.motor.strength > 0) driven.push_back(k);
  }
  // Of two frictions it takes the larger one.
  void write(const PeerShape& shape) {
    if (shape.kind == PeerShape::Kind::none) return;
    text_ << "<geom contype='" << (shape.is_ground ? 1 : 2) << "' conaffinity='"
          << (shape.is_ground ? 2 : 1) << "' friction='" << (shape.is_ground ? 0 : shape.friction)
          << " 0.005 0.0001' type='";
    switch (shape.kind) {
      case PeerShape::Kind::plane:  // its normal is z
        text_ << "plane' size='0 0 1' pos='0 " << shape.height
              << " 0' quat='0.70710678118654757 -0.70710678118654757 0 0'/>";
        break;
      case PeerShape::Kind::box: text_ << "box' size='" << words(shape.half) << "'/>"; break;
      default: text_ << "sphere' size='" << shape.half.x << "'/>";
    }
  }
  // A ball's loop closes at a point, a hinge's at two points of its axis.
  void write_loops() {
    if (trees_.loops.empty()) return;
    text_ << "<equality>";
    for (const int k : trees_.loops) {
      const PeerJoint& joint = scene_.joints[at(k)];
      const Body& body = scene_.bodies[at(joint.body1)];
      const bool is_hinge = joint.kind == PeerJoint::Kind::hinge;
      const std::string bodies = " body1='b" + std::to_string(joint.body1) + "' body2='b" +
                                 std::to_string(joint.body2) + "'";
      if (joint.kind == PeerJoint::Kind::fixed) {
        text_ << "<weld" << bodies << "/>";
        continue;
      }
      for (const double side : {0.5, -0.5}) {
        const glm::dvec3 point = joint.anchor + (is_hinge ? side : 0) * joint.axis;
        text_ << "<connect" << bodies << " anchor='"
              << words(conjugate(glm::dquat(body.q)) * (point - glm::dvec3(body.x))) << "'/>";
        if (!is_hinge) break;
      }
    }
    text_ << "</equality>";
  }
  void write_motors() {
    if (driven.empty()) return;
    text_ << "<actuator>";
    for (const int k : driven) {
      const double strength = double(scene_.joints[at(k)].motor.strength);
      text_ << "<velocity joint='j" << k << "' kv='1' forcelimited='true' forcerange='"
            << -strength << ' ' << strength << "'/>";
    }
    text_ << "</actuator>";
  }

  const PeerScene& scene_;
  Trees trees_;
  std::vector<std::vector<int>> children_;
  std::vector<std::string> files_{""};
  std::ostringstream text_;
  int depth_ = 0;
  static constexpr int most_depth = 80;
};

mjModel* compiled(const std::vector<std::string>& files) {
  const auto held = std::make_unique<mjVFS>();
  mj_defaultVFS(held.get());
  for (std::size_t k = 0; k < files.size(); ++k) {
    const std::string name = Model::name(k), &text = files[k];
    if (mj_makeEmptyFileVFS(held.get(), name.c_str(), int(text.size())) != 0)
      refuse("MuJoCo: too many files");
    std::memcpy(held->filedata[mj_findFileVFS(held.get(), name.c_str())], text.data(),
                text.size());
  }
  char words[500] = "";
  mjModel* model = mj_loadXML(Model::name(0).c_str(), held.get(), words, sizeof words);
  mj_deleteVFS(held.get());
  if (!model) refuse(std::string("MuJoCo: ") + words);
  return model;
}

class MujocoWorld : public Peer {
 public:
  MujocoWorld(const PeerScene& scene, const Choice& choice) : choice_(choice) {
    const Model model(scene);
    slots_ = model.slots;
    for (const Body& body : scene.bodies) is_static_.push_back(body.is_static());
    model_ = compiled(model.files());
    model_->opt.integrator = choice.integrator;
    if (choice.integrator == mjINT_IMPLICIT)  // its own guess is too little for a chain of 100
      model_->nstack += 30 * model_->nv * model_->nv;
    make_room(scene);
    const auto set_time = [&](mjtNum* solref, int count) {
      for (int k = 0; k < count; ++k) solref[k * mjNREF] = choice.time_constant;
    };
    set_time(model_->eq_solref, model_->neq);      // loops
    set_time(model_->jnt_solref, model_->njnt);    // limits
    set_time(model_->geom_solref, model_->ngeom);  // contacts
    data_ = mj_makeData(model_);
    set_rates(scene);
    for (std::size_t k = 0; k < model.driven.size(); ++k)
      data_->ctrl[k] = double(scene.joints[at(model.driven[k])].motor.speed);
  }
  ~MujocoWorld() override {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }
  MujocoWorld(const MujocoWorld&) = delete;
  MujocoWorld& operator=(const MujocoWorld&) = delete;

  void step(double h) override {
    const double part = h / choice_.substeps;
    if (model_->opt.timestep != part || !started_) {
      model_->opt.timestep = part;
      set_gains(part);
      started_ = true;
    }
    for (int n = 0; n < choice_.substeps; ++n) mj_step(model_, data_);
    for (const int what : {mjWARN_CONTACTFULL, mjWARN_CNSTRFULL})
      if (data_->warning[what].number > 0) refuse("MuJoCo: it dropped a contact or a row");
  }
  void show(Bodies& bodies) override {
    mj_kinematics(model_, data_);
    mj_comPos(model_, data_);
    mj_comVel(model_, data_);
    // It starts anew where its numbers are bad: not so here.
    bool lost = false;
    for (const int what : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
      lost = lost || data_->warning[what].number > 0;
    for (std::size_t k = 0; k < slots_.size(); ++k) {
      if (is_static_[at(slots_[k])]) continue;
      const std::size_t id = k + 1;
      Body& body = bodies.at(slots_[k]);
      const mjtNum* q = data_->xquat + 4 * id;
      mjtNum v[6];
      mj_objectVelocity(model_, data_, mjOBJ_BODY, int(id), v, 0);
      body.x = lost ? vec3(std::numeric_limits<real>::quiet_NaN()) : vector(data_->xpos + 3 * id);
      body.q = quat(real(q[0]), real(q[1]), real(q[2]), real(q[3]));
      body.w = vector(v);
      body.v = vector(v + 3);
    }
  }

 private:
  // The velocities of the start and the torques from outside, of its bodies in their order. A free
  // body's angular velocity is in its own axes.
  void set_rates(const PeerScene& scene) {
    const Trees trees = trees_of(scene);
    const auto set = [](mjtNum* to, const glm::dvec3& a, int count) {
      for (int i = 0; i < count; ++i) to[i] = a[i];
    };
    for (int k = 1; k < model_->nbody; ++k) {
      const int slot = slots_[at(k - 1)];
      set(data_->xfrc_applied + 6 * k + 3, glm::dvec3(scene.bodies[at(slot)].torque), 3);
      if (model_->body_dofnum[k] == 0) continue;
      mjtNum* const rate = data_->qvel + model_->body_dofadr[k];
      if (trees.parent[at(slot)] >= 0) {
        set(rate, start_rate(scene, trees, slot), model_->body_dofnum[k]);
        continue;
      }
      const Body& body = scene.bodies[at(slot)];
      set(rate, glm::dvec3(body.v), 3);
      set(rate + 3, glm::dvec3(to_local(body, body.w)), 3);
    }
  }
  static vec3 vector(const mjtNum* a) { return vec3(real(a[0]), real(a[1]), real(a[2])); }
  // Its own guess is a hundred contacts in all, and it drops what is more. A box has up to four on
  // a plane, a contact four rows.
  void make_room(const PeerScene& scene) {
    const auto stands = [](const PeerShape& one) {
      return one.kind != PeerShape::Kind::none && !one.is_ground;
    };
    const int contacts = 4 * int(std::count_if(scene.shapes.begin(), scene.shapes.end(), stands));
    model_->njmax += 4 * std::max(0, contacts - model_->nconmax);
    model_->nconmax = std::max(model_->nconmax, contacts);
  }
  void set_gains(double h) {
    for (int k = 0; k < model_->nu; ++k) {
      const int dof = model_->jnt_dofadr[model_->actuator_trnid[2 * k]];
      const double gain = choice_.gain > 0 ? choice_.gain * model_->dof_M0[dof] / h
                                           : model_->actuator_forcerange[2 * k + 1] /
                                                 std::abs(data_->ctrl[k]);
      model_->actuator_gainprm[k * mjNGAIN] = gain;
      model_->actuator_biasprm[k * mjNBIAS + 2] = -gain;
    }
  }

  Choice choice_;
  std::vector<int> slots_;  // of its bodies from 1 on
  std::vector<bool> is_static_;  // of our slots
  bool started_ = false;
  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
};

std::string version() {
  const std::string digits = std::to_string(mj_version());
  return {digits[0], '.', digits[1], '.', digits[2]};
}

}  // namespace

std::vector<PeerSetting> mujoco_settings(bool search) {
  mju_user_warning = [](const char*) {};  // else it writes them into a file
  mju_user_error = [](const char* words) { refuse(std::string("MuJoCo: ") + words); };
  std::vector<PeerSetting> out;
  const auto add = [&](const std::string& name, const Choice& choice, bool quick) {
    const bool is_implicit = choice.integrator == mjINT_IMPLICIT;  // its stack grows as a square
    out.push_back({.engine = "MuJoCo", .version = version(),
                   .number = sizeof(mjtNum) == 8 ? "double" : "float", .name = name,
                   .quick = quick, .most_joints = is_implicit ? 300 : 2000, .exact = true,
                   .substeps = choice.integrator == mjINT_RK4 ? 0 : choice.substeps,
                   .reduced = true,
                   .make = [choice](const PeerScene& scene) {
                     return std::make_unique<MujocoWorld>(scene, choice);
                   }});
  };
  const double at_bound = 0;
  if (search) {
    for (const int substeps : {1, 4, 16})
      for (const auto& [words, integrator] :
           {std::pair{"Euler", mjINT_EULER}, {"implicit", mjINT_IMPLICIT}, {"RK4", mjINT_RK4}})
        for (const double time : {0.02, 0.002})
          add(std::to_string(substeps) + " x " + words + (time < 0.02 ? " stiff" : ""),
              {integrator, substeps, integrator == mjINT_IMPLICIT ? at_bound : 0.5, time}, true);
    return out;
  }
  add("Euler (its default)", {}, true);
  out.back().basic = true;
  add("Euler 8 substeps", {.substeps = 8}, true);
  add("implicit", {.integrator = mjINT_IMPLICIT, .gain = at_bound}, true);
  add("Runge-Kutta", {.integrator = mjINT_RK4}, true);
  add("implicit stiff", {mjINT_IMPLICIT, 1, at_bound, 0.002}, false);
  out.back().swept = true;
  add("Runge-Kutta stiff", {mjINT_RK4, 1, 0.5, 0.002}, false);
  out.back().swept = true;
  add("implicit 8 substeps stiff", {mjINT_IMPLICIT, 8, at_bound, 0.002}, false);
  add("Runge-Kutta 4 substeps stiff", {mjINT_RK4, 4, 0.5, 0.002}, false);
  return out;
}

}  // namespace joints::bench
