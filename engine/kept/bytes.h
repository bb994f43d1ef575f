// Values as bytes, one after the other: to be kept, or sent to another process.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

/// \addtogroup world
/// @{
namespace joints {

/// Values as bytes, in sequence.
struct Bytes {
  std::string data{};  ///< the bytes
  std::size_t at = 0;  ///< of the next that is read

  /// Appends `size` bytes.
  void write(const void* from, std::size_t size) {
    data.append(static_cast<const char*>(from), size);
  }
  /// Takes the next `size` bytes. \throws std::invalid_argument if there are fewer
  void read(void* to, std::size_t size) {
    if (size > data.size() - at) throw std::invalid_argument("the bytes end too early");
    data.copy(static_cast<char*>(to), size, at);
    at += size;
  }
};

/// True for vectors of whatever type.
template <class T>
constexpr bool is_vector = false;
template <class T>
constexpr bool is_vector<std::vector<T>> = true;

/// Appends a value: numbers and structs of them, vectors of any depth, and structs whose parts a
/// function `members` of their namespace returns.
template <class T>
void put(Bytes& bytes, const T& value) {
  if constexpr (is_vector<T>) {
    put(bytes, value.size());
    for (const typename T::value_type& one : value) put(bytes, one);
  } else if constexpr (requires(T& whole) { members(whole); }) {
    std::apply([&](auto&... part) { (put(bytes, part), ...); }, members(const_cast<T&>(value)));
  } else {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
    bytes.write(&value, sizeof value);
  }
}

/// Reads what put() has written.
template <class T>
void get(Bytes& bytes, T& value) {
  if constexpr (is_vector<T>) {
    std::size_t count = 0;
    get(bytes, count);
    value.clear();
    while (count-- > 0) {
      typename T::value_type one{};
      get(bytes, one);
      value.push_back(one);
    }
  } else if constexpr (requires { members(value); }) {
    std::apply([&](auto&... part) { (get(bytes, part), ...); }, members(value));
  } else {
    bytes.read(&value, sizeof value);
  }
}
/// The next value, as get() reads it.
template <class T>
T got(Bytes& bytes) {
  T value{};
  get(bytes, value);
  return value;
}

}  // namespace joints
/// @}
