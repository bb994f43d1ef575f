#include "checker/mistakes.h"

#include <algorithm>

#include "checker/report.h"

namespace joints::testing {

Rows rows_of(const Numbers& J) {
  Rows out(J.size() / 12);
  for (std::size_t i = 0; i < J.size(); ++i) {
    Row& row = out[i / 12];
    vec3* const blocks[] = {&row.v1, &row.w1, &row.v2, &row.w2};
    (*blocks[i % 12 / 3])[int(i % 3)] = real(J[i]);
  }
  return out;
}
bool pushes(const Rows& J) {
  return std::any_of(J.begin(), J.end(),
                     [](const Row& row) { return row.v1 != vec3(0) || row.v2 != vec3(0); });
}

namespace {

Numbers flat(const Rows& rows) {
  Numbers out;
  for (const Row& row : rows)
    for (const Numbers& numbers = testing::flat(to_jacobian(row)); double number : numbers)
      out.push_back(number);
  return out;
}

}  // namespace

Wrong wrong_levers(const Rows& J, const Pair& pair) {
  if (!pushes(J)) return {};
  Wrong out;
  const auto add = [&](const char* words, auto change) {
    Rows wrong = J;
    for (Row& row : wrong) change(row);
    out.push_back({words, flat(wrong)});
  };
  add("#order-cross-products the sign of the blocks w1 and w2: a x b is -(b x a)",
      [](Row& row) { row.w1 = -row.w1, row.w2 = -row.w2; });
  add("#without-levers the blocks w1 and w2 are missing: they hold the levers",
      [](Row& row) { row.w1 = row.w2 = vec3(0); });
  add("#no-arms-n-turns the levers are missing: w1 and w2 hold r x n, not n",
      [](Row& row) { row.w1 = row.v1, row.w2 = row.v2; });
  add("#points-for-levers a point where a lever belongs: r runs from the body's centre to the "
      "anchor (to_world, not world_point)",
      [&](Row& row) {
        row.w1 += cross(pair.body1.x, row.v1);
        row.w2 += cross(pair.body2.x, row.v2);
      });
  add("a point where the lever of body 1 belongs: r1 runs from the body's centre to the anchor "
      "(to_world, not world_point)",
      [&](Row& row) { row.w1 += cross(pair.body1.x, row.v1); });
  add("a point where the lever of body 2 belongs: r2 runs from the body's centre to the anchor "
      "(to_world, not world_point)",
      [&](Row& row) { row.w2 += cross(pair.body2.x, row.v2); });
  add("#levers-exchanged the levers r1 and r2 are exchanged", [](Row& row) {
    const vec3 w1 = row.w1;
    row.w1 = -row.w2;
    row.w2 = -w1;
  });
  add("#r1-for-both the lever of body 1 for both bodies: each has its own",
      [](Row& row) { row.w2 = -row.w1; });
  add("the lever of body 2 for both bodies: each has its own",
      [](Row& row) { row.w1 = -row.w2; });
  return out;
}

namespace {

// J where nothing stands for a body that is static, and J times M^-1.
Wrong wrong_bodies(Rows J, const Pair& pair) {
  Wrong out;
  Rows without = J;
  for (Row& row : without) {
    if (pair.body1.is_static()) row.v1 = row.w1 = vec3(0);
    if (pair.body2.is_static()) row.v2 = row.w2 = vec3(0);
  }
  if (pair.body1.is_static() != pair.body2.is_static())
    out.push_back({"#static-body-left-out a static body has its blocks in J, too: its mass enters "
                   "only through K",
                   flat(without)});
  for (Row& row : J)
    row = {pair.body1.inverse_mass * row.v1, inverse_inertia(pair.body1) * row.w1,
           pair.body2.inverse_mass * row.v2, inverse_inertia(pair.body2) * row.w2};
  out.push_back({"#inverse-masses-row J times M^-1: masses and inertias belong to K", flat(J)});
  return out;
}

// ---- what is turned with which body -------------------------------------------------------------

// The pair with other orientations. An answer that is right there and wrong elsewhere has left
// something in body space or turned it twice (right where that body is not turned), has turned it
// the wrong way round (right where it is turned by half a turn, too), or with the other body (right
// where both are turned alike).
Pair turned(Pair pair, int which, const quat& q) {
  if (which != 2) pair.body1.q = q;
  if (which != 1) pair.body2.q = q;
  return pair;
}

// Which of the levers differs; where the direction comes from both, it cannot be told.
std::string lever_that_differs(const Sample& s) {
  bool differs[4] = {};
  for (std::size_t i = 0; i < s.right.size(); ++i)
    if (!near(s.yours[i], s.right[i], difference_tolerance)) differs[i % 12 / 3] = true;
  if (differs[0] || differs[2]) return "a lever is";
  return differs[1] && differs[3] ? "each lever is"
                                  : std::string("the lever of body ") + (differs[1] ? "1" : "2") +
                                        " is";
}

// What one body has in J: w = r x v in each row, with the lever r to where it is pushed.
struct Share {
  std::vector<vec3> v, w;
  Share(const Numbers& J, bool second) {
    for (const Row& row : rows_of(J)) {
      v.push_back(second ? row.v2 : row.v1);
      w.push_back(second ? row.w2 : row.w1);
    }
  }
};
// Are the blocks w of a body those of its right lever, left in the axes of the body? All else of
// its rows must be right. With one direction v the part of r along it is seen in nothing but this.
bool lever_is_left(const Sample& s, const Body& body, bool second) {
  const Share yours(s.yours, second), right(s.right, second);
  mat3 A(0);
  vec3 b(0);
  for (std::size_t i = 0; i < right.v.size(); ++i) {
    const mat3 across = skew(right.v[i]);
    A -= across * across;
    b += cross(right.v[i], right.w[i]);
  }
  const vec3 along = normalize(right.v[0]);
  const bool one_direction = std::abs(dot(along, A * along)) < real(1e-6);
  if (one_direction) A += mat3(along.x * along, along.y * along, along.z * along);
  if (!(std::abs(determinant(A)) > real(1e-9))) return false;
  const vec3 lever = to_local(body, inverse(A) * b), more = to_local(body, along);
  real above = 0, below = 0;
  for (std::size_t i = 0; one_direction && i < right.v.size(); ++i) {
    const vec3 by = cross(more, right.v[i]);
    above += dot(yours.w[i] - cross(lever, right.v[i]), by);
    below += dot(by, by);
  }
  const vec3 left = lever + (below > 0 ? above / below : 0) * more;
  for (std::size_t i = 0; i < right.v.size(); ++i)
    if (length(yours.v[i] - right.v[i]) > difference_tolerance ||
        length(yours.w[i] - cross(left, right.v[i])) > 10 * difference_tolerance)
      return false;
  return true;
}

// The same where some rows of J are right and the others have the mistake.
void add_named_in_rows(Sample& sample, const Wrong& wrong) {
  for (const auto& [words, numbers] : wrong) {
    bool fits = true, some_right = false;
    for (std::size_t row = 0; row < sample.right.size(); row += 12) {
      const auto same = [&](const Numbers& a) {
        bool out = true;
        for (std::size_t k = row; k < row + 12; ++k)
          out = out && near(sample.yours[k], a[k], difference_tolerance);
        return out;
      };
      const bool right = same(sample.right);
      some_right = some_right || right;
      fits = fits && (right || same(numbers));
    }
    if (fits && some_right) sample.mistakes.push_back("in one row alone: " + words);
  }
}

void add(Sample& sample, const std::vector<std::string>& words) {
  sample.mistakes.insert(sample.mistakes.end(), words.begin(), words.end());
}

}  // namespace

Wrong own_Js(const Seen& part, const Pair& pair) {
  return part.mistakes ? part.mistakes(pair) : Wrong{};
}

std::vector<std::string> wrong_turns(const Pair& pair,
                                     const std::function<bool(const Pair&)>& holds,
                                     const std::string& lever,
                                     const std::function<bool(int)>& lever_left) {
  const quat unturned(1, 0, 0, 0), half_turn(0, real(0.36), real(0.48), real(0.8)),
      alike = rotation(vec3(real(0.4), real(-0.9), real(0.6)));
  if (holds(turned(pair, 0, alike)))
    return {lever + " turned with the other body: each body turns its own"};
  const char* const of[] = {"both bodies", "body 1", "body 2"};
  std::vector<std::string> out;
  for (const int which : {1, 2, 0}) {
    if (!holds(turned(pair, which, unturned))) continue;
    const bool more = which != 0 && lever == "each lever is";  // both blocks, by one body's turn
    const std::string what = (more         ? "a direction of "
                              : which == 0 ? "the levers of "
                                           : "the lever of ") + std::string(of[which]) +
                             (which == 0 ? " are " : " is ");
    if (holds(turned(pair, which, half_turn)))
      out.push_back(what + "turned the wrong way round: to_world, not to_local");
    else if (lever_left(which))
      out.push_back("body-space lever: " + what + "not turned into the world");
    else
      out.push_back(std::string("right only where ") + of[which] +
                    (which == 0 ? " are" : " is") + " not turned: something of it is left in the "
                    "body's axes, or is turned twice");
  }
  return out;
}

namespace {

void add_to(std::vector<std::string>& named, const Sample& sample, const Wrong& wrong,
            double tolerance) {
  for (const auto& [words, numbers] : wrong)
    if (close(sample.yours, numbers, tolerance) && !close(sample.right, numbers, tolerance))
      named.push_back(words);
}

}  // namespace

void add_named(Sample& sample, const Wrong& wrong, double tolerance) {
  add_to(sample.mistakes, sample, wrong, tolerance);
}
void add_slips(Sample& sample, const Wrong& wrong, double tolerance) {
  add_to(sample.slips, sample, wrong, tolerance);
}
Sample jacobian_sample(int pose, const Seen& part, const Pair& pair, const Numbers& right) {
  Sample sample{pose, part.J(pair), right, {}, part.broken};
  if (close(sample.yours, right, difference_tolerance)) return sample;
  if (part.slips) add_slips(sample, part.slips(pair), difference_tolerance);
  const Wrong own = own_Js(part, pair), levers = wrong_levers(rows_of(right), pair);
  add_named(sample, own, difference_tolerance);
  sample.own = long(sample.mistakes.size());
  add_named(sample, levers, difference_tolerance);
  for (const Wrong& usual : {own, levers})
    if (sample.mistakes.empty()) add_named_in_rows(sample, usual);
  add_named(sample, wrong_bodies(rows_of(right), pair), difference_tolerance);
  const auto holds = [&](const Pair& at) {
    return close(part.J(at), part.slope(at), difference_tolerance);
  };
  const auto left = [&](int which) {
    return (which == 2 || lever_is_left(sample, pair.body1, false)) &&
           (which == 1 || lever_is_left(sample, pair.body2, true));
  };
  if (pushes(rows_of(right)))
    add(sample, wrong_turns(pair, holds, lever_that_differs(sample), left));
  return sample;
}

}  // namespace joints::testing
