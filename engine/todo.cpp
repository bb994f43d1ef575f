// The one throw of the exercises.
#include "engine/todo.h"

namespace joints {

void todo(const char* id) { throw NotDone(id); }

}  // namespace joints
