// Options and errors of the programs.
#include "engine/instruments/options.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "engine/real.h"
#include "engine/instruments/todo.h"

namespace joints {

Options::Options(std::string program, std::vector<Option> known)
    : program_(std::move(program)), known_(std::move(known)) {
  known_.push_back({"out", "out", "folder for tables and motion"});
}

bool Options::read(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--help" || word == "-h") {
      std::printf("%s\n", program_.c_str());
      for (const Option& option : known_)
        std::printf("  --%-12s %s%s\n", option.name.c_str(), option.help.c_str(),
                    option.value.empty() ? "" : (" (" + option.value + ")").c_str());
      return false;
    }
    bool found = false;
    for (Option& option : known_) {
      if (word != "--" + option.name) continue;
      found = true;
      const bool alone = i + 1 >= argc || std::string_view(argv[i + 1]).starts_with("--");
      if (alone && !option.help.starts_with("1: ")) refuse(word + ": needs a value");
      option.value = alone ? "1" : argv[++i];
    }
    if (!found) refuse(word + ": unknown option (--help lists them)");
  }
  return true;
}

std::string Options::text(const std::string& name) const {
  for (const Option& option : known_)
    if (option.name == name) return option.value;
  refuse("--" + name + ": this program has no such option");
}

double Options::number(const std::string& name, double least) const {
  const std::string value = text(name);
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  if (value.empty() || *end != '\0' || !std::isfinite(number) || number < least) {
    char bound[32];
    std::snprintf(bound, sizeof bound, "%g", least);
    refuse("--" + name + " " + value + ": must be a number of at least " + bound);
  }
  return number;
}

int Options::count(const std::string& name, int least) const {
  const double number = this->number(name, least);
  if (number != std::floor(number) || number > 1e6)
    refuse("--" + name + " " + text(name) + ": must be a whole number up to a million");
  return int(number);
}

bool Options::flag(const std::string& name) const {
  const std::string value = text(name);
  if (value != "0" && value != "1") refuse("--" + name + " " + value + ": must be 0 or 1");
  return value == "1";
}

int run_program(const std::function<void()>& body) {
  try {
    body();
    return 0;
  } catch (const NotDone& not_done) {
    std::fprintf(stderr, "%s\n", not_done.what());
    return 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  }
}

}  // namespace joints
