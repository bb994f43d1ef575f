// Writes the numbers of bodies and joints to a State, or reads them from it. The variables are
// listed once for both directions.
#pragma once

#include <array>
#include <vector>

#include "engine/joint.h"

/// \addtogroup world
/// @{
namespace joints {

/// Writes variables to a list of numbers, or reads them from one. A class lists its variables once,
/// for both directions. When reading, it rejects numbers that cannot have been written.
/// \throws std::invalid_argument for a number that is not finite, or a bool that is not 0 or 1
class StateStream {
 public:
  /// Appends the variables to `out`.
  explicit StateStream(std::vector<real>& out) : out_(&out) {}
  /// Sets the variables to the numbers from `in` on; there must be enough.
  explicit StateStream(const real* in) : in_(in) {}

  /// Writes or reads each variable in turn: real, bool, vec3, quat, or a std::array of these.
  template <class... Variables>
  void operator()(Variables&... variables) {
    (carry(variables), ...);
  }
  /// Writes or reads a bound, which may be infinite.
  void bound(real& x) {
    if (out_) return out_->push_back(x);
    require(*in_ == *in_, "state: holds a bound that is not a number");
    x = *in_++;
  }

 private:
  void carry(real& x) {
    require(out_ || finite(*in_), "state: holds a number that is not finite");
    bound(x);
  }
  void carry(bool& x) {
    real number = x;
    bound(number);
    require(number == 0 || number == 1, "state: holds a truth value that is neither 0 nor 1");
    x = number == 1;
  }
  void carry(vec3& a) { (*this)(a.x, a.y, a.z); }
  void carry(quat& q) { (*this)(q.w, q.x, q.y, q.z); }
  template <class T, std::size_t N>
  void carry(std::array<T, N>& all) {
    for (T& one : all) carry(one);
  }

  std::vector<real>* out_ = nullptr;
  const real* in_ = nullptr;
};

/// Writes or reads all data that a joint keeps from step to step.
inline void serialize(Joint& joint, StateStream& stream) {
  stream(joint.h_, joint.impulse_duration_, joint.can_move_);
  require(joint.h_ >= 0 && joint.impulse_duration_ >= 0, "state: holds a step of negative length");
  joint.serialize(stream);
}

}  // namespace joints
/// @}
