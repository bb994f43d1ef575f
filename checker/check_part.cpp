// Asks a part its questions at drawn poses and puts the answers into words.
#include "checker/check_part.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "checker/guess.h"
#include "checker/report.h"
#include "checker/slopes.h"

namespace joints {

using testing::close_joint, testing::dot12, testing::Numbers, testing::slope, testing::Span;

namespace {

// The momentum that a unit impulse of a row gives to both bodies together, about the origin.
struct Momentum {
  double linear = 0, angular = 0;
  double largest() const { return std::max(linear, angular); }
};
Momentum momentum_of(const double* row, const PosePair& at) {
  const auto part = [&](int k) { return vec3(real(row[k]), real(row[k + 1]), real(row[k + 2])); };
  const vec3 angular = cross(at.body1.x, part(0)) + part(3) + cross(at.body2.x, part(6)) + part(9);
  return {double(length(part(0) + part(6))), double(length(angular))};
}

// How far a row is from the form that its part promises.
double off_form(const PartFunctions& part, const Numbers& J) {
  double out = 0;
  const auto differ = [&](double a, double b) { out = std::max(out, std::abs(a - b)); };
  const std::size_t first = part.form == Form::point ? 3 : 0;
  for (std::size_t i = 12 * first; i < J.size(); i += 12)
    for (std::size_t k = 0; k < 3; ++k) {
      differ(J[i + k], 0), differ(J[i + 6 + k], 0);
      differ(J[i + 3 + k], -J[i + 9 + k]);
    }
  for (std::size_t i = 0; i < 12 * first; i += 12)
    for (std::size_t k = 0; k < 3; ++k) {
      differ(J[i + k], i / 12 == k ? -1 : 0), differ(J[i + 6 + k], i / 12 == k ? 1 : 0);
      // w1 is a row of skew(r1), w2 one of -skew(r2): zero on the diagonal, opposite across it
      differ(J[i + 3 + k], -J[12 * k + 3 + i / 12]), differ(J[i + 9 + k], -J[12 * k + 9 + i / 12]);
    }
  return out;
}

std::string of_poses(const Finding& finding) {
  return std::to_string(finding.right) + " of " + std::to_string(finding.poses) + " poses";
}

// ---- the questions ------------------------------------------------------------------------------

class Check {
 public:
  Check(const PartFunctions& given, const PoseMaker& pose, const CheckSettings& settings)
      : part_(given), settings_(settings) {
    if (part_.names.empty()) part_.names = settings.names;
    for (int i = int(part_.names.size()); i < part_.rows; ++i)
      part_.names.push_back(part_.rows == 1 ? "C" : "C." + std::to_string(i + 1));
    for (int n = 0; n < settings.poses; ++n) {
      PoseRandom random(settings.seed + unsigned(n));
      PosePair at = pose(random);
      if (!numbers_are_whole(at)) return;
      broken_.push_back(at);
      if (close_joint(part_.C, at)) closed_.push_back(at);
    }
  }

  PartReport report() {
    if (!numbers_.words.empty()) return {{numbers_}};
    PartReport out;
    out.findings = {poses(), jacobian()};
    if (out.findings.back().holds) out.findings.push_back(broken_jacobian());
    if (part_.form != Form::any) out.findings.push_back(form());
    out.findings.push_back(rank());
    if (part_.K) out.findings.push_back(K());
    out.findings.push_back(momentum());
    out.findings.push_back(power());
    out.findings.push_back(turns());
    return out;
  }

 private:
  // C and J must have as many numbers as there are rows, all of them finite.
  bool numbers_are_whole(const PosePair& at) {
    const Numbers C = part_.C(at), J = part_.J(at);
    const std::string none = testing::no_number(C), none_J = testing::no_number(J);
    numbers_ = {"numbers", false, 0, 1, 0, ""};
    if (C.size() != std::size_t(part_.rows) || J.size() != 12 * C.size())
      numbers_.words = "C and J must have one entry and 12 numbers per row.";
    else if (!none.empty()) numbers_.words = "In C: " + testing::without_ids(none) + ".";
    else if (!none_J.empty()) numbers_.words = "In J: " + testing::without_ids(none_J) + ".";
    return numbers_.words.empty();
  }

