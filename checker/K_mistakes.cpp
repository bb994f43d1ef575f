#include "checker/mistakes.h"

#include <algorithm>

namespace joints::testing {

namespace {

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
    const char* const masses = "#masses-added masses where inverse masses belong: K is in 1/kg";
    add(masses, {1 / m1, none}, {1 / m2, none});
    add(masses, {1 / m1, I1}, {1 / m2, I2});
    add(masses, {1 / m1, glm::inverse(I1)}, {1 / m2, glm::inverse(I2)});
    add("#one-over-whole-mass one over the sum of the masses: each mass is inverted first, then "
        "they are added",
        {both / 2, I1}, {both / 2, I2});
    add("#inertia-inverse inertia where inverse inertia belongs",
        {m1, glm::inverse(I1)}, {m2, glm::inverse(I2)});
  }
  add("#without-rotation the term of the rotation is missing", {m1, none}, {m2, none});
  add("#body-2-alone body 1 is missing", {0, none}, two);
  add("body 2 is missing", one, {0, none});
  add("#rotation-body-1-left the rotation of body 1 is missing", {m1, none}, two);
  add("#rotation-body-2-left the rotation of body 2 is missing", one, {m2, none});
  add("#mass-body-1-left the inverse mass of body 1 is missing", {0, I1}, two);
  add("the inverse mass of body 2 is missing", one, {0, I2});
  add("#without-masses the inverse masses are missing", {0, I1}, {0, I2});
  add("#without-inertia the inverse inertia is missing", {m1, mat3(1)}, {m2, mat3(1)});
  const char* const local[] = {
      "body-space inertia of body 1: it must be turned into the world, R I^-1 R^T",
      "body-space inertia of body 2: it must be turned into the world, R I^-1 R^T",
      "#body-space-inertia-both body-space inertia of both bodies: it must be turned into the "
      "world, R I^-1 R^T"};
  add(local[0], {m1, local1}, two);
  add(local[1], one, {m2, local2});
  add(local[2], {m1, local1}, {m2, local2});
  add("#inertia-turned-wrong-way the inertia is turned the wrong way round: R I^-1 R^T, not R^T "
      "I^-1 R",
      {m1, inertia_turned(a, conjugate(a.q))}, {m2, inertia_turned(b, conjugate(b.q))});
  add("the inertia of body 1 is turned with body 2", {m1, inertia_turned(a, b.q)}, two);
  add("the inertia of body 2 is turned with body 1", one, {m2, inertia_turned(b, a.q)});
  add("#without-transpose the sign of the rotation's term: it is added (skew(r) I^-1 skew(r) lacks "
      "a transpose)",
      {m1, -I1}, {m2, -I2});
  add("the sign of body 1's terms: the terms of both bodies are added",
      {-m1, -I1}, two);
  add("#inverse-masses-subtracted the sign of body 2's terms: the terms of both bodies are added",
      one, {-m2, -I2});
  add("the sign of the rotation of body 1: its term is added", {m1, -I1}, two);
  add("#sign-rotation the sign of the rotation of body 2: its term is added", one, {m2, -I2});
  add("the sign of body 1's inverse mass: all terms are added", {-m1, I1}, two);
  add("the sign of body 2's inverse mass: all terms are added", one, {-m2, I2});
  add("#inertias-exchanged the lever of one body with the inertia of the other",
      {m1, I2}, {m2, I1});
  add("the inertia of body 1 for both bodies: each has its own",
      one, {m2, I1});
  add("the inertia of body 2 for both bodies: each has its own", {m1, I2}, two);
  add("#body-1-twice the inverse mass of body 1 for both bodies: each has its own", one, {m1, I2});
  add("the inverse mass of body 2 for both bodies: each has its own",
      {m2, I1}, two);
  add("#rotation-body-1-twice the rotation of body 1 is counted twice, that of body 2 not",
      {m1, real(2) * I1},
      {m2, none});
  add("the rotation of body 2 is counted twice, that of body 1 not", {m1, none},
      {m2, real(2) * I2});
  const char* const one_moment = "#one-moment one moment stands for all three axes: that is right "
                                 "for a ball alone";
  for (int i = 0; i < 3; ++i) {
    add(one_moment, {m1, mat3(local1[i][i])}, {m2, mat3(local2[i][i])});
    add(one_moment, {m1, mat3(I1[i][i])}, {m2, mat3(I2[i][i])});
  }
  const auto diagonal = [](const mat3& I) {
    return mat3(I[0][0], 0, 0, 0, I[1][1], 0, 0, 0, I[2][2]);
  };
  add("only the diagonal of the world inertia is used: it has nine entries", {m1, diagonal(I1)},
      {m2, diagonal(I2)});
  add("the rotation's terms are halved: each stands once in K", {m1, I1 / real(2)},
      {m2, I2 / real(2)});
  add("the rotation's terms are doubled: each stands once in K", {m1, real(2) * I1},
      {m2, real(2) * I2});
  add("#mass-for-inertia inverse mass where inverse inertia belongs",
      {m1, mat3(m1)}, {m2, mat3(m2)});
  add("the inverse inertia stands twice in a term", {m1, I1 * I1}, {m2, I2 * I2});
  add("#inverse-masses-multiplied the inverse masses are multiplied: they are added",
      {m1 * m2, I1}, {0, I2});
  add("#squares-inverse-masses the inverse masses are squared: M^-1 stands once in K",
      {m1 * m1, I1}, {m2 * m2, I2});
  add("#the-larger-one the larger inverse mass alone: they are added",
      {std::max(m1, m2), I1}, {0, I2});
  const mat3 R1 = mat3_cast(a.q), R2 = mat3_cast(b.q);
  add("#world-inertia-half-turned the world inertia lacks R^T on its right: it is R I^-1 R^T",
      {m1, R1 * local1},
      {m2, R2 * local2});
  add("#world-inertia-half-turned-back the world inertia lacks R on its left: it is R I^-1 R^T",
      {m1, local1 * transpose(R1)},
      {m2, local2 * transpose(R2)});
  add("the world inertia is turned once more: inverse_inertia(body) is in world axes already",
      {m1, R1 * I1 * transpose(R1)}, {m2, R2 * I2 * transpose(R2)});
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
  out.push_back({"#inverse-of-k the inverse of K: that is the effective mass, the solver inverts "
                 "K itself",
                 {inverse.begin(), inverse.end()}});
  Numbers whole = everywhere;
  for (double& number : whole) number = std::trunc(number);
  out.push_back({"#cut-int the fraction is cut off: an int holds whole numbers only", whole});
  for (int i = 0; i < n * n; ++i)
    if (i % (n + 1) != 0) everywhere[std::size_t(i)] += double(masses);
  if (n > 1)
    out.push_back({"#number-plus-matrix a matrix plus a number adds it to all nine entries: write "
                   "mat3(a)",
                   everywhere});
  for (const auto& wrong : {own_Js(part, pair), wrong_levers(rows, pair)})
    for (const auto& [words, numbers] : wrong) out.push_back({words, whole_K(numbers, pair)});
  return out;
}

}  // namespace

Numbers whole_K(const Numbers& J, const Pair& pair) {
  return product(rows_of(J), inverse_of(pair.body1), inverse_of(pair.body2));
}

Sample K_sample(int pose, const Seen& part, const Pair& pair, const Numbers& right) {
  Sample sample{pose, part.K(pair), right, {}, part.broken};
  if (close(sample.yours, right, K_tolerance)) return sample;
  if (part.K_slips) add_slips(sample, part.K_slips(pair), K_tolerance);
  const Numbers J = part.slope(pair);
  add_named(sample, part.K_mistakes ? part.K_mistakes(pair) : Wrong{}, K_tolerance);
  sample.own = long(sample.mistakes.size());
  add_named(sample, wrong_Ks(part, J, pair), K_tolerance);
  const auto holds = [&](const Pair& at) {
    return close(part.K(at), whole_K(part.slope(at), at), K_tolerance);
  };
  if (pushes(rows_of(J)))
    for (const std::string& words :
         wrong_turns(pair, holds, "a lever is", [](int) { return false; }))
      sample.mistakes.push_back(words);
  return sample;
}

}  // namespace joints::testing
