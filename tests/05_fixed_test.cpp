// The tests of chapter 5's exercises. Linked with the solution, with the reader's file, with the
// stub and with every known wrong and right answer.
#include "tests/catch.h"
#include "tests/fixtures.h"
