#include "chapters/08_ground/program/program.h"

namespace joints::chapter8 {

void bridge(const Choice&, std::vector<Summary>&) {}

}  // namespace joints::chapter8
