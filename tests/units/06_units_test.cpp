// Chapter 6 with numbers that carry units.
#include "chapters/06_baumgarte/baumgarte.h"
