// Runs scenes of the live page in a native program: live_digits STEPS runs all and prints where
// their bodies are, and the page's module has to print the same; live_digits --state ADDRESS runs
// one to the state of an address (docs/live/README.md) and prints what the page reads there.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "docs/live/run.h"

namespace {

using namespace joints::live;

void print_bodies(int steps) {
  for (const Entry& entry : entries()) {
    LiveRun run(entry);
    run.set(run.settings());
    for (int k = 0; k < steps; ++k) run.step();
    std::printf("%s", entry.name);
    for (std::size_t k = 0; k < run.scene().shapes.size(); ++k) {
      const joints::Body& b = run.scene().world.bodies.at(int(k));
      for (const joints::real x : {b.x.x, b.x.y, b.x.z, b.q.w, b.q.x, b.q.y, b.q.z})
        std::printf(" %.17g", double(x));
    }
    for (const double error : run.errors(10)) std::printf(" %.17g", error);
    std::printf(" %.17g\n", run.rate(1000));
  }
}

// What an address names: "scene=chain&beta=2.1&t=3".
std::map<std::string, std::string> parts_of(const std::string& address) {
  std::map<std::string, std::string> parts;
  std::istringstream in(address);
  for (std::string part; std::getline(in, part, '&');) {
    const std::size_t at = part.find('=');
    if (at == std::string::npos) throw std::invalid_argument(part + ": no value");
    parts[part.substr(0, at)] = part.substr(at + 1);
  }
  return parts;
}

// A number of the address, which is then done with.
double taken(std::map<std::string, std::string>& parts, const char* name, double otherwise) {
  const auto found = parts.find(name);
  if (found == parts.end()) return otherwise;
  const double value = std::stod(found->second);
  parts.erase(found);
  return value;
}

double largest_error(LiveRun& run, int iterations, int blocks) {
  double largest = 0;
  for (const JointLook& joint : run.look(iterations, blocks))
    largest = std::max(largest, joint.error);
  return largest;
}

void print_state(const std::string& address) {
  auto parts = parts_of(address);
  const std::string scene = parts["scene"];
  parts.erase("scene");
  const auto entry = std::find_if(entries().begin(), entries().end(), [&](const Entry& each) {
    return each.name == scene;
  });
  if (entry == entries().end()) throw std::invalid_argument("there is no scene " + scene);
  PageSettings settings = LiveRun(*entry).settings();
  double* value = &settings.beta;
  for (const char* name : setting_names) {
    *value = taken(parts, name, *value);
    ++value;
  }
  const double t = taken(parts, "t", 0), iteration = taken(parts, "iteration", -1);
  const double block = taken(parts, "block", 0);
  parts.erase("view");
  if (!parts.empty()) throw std::invalid_argument("the page knows no " + parts.begin()->first);
  LiveRun run(*entry, settings.ratio);
  run.set(settings);
  for (long k = std::lround(t / settings.h); k > 0; --k) run.step();
  std::printf("t %.17g\ngap %.17g\nenergy %.17g\n", run.time(), run.gap(), run.energy());
  if (iteration >= 0)
    std::printf("error %.17g\nfirst_error %.17g\n",
                largest_error(run, int(iteration), int(block)), largest_error(run, 0, 0));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3 || std::strcmp(arguments[1], "--state") != 0) {
    print_bodies(std::atoi(arguments[1]));
    return 0;
  }
  try {
    print_state(arguments[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
