// How often a call takes memory from the heap. The counting operators stand in allocations.cpp.
#pragma once

namespace joints::testing {

extern bool counting;     ///< count what is allocated from now on
extern long allocations;  ///< counted so far

template <class Call>
long allocations_of(Call call) {
  allocations = 0;
  counting = true;
  call();
  counting = false;
  return allocations;
}

}  // namespace joints::testing
