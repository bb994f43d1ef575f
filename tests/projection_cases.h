// Exercise 6.3 as tables of cases with their usual mistakes: a visit of position projection to a
// point and to a rope, and the chain that a sweep visits.
#pragma once

#include "tests/warm_cases.h"

namespace joints::testing {

/// The rotation vector [rad] that leads from one orientation to another.
inline vec3 turn_between(const quat& from, const quat& to) {
  quat turn = to * conjugate(from);
  if (turn.w < 0) turn = -turn;
  const vec3 axis(turn.x, turn.y, turn.z);
  const real sine = length(axis);
  return sine > 0 ? 2 * std::atan2(sine, turn.w) / sine * axis : vec3(0);
}

template <class Part>
struct VisitCase {
  std::string words;
  Part part;
  Pair pair;
};

inline const Distance& rod_of(const Rope<Distance>& rope) { return rope.rod; }
inline const Point& rod_of(const Point& point) { return point; }

/// K lambda = -C and all that belongs to it, with J by differences.
template <class Part>
struct VisitTwin {
  static constexpr int n = Part::rows;
  Pair pair;
  Jacobian<n> J;
  Matrix<n> K;
  Vector<n> C;

  VisitTwin(const Part& part, const Pair& pair)
      : pair(pair), J(numeric_jacobian(part, pair.body1, pair.body2)),
        K(dense_K(J, pair.body1, pair.body2)), C(to_vector(part.error(pair.body1, pair.body2))) {}

  static Vector<n> solved(Matrix<n> K, const Vector<n>& C) {
    invert_symmetric(K.m[0].data(), n);
    return times(K, C);
  }
  static Vector<n> times(const Matrix<n>& K, const Vector<n>& C) {
    Vector<n> out{};
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) out[i] -= K[i][j] * C[j];
    return out;
  }
  Vector<n> lambda() const { return solved(K, C); }
  Vector<n> without_K() const {
    Vector<n> out{};
    for (int i = 0; i < n; ++i) out[i] = -C[i];
    return out;
  }
  Vector<n> each_row_alone() const {
    Vector<n> out{};
    for (int i = 0; i < n; ++i) out[i] = -C[i] / K[i][i];
    return out;
  }
  Vector<n> with_velocities() const {
    Vector<n> all = C;
    for (int i = 0; i < n; ++i) all[i] += row_velocity(J[i], pair.body1, pair.body2);
    return solved(K, all);
  }
  /// The rows with other levers: w1 = -(r1 x n), w2 = r2 x n for each direction n.
  Jacobian<n> levers(const vec3& r1, const vec3& r2) const {
    Jacobian<n> out = J;
    for (int i = 0; i < n; ++i) {
      out[i].w1 = cross(r1, J[i].v1);
      out[i].w2 = cross(r2, J[i].v2);
    }
    return out;
  }
};

/// The moves of a visit; none where the part is one-sided and its error is not negative.
template <class Part>
Moves twin_moves(const Part& part, const Pair& pair) {
  const VisitTwin<Part> twin(part, pair);
  if (Part::one_sided && twin.C[0] >= 0) return {};
  return response<Part::rows>(twin.J, twin.lambda(), pair);
}
inline void move_by(const Moves& a, Body& body1, Body& body2) {
  body1.x += a.way1;
  body2.x += a.way2;
  body1.q = normalize(rotation(a.turn1) * body1.q);
  body2.q = normalize(rotation(a.turn2) * body2.q);
}

