// Exercises 8.3 and 8.4 as tables of cases: which corners get rows, an iteration, a rebound.
#pragma once

#include "chapters/08_ground/ground.h"
#include "tests/checker/pose_cases.h"
#include "tests/checker/unit_rates.h"

namespace joints::testing {

// ---- which corners get rows ---------------------------------------------------------------------

struct LiveCase {
  std::string words;
  std::vector<real> C, rate;
  real h;
};
/// How often each corner is in the list, and how many others are.
inline Numbers counted(const std::vector<int>& live, std::size_t corners) {
  Numbers out(9, 0);
  for (const int k : live) ++out[k >= 0 && std::size_t(k) < corners ? std::size_t(k) : 8];
  return out;
}
/// A corner is in it if it will be low and fewer than four will be lower.
inline Numbers live_right(const LiveCase& c) {
  Numbers out(9, 0);
  const auto later = [&](std::size_t k) { return c.C[k] + c.h * c.rate[k]; };
  for (std::size_t k = 0; k < c.C.size(); ++k) {
    int lower = 0;
    for (std::size_t j = 0; j < c.C.size(); ++j) lower += later(j) < later(k);
    out[k] = later(k) < real(0.1) * c.h && lower < 4;
  }
  return out;
}
inline CaseTable<LiveCase> live_table() {
  CaseTable<LiveCase> table{
      {"8.3", "the corners that get rows (1 yes, 0 no)"},
      {"corner 0", "corner 1", "corner 2", "corner 3", "corner 4", "corner 5", "corner 6",
       "corner 7", "no corner"}, {}, {}, {}, {}};
  judge(table, live_corners, [](auto live, const LiveCase& c) {
    return counted(live(c.C, c.rate, c.h, real(0.1)), c.C.size());
  });
  table.right = live_right;
  Random random(83);
  for (const double h : {0.05, 0.016, 0.004})
    for (const int corners : {8, 8, 8, 8, 1, 3, 6})
      for (const double depth : {-0.5, 0.0, 0.5}) {
        LiveCase c{std::to_string(corners) + " corners, h " + short_number(h), {}, {}, real(h)};
        for (int k = 0; k < corners; ++k) {
          c.rate.push_back(random.uniform(-3, 3));
          c.C.push_back(random.uniform(-1, 1) * real(2 * h) + real(depth * h));
        }
        table.cases.push_back(c);
      }
  table.cases.push_back({"all far above", {1, 2, 3, 1, 2, 3, 1, 2}, std::vector<real>(8, 0),
                         real(0.01)});
  table.whole = true;
  return table;
}

// ---- an iteration -------------------------------------------------------------------------------

struct ContactCase {
  std::string words;
  std::vector<ContactRows> corners;
  double mu;
  Pair pair;
};
inline ContactRows contact_rows(const vec3& n, const vec3& t1, const vec3& r1, const vec3& r2,
                                const Pair& pair) {
  ContactRows out;
  const vec3 directions[] = {t1, cross(n, t1), n};
  for (const std::size_t i : {0, 1, 2}) {
    out.J[i] = row_by_rates(directions[i], r1, r2);
    out.K[i] = coupling(out.J[i], out.J[i], pair.body1, pair.body2);
  }
  return out;
}
inline const std::vector<std::string>& contact_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out = with_xyz({"v1", "w1", "v2", "w2"});
    for (const char* k : {"corner 0", "corner 1", "corner 2"})
      for (const char* row : {" t1", " t2", " n"}) out.push_back(std::string("sum of ") + k + row);
    return out;
  }();
  return names;
}
inline Numbers numbers_of(const std::vector<ContactRows>& corners, const Pair& pair) {
  Numbers out;
  for (const Body* body : {&pair.body1, &pair.body2}) append(out, body->v), append(out, body->w);
  for (const ContactRows& corner : corners)
    for (const real sum : corner.sum) out.push_back(double(sum));
  out.resize(contact_names().size(), 0);
  return out;
}
/// V += M^-1 J^T times an impulse, number by number.
inline void push(const Row& J, double impulse, Pair& pair) {
  Row response;
  form_responses(&J, 1, pair.body1, pair.body2, &response);
  const real size = real(impulse);
  pair.body1.v += size * response.v1, pair.body1.w += size * response.w1;
  pair.body2.v += size * response.v2, pair.body2.w += size * response.w2;
}
/// Puts a sum in place of the old one.
inline void set_sum(ContactRows& corner, std::size_t i, double sum, Pair& pair) {
  push(corner.J[i], sum - double(corner.sum[i]), pair);
  corner.sum[i] = real(sum);
}
inline double wanted_sum(const ContactRows& corner, std::size_t i, double target,
                         const Pair& pair) {
  const double now = double(row_velocity(corner.J[i], pair.body1, pair.body2));
  return double(corner.sum[i]) + (target - now) / double(corner.K[i]);
}
inline Numbers contact_right(ContactCase c) {
  for (ContactRows& corner : c.corners) {
    for (const std::size_t i : {0, 1}) {
      const double most = c.mu * double(corner.sum[2]);
      const double wanted = wanted_sum(corner, i, 0, c.pair);
      set_sum(corner, i, wanted > most ? most : wanted < -most ? -most : wanted, c.pair);
    }
    const double normal = wanted_sum(corner, 2, -double(corner.bias), c.pair);
    set_sum(corner, 2, normal < 0 ? 0 : normal, c.pair);
  }
  return numbers_of(c.corners, c.pair);
}

