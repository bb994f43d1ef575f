// Exercise 7.1 as tables of cases, each with its usual mistakes: levers, axis rows, inverse
// inertias. The biases have a file of their own.
#pragma once

#include "tests/07_performance/loop_hinges.h"

namespace joints::testing {

/// Yours: hoist() on numbers that hold something else before.
inline HingeNumbers<real> hoisted(const HingeCase& c) {
  HingeNumbers<real> out;
  std::fill_n(reinterpret_cast<real*>(&out), sizeof out / sizeof(real),
              real(unwritten));
  hoist(c.hinge, c.pair.body1, c.pair.body2, c.h, out);
  return out;
}

/// A rule for one of the two bodies, and the mistake that it is.
template <class Value>
struct BodyRule {
  std::string words;
  Call<Value(const HingeCase&, bool)> of;
};
/// Each rule for both bodies, for body 1 and for body 2, the other one's being right; and one rule
/// for body 1 and another for body 2.
template <class Value, class Flat>
void add_body_rules(CaseTable<HingeCase>& table, const std::vector<BodyRule<Value>>& wrong,
                    const Call<Value(const HingeCase&, bool)>& right,
                    const std::string& name, Flat flat) {
  for (const int which : {3, 1, 2})
    for (const BodyRule<Value>& rule : wrong) {
      const std::string who = which == 3 ? name + "1 and " + name + "2"
                                         : name + std::to_string(which);
      table.mistakes.push_back({who + ": " + rule.words, [=, of = rule.of](const HingeCase& c) {
                                  return flat((which & 1 ? of : right)(c, false),
                                              (which & 2 ? of : right)(c, true));
                                }});
    }
  table.pairs = [=] {
    CaseTable<HingeCase>::Mistakes out;
    for (const BodyRule<Value>& one : wrong)
      for (const BodyRule<Value>& two : wrong)
        out.push_back({name + "1: " + one.words + "; and " + name + "2: " + two.words,
                       [=, of1 = one.of, of2 = two.of](const HingeCase& c) {
                         return flat(of1(c, false), of2(c, true));
                       }});
    return out;
  };
}

// ---- levers -------------------------------------------------------------------------------------

inline CaseTable<HingeCase> lever_table() {
  using Case = HingeCase;
  const auto flat = [](const vec3& r1, const vec3& r2) {
    Numbers out;
    append(out, r1);
    append(out, r2);
    return out;
  };
  CaseTable<Case> table{{"7.1", "the levers of a hinge"}, with_xyz({"r1", "r2"}), {}, {}, {},
                        hinge_cases()};
  table.yours = [](const Case& c) {
    const HingeNumbers<real> yours = hoisted(c);
    Numbers out;
    append(out, yours.r1);
    append(out, yours.r2);
    return out;
  };
  table.right = [=](const Case& c) {
    return flat(reference_lever(c, false), reference_lever(c, true));
  };
  add_body_rules<vec3>(
      table,
      {{"not written yet", [](const Case&, bool) { return vec3(real(unwritten)); }},
       {"not turned into the world: to_world(body, anchor)",
        [](const Case& c, bool second) { return c.anchor(second); }},
       {"turned the wrong way: to_world, not to_local",
        [](const Case& c, bool second) {
          return rotated(conjugate(c.body(second).q), c.anchor(second));
        }},
       {"the place of the anchor: a lever begins at the centre of its body, to_world and not "
        "world_point",
        [](const Case& c, bool second) { return c.body(second).x + reference_lever(c, second); }},
       {"the lever of the other body",
        [](const Case& c, bool second) { return reference_lever(c, !second); }},
       {"the anchor of the other body, turned with this one",
        [](const Case& c, bool second) { return rotated(c.body(second).q, c.anchor(!second)); }},
       {"turned with the other body: each anchor rides on its own body",
        [](const Case& c, bool second) { return rotated(c.body(!second).q, c.anchor(second)); }},
       {"the anchor of the other body, not turned",
        [](const Case& c, bool second) { return c.anchor(!second); }},
       {"the sign: from the centre to the anchor",
        [](const Case& c, bool second) { return -reference_lever(c, second); }},
       {"to the anchor on the other body: that is the same point only while the gap is zero",
        [](const Case& c, bool second) {
          return c.body(!second).x + reference_lever(c, !second) - c.body(second).x;
        }},
       {"it begins at the centre of the other body: at that of its own",
        [](const Case& c, bool second) {
          return c.body(second).x + reference_lever(c, second) - c.body(!second).x;
        }},
       {"made a unit vector: a lever keeps its length",
        [](const Case& c, bool second) {
          const vec3 r = reference_lever(c, second);
          return length(r) > 0 ? normalize(r) : r;
        }}},
      reference_lever, "r", flat);
  table.tolerance = 10 * rounding;
  return table;
}

// ---- axis rows ----------------------------------------------------------------------------------

inline CaseTable<HingeCase> axis_row_table() {
  using Case = HingeCase;
  using Rows = std::array<vec3, 2>;
  const auto flat = [](const Rows& rows) {
    Numbers out;
    for (const vec3& row : rows) append(out, row);
    return out;
  };
  // the rows from a1, b and c, each turned by a rule
  const auto from = [=](auto of_a1, auto of_b_and_c) {
    return [=](const Case& c) {
      const Axis& axis = c.hinge.axis;
      return flat(axis_rows(of_a1(c, axis.a1_local), of_b_and_c(c, axis.b_local),
                            of_b_and_c(c, axis.c_local)));
    };
  };
  const auto of_rows = [=](auto change) {
    return [=](const Case& c) { return flat(change(c, reference_rows(c))); };
  };
  const auto on_1 = [](const Case& c, const vec3& a) { return rotated(c.pair.body1.q, a); };
  const auto on_2 = [](const Case& c, const vec3& a) { return rotated(c.pair.body2.q, a); };
  const auto as_it_is = [](const Case&, const vec3& a) { return a; };

  CaseTable<Case> table{{"7.1", "the axis rows of a hinge"},
                        with_xyz({"axis_row[0]", "axis_row[1]"}), {}, {}, {}, hinge_cases()};
  table.yours = [](const Case& c) {
    const HingeNumbers<real> yours = hoisted(c);
    Numbers out;
    for (const Triple<real>& row : yours.axis_row) append(out, row);
    return out;
  };
  // the slopes of the last two errors as body 2 turns
  table.right = [=](const Case& c) {
    const Jacobian<5> J = numeric_jacobian(c.hinge, c.pair.body1, c.pair.body2);
    return flat({J[3].w2, J[4].w2});
  };
  table.mistakes = {
      {"the rows are not written yet", of_rows([](const Case&, const Rows&) {
         return Rows{vec3(real(unwritten)), vec3(real(unwritten))};
       })},
      {"the first row is not written yet", of_rows([](const Case&, const Rows& a) {
         return Rows{vec3(real(unwritten)), a[1]};
       })},
      {"#axis-sign-one-row the sign of the first row: b x a1 is the block w2",
       of_rows([](const Case&, const Rows& a) { return Rows{-a[0], a[1]}; })},
      {"the sign of the second row: c x a1 is the block w2",
       of_rows([](const Case&, const Rows& a) { return Rows{a[0], -a[1]}; })},
      {"#axis-bodies-exchanged the bodies are exchanged: axis.jacobian(body1, body2)",
       [=](const Case& c) {
         const Jacobian<2> J = c.hinge.axis.jacobian(c.pair.body2, c.pair.body1);
         return flat({J[0].w2, J[1].w2});
       }},
      {"the second row is not written yet", of_rows([](const Case&, const Rows& a) {
         return Rows{a[0], vec3(real(unwritten))};
       })},
      {"the sign: b x a1 and c x a1 are the blocks w2, the blocks w1 are their opposites",
       of_rows([](const Case&, const Rows& a) { return Rows{-a[0], -a[1]}; })},
      {"the two rows are exchanged: b comes first, then c",
       of_rows([](const Case&, const Rows& a) { return Rows{a[1], a[0]}; })},
      {"#axis-row-twice the first row stands there twice: the second one is c x a1",
       of_rows([](const Case&, const Rows& a) { return Rows{a[0], a[0]}; })},
      {"the second row stands there twice: the first one is b x a1",
       of_rows([](const Case&, const Rows& a) { return Rows{a[1], a[1]}; })},
      {"the blocks v of the rows, which are zero: take w2",
       of_rows([](const Case&, const Rows&) { return Rows{vec3(0), vec3(0)}; })},
      {"turned back into the axes of body 2: the iterations need the rows in world axes",
       of_rows([](const Case& c, const Rows& a) {
         const quat back = conjugate(c.pair.body2.q);
         return Rows{rotated(back, a[0]), rotated(back, a[1])};
       })},
      {"turned back into the axes of body 1: the iterations need the rows in world axes",
       of_rows([](const Case& c, const Rows& a) {
         const quat back = conjugate(c.pair.body1.q);
         return Rows{rotated(back, a[0]), rotated(back, a[1])};
       })},
      {"turned once more: axis.jacobian gives world axes already",
       of_rows([](const Case& c, const Rows& a) {
         return Rows{rotated(c.pair.body2.q, a[0]), rotated(c.pair.body2.q, a[1])};
       })},
      {"b and c themselves: their cross products with a1 belong there",
       [=](const Case& c) {
         return flat({on_2(c, c.hinge.axis.b_local), on_2(c, c.hinge.axis.c_local)});
       }},
      {"a2, the axis of body 2, in the place of a1: then the rows are -c and b, right only while "
       "the axes agree", [=](const Case& c) {
         return flat({-on_2(c, c.hinge.axis.c_local), on_2(c, c.hinge.axis.b_local)});
       }},
      {"nothing is turned into the world: b, c and a1 are body-space", from(as_it_is, as_it_is)},
      {"a1_local is not turned into the world", from(as_it_is, on_2)},
      {"b_local and c_local are not turned into the world", from(on_1, as_it_is)},
      {"#axis-wrong-body the axis is turned with the wrong body: a1 rides on body 1, b and c on "
       "body 2",
       from(on_2, on_2)},
      {"b and c are turned with the wrong body: they ride on body 2", from(on_1, on_1)},
      {"the bodies are exchanged: a1 rides on body 1, b and c on body 2", from(on_2, on_1)}};
  table.tolerance = difference_tolerance;
  return table;
}

// ---- inverse inertias ---------------------------------------------------------------------------

inline constexpr const char* inertia_entries[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
inline Numbers six_numbers(const mat3& I) {
  return {double(I[0][0]), double(I[1][1]), double(I[2][2]),
          double(I[0][1]), double(I[0][2]), double(I[1][2])};
}
inline Numbers six_numbers(const Symmetric<real>& m) {
  return {double(m.xx), double(m.yy), double(m.zz), double(m.xy), double(m.xz), double(m.yz)};
}

inline CaseTable<HingeCase> inertia_table() {
  using Case = HingeCase;
  const auto both = [](Numbers one, const Numbers& two) {
    one.insert(one.end(), two.begin(), two.end());
    return one;
  };
  const auto with_body = [](auto of) {
    return [=](const Case& c, bool second) { return six_numbers(of(c.body(second))); };
  };
  const auto right = [](const Case& c, bool second) {
    return six_numbers(reference_inertia(c, second));
  };
  const auto in_order = [=](std::array<int, 6> order) {  // which number stands in each place
    return [=](const Case& c, bool second) {
      const Numbers all = right(c, second);
      Numbers out;
      for (const int k : order) out.push_back(k < 0 ? 0 : all[std::size_t(k)]);
      return out;
    };
  };
  std::vector<std::string> names;
  for (const char* body : {"I1.", "I2."})
    for (const char* entry : inertia_entries)
      names.push_back(std::string(body) + entry);
  CaseTable<Case> table{{"7.1", "the inverse inertias of a hinge's bodies"}, names, {}, {}, {},
                        hinge_cases()};
  table.yours = [=](const Case& c) {
    const HingeNumbers<real> yours = hoisted(c);
    return both(six_numbers(yours.I1), six_numbers(yours.I2));
  };
  table.right = [=](const Case& c) { return both(right(c, false), right(c, true)); };
  add_body_rules<Numbers>(
      table,
      {{"not written yet", [](const Case&, bool) { return Numbers(6, unwritten); }},
       {"body-space: it must be turned into the world, R I^-1 R^T, inverse_inertia(body)",
        with_body([](const Body& b) {
          return turned_inertia(quat(1, 0, 0, 0), b.inverse_inertia_local);
        })},
       {"turned the wrong way round: R I^-1 R^T, not R^T I^-1 R", with_body([](const Body& b) {
          return turned_inertia(conjugate(b.q), b.inverse_inertia_local);
        })},
       {"the inertia of the other body",
        [=](const Case& c, bool second) { return right(c, !second); }},
       {"turned with the other body", [](const Case& c, bool second) {
          return six_numbers(turned_inertia(c.body(!second).q,
                                            c.body(second).inverse_inertia_local));
        }},
       {"the inertia itself, not its inverse", with_body([](const Body& b) {
          return inverse(turned_inertia(b.q, b.inverse_inertia_local));
        })},
       {"times the inverse mass: an inverse inertia has the mass in it",
        with_body([](const Body& b) {
          return b.inverse_mass * turned_inertia(b.q, b.inverse_inertia_local);
        })},
       {"R^T is missing: R I^-1 R^T", with_body([](const Body& b) {
          mat3 out = glm::mat3_cast(b.q);
          for (int k = 0; k < 3; ++k) out[k] *= b.inverse_inertia_local[k];
          return transpose(out);  // entry [column][row] as symmetric() takes it
        })},
       {"row after row: the diagonal xx, yy, zz comes first, then xy, xz, yz (symmetric(m))",
        in_order({0, 3, 4, 1, 5, 2})},
       {"the entries beside the diagonal are in another order: xy, xz, yz",
        in_order({0, 1, 2, 5, 4, 3})},
       {"the entries beside the diagonal are in another order: xy, xz, yz",
        in_order({0, 1, 2, 3, 5, 4})},
       {"only the diagonal: a turned body has numbers beside it", in_order({0, 1, 2, -1, -1, -1})}},
      right, "I", both);
  table.tolerance = 10 * rounding;
  return table;
}

}  // namespace joints::testing
