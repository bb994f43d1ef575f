// Chapter 9's program.
#include "chapters/09_direct/direct_solver.h"

int main() { joints::DirectSolver().check(); }
