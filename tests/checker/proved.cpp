#include "tests/checker/proved.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

namespace joints::testing {

namespace {

struct Counts {
  std::map<std::string, long> of;
  ~Counts() {
    const char* name = std::getenv("WORKBOOK_COUNTS");
    if (!name) return;
    std::ofstream file(name, std::ios::app);
    for (const auto& [what, number] : of) file << what << ' ' << number << '\n';
  }
};

}  // namespace

void proved(const char* what, long how_many) {
  static Counts counts;
  counts.of[what] += how_many;
}

}  // namespace joints::testing
