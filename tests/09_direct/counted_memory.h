// The heap of chapter 9's tests: a loop without an end that asks for memory again and again,
// or for more and more, is stopped. While pieces are counted none is given back: a loop over a set
// that erases from it does not crash. Included by one file of a program.
#pragma once

#include <cstdlib>
#include <new>

namespace joints::testing {

struct Endless {};  ///< thrown out of a loop without an end

inline long allocations_left = -1;  ///< so many pieces of memory are allowed; -1: any number
inline constexpr std::size_t largest_piece = 1 << 21;  ///< while they are counted [bytes]

}  // namespace joints::testing

void* operator new(std::size_t size) {
  using namespace joints::testing;
  if (allocations_left >= 0 && (allocations_left-- == 0 || size > largest_piece)) {
    allocations_left = -1;
    throw Endless{};
  }
  void* const memory = std::malloc(size);
  if (!memory) throw std::bad_alloc();
  return memory;
}
// Not inlined: g++ would take the free() for one that fits no operator new.
[[gnu::noinline]] void operator delete(void* pointer) noexcept {
  if (joints::testing::allocations_left < 0) std::free(pointer);
}
[[gnu::noinline]] void operator delete(void* pointer, std::size_t) noexcept {
  operator delete(pointer);
}
