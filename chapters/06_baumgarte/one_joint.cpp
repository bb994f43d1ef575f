#include "chapters/06_baumgarte/program.h"
namespace joints::chapter6 {
void one_joint(const Options6&, std::vector<Summary>&) {}
}  // namespace joints::chapter6
