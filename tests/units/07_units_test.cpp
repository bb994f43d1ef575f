// Exercises of chapter 7 with numbers that carry units.
#include "chapters/07_performance/performance.h"
#include "tests/units/units.h"
