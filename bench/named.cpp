// Settings by a word, and cells of tables.
#include "bench/named.h"

#include <cmath>
#include <cstdio>

namespace joints::bench {

Setting setting_of(const std::string& method) {
  const Way direct{.loop = Loop::direct, .beta = 1, .leapfrog = true};
  Way shake = direct, stiff = direct;
  shake.newton = stiff.newton = 8;
  stiff.stiffness = 8;
  const struct {
    std::string word;
    Way way;
    int iterations = 30;
  } known[] = {{"si30", {}},
               {"beta1", {.beta = 1}},
               {"4x8", {.beta = 1, .substeps = 4}, 32},
               {"16x2", {.beta = 1, .substeps = 16}, 32},
               {"warm", {.warm = true, .projections = 1, .beta = 0}},
               {"projection", {.projections = 1, .beta = 0}},
               {"split", {.warm = true, .beta = 1, .substeps = 4, .split = 4}, 16},
               {"relax", {.warm = true, .substeps = 16, .relax = 1, .frequency = 60}, 16},
               {"omega", {.loop = Loop::packed, .beta = 1, .relaxation = real(1.9)}},
               {"lanes", {.loop = Loop::lanes, .beta = 1, .relaxation = real(1.9)}},
               {"lanes10", {.loop = Loop::lanes, .warm = true, .beta = real(0.1)}, 10},
               {"chapter7", {.loop = Loop::hinges, .relaxation = real(1.9)}, 20},
               {"textbook", {.loop = Loop::textbook}},
               {"velocity", direct},
               {"shake", shake},
               {"stiff", stiff},
               {"rk4", {.loop = Loop::runge_kutta, .beta = 1}}};
  for (const auto& one : known)
    if (one.word == method) return one.way.setting(one.iterations);
  refuse("method " + method + ": there is none of this name");
}

std::string cell(double number, bool means_something) {
  char text[32] = "";
  if (means_something && !std::isnan(number)) std::snprintf(text, sizeof text, ",%.6g", number);
  return *text ? text : ",";
}

}  // namespace joints::bench