  Finding poses() const {
    Finding out{"poses", true, int(closed_.size()), int(broken_.size()), 0, ""};
    out.holds = 2 * out.right >= out.poses;
    out.words = "C becomes 0 from " + of_poses(out) +
                (out.holds ? "." : ": its rows contradict each other, or C has no zero near them.");
    return out;
  }

  // J, or K, beside differences at some poses. \param pose closed_pose or broken_pose
  Finding compared(const std::string& question, const std::vector<PosePair>& at, int pose) const {
    const bool of_K = question == "K";
    const double tolerance = of_K ? testing::K_tolerance : testing::difference_tolerance;
    testing::Seen seen;
    seen.J = part_.J;
    seen.K = part_.K;
    seen.slope = [this](const PosePair& pair) { return slope(part_.C, pair); };
    std::vector<testing::Sample> samples;
    Finding out{question, true, 0, int(at.size()), 0, ""};
    for (const PosePair& pair : at) {
      const Numbers J = slope(part_.C, pair);
      testing::Sample sample = of_K ? testing::K_sample(pose, seen, pair, testing::whole_K(J, pair))
                                    : testing::jacobian_sample(pose, seen, pair, J);
      out.right += testing::close(sample.yours, sample.right, tolerance);
      for (std::size_t i = 0; i < sample.right.size(); ++i)
        out.worst = std::max(out.worst, std::abs(sample.yours[i] - sample.right[i]));
      samples.push_back(sample);
    }
    out.holds = out.right == out.poses;
    out.words = testing::without_ids(
        of_K ? testing::K_report(part_.names, samples, tolerance)
             : testing::jacobian_report(part_.names, samples, tolerance) + factors(samples));
    if (!out.holds && 4 * out.right >= 3 * out.poses)  // no usual mistake is right so often
      out.words = out.words.substr(0, out.words.find("\nFails at")) + "\nIt is right at " +
                  of_poses(out) +
                  ". Is the part used at the others? If not, pass a function that makes the poses "
                  "in which it is used.\n";
    return out;
  }
  // The blocks of J that are the same multiple of the right ones at all poses: a ratio that is
  // missing, or a sign.
  std::string factors(const std::vector<testing::Sample>& samples) const {
    std::string out;
    for (std::size_t row = 0; row < part_.names.size(); ++row)
      for (std::size_t block = 0; block < 4; ++block) {
        double factor = 0, largest = 0, off = 0;
        const auto each = [&](auto look) {
          for (const testing::Sample& s : samples)
            for (std::size_t k = 12 * row + 3 * block; k < 12 * row + 3 * block + 3; ++k)
              look(s.yours[k], s.right[k]);
        };
        each([&](double yours, double right) {
          if (std::abs(right) > largest) largest = std::abs(right), factor = yours / right;
        });
        each([&](double yours, double right) {
          off = std::max(off, std::abs(yours - factor * right));
        });
        if (largest == 0 || std::abs(factor - 1) < 1e-5 || off > 1e-4 * largest) continue;
        char words[120];
        std::snprintf(words, sizeof words, "Seen: in row %s, %s is %.4g times the slope at every "
                      "pose.\n", part_.names[row].c_str(), testing::block_names[block], factor);
        out += words;
      }
    return out;
  }
  Finding jacobian() const {
    Finding out = compared("J", closed_, testing::closed_pose);
    if (out.holds) out.words = "J is the slope of C at " + of_poses(out) + " where C is 0.";
    return out;
  }
  Finding broken_jacobian() const {
    Finding out = compared("broken J", broken_, testing::broken_pose);
    const bool exact = out.holds;
    if (!exact && settings_.exact_when_broken) return out;
    out.holds = true;
    out.words = "J is the slope of C at " + of_poses(out) + " where C is not 0" +
                (exact ? "." : ": it is exact only where C is 0.");
    return out;
  }
  Finding K() const {
    Finding out = compared("K", closed_, testing::closed_pose);
    if (out.holds) out.words = "K is J M^-1 J^T at " + of_poses(out) + ".";
    return out;
  }
  Finding form() const {
    Finding out{"form", true, 0, int(closed_.size()), 0, ""};
    for (const PosePair& at : closed_) {
      const double off = off_form(part_, part_.J(at));
      out.worst = std::max(out.worst, off);
      out.right += off < testing::difference_tolerance;
    }
    out.holds = out.right == out.poses;
    out.words = out.holds ? "The rows have the form that the part promises."
                          : "The rows have the promised form at " + of_poses(out) +
                                ". Packed solvers rely on it: declare Form::any.";
    return out;
  }

