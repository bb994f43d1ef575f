// Every allocation of a program that asks for them goes through here, counted while `counting`.
#include "tests/oracle/allocations.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

bool joints::testing::counting = false;
long joints::testing::allocations = 0;

namespace {

void* allocate(std::size_t size, std::size_t alignment) {
  if (joints::testing::counting) ++joints::testing::allocations;
  const std::size_t pieces = (std::max(size, std::size_t(1)) + alignment - 1) / alignment;
  return alignment <= alignof(std::max_align_t) ? std::malloc(pieces * alignment)
                                                : std::aligned_alloc(alignment, pieces * alignment);
}
void* allocate_or_throw(std::size_t size, std::size_t alignment) {
  if (void* memory = allocate(size, alignment)) return memory;
  throw std::bad_alloc();
}
// Not inlined: g++ would take the free() in operator delete for one that fits no operator new.
[[gnu::noinline]] void release(void* memory) { std::free(memory); }
constexpr std::size_t usual = alignof(std::max_align_t);

}  // namespace

void* operator new(std::size_t n) { return allocate_or_throw(n, usual); }
void* operator new[](std::size_t n) { return allocate_or_throw(n, usual); }
void* operator new(std::size_t n, std::align_val_t a) {
  return allocate_or_throw(n, std::size_t(a));
}
void* operator new[](std::size_t n, std::align_val_t a) {
  return allocate_or_throw(n, std::size_t(a));
}
void* operator new(std::size_t n, const std::nothrow_t&) noexcept { return allocate(n, usual); }
void* operator new[](std::size_t n, const std::nothrow_t&) noexcept { return allocate(n, usual); }
void operator delete(void* p) noexcept { release(p); }
void operator delete[](void* p) noexcept { release(p); }
void operator delete(void* p, std::size_t) noexcept { release(p); }
void operator delete[](void* p, std::size_t) noexcept { release(p); }
void operator delete(void* p, std::align_val_t) noexcept { release(p); }
void operator delete[](void* p, std::align_val_t) noexcept { release(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { release(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { release(p); }

