// Exercise 5.2 as tables of cases with their usual mistakes: the load of a weld, and the same load
// about another point.
#pragma once

#include "chapters/05_fixed/fixed.h"
#include "tests/checker/pieces.h"
#include "tests/checker/pose_cases.h"

namespace joints::testing {

// ---- the load -----------------------------------------------------------------------------------

struct LoadCase {
  std::string words;
  Vector<6> impulse;
  real h;
};

struct LoadReference {
  LoadCase c;
  std::array<int, 6> from{0, 1, 2, 3, 4, 5};  ///< which impulse each number is
  std::array<real, 2> scale;                  ///< of force and torque
  Numbers more = Numbers(6, 0);
  explicit LoadReference(const LoadCase& c) : c(c), scale{1 / c.h, 1 / c.h} {}
  Numbers load() const {
    Numbers out = more;
    for (std::size_t i = 0; i < 6; ++i)
      if (from[i] >= 0) out[i] += double(scale[i / 3] * c.impulse[std::size_t(from[i])]);
    return out;
  }
};

inline CaseTable<LoadCase> load_table() {
  using T = LoadReference;
  Pieces<T> pieces;
  // what is wrong with both, with the force, with the torque
  const auto scaled = [&](const std::string& words, auto scale) {
    for (const int which : {3, 1, 2})
      pieces.push_back({words + (which == 3 ? "" : which == 1 ? " (force)" : " (torque)"),
                        [=](T& t) {
                          for (int k = 0; k < 2; ++k)
                            if (which >> k & 1) t.scale[k] = scale(t.c.h);
                        }});
  };
  scaled("#impulse-for-force this is the impulse: a force is the impulse over the step h",
         [](real) { return 1; });
  scaled("times h where it must be divided by h", [](real h) { return h; });
  scaled("the sign: return the load on body 2, on which +lambda acts",
         [](real h) { return -1 / h; });
  scaled("divided by h twice", [](real h) { return 1 / (h * h); });
  scaled("60 in the place of 1/h: a step may have another length than 1/60 "
         "s", [](real) { return 60; });
  scaled("1/h is cut to a whole number: an int has no fraction",
         [](real h) { return std::trunc(1 / h); });
  const auto places = [&](const std::string& words, const std::array<int, 6>& from) {
    pieces.push_back({words, [=](T& t) { t.from = from; }});
  };
  places("#threes-exchanged the two threes are exchanged: the point's rows come first",
         {3, 4, 5, 0, 1, 2});
  places("every second number: the point has the first three and the lock the rest",
         {0, 2, 4, 1, 3, 5});
  places("the impulses from the last to the first: those of the point come first",
         {5, 4, 3, 2, 1, 0});
  for (int push = 0; push < 4; ++push)
    for (int turn = 0; turn < 4; ++turn) {
      if ((push == 0 && turn == 3) || (push == 3 && turn == 0)) continue;
      std::string words;
      if (push != 0) words = "the force begins with impulse[" + std::to_string(push) + "]";
      if (turn != 3)
        words += (words.empty() ? "the torque begins with impulse["
                                : ", the torque with impulse[") + std::to_string(turn) + "]";
      places(words + ": the three of the point are impulse[0] to impulse[2], those of the lock "
                     "impulse[3] to impulse[5]",
             {push, push + 1, push + 2, turn, turn + 1, turn + 2});
    }
  pieces.push_back({"force and torque are added up: each has its own three numbers", [](T& t) {
                      for (std::size_t i = 0; i < 6; ++i)
                        t.more[i] = double(t.c.impulse[(i + 3) % 6] / t.c.h);
                    }});
  pieces.push_back({"the torque has a cross product in it: about the anchor the lock's own three "
                    "are the whole torque", [](T& t) {
                      const Vector<6>& a = t.c.impulse;
                      const vec3 T = cross(vec3(a[0], a[1], a[2]), vec3(a[3], a[4], a[5])) / t.c.h;
                      t.from[3] = t.from[4] = t.from[5] = -1;
                      for (int i = 0; i < 3; ++i) t.more[std::size_t(3 + i)] = double(T[i]);
                    }});
  CaseTable<LoadCase> table{{"5.2", "the load of a weld"}, with_xyz({"force", "torque"}),
                            {}, {}, {}, {}};
  table.yours = [](const LoadCase& c) {
    const Reaction load = carried(c.impulse, c.h);
    Numbers out;
    append(out, load.force);
    append(out, load.torque);
    return out;
  };
  table.right = [](const LoadCase& c) { return LoadReference(c).load(); };
  table.cases = {{"h = 0.25", {real(0.3), real(-0.2), real(0.7), real(-0.4), real(0.1), real(0.6)},
                  real(0.25)},
                 {"h = 0.016", {real(-1), real(0.5), real(0.2), real(0.9), real(-0.8), real(0.35)},
                  real(0.016)}};
  table.tolerance = 1000 * rounding;
  add_pieces(table, [](const LoadCase& c) { return LoadReference(c); },
             [](const LoadReference& t) { return t.load(); }, pieces);
  return table;
}

// ---- about another point ------------------------------------------------------------------------

struct AboutCase {
  std::string words;
  Reaction load;
  vec3 from, to;
};

struct AboutReference {
  AboutCase c;
  vec3 arm, pushed, kept, force;  ///< force and kept + arm x pushed
  explicit AboutReference(const AboutCase& c)
      : c(c), arm(c.from - c.to), pushed(c.load.force), kept(c.load.torque), force(c.load.force) {}
  Numbers load() const {
    Numbers out;
    append(out, kept + cross(arm, pushed));
    append(out, force);
    return out;
  }
};

inline CaseTable<AboutCase> about_table() {
  using T = AboutReference;
  const auto arm = [](auto of) {
    return Call<void(T&)>([=](T& t) { t.arm = of(t.c); });
  };
  const Pieces<T> pieces = {
      {"#sign-new-share-x the sign of the new term, (from - to) x F: from and to are exchanged, or "
       "the two sides of the cross product",
       arm([](const AboutCase& c) { return c.to - c.from; })},
      {"the torque is as it was: a force beside the point turns, too",
       arm([](const AboutCase&) { return vec3(0); })},
      {"`to` is forgotten: the lever runs from `to` to `from`",
       arm([](const AboutCase& c) { return c.from; })},
      {"`to` is forgotten, and the sign of the new term",
       arm([](const AboutCase& c) { return -c.from; })},
      {"`from` is forgotten: the lever runs from `to` to `from`",
       arm([](const AboutCase& c) { return -c.to; })},
      {"`from` is forgotten, and the sign of the new term",
       arm([](const AboutCase& c) { return c.to; })},
      {"the lever is a difference: from - to",
       arm([](const AboutCase& c) { return c.from + c.to; })},
      {"a short lever is ignored: it gives a torque, too", arm([](const AboutCase& c) {
         return length(c.from - c.to) < real(0.05) ? vec3(0) : c.from - c.to;
       })},
      {"#unit-lever the lever is made a unit vector: it keeps its length",
       arm([](const AboutCase& c) { return normalize(c.from - c.to); })},
      {"the new term is added twice", arm([](const AboutCase& c) {
         return real(2) * (c.from - c.to);
       })},
      {"#lever-torque the force has the lever, not the torque: (from - to) x F",
       [](T& t) { t.pushed = t.c.load.torque; }},
      {"#without-old-torque the old torque is lost: the new term is added to it",
       [](T& t) { t.kept = vec3(0); }},
      {"the sign of the old torque: the new term is added to it", [](T& t) { t.kept = -t.kept; }},
      {"#by-entries entry times entry: the lever and the force have a cross product, cross(from - "
       "to, F)",
       [](T& t) { t.kept += t.arm * t.pushed, t.arm = vec3(0); }},
      {"the length of the lever times the force: they have a cross product, cross(from - to, F)",
       [](T& t) { t.kept += length(t.arm) * t.pushed, t.arm = vec3(0); }},
      {"the force is lost: it stays the same", [](T& t) { t.force = vec3(0); }},
      {"the sign of the force: it stays the same", [](T& t) { t.force = -t.force; }},
      {"the new term belongs to the torque: the force stays",
       [](T& t) { t.force += cross(t.arm, t.pushed); }},
      {"a term is added to the force: it stays the same",
       [](T& t) { t.force += cross(t.arm, t.c.load.torque); }},
      {"force and torque are added up: the force stays the same",
       [](T& t) { t.force += t.c.load.torque; }},
      {"the force is the torque: it stays the same", [](T& t) { t.force = t.c.load.torque; }},
      {"#exchanged force and torque are exchanged: {force, torque}", [](T& t) {
         t.force = t.kept + cross(t.arm, t.pushed);
         t.kept = t.c.load.force;
         t.arm = vec3(0);
       }}};
  CaseTable<AboutCase> table{{"5.2", "the load about another point", 2},
                             with_xyz({"torque", "force"}), {}, {}, {}, {}};
  table.yours = [](const AboutCase& c) {
    const Reaction moved = about(c.load, c.from, c.to);
    Numbers out;
    append(out, moved.torque);
    append(out, moved.force);
    return out;
  };
  table.right = [](const AboutCase& c) { return AboutReference(c).load(); };
  Random random(52);
  for (int draw = 0; draw < 8; ++draw)
    table.cases.push_back({"points anywhere", {random.vector(5), random.vector(5)},
                           random.vector(2), random.vector(2)});
  table.cases.push_back({"points close together", {random.vector(5), random.vector(5)},
                         vec3(1, 2, 3), vec3(1, real(2.02), real(2.99))});
  table.tolerance = 10 * rounding;
  add_pieces(table, [](const AboutCase& c) { return AboutReference(c); },
             [](const AboutReference& t) { return t.load(); }, pieces);
  return table;
}

}  // namespace joints::testing
