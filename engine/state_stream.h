// Carries the numbers of bodies and joints out into a State, or back in: one way to name them.
#pragma once

#include <array>
#include <vector>

#include "engine/real.h"

/// \addtogroup world
/// @{
namespace joints {

/// Carries variables out to a list of numbers, or sets them to the numbers of one: whoever has
/// variables names them once, for both directions.
class StateStream {
 public:
  /// Appends the variables to `out`.
  explicit StateStream(std::vector<real>& out) : out_(&out) {}
  /// Sets the variables to the numbers from `in` on; there must be enough.
  explicit StateStream(const real* in) : in_(in) {}

  /// Each in turn: real, bool, int (below 2^24), vec3, quat, or a std::array of these.
  template <class... Variables>
  void operator()(Variables&... variables) {
    (carry(variables), ...);
  }

 private:
  void carry(real& x) { out_ ? out_->push_back(x) : void(x = *in_++); }
  void carry(bool& x) { out_ ? out_->push_back(x) : void(x = *in_++ != 0); }
  void carry(int& x) { out_ ? out_->push_back(real(x)) : void(x = int(*in_++)); }
  void carry(vec3& a) { (*this)(a.x, a.y, a.z); }
  void carry(quat& q) { (*this)(q.w, q.x, q.y, q.z); }
  template <class T, std::size_t N>
  void carry(std::array<T, N>& all) {
    for (T& one : all) carry(one);
  }

  std::vector<real>* out_ = nullptr;
  const real* in_ = nullptr;
};

}  // namespace joints
/// @}
