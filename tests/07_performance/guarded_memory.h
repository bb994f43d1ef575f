// The heap of chapter 7's tests: memory that was never set holds bits of one's choice, and behind
// each piece lies a strip that nobody may write to. Included by one file of a program.
#pragma once

#include <cstdlib>
#include <cstring>
#include <new>

namespace joints::testing {

inline unsigned char memory_fill = 0;   ///< what new memory holds
inline bool memory_is_broken = false;   ///< was something written behind the end of a piece?

inline constexpr std::size_t memory_head = 32;    ///< before a piece [bytes]
inline constexpr std::size_t memory_strip = 256;  ///< behind it [bytes]

}  // namespace joints::testing

void* operator new(std::size_t size) {
  using namespace joints::testing;
  char* const memory = static_cast<char*>(std::malloc(memory_head + size + memory_strip));
  if (!memory) throw std::bad_alloc();
  std::memcpy(memory, &size, sizeof size);
  std::memset(memory + memory_head, memory_fill, size);
  std::memset(memory + memory_head + size, 0, memory_strip);
  return memory + memory_head;
}
// Not inlined: g++ would take the free() for one that fits no operator new.
[[gnu::noinline]] void operator delete(void* pointer) noexcept {
  using namespace joints::testing;
  if (!pointer) return;
  char* const memory = static_cast<char*>(pointer) - memory_head;
  std::size_t size;
  std::memcpy(&size, memory, sizeof size);
  for (std::size_t n = 0; n < memory_strip; ++n)
    if (memory[memory_head + size + n] != 0) memory_is_broken = true;
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* pointer, std::size_t) noexcept {
  operator delete(pointer);
}
