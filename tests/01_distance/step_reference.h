// A step beside the reader's, exercise 1.4. Each of its parts can be exchanged: a mistake is a step
// with another part.
#pragma once

#include <numeric>

#include "chapters/01_distance/distance.h"
#include "tests/checker/cases.h"
#include "tests/checker/unit_rates.h"

namespace joints::testing {

/// Bodies and links, and how they are to be stepped.
struct Scene {
  std::string words;
  std::vector<Body> bodies;
  std::vector<Link> links;
  StepSettings settings;
  int steps = 1;
};

/// One link in one iteration.
struct Turn {
  const Link& link;
  LinkRow& row;
  Body &body1, &body2;
  const StepSettings& settings;
};

struct Way {
  /// The four pieces in their order: forces, rows, impulses, positions.
  std::string pieces = "FRIP";
  /// Pieces that are done (again) in every iteration.
  std::string in_iteration;
  Call<void(Body&, const StepSettings&)> fall = [](Body& body, const StepSettings& s) {
    body.v += s.h * s.gravity;
  };
  Call<void(Body&, const StepSettings&)> travel = [](Body& body, const StepSettings& s) {
    body.x += s.h * body.v;
  };
  bool static_falls = false;
  bool needs_links = false;  ///< ends after the forces where there are none
  Call<bool(std::size_t)> falls = [](std::size_t) { return true; };    ///< by its place
  Call<bool(std::size_t)> travels = [](std::size_t) { return true; };
  Call<int(const Scene&)> iterations = [](const Scene& s) {
    return s.settings.iterations;
  };
  /// The indices of the links in the order in which an iteration solves them.
  Call<std::vector<int>(int links, int iteration)> order = [](int links, int) {
    std::vector<int> out(links);
    std::iota(out.begin(), out.end(), 0);
    return out;
  };
  /// Whom a row acts on; it has been set up for the right ones.
  Call<Link(const Scene&, int place)> link = [](const Scene& s, int place) {
    return s.links[place];
  };
  /// The place of the row that a link takes.
  Call<int(int place)> row = [](int place) { return place; };
  Call<bool(const Turn&)> skips = [](const Turn&) { return false; };
  bool skip_is_the_last = false;  ///< of its iteration
  Call<real(const Turn&)> wants = [](const Turn& t) {
    real inverse = t.row.K;
    invert_symmetric(&inverse, 1);  // of 0 it is 0
    return -inverse * (t.row.bias + row_velocity(t.row.J, t.body1, t.body2));
  };
  /// The applied part of it: of a rope, the part that its sum allows.
  Call<real(real, const Turn&)> gets = [](real wanted, const Turn& t) {
    return t.link.rope ? allowed(wanted, t.row.sum) : wanted;
  };
  Call<void(real, const Turn&)> gives = [](real lambda, const Turn& t) {
    push(lambda, t.row.J, t.body1, t.body2);
  };
  bool at_once = true;      ///< each impulse is applied before the next one is asked for
  bool asked_once = false;  ///< and is not asked for again in later iterations
  enum class Sum { each, of_iteration, of_all } sum = Sum::each;  ///< which sum a rope's is