template <class Part>
CaseTable<VisitCase<Part>> visit_table(const Subject& subject,
                                       std::vector<VisitCase<Part>> cases) {
  using Case = VisitCase<Part>;
  using Twin = VisitTwin<Part>;
  constexpr int n = Part::rows;
  const auto of = [](const Moves& poses, const Moves& velocities = {}) {
    const auto short_way = [](const vec3& a) { return turn_between({1, 0, 0, 0}, rotation(a)); };
    return flat({poses.way1, short_way(poses.turn1), poses.way2, short_way(poses.turn2),
                 velocities.way1, velocities.turn1, velocities.way2, velocities.turn2});
  };
  // what a mistake does to the moves, or to lambda, where there is something to do
  const auto changed = [=](auto change) {
    return [=](const Case& c) {
      const Twin twin(c.part, c.pair);
      return Part::one_sided && twin.C[0] >= 0
                 ? of({}) : of(change(twin, response<n>(twin.J, twin.lambda(), c.pair)));
    };
  };
  const auto pushed = [=](auto lambda) {
    return changed([=](const Twin& twin, const Moves&) {
      return response<n>(twin.J, lambda(twin), twin.pair);
    });
  };
  const auto times = [=](double factor) {
    return changed([=](const Twin&, const Moves& a) {
      return scaled(real(factor), real(factor), a);
    });
  };
  const auto turns = [=](auto other) {  // of a body with its turn: what happens instead
    return changed([=](const Twin& twin, Moves a) {
      a.turn1 = other(twin.pair.body1, a.turn1);
      a.turn2 = other(twin.pair.body2, a.turn2);
      return a;
    });
  };
  const auto right = changed([](const Twin&, const Moves& a) { return a; });
  const auto velocities_of = [](const Pair& pair) {
    return Moves{pair.body1.v, pair.body1.w, pair.body2.v, pair.body2.w};
  };
  const auto yours = [=](const Case& c) {
    Pair after = c.pair;
    project(c.part, after.body1, after.body2);
    const Body &a = c.pair.body1, &b = c.pair.body2;
    return of({after.body1.x - a.x, turn_between(a.q, after.body1.q), after.body2.x - b.x,
               turn_between(b.q, after.body2.q)},
              {after.body1.v - a.v, after.body1.w - a.w, after.body2.v - b.v,
               after.body2.w - b.w});
  };
  double factor = 0;  // by which the moves of the first case are too long, whatever it is
  {
    const Numbers mine = yours(cases[0]), other = right(cases[0]);
    double size = 0;
    for (std::size_t i = 0; i < mine.size(); ++i) {
      factor += mine[i] * other[i];
      size += other[i] * other[i];
    }
    factor /= size;
  }

  CaseTable<Case> table{subject,
                        {"move of 1", "turn of 1", "move of 2", "turn of 2", "change of v1",
                         "change of w1", "change of v2", "change of w2"},
                        yours, right, {}, cases};
  table.tolerance = difference_tolerance;
  auto& add = table.mistakes;
  add = {{"nothing moves: the bodies themselves must, and not copies of them", times(0)},
         {"the sign: lambda = -K^-1 C works against the gap", times(-1)},
         {"times h: there is no step in it. lambda is an impulse times a time already",
          times(1.0 / 60)},
         {"divided by h: there is no step in it, K lambda = -C", times(60)}};
  if (factor > 0 && factor < 1 - 100 * difference_tolerance)
    add.push_back({"only a share of the gap is taken: there is no beta here, a visit takes it all",
                   times(factor)});
  add.insert(add.end(), {
      {"the velocities are changed, and the poses stay: add the moves to x and turn q by them",
       [=](const Case& c) {
         const Twin twin(c.part, c.pair);
         if (Part::one_sided && twin.C[0] >= 0) return of({});
         return of({}, response<n>(twin.J, twin.lambda(), c.pair));
       }},
      {"the velocities are changed, too: they stay as they are, take copies of the bodies",
       [=](const Case& c) {
         const Twin twin(c.part, c.pair);
         if (Part::one_sided && twin.C[0] >= 0) return of({});
         const Moves a = response<n>(twin.J, twin.lambda(), c.pair);
         return of(a, a);
       }},
      {"the velocities are lost: they stay as they are, only the copies are at rest",
       [=](const Case& c) {
         const Twin twin(c.part, c.pair);
         const bool idle = Part::one_sided && twin.C[0] >= 0;
         return idle ? of({}) : of(response<n>(twin.J, twin.lambda(), c.pair),
                                   scaled(-1, -1, velocities_of(c.pair)));
       }},
      {"the velocities hold the moves now: they stay as they are, take copies of the bodies",
       [=](const Case& c) {
         const Twin twin(c.part, c.pair);
         if (Part::one_sided && twin.C[0] >= 0) return of({});
         const Moves a = response<n>(twin.J, twin.lambda(), c.pair), b = velocities_of(c.pair);
         return of(a, {a.way1 - b.way1, a.turn1 - b.turn1, a.way2 - b.way2, a.turn2 - b.turn2});
       }},
      {"the copies are not at rest: v and w of both must be zero before they are given lambda",
       changed([=](const Twin& twin, const Moves& a) {
         const Moves b = velocities_of(twin.pair);
         return Moves{a.way1 + b.way1, a.turn1 + b.turn1, a.way2 + b.way2, a.turn2 + b.turn2};
       })},
      {"the velocities are in lambda: K lambda = -C has no J V, the copies are at rest",
       pushed([](const Twin& twin) { return twin.with_velocities(); })},
      {"K is missing: lambda is -K^-1 C",
       pushed([](const Twin& twin) { return twin.without_K(); })},
      {"times K where its inverse belongs",
       pushed([](const Twin& twin) { return Twin::times(twin.K, twin.C); })},
      {"K without the turns: it holds the masses only",
       pushed([](const Twin& twin) {
         return Twin::solved(product_K(twin.J, twin.pair.body1.inverse_mass, mat3(0),
                                       twin.pair.body2.inverse_mass, mat3(0)), twin.C);
       })},
      {"the turns are missing: the other half of Eq. 6-11",
       turns([](const Body&, const vec3&) { return vec3(0); })},
      {"a body turns in its own axes: exp(w) q and not q exp(w), w is in world axes",
       turns([](const Body& body, const vec3& turn) { return body.q * turn; })},
      {"the sign of the turns", turns([](const Body&, const vec3& turn) { return -turn; })},
      {"half the turn: turned(q, w, 1) halves the angle itself",
       turns([](const Body&, const vec3& turn) { return turn / real(2); })},
      {"twice the turn: turned(q, w, 1) halves the angle itself",
       turns([](const Body&, const vec3& turn) { return real(2) * turn; })},
      {"the turn is multiplied by h: turned(q, w, 1), for w is an angle already",
       turns([](const Body&, const vec3& turn) { return turn / real(60); })},
      {"q + (0, w) q/2 is only the first term of the turn: take turned(q, w, 1)",
       turns([](const Body&, const vec3& turn) {
         const real half = length(turn) / 2;
         return half > 0 ? std::atan(half) / half * turn : turn;
       })},
      {"body-space inertia: take inverse_inertia(body)",
       turns([](const Body& body, const vec3& turn) {
         return body.is_static() ? vec3(0)
                                 : body.inverse_inertia_local *
                                       (inverse(inverse_inertia(body)) * turn);
       })},
      {"the moves are missing: the first half of Eq. 6-11",
       changed([](const Twin&, const Moves& a) {
         return Moves{vec3(0), a.turn1, vec3(0), a.turn2};
       })},
      {"only body 2 moves: body 1 has its share of the gap",
       changed([](const Twin&, const Moves& a) { return scaled(0, 1, a); })},
      {"only body 1 moves: body 2 has its share of the gap",
       changed([](const Twin&, const Moves& a) { return scaled(1, 0, a); })},
      {"the moves of the two bodies are exchanged",
       changed([](const Twin&, const Moves& a) {
         return Moves{a.way2, a.turn2, a.way1, a.turn1};
       })},
      {"the inverse masses are missing",
       changed([](const Twin& twin, Moves a) {
         const auto push = [&](const Body& body, const vec3& way) {
           return body.is_static() ? way : way / body.inverse_mass;
         };
         a.way1 = push(twin.pair.body1, a.way1);
         a.way2 = push(twin.pair.body2, a.way2);
         return a;
       })}});
  if (n > 1)
    add.push_back({"each row divided by its own K: the rows of a block are solved together",
                   pushed([](const Twin& twin) { return twin.each_row_alone(); })});
  for (const bool all : {false, true})
    add.push_back({"body-space arm: the levers are not turned into the world",
                   [=](const Case& c) {
                     Twin twin(c.part, c.pair);
                     if (Part::one_sided && twin.C[0] >= 0) return of({});
                     const auto& rod = rod_of(c.part);
                     const Jacobian<n> J = twin.levers(rod.anchor1_local, rod.anchor2_local);
                     if (all) twin.K = dense_K(J, c.pair.body1, c.pair.body2);
                     return of(response<n>(J, twin.lambda(), c.pair));
                   }});
  if constexpr (Part::one_sided) {
    const auto whatever = [=](auto live) {
      return [=](const Case& c) {
        const Twin twin(c.part, c.pair);
        return live(twin.C[0]) ? of(response<n>(twin.J, twin.lambda(), c.pair)) : of({});
      };
    };
    add.insert(add.begin(),
               {{"a slack rope is pushed to its length: it is left alone where C >= 0",
                 whatever([](real) { return true; })},
                {"the wrong way round: C < 0 is too long, C > 0 is slack",
                 whatever([](real C) { return C > 0; })}});
  }
  return table;
}

}  // namespace joints::testing
