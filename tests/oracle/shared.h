// What several of the workbook's own tests ask: what was refused, how far a J is from its slope.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "tests/checker/check.h"

namespace joints::testing {

// What the refusal of a call says; "accepted" where there was none.
template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

// The largest difference of a part's J and the slope of its C.
template <class Part>
double slope_error(const Part& part, const Body& a, const Body& b) {
  const Numbers yours = flat(to_jacobian(part.jacobian(a, b)));
  const Numbers slope = flat(numeric_jacobian(part, a, b));
  double worst = 0;
  for (std::size_t i = 0; i < slope.size(); ++i)
    worst = std::max(worst, std::abs(yours[i] - slope[i]));
  return worst;
}

}  // namespace joints::testing