  // Rows that depend on those above them, by the slope: J itself may be wrong.
  Finding rank() const {
    Finding out{"rank", true, 0, int(closed_.size()), 0, ""};
    std::vector<int> dependent(std::size_t(part_.rows), 0);
    for (const PosePair& at : closed_) {
      const Span span(slope(part_.C, at));
      bool full = true;
      for (std::size_t i = 0; i < span.left.size(); ++i)
        if (span.left[i] < Span::least) full = false, ++dependent[i];
      out.right += full;
    }
    std::vector<std::string> always;
    for (std::size_t i = 0; i < dependent.size(); ++i)
      if (out.poses > 0 && dependent[i] == out.poses) always.push_back(part_.names[i]);
    out.holds = out.right > 0 || out.poses == 0;
    out.worst = double(out.poses - out.right);
    out.words = !out.holds ? "The rows are dependent at every pose" +
                                 (always.empty() ? "" : ": " + testing::joined(always)) +
                                 ". Such a row is zero or follows from the rows above it; it "
                                 "removes no degree of freedom."
                : out.right == out.poses
                    ? "The rows remove " + std::to_string(part_.rows) +
                          (part_.rows == 1 ? " degree" : " degrees") + " of freedom at all poses."
                    : "The rows are independent at " + of_poses(out) + "; singular at the others.";
    return out;
  }

  Finding momentum() const {
    Finding out{"momentum", true, 0, int(closed_.size()), 0, ""};
    double numeric = 0, linear = 0, force = 0;
    for (const PosePair& at : closed_) {
      const Numbers J = part_.J(at), right = slope(part_.C, at);
      double own = 0;
      for (std::size_t i = 0; i < J.size(); i += 12) {
        own = std::max(own, momentum_of(&J[i], at).largest());
        linear = std::max(linear, momentum_of(&J[i], at).linear);
        for (std::size_t k = 0; k < 3; ++k) force = std::max(force, std::abs(J[i + k]));
        numeric = std::max(numeric, momentum_of(&right[i], at).largest());
      }
      out.worst = std::max(out.worst, own);
      out.right += own < 100 * testing::difference_tolerance;
    }
    const bool refers = numeric > 100 * testing::difference_tolerance;
    out.holds = refers || out.right == out.poses;
    out.words = !out.holds
                    ? "The forces change the momentum of the two bodies (" + of_poses(out) +
                          " are right)" +
                          (force > 0 && linear < 100 * testing::difference_tolerance
                               ? ": they are opposite, but their levers, each from the centre of "
                                 "its body, do not end on one line."
                               : ": they must be opposite, with levers about each centre.")
                : refers ? "C changes when both bodies move as one, so the joint exchanges "
                           "momentum with the world: right only for parts of a fixed machine."
                         : "The forces conserve linear and angular momentum.";
    return out;
  }

  // Forces J^T lambda do no work on velocities that keep C: the rows of J lie in the span of its
  // slope.
  Finding power() const {
    Finding out{"power", true, 0, int(closed_.size()), 0, ""};
    for (const PosePair& at : closed_) {
      const Span span(slope(part_.C, at));
      const Numbers J = part_.J(at);
      double work = 0;
      for (std::size_t i = 0; i < J.size(); i += 12) {
        Numbers row(J.begin() + long(i), J.begin() + long(i) + 12);
        span.remove_from(row);
        work = std::max(work, std::sqrt(dot12(row.data(), row.data())));
      }
      out.worst = std::max(out.worst, work);
      out.right += work < 100 * testing::difference_tolerance;
    }
    out.holds = out.right == out.poses;
    out.words = out.holds ? "The forces do no work on a motion that keeps C."
                          : "The forces do work on motions that keep C (" + of_poses(out) +
                                " are right): they drive or brake what the joint leaves free.";
    return out;
  }

