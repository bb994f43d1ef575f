// What a table holds of each of its lambdas: a call without its type. Tables have hundreds of them;
// the compiler writes two small functions for each here, and for each std::function a dozen.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace joints::testing {

template <class Signature>
class Call;

/// Copies share what was captured: it is not changed by a call.
template <class Result, class... Arguments>
class Call<Result(Arguments...)> {
 public:
  Call() = default;
  /// \param function a lambda, or a plain function
  template <class Function>
  Call(Function function) {
    if constexpr (std::is_empty_v<Function> && std::is_default_constructible_v<Function>) {
      run_ = &Call::anew<Function>;
    } else {
      run_ = &Call::held<Function>;
      captured_ = {static_cast<void*>(new Function(std::move(function))), &Call::end<Function>};
    }
  }
  Result operator()(Arguments... arguments) const {
    return run_(captured_.get(), static_cast<Arguments&&>(arguments)...);
  }
  explicit operator bool() const { return run_; }

 private:
  // Calls a lambda without captures, which is made anew.
  template <class Function>
  static Result anew(const void*, Arguments... arguments) {
    return Function()(static_cast<Arguments&&>(arguments)...);
  }
  template <class Function>
  static Result held(const void* function, Arguments... arguments) {
    return (*static_cast<const Function*>(function))(static_cast<Arguments&&>(arguments)...);
  }
  template <class Function>
  static void end(void* function) {
    delete static_cast<Function*>(function);
  }

  Result (*run_)(const void* captured, Arguments...) = nullptr;
  std::shared_ptr<const void> captured_;
};

}  // namespace joints::testing
