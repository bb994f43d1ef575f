#include "tests/checker/chosen.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

namespace joints::testing {

int chosen_answer(std::initializer_list<const char*> names) {
  const char* wanted = std::getenv("WORKBOOK_ANSWER");
  if (!wanted) return -1;
  int place = 0;
  for (const char* name : names) {
    if (std::strcmp(name, wanted) == 0) return place;
    ++place;
  }
  std::fprintf(stderr, "no such answer: %s\n", wanted);
  std::exit(97);
}

void no_return(const char* place) {
  throw std::logic_error(std::string("the answer ends without a return: ") + place);
}

}  // namespace joints::testing
