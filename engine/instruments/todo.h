// todo(): the placeholder of an exercise that has not been written yet.
#pragma once

#include <stdexcept>
#include <string>

#ifndef JOINTS_LIBRARY  // programs that link the library have no exercises
/// \addtogroup joint
/// @{
namespace joints {

/// Thrown by an exercise that has not been written yet.
struct NotDone : std::logic_error {
  std::string id;  ///< the exercise, such as "2.1"
  /// Of an exercise. \param id the exercise
  explicit NotDone(const std::string& id)
      : std::logic_error("exercise " + id + " is not written yet"), id(id) {}
};

/// Placeholder: replace it with your code. \throws NotDone always
[[noreturn]] inline void todo(const char* id) { throw NotDone(id); }

}  // namespace joints
/// @}
#endif
