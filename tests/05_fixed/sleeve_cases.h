// Exercise 5.3: a joint put together from parts, and its load, as tables of cases.
#pragma once

#include "tests/checker/joint_fixtures.h"
#include "tests/checker/pose_cases.h"

namespace joints::testing {

// ---- the block ----------------------------------------------------------------------------------

struct SleeveCase {
  std::string words;
  Kit kit;
  Pair pair;
};

/// All parts of this pose with this anchor and axis.
inline Kit kit_of(const Pair& pair, const vec3& anchor, const vec3& along) {
  return {point_at(pair.body1, pair.body2, anchor), line_along(pair, anchor, along),
          axis_along(pair.body1, pair.body2, along), lock_of(pair.body1, pair.body2)};
}
/// The pose for pencil and paper: the shaft is the x axis of a wall.
inline SleeveCase paper_sleeve() {
  const vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), l2(real(0.5), 1, 0);
  return {"pencil and paper",
          {{vec3(0), l2}, {vec3(0), l2, y, z}, {x, y, z}, {}},
          {static_body(vec3(0)),
           body_with(2, vec3(real(0.4), real(0.5), real(0.4)), vec3(real(0.5), -1, 0))}};
}
inline Numbers numbers_of(const FourRows& rows) {
  Numbers out(rows.C.begin(), rows.C.end());
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) out.push_back(double(rows.K[i][j]));
  for (const Row& row : rows.J.row)
    for (const vec3& block : {row.v1, row.w1, row.v2, row.w2}) append(out, block);
  return out;
}
inline std::vector<std::string> names_of_four_rows() {
  std::vector<std::string> out{"C[0]", "C[1]", "C[2]", "C[3]"}, blocks;
  for (const char* i : {"[0", "[1", "[2", "[3"})
    for (const char* j : {", 0]", ", 1]", ", 2]", ", 3]"}) out.push_back(std::string("K") + i + j);
  for (const char* i : {"J[0].", "J[1].", "J[2].", "J[3]."})
    for (const char* block : {"v1", "w1", "v2", "w2"}) blocks.push_back(std::string(i) + block);
  for (const std::string& name : with_xyz(blocks)) out.push_back(name);
  return out;
}
/// The same block from the engine's composite.
inline FourRows composed(const Kit& kit, const Pair& pair) {
  const Composite<Line, Axis> part{kit.line, kit.axis};
  return {part.error(pair.body1, pair.body2), part.jacobian(pair.body1, pair.body2),
          part.K(pair.body1, pair.body2)};
}

inline CaseTable<SleeveCase> sleeve_table() {
  CaseTable<SleeveCase> table{{"5.3", "C, J and K of a sleeve"}, names_of_four_rows(),
                              {}, {}, {}, {}};
  judge(table, sleeve, [](auto sleeve, const SleeveCase& c) {
    return numbers_of(sleeve(c.kit, c.pair.body1, c.pair.body2));
  });
  table.right = [](const SleeveCase& c) { return numbers_of(composed(c.kit, c.pair)); };
  table.cases.push_back(paper_sleeve());
  Random random(53);
  for (const char* words : {"in place", "slid and turned", "broken", "1 static", "2 static"})
    for (int draw = 0; draw < 2; ++draw) {
      Pair pair = uneven_pair();
      move_together(pair, random);
      const vec3 along = normalize(random.vector(1) + vec3(0, 2, 0));
      SleeveCase c{words, kit_of(pair, random.vector(1), along), pair};
      Body& body2 = c.pair.body2;
      if (words[0] != 'i') {
        body2.x += real(0.4) * along;
        turn_about(body2, world_point(body2, c.kit.line.anchor2_local), rotation(along));
      }
      if (words[0] == 'b') {
        body2.x += random.vector(real(0.3));
        turn_about(body2, body2.x, rotation(random.vector(real(0.3))));
      }
      if (words[0] == '1') c.pair.body1 = static_body(c.pair.body1.x, c.pair.body1.q);
      if (words[0] == '2') body2 = static_body(body2.x, body2.q);
      table.cases.push_back(c);
    }
  table.tolerance = 100 * rounding;
  return table;
}

// ---- the load -----------------------------------------------------------------------------------

struct TransmittedCase {
  std::string words;
  Jacobian<4> J;
  Vector<4> impulse;
  real h;
  Body body2;
  vec3 seam;
};
inline TransmittedCase paper_transmitted() {
  const SleeveCase c = paper_sleeve();
  return {"pencil and paper", composed(c.kit, c.pair).J,
          {real(0.5), 0, real(0.05), 0}, real(0.1), c.pair.body2, vec3(0)};
}

/// What the impulses do to a motion of body 2 is their force and torque, number by number.
inline Numbers transmitted_right(const TransmittedCase& c) {
  Numbers out;
  const vec3 lever = c.body2.x - c.seam;
  for (int k = 0; k < 6; ++k) {
    vec3 v(0), w(0);
    (k < 3 ? v : w)[k % 3] = 1;
    if (k >= 3) v = cross(w, lever);  // a rotation about the seam
    double work = 0;
    for (int i = 0; i < 4; ++i)
      work += double(c.impulse[std::size_t(i)] * (dot(c.J[i].v2, v) + dot(c.J[i].w2, w)));
    out.push_back(work / double(c.h));
  }
  return out;
}

inline CaseTable<TransmittedCase> transmitted_table() {
  CaseTable<TransmittedCase> table{{"5.3", "the load of four rows", 2},
                                   with_xyz({"force", "torque"}), {}, {}, {}, {}};
  judge(table, transmitted, [](auto transmitted, const TransmittedCase& c) {
    const Reaction load = transmitted(c.J, c.impulse, c.h, c.body2, c.seam);
    Numbers out;
    append(out, load.force);
    append(out, load.torque);
    return out;
  });
  table.right = transmitted_right;
  table.cases.push_back(paper_transmitted());
  Random random(54);
  for (const double h : {0.25, 0.016, 0.004})
    for (const SleeveCase& c : sleeve_table().cases) {
      TransmittedCase one{c.words, composed(c.kit, c.pair).J, {}, real(h), c.pair.body2,
                          random.vector(2)};
      for (real& a : one.impulse) a = random.uniform(-1, 1);
      table.cases.push_back(one);
    }
  table.tolerance = 1000 * rounding;
  return table;
}

}  // namespace joints::testing