  // The largest jump of C while a body is turned once about itself, by halving the step in which C
  // changes most.
  double jump(PosePair at, Body PosePair::*body, const vec3& axis) const {
    const quat from = (at.*body).q;
    const auto C = [&](double angle) {
      (at.*body).q = rotation(real(angle) * axis) * from;
      return part_.C(at);
    };
    const auto change = [](const Numbers& a, const Numbers& b) {
      double out = 0;
      for (std::size_t i = 0; i < a.size(); ++i) out = std::max(out, std::abs(b[i] - a[i]));
      return out;
    };
    double low = 0, step = 0.1, first = 0;
    for (double angle = 0; angle < 6.3; angle += step) {
      const double now = change(C(angle), C(angle + step));
      if (now > first) first = now, low = angle;
    }
    double left = first;
    for (int n = 0; n < 15; ++n) {
      step /= 2;
      const double below = change(C(low), C(low + step));
      const double above = change(C(low + step), C(low + 2 * step));
      if (above > below) low += step;
      left = std::max(above, below);
    }
    return left > 0.1 * first ? left : 0;
  }
  Finding turns() const {
    Finding out{"turns", true, 0, int(closed_.size()), 0, ""};
    PoseRandom random(settings_.seed);
    for (const PosePair& at : closed_) {
      double largest = 0;
      for (Body PosePair::*body : {&PosePair::body1, &PosePair::body2})
        largest = std::max(largest, jump(at, body, normalize(random.vector(1))));
      out.right += largest == 0;
      out.worst = std::max(out.worst, largest);
    }
    out.note = out.right < out.poses;
    char size[40];
    std::snprintf(size, sizeof size, "%.3g", out.worst);
    out.words = out.note ? "C jumps by " + std::string(size) +
                               " while a body is turned once about itself. Beyond that place the "
                               "joint pulls the other way. A part that turns so far has to count "
                               "its turns (CountingJoint)."
                         : "C does not jump while a body is turned once about itself.";
    return out;
  }

  PartFunctions part_;
  CheckSettings settings_;
  std::vector<PosePair> broken_, closed_;
  Finding numbers_;
};

}  // namespace

PosePair any_pose(PoseRandom& random) {
  PosePair pair = testing::uneven_pair();
  for (Body* body : {&pair.body1, &pair.body2}) {
    body->x = random.vector(1);
    body->q = random.turn();
  }
  return pair;
}

PartReport check_functions(const PartFunctions& part, const PoseMaker& pose,
                           const CheckSettings& settings) {
  return Check(part, pose, settings).report();
}

bool PartReport::good() const {
  return std::all_of(findings.begin(), findings.end(), [](const Finding& f) { return f.holds; });
}

const Finding& PartReport::operator[](const std::string& question) const {
  for (const Finding& finding : findings)
    if (finding.question == question) return finding;
  throw std::invalid_argument("question: the report has no finding '" + question + "'");
}

std::string PartReport::text() const {
  std::string out;
  for (const Finding& finding : findings) {
    const bool lines = finding.words.find('\n') != finding.words.npos;
    const std::string head = (finding.note ? "note   " : finding.holds ? "right  " : "WRONG  ") +
                             finding.question;
    out += testing::folded(lines ? head : head + ": " + finding.words);
    for (std::size_t from = 0; lines && from < finding.words.size();) {
      const std::size_t end = std::min(finding.words.find('\n', from), finding.words.size());
      out += testing::folded(finding.words.substr(from, end - from));
      from = end + 1;
    }
  }
  return out;
}

}  // namespace joints
