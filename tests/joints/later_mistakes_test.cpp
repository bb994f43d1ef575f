// The usual mistakes that the tests of chapters 5 to 8 know: each is found out, and called by its
// name.
#include "tests/05_fixed/break_cases.h"
#include "tests/05_fixed/cross_cases.h"
#include "tests/05_fixed/load_cases.h"
#include "tests/checker/named.h"

using namespace joints;
using namespace joints::testing;

namespace {

template <class Case>
void is_sound(const CaseTable<Case>& table) {
  each_is_named(table);
  none_is_blamed(table);
}

}  // namespace

TEST_CASE("each usual mistake of chapter 5 is found out and called by its name") {
  is_sound(cross_table());
  is_sound(load_table());
  is_sound(about_table());
  is_sound(break_table());
}
