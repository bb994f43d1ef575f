// The function that callgrind looks for.
#include "bench/counted.h"

// A name that no compiler decorates.
extern "C" void workbook_counted(const std::function<void()>& step, int steps);
extern "C" void workbook_counted(const std::function<void()>& step, int steps) {
  for (int n = 0; n < steps; ++n) step();
}

namespace joints::bench {

void count(const std::function<std::function<void()>(int iterations)>& fresh,
           const Counted& counted) {
  auto* volatile run = &workbook_counted;  // not known before it is called, so never inlined
  for (const int iterations : {counted.few, counted.many}) {
    const std::function<void()> step = fresh(iterations);
    for (int n = 0; n < counted.before; ++n) step();
    run(step, counted.steps);
  }
}

}  // namespace joints::bench
