// What all wrong numbers of a table have in common, case by case: always zero, the sign, a factor,
// what belongs elsewhere. A last resort where no mistake of the table explains them: it says no
// more than what the numbers show, and says it only where they show it in every case.
#pragma once

#include <string>
#include <vector>

#include "checker/samples.h"

namespace joints::testing {

/// Yours and what is right, in one case.
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
