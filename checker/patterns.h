// The pattern that all wrong numbers of a table have in common, case by case: always zero, the
// sign, a factor, the value of another entry. A last resort if no mistake of the table explains
// them. It reports only patterns that the numbers show in every case.
#pragma once

#include <string>
#include <vector>

#include "checker/samples.h"

namespace joints::testing {

/// Your numbers and the right ones, in one case.
struct Compared {
  Numbers yours, right;
};

/// In words; "" where the wrong entries have nothing in common. \param entries what each is called
/// \param whole only what holds for all entries at once
std::string common_pattern(const std::vector<std::string>& entries,
                           const std::vector<Compared>& cases, double tolerance,
                           bool whole = false);

/// Are yours right, but for what a float among doubles loses? In words; "" where they are not.
std::string seven_digits(const std::vector<Compared>& cases);

/// "r1.x, r1.y, r1.z, r2.x" as "r1, r2.x"; of a long list only the first ones.
std::string listed(const std::vector<std::string>& names);

}  // namespace joints::testing