/// One to three corners of a box that slides, with the sums of an iteration before.
inline ContactCase contact_case(const std::string& words, int corners, unsigned seed) {
  Random random(seed);
  ContactCase c{words, {}, double(random.uniform(real(0.2), real(0.9))), uneven_pair()};
  move_together(c.pair, random);
  for (Body* body : {&c.pair.body1, &c.pair.body2})
    body->v = random.vector(2), body->w = random.vector(2);
  if (words == "beside a ground that does not move")
    c.pair.body1 = static_body(c.pair.body1.x, c.pair.body1.q);
  const vec3 n = normalize(random.vector(1) + vec3(0, 2, 0));
  const vec3 t1 = normalize(cross(n, random.vector(1)));
  for (int k = 0; k < corners; ++k) {
    const vec3 r1 = random.vector(1), r2 = random.vector(1);
    c.corners.push_back(contact_rows(n, t1, r1, r2, c.pair));
    ContactRows& corner = c.corners.back();
    corner.bias = random.uniform(-1, 1);
    if (words == "cold") continue;
    corner.sum[2] = random.uniform(0, 2);
    for (const std::size_t i : {0, 1})
      corner.sum[i] = random.uniform(-1, 1) * real(c.mu) * corner.sum[2];
  }
  return c;
}
/// The corner of the text, cold.
inline ContactCase paper_contact(const Corner& corner, Pair pair) {
  pair.body2.v = vec3(3, real(-2.49), 0);
  const vec3 p = corner.point(pair.body1, pair.body2);
  ContactCase c{"pencil and paper", {contact_rows(vec3(0, 1, 0), vec3(1, 0, 0), p - pair.body1.x,
                                                  p - pair.body2.x, pair)}, 0.5, pair};
  c.corners[0].bias = 2;
  return c;
}

inline CaseTable<ContactCase> contact_table() {
  CaseTable<ContactCase> table{{"8.3", "an iteration over the corners", 2}, contact_names(),
                               {}, {}, {}, {}};
  judge(table, solve_contact, [](auto solve, const ContactCase& c) {
    ContactCase mine = c;
    solve(mine.corners, real(c.mu), mine.pair.body1, mine.pair.body2);
    return numbers_of(mine.corners, mine.pair);
  });
  table.right = contact_right;
  for (const char* words : {"one corner", "three corners", "beside a ground that does not move",
                            "cold", "two corners"})
    for (unsigned draw = 0; draw < 6; ++draw)
      table.cases.push_back(contact_case(words, words[0] == 'o' ? 1 : words[1] == 'w' ? 2 : 3,
                                         830 + 10 * unsigned(words[1]) + draw));
  table.tolerance = 1000 * rounding;
  return table;
}

