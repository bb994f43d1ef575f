#include "tests/checker/proved.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

namespace joints::testing {

namespace {

struct Counts {
  std::map<std::string, long> of;
  ~Counts() {
    const char* name = std::getenv("WORKBOOK_COUNTS");
    if (!name) return;
    std::FILE* const file = std::fopen(name, "a");
    if (!file) return;
    for (const auto& [what, number] : of) std::fprintf(file, "%s %ld\n", what.c_str(), number);
    std::fclose(file);
  }
};

}  // namespace

void proved(const char* what, long how_many) {
  static Counts counts;
  counts.of[what] += how_many;
}

}  // namespace joints::testing
