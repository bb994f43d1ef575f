// The units of chapter 9's exercises.
#include "chapters/09_direct/direct.h"
#include "tests/checker/units.h"