// ---- the rebound --------------------------------------------------------------------------------

struct SpeedCase {
  std::string words;
  double C, rate, kick, h;
};
inline CaseTable<SpeedCase> speed_table() {
  CaseTable<SpeedCase> table{{"8.4", "the speed of an impact"}, {"v_hit"}, {}, {}, {}, {}};
  judge(table, impact_speed, [](auto speed, const SpeedCase& c) {
    return Numbers{double(speed(real(c.C), real(c.rate), real(c.kick), real(c.h)))};
  });
  // The energy of a fall: half a square, and the acceleration times the height.
  table.right = [](const SpeedCase& c) {
    const double begin = c.rate - c.kick / 2, energy = begin * begin / 2 - c.kick * c.C / c.h;
    return Numbers{energy > 0 ? std::sqrt(2 * energy) : 0};
  };
  Random random(84);
  for (const double h : {0.1, 0.05, 0.016})
    for (int draw = 0; draw < 5; ++draw)
      table.cases.push_back({"h " + short_number(h), double(random.uniform(0, real(0.2))),
                             -double(random.uniform(2, 8)), -double(random.uniform(0, 2)), h});
  table.cases.push_back({"no fall: a lift", 0.01, -5, 1.5, 0.05});
  table.cases.push_back({"in the ground, hardly moving", -0.1, -0.2, -0.16, 0.016});
  table.cases.push_back({"no kick", 0.05, -3, 0, 0.05});
  table.tolerance = 1000 * rounding;
  return table;
}

struct ReboundCase {
  std::string words;
  ContactCase contact;
  std::vector<Bounce> bounces;
  int iterations;
};
inline Numbers rebound_right(const ReboundCase& c) {
  std::vector<ContactRows> corners = c.contact.corners;
  Pair pair = c.contact.pair;
  for (int i = 0; i < c.iterations; ++i)
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Bounce& bounce = c.bounces[k];
      const double most = double(c.contact.corners[k].sum[2]) * (1 + double(bounce.ratio));
      double sum = wanted_sum(corners[k], 2, double(bounce.speed), pair);
      if (bounce.speed > 0 && sum > most) sum = most;
      set_sum(corners[k], 2, sum < 0 ? 0 : sum, pair);
    }
  return numbers_of(corners, pair);
}
inline CaseTable<ReboundCase> rebound_table() {
  CaseTable<ReboundCase> table{{"8.4", "the solve of a rebound", 2}, contact_names(),
                               {}, {}, {}, {}};
  judge(table, rebound, [](auto rebound, const ReboundCase& c) {
    ContactCase mine = c.contact;
    rebound(mine.corners, c.bounces, c.iterations, mine.pair.body1, mine.pair.body2);
    return numbers_of(mine.corners, mine.pair);
  });
  table.right = rebound_right;
  Random random(85);
  for (const int iterations : {1, 2, 3})
    for (const int corners : {1, 2, 3, 3})
      for (int draw = 0; draw < 3; ++draw) {
        ReboundCase c{std::to_string(iterations) + " iterations, corners: " +
                          std::to_string(corners),
                      contact_case("moving", corners, unsigned(8400 + table.cases.size())), {},
                      iterations};
        for (int k = 0; k < corners; ++k)
          c.bounces.push_back(k == 1 ? Bounce{}
                                     : Bounce{random.uniform(1, 4), random.uniform(0, 1)});
        table.cases.push_back(c);
      }
  table.tolerance = 1000 * rounding;
  return table;
}
/// A ball of 2 kg that has been stopped by 12.9 N s.
inline ReboundCase paper_rebound(double ratio) {
  const Pair pair{static_body(vec3(0)), body_with(2, vec3(1), vec3(0, 1, 0))};
  ReboundCase c{"pencil and paper", {"", {contact_rows(vec3(0, 1, 0), vec3(1, 0, 0), vec3(0),
                                                       vec3(0, -1, 0), pair)}, 0, pair},
                {{real(3.4), real(ratio)}}, 1};
  c.contact.corners[0].sum[2] = real(12.9);
  return c;
}

}  // namespace joints::testing
