// The usual mistakes in the J and the K of a part, worked out from the right one: levers, inertias.
#include <algorithm>

#include "tests/checker/report.h"

namespace joints::testing {

namespace {

using Rows = std::vector<Row>;

Rows rows_of(const Numbers& J) {
  Rows out(J.size() / 12);
  for (std::size_t i = 0; i < J.size(); ++i) {
    Row& row = out[i / 12];
    vec3* const blocks[] = {&row.v1, &row.w1, &row.v2, &row.w2};
    (*blocks[i % 12 / 3])[int(i % 3)] = real(J[i]);
  }
  return out;
}
Numbers flat(const Rows& rows) {
  Numbers out;
  for (const Row& row : rows)
    for (const Numbers& numbers = testing::flat(to_jacobian(row)); double number : numbers)
      out.push_back(number);
  return out;
}

bool pushes(const Rows& J) {
  return std::any_of(J.begin(), J.end(),
                     [](const Row& row) { return row.v1 != vec3(0) || row.v2 != vec3(0); });
}

// Mistakes with levers. Rows that only turn have none.
Wrong wrong_levers(const Rows& J, const Pair& pair) {
  if (!pushes(J)) return {};
  Wrong out;
  const auto add = [&](const char* words, auto change) {
    Rows wrong = J;
    for (Row& row : wrong) change(row);
    out.push_back({words, flat(wrong)});
  };
  add("the sign of the blocks w1 and w2: a x b is -(b x a)",
      [](Row& row) { row.w1 = -row.w1, row.w2 = -row.w2; });
  add("the blocks w1 and w2 are missing: they hold the levers",
      [](Row& row) { row.w1 = row.w2 = vec3(0); });
  add("the arms are missing: w1 and w2 hold r x n, not n",
      [](Row& row) { row.w1 = row.v1, row.w2 = row.v2; });
  add("a point where a lever belongs: r runs from the body's centre to the anchor "
      "(to_world, not world_point)",
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
  add("the levers r1 and r2 are exchanged", [](Row& row) {
    const vec3 w1 = row.w1;
    row.w1 = -row.w2;
    row.w2 = -w1;
  });
  add("the lever of body 1 for both bodies: each has its own",
      [](Row& row) { row.w2 = -row.w1; });
  add("the lever of body 2 for both bodies: each has its own",
      [](Row& row) { row.w1 = -row.w2; });
  return out;
}

// J where nothing stands for a body that is static, and J times M^-1.
Wrong wrong_bodies(Rows J, const Pair& pair) {
  Wrong out;
  Rows without = J;
  for (Row& row : without) {
    if (pair.body1.is_static()) row.v1 = row.w1 = vec3(0);
    if (pair.body2.is_static()) row.v2 = row.w2 = vec3(0);
  }
  if (pair.body1.is_static() != pair.body2.is_static())
    out.push_back({"a static body has its blocks in J, too: it is K that its mass leaves out",
                   flat(without)});
  for (Row& row : J)
    row = {pair.body1.inverse_mass * row.v1, inverse_inertia(pair.body1) * row.w1,
           pair.body2.inverse_mass * row.v2, inverse_inertia(pair.body2) * row.w2};
  out.push_back({"J times M^-1: masses and inertias come in with K", flat(J)});
  return out;
}

Wrong own_Js(const Seen& part, const Pair& pair) {
  return part.mistakes ? part.mistakes(pair) : Wrong{};
}

// ---- what is turned with which body -------------------------------------------------------------

// The pair with other orientations. An answer that is right there and wrong elsewhere has left a
// lever in body space (right where that body is not turned), has turned it the wrong way round
// (right where it is turned by half a turn, too), or with the other body (right where both are
// turned alike).
Pair turned(Pair pair, int which, const quat& q) {
  if (which != 2) pair.body1.q = q;
  if (which != 1) pair.body2.q = q;
  return pair;
}

using Holds = std::function<bool(const Pair&)>;

std::vector<std::string> wrong_turns(const Pair& pair, const Holds& holds,
                                     const std::string& which_lever) {
  const quat unturned(1, 0, 0, 0), half_turn(0, real(0.36), real(0.48), real(0.8)),
      alike = rotation(vec3(real(0.4), real(-0.9), real(0.6)));
  const char* const levers[] = {"the levers of both bodies are ", "the lever of body 1 is ",
                                "the lever of body 2 is "};
  if (holds(turned(pair, 0, alike)))
    return {which_lever + " turned with the other body: each body turns its own"};
  std::vector<std::string> out;
  for (const int which : {1, 2, 0})
    if (holds(turned(pair, which, unturned)))
      out.push_back(holds(turned(pair, which, half_turn))
                        ? std::string(levers[which]) +
                              "turned the wrong way round: to_world, not to_local"
                        : std::string("body-space arm: ") + levers[which] +
                              "not turned into the world");
  return out;
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

// What is right here, as some mistakes are at some poses, explains nothing.
void add_named(Sample& sample, const Wrong& wrong, double tolerance) {
  for (const auto& [words, numbers] : wrong)
    if (close(sample.yours, numbers, tolerance) && !close(sample.right, numbers, tolerance))
      sample.mistakes.push_back(words);
}

void add(Sample& sample, const std::vector<std::string>& words) {
  sample.mistakes.insert(sample.mistakes.end(), words.begin(), words.end());
}

// ---- K ------------------------------------------------------------------------------------------

// What stands in the place of a body's inverse mass and inverse inertia.
struct Mass {
  real linear;
  mat3 angular;
};

Numbers product(const Rows& J, const Mass& m1, const Mass& m2) {
  Numbers K;
  for (const Row& a : J)
    for (const Row& b : J)
      K.push_back(double(m1.linear * dot(a.v1, b.v1) + dot(a.w1, m1.angular * b.w1) +
                         m2.linear * dot(a.v2, b.v2) + dot(a.w2, m2.angular * b.w2)));
  return K;
}

Mass inverse_of(const Body& body) { return {body.inverse_mass, inverse_inertia(body)}; }

// The inverse inertia of a body that is turned by q.
mat3 inertia_turned(Body body, const quat& q) {
  body.q = q;
  return inverse_inertia(body);
}

Wrong wrong_masses(const Rows& J, const Pair& pair) {
  const Body &a = pair.body1, &b = pair.body2;
  const Mass one = inverse_of(a), two = inverse_of(b);
  const auto [m1, I1] = one;
  const auto [m2, I2] = two;
  const mat3 none(0);
  const quat unturned(1, 0, 0, 0);
  const mat3 local1 = inertia_turned(a, unturned), local2 = inertia_turned(b, unturned);
  Wrong out;
  const auto add = [&](const char* words, const Mass& first, const Mass& second) {
    out.push_back({words, product(J, first, second)});
  };
  if (m1 != 0 && m2 != 0) {
    const real both = 1 / (1 / m1 + 1 / m2);
    const char* const masses = "masses where inverse masses belong: K is in 1/kg";
    add(masses, {1 / m1, none}, {1 / m2, none});
    add(masses, {1 / m1, I1}, {1 / m2, I2});
    add(masses, {1 / m1, glm::inverse(I1)}, {1 / m2, glm::inverse(I2)});
    add("one over the sum of the masses: each mass is inverted first, then they are added",
        {both / 2, I1}, {both / 2, I2});
    add("inertia where inverse inertia belongs", {m1, glm::inverse(I1)}, {m2, glm::inverse(I2)});
  }
  add("the share of the rotation is missing", {m1, none}, {m2, none});
  add("body 1 is missing", {0, none}, two);
  add("body 2 is missing", one, {0, none});
  add("the rotation of body 1 is missing", {m1, none}, two);
  add("the rotation of body 2 is missing", one, {m2, none});
  add("the inverse mass of body 1 is missing", {0, I1}, two);
  add("the inverse mass of body 2 is missing", one, {0, I2});
  add("the inverse masses are missing", {0, I1}, {0, I2});
  add("the inverse inertia is missing", {m1, mat3(1)}, {m2, mat3(1)});
  const char* const local[] = {
      "body-space inertia of body 1: it must be turned into the world, R I^-1 R^T",
      "body-space inertia of body 2: it must be turned into the world, R I^-1 R^T",
      "body-space inertia of both bodies: it must be turned into the world, R I^-1 R^T"};
  add(local[0], {m1, local1}, two);
  add(local[1], one, {m2, local2});
  add(local[2], {m1, local1}, {m2, local2});
  add("the inertia is turned the wrong way round: R I^-1 R^T, not R^T I^-1 R",
      {m1, inertia_turned(a, conjugate(a.q))}, {m2, inertia_turned(b, conjugate(b.q))});
  add("the inertia of body 1 is turned with body 2", {m1, inertia_turned(a, b.q)}, two);
  add("the inertia of body 2 is turned with body 1", one, {m2, inertia_turned(b, a.q)});
  add("the sign of the rotation's share: it is added (skew(r) I^-1 skew(r) lacks a transpose)",
      {m1, -I1}, {m2, -I2});
  add("the sign of body 1's share: the shares of both bodies are added", {-m1, -I1}, two);
  add("the sign of body 2's share: the shares of both bodies are added", one, {-m2, -I2});
  add("the sign of the rotation of body 1: its share is added", {m1, -I1}, two);
  add("the sign of the rotation of body 2: its share is added", one, {m2, -I2});
  add("the sign of body 1's inverse mass: all shares are added", {-m1, I1}, two);
  add("the sign of body 2's inverse mass: all shares are added", one, {-m2, I2});
  add("the lever of one body with the inertia of the other", {m1, I2}, {m2, I1});
  add("the inertia of body 1 for both bodies: each has its own", one, {m2, I1});
  add("the inertia of body 2 for both bodies: each has its own", {m1, I2}, two);
  add("the inverse mass of body 1 for both bodies: each has its own", one, {m1, I2});
  add("the inverse mass of body 2 for both bodies: each has its own", {m2, I1}, two);
  add("the rotation of body 1 is counted twice, that of body 2 not", {m1, real(2) * I1},
      {m2, none});
  add("the rotation of body 2 is counted twice, that of body 1 not", {m1, none},
      {m2, real(2) * I2});
  add("inverse mass where inverse inertia belongs", {m1, mat3(m1)}, {m2, mat3(m2)});
  add("the inverse inertia stands twice in a term", {m1, I1 * I1}, {m2, I2 * I2});
  add("the inverse masses are multiplied: they are added", {m1 * m2, I1}, {0, I2});
  add("the inverse masses are squared: M^-1 stands once in K", {m1 * m1, I1}, {m2 * m2, I2});
  add("the larger inverse mass alone: they are added", {std::max(m1, m2), I1}, {0, I2});
  const mat3 R1 = mat3_cast(a.q), R2 = mat3_cast(b.q);
  add("the world inertia lacks R^T on its right: it is R I^-1 R^T", {m1, R1 * local1},
      {m2, R2 * local2});
  add("the world inertia lacks R on its left: it is R I^-1 R^T", {m1, local1 * transpose(R1)},
      {m2, local2 * transpose(R2)});
  add("body 1 twice: each body has its own mass and inertia", one, one);
  add("body 2 twice: each body has its own mass and inertia", two, two);
  return out;
}

Wrong wrong_Ks(const Seen& part, const Numbers& J, const Pair& pair) {
  const Rows rows = rows_of(J);
  Wrong out = wrong_masses(rows, pair);
  const real masses = pair.body1.inverse_mass + pair.body2.inverse_mass;
  const int n = int(rows.size());
  Numbers everywhere = whole_K(J, pair);
  std::vector<real> inverse(everywhere.begin(), everywhere.end());
  invert_symmetric(inverse.data(), n);
  out.push_back({"the inverse of K: that is the effective mass, the solver inverts K itself",
                 {inverse.begin(), inverse.end()}});
  Numbers with_unit = everywhere, whole = everywhere;
  for (double& number : whole) number = std::trunc(number);
  out.push_back({"the fraction is cut off: an int holds whole numbers only", whole});
  for (int i = 0; i < n * n; ++i)
    (i % (n + 1) == 0 ? with_unit : everywhere)[std::size_t(i)] +=
        i % (n + 1) == 0 ? 1 : double(masses);
  if (n > 1)
    out.push_back({"a matrix plus a number adds it to all nine entries: write mat3(a)",
                   everywhere});
  if (n == 3)
    out.push_back({"the unit matrix too much: mat3 K; is not zero, write mat3 K(0)", with_unit});
  for (const auto& wrong : {own_Js(part, pair), wrong_levers(rows, pair)})
    for (const auto& [words, numbers] : wrong) out.push_back({words, whole_K(numbers, pair)});
  return out;
}

}  // namespace

Numbers whole_K(const Numbers& J, const Pair& pair) {
  return product(rows_of(J), inverse_of(pair.body1), inverse_of(pair.body2));
}

Sample jacobian_sample(int pose, const Seen& part, const Pair& pair, const Numbers& right) {
  Sample sample{pose, part.J(pair), right, {}, part.broken};
  if (close(sample.yours, right, difference_tolerance)) return sample;
  add_named(sample, own_Js(part, pair), difference_tolerance);
  sample.own = long(sample.mistakes.size());
  add_named(sample, wrong_levers(rows_of(right), pair), difference_tolerance);
  add_named(sample, wrong_bodies(rows_of(right), pair), difference_tolerance);
  const std::string lever = lever_that_differs(sample);
  const auto holds = [&](const Pair& at) {
    return close(part.J(at), part.slope(at), difference_tolerance);
  };
  if (pushes(rows_of(right))) add(sample, wrong_turns(pair, holds, lever));
  return sample;
}

Sample K_sample(int pose, const Seen& part, const Pair& pair, const Numbers& right) {
  Sample sample{pose, part.K(pair), right, {}, part.broken};
  if (close(sample.yours, right, K_tolerance)) return sample;
  const Numbers J = part.slope(pair);
  add_named(sample, part.K_mistakes ? part.K_mistakes(pair) : Wrong{}, K_tolerance);
  sample.own = long(sample.mistakes.size());
  add_named(sample, wrong_Ks(part, J, pair), K_tolerance);
  const auto holds = [&](const Pair& at) {
    return close(part.K(at), whole_K(part.slope(at), at), K_tolerance);
  };
  if (pushes(rows_of(J))) add(sample, wrong_turns(pair, holds, "a lever is"));
  return sample;
}

}  // namespace joints::testing