  /// What would push is refused.
  static real allowed(real wanted, real& sum) {
    const real whole = sum + wanted, refused = (std::abs(whole) - whole) / 2;
    sum = whole + refused;
    return wanted + refused;
  }
  static void push(real lambda, const Row& J, Body& body1, Body& body2) {
    Row response;
    form_responses(&J, 1, body1, body2, &response);
    body1.v += lambda * response.v1;  // nothing turns
    body2.v += lambda * response.v2;
  }
};

/// A step may solve the links in any of these orders.
inline std::vector<Way> right_ways() {
  std::vector<Way> ways(4);
  for (int k = 1; k < 4; ++k)
    ways[k].order = [=, forward = Way{}.order](int links, int n) {
      std::vector<int> out = forward(links, n);
      if (n % 2 ? k / 2 : k % 2) std::reverse(out.begin(), out.end());
      return out;
    };
  return ways;
}

/// Eq. 1-4, 1-5, 1-7 and 1-11, without the reader's exercises.
inline LinkRow reference_row(const Link& link, const std::vector<Body>& bodies,
                             const StepSettings& s) {
  const Body &a = bodies[link.body1], &b = bodies[link.body2];
  const real sign = link.rope ? -1 : 1, C = sign * (length(b.x - a.x) - link.length);
  const Row J = row_by_rates(sign * direction(b.x - a.x), vec3(0), vec3(0));
  return {J, dense_K(to_jacobian(J), a, b)[0][0], (link.rope && C > 0 ? 1 : s.beta) * C / s.h, 0};
}

/// What became of the bodies: six numbers each. A scene has four at most; 0 for those that it has
/// not. Where a step explodes, rounding errors do, too: numbers beyond 1e4 are as good.
constexpr int most_bodies = 4;
inline Numbers filled_up(Numbers numbers) {
  numbers.resize(6 * most_bodies);
  return numbers;
}
inline Numbers numbers_of(const std::vector<Body>& bodies) {
  Numbers out;
  for (const Body& body : bodies)
    for (const vec3& a : {body.v, body.x})
      for (int i = 0; i < 3; ++i) out.push_back(std::clamp(double(a[i]), -1e4, 1e4));
  return filled_up(out);
}
inline std::vector<std::string> step_entries() {
  std::vector<std::string> out;
  for (int body = 0; body < most_bodies; ++body)
    for (const char* entry : {"v.x", "v.y", "v.z", "x.x", "x.y", "x.z"})
      out.push_back("bodies[" + std::to_string(body) + "]." + entry);
  return out;
}

/// The steps of one scene.
class Walk {
 public:
  Walk(const Scene& scene, const Way& way) : scene_(scene), way_(way), bodies_(scene.bodies) {}

  std::vector<Body> bodies() {
    for (int n = 0; n < scene_.steps; ++n) {
      rows_.assign(scene_.links.size(), LinkRow{});  // where the pieces forget to set them up
      once_.assign(scene_.links.size(), 0);
      for (char piece : way_.pieces) {
        if (way_.needs_links && scene_.links.empty() && piece != 'F') break;
        if (piece == 'I') iterate();
        else do_piece(piece);
      }
    }
    return bodies_;
  }

 private:
  void do_piece(char piece) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      Body& body = bodies_[i];
      if (piece == 'F' && way_.falls(i) && (way_.static_falls || !body.is_static()))
        way_.fall(body, scene_.settings);
      if (piece == 'P' && way_.travels(i)) way_.travel(body, scene_.settings);
    }
    if (piece == 'R')
      for (std::size_t k = 0; k < rows_.size(); ++k)
        rows_[k] = reference_row(scene_.links[k], bodies_, scene_.settings);
  }
  void iterate() {
    real sum_of_all = 0;
    for (int n = 0; n < way_.iterations(scene_); ++n) {
      std::vector<Call<void()>> later;
      for (int k : way_.order(int(rows_.size()), n)) {
        const Link link = way_.link(scene_, k);
        LinkRow& row = rows_[way_.row(k)];
        if (way_.sum == Way::Sum::of_iteration) row.sum = 0;
        if (way_.sum == Way::Sum::of_all) row.sum = sum_of_all;
        const Turn turn{link, row, bodies_[link.body1], bodies_[link.body2], scene_.settings};
        if (way_.skips(turn) && way_.skip_is_the_last) break;
        if (way_.skips(turn)) continue;
        const real wanted = way_.asked_once && n > 0 ? once_[k] : way_.wants(turn);
        once_[k] = wanted;
        const real lambda = way_.gets(wanted, turn);
        sum_of_all = row.sum;
        later.push_back([=, this, &row] {
          way_.gives(lambda, {link, row, bodies_[link.body1], bodies_[link.body2],
                              scene_.settings});
        });
        if (way_.at_once) later.back()();
      }
      if (!way_.at_once)
        for (const auto& give : later) give();
      for (char piece : way_.in_iteration) do_piece(piece);
    }
  }

  const Scene& scene_;
  const Way& way_;
  std::vector<Body> bodies_;
  std::vector<LinkRow> rows_;
  std::vector<real> once_;
};

inline Numbers walked(const Scene& scene, const Way& way = {}) {
  return numbers_of(Walk(scene, way).bodies());
}

}  // namespace joints::testing
