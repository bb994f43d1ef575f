#include "tests/checker/known.h"

#include <stdexcept>

namespace joints::testing {

static std::vector<Known>& remembered() {
  static std::vector<Known> all;
  return all;
}

void Known::remember(const Known& one) { remembered().push_back(one); }
std::vector<const Known*> Known::of(const std::string& id, int region,
                                    const std::type_info& type, bool slip) {
  std::vector<const Known*> out;
  for (const Known& one : remembered()) {
    if (one.id != id || one.region != region || one.slip != slip) continue;
    if (*one.type != type) throw std::logic_error("a mistake of another type");
    out.push_back(&one);
  }
  return out;
}

}  // namespace joints::testing
