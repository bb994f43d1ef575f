// Settings by a word, and cells of tables.
#include "bench/named.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace joints::bench {

Setting setting_named(const std::string& method) {
  const Way direct{.loop = Loop::direct, .beta = 1, .leapfrog = true};
  Way shake = direct, inertia = direct, plain = direct;
  shake.newton = inertia.newton = 8;
  plain.leapfrog = false;
  Way placed = plain;
  placed.newton = 8;
  inertia.added_inertia = 8, inertia.beta = real(0.2);  // as it is constructed
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
               {"rows10", {.warm = true, .beta = real(0.1)}, 10},
               {"lanes10", {.loop = Loop::lanes, .warm = true, .beta = real(0.1)}, 10},
               {"chapter7", {.loop = Loop::hinges, .relaxation = real(1.9)}, 20},
               {"textbook", {.loop = Loop::textbook}},
               {"velocity", direct},
               {"shake", shake},
               {"plain", plain},
               {"placed", placed},
               {"inertia", inertia},
               {"rk4", {.loop = Loop::runge_kutta, .beta = 1}},
               {"tree", {.loop = Loop::tree}},
               {"tree-rk4", {.loop = Loop::tree_runge_kutta}},
               {"xpbd", {.loop = Loop::xpbd, .beta = 1, .substeps = 20}, 20},
               {"nncg", {.loop = Loop::nonsmooth, .beta = 1}},
               {"cg", {.loop = Loop::gradients, .beta = 1}},
               {"cg-exact", {.loop = Loop::gradients, .beta = 1, .tolerance = real(1e-9)}, 100000}};
  const std::size_t slash = method.find_first_of("/:");
  for (auto one : known) {
    if (one.word != method.substr(0, slash)) continue;
    if (slash != std::string::npos) {
      const int count = std::atoi(method.c_str() + slash + 1);
      if (count < 1) refuse("method " + method + ": how many?");
      if (method[slash] == '/') one.way.substeps = count;
      one.iterations = method[slash] == '/' ? one.iterations * count : count;
    }
    return one.way.setting(one.iterations);
  }
  refuse("method " + method + ": there is none of this name");
}

std::string tree_methods(const MakeScene& make_scene) {
  std::string accepted;
  for (const std::string method : {"tree", "tree-rk4"}) {
    BenchScene scene = make_scene();
    try {
      setting_named(method).make()(scene.world, real(1) / 60);
      accepted += " " + method;
    } catch (const std::invalid_argument&) {  // a loop, a contact, a soft joint; or a drive
    }
  }
  return accepted;
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

FILE* open_table(const std::string& path, bool append, const std::string& columns) {
  FILE* file = std::fopen(path.c_str(), append ? "a" : "w");
  if (!file) refuse("--csv " + path + ": cannot be written");
  std::fseek(file, 0, SEEK_END);
  if (std::ftell(file) == 0) std::fprintf(file, "%s\n", columns.c_str());
  return file;
}

std::string cell(double number, bool means_something) {
  char text[32] = "";
  if (means_something && !std::isnan(number)) std::snprintf(text, sizeof text, ",%.6g", number);
  return *text ? text : ",";
}

std::string measure_cells(const BenchScene& scene, const Result& result) {
  const bool lost = result.status == "nan";
  return cell(result.gap_rms) + cell(result.gap_max) + cell(result.axis_error, !lost) +
         cell(result.tip_error, scene.tip_mask != glm::dvec3(0) && !lost) +
         cell(result.sideways, scene.forbidden != glm::dvec3(0) && !lost) + "," +
         scene.finding.what + cell(scene.finding.expected, !scene.finding.what.empty()) +
         cell(result.found) + cell(result.energy_drift, std::isfinite(scene.energy_scale));
}

}  // namespace joints::bench
