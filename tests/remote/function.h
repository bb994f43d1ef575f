// A function of an exercise file: called on the side of the tests, served on that of the answer.
#pragma once

#include <functional>
#include <typeinfo>

#include "tests/remote/wire.h"

namespace joints::testing::remote {

// ---- the side of the tests (client.cpp) ---------------------------------------------------------

/// What an answer may ask for while it is called: reads its question and writes the reply.
using Asked = std::function<void(Bytes& question, Bytes& reply)>;

/// Calls a function of the answer. Throws what it throws, or how its process has ended.
/// \param id its exercise \param arguments are replaced by what comes back
void exchange(const std::string& id, const std::string& key, Bytes& arguments,
              const Asked& asked);

// ---- the side of the answer (server.cpp) --------------------------------------------------------

/// Calls a function: reads its arguments, writes those that may have changed and the result.
using Served = std::function<void(Bytes& arguments, Bytes& result)>;
void serve(const std::string& key, Served function);
/// Serves the functions of the chapter's exercise file. Made by tools/classroom/remote.py.
void serve_all();
/// Asks the tests in the middle of a call; returns the reply.
Bytes ask(const Bytes& question);

// ---- both ---------------------------------------------------------------------------------------

/// True of an argument that a call may change.
template <class Argument>
constexpr bool is_changed =
    std::is_lvalue_reference_v<Argument> && !std::is_const_v<std::remove_reference_t<Argument>>;

template <class Signature>
struct Function;
/// Of arguments that are values. Its key is its name with their types.
template <class Result, class... Arguments>
struct Function<Result(Arguments...)> {
  static std::string key(const std::string& name) {
    return name + " " + typeid(Result(Arguments...)).name();
  }

  static Result call(const std::string& id, const std::string& name, const Asked& asked,
                     Arguments... arguments) {
    Bytes bytes;
    (put(bytes, arguments), ...);
    exchange(id, key(name), bytes, asked);
    ((is_changed<Arguments> ? get(bytes, const_cast<std::remove_cvref_t<Arguments>&>(arguments))
                            : void()), ...);
    if constexpr (!std::is_void_v<Result>) return got<Result>(bytes);
  }

  template <class Call>
  static void serve(const std::string& name, Call call) {
    remote::serve(key(name), [call](Bytes& bytes, Bytes& out) {
      std::tuple<std::remove_cvref_t<Arguments>...> all;
      std::apply([&](auto&... one) { (get(bytes, one), ...); }, all);
      const auto changed = [&](auto&... one) {
        ((is_changed<Arguments> ? put(out, one) : void()), ...);
      };
      if constexpr (std::is_void_v<Result>) {
        std::apply(call, all);
        std::apply(changed, all);
      } else {
        const Result result = std::apply(call, all);
        std::apply(changed, all);
        put(out, result);
      }
    });
  }
};

}  // namespace joints::testing::remote
