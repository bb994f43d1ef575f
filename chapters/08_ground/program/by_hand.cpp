#include "chapters/08_ground/program/program.h"

namespace joints::chapter8 {

void by_hand(const Choice&) {}

}  // namespace joints::chapter8
