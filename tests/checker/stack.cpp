// Tells a stack that is full from other crashes: both end in the same signal, and only the address
// differs. Catch2 asks the system to be told of crashes; here it is asked first.
#include <features.h>
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#include <csignal>
#include <cstdint>
#include <sys/resource.h>
#include <unistd.h>

extern "C" int __sigaction(int, const struct sigaction*, struct sigaction*);  // glibc's own

namespace {

void (*told_next)(int);
const char* const stack_begin = static_cast<char*>(__builtin_frame_address(0));

void crashed(int signal, siginfo_t* info, void*) {
  rlimit most{};
  getrlimit(RLIMIT_STACK, &most);
  const auto depth = reinterpret_cast<std::intptr_t>(stack_begin) -
                     reinterpret_cast<std::intptr_t>(info->si_addr);
  const auto limit = static_cast<std::intptr_t>(most.rlim_cur), slack = std::intptr_t{1} << 20;
  if (depth > limit - slack && depth < 2 * limit) {
    constexpr char words[] = "the stack is full\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, words, sizeof words - 1);
  }
  told_next(signal);
}

}  // namespace

extern "C" int sigaction(int signal, const struct sigaction* action, struct sigaction* before) {
  const bool asks = signal == SIGSEGV && action && !(action->sa_flags & SA_SIGINFO) &&
                    action->sa_handler != SIG_DFL && action->sa_handler != SIG_IGN;
  if (!asks) return __sigaction(signal, action, before);
  told_next = action->sa_handler;
  struct sigaction own = *action;
  own.sa_flags |= SA_SIGINFO;
  own.sa_sigaction = crashed;
  return __sigaction(signal, &own, before);
}
#endif
