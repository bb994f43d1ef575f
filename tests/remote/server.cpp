// Answers calls until there are no more. What the answer prints goes where its errors go.
#include "tests/remote/function.h"

#include <csignal>
#include <cstdlib>
#include <map>
#include <unistd.h>

#include "engine/instruments/todo.h"

namespace joints::testing::remote {

namespace {

int from, to;

std::map<std::string, Served>& served() {
  static std::map<std::string, Served> all;
  return all;
}

void answer(Bytes& bytes) {
  Bytes out;
  try {
    const auto key = got<std::vector<char>>(bytes);
    served().at({key.begin(), key.end()})(bytes, out);
    send(to, Kind::result, out.data);
  } catch (const NotDone& error) {
    send(to, Kind::not_done, error.id);
  } catch (const std::exception& error) {
    send(to, Kind::thrown, error.what());
  } catch (...) {
    send(to, Kind::thrown, "Unknown exception");
  }
}

}  // namespace

void serve(const std::string& key, Served function) { served()[key] = std::move(function); }

Bytes ask(const Bytes& question) {
  send(to, Kind::asks, question.data);
  Bytes reply;
  for (Kind kind; receive(from, kind, reply);) {  // it may call another function first
    if (kind == Kind::asks) return reply;
    if (kind == Kind::thrown) throw std::runtime_error(reply.data);
    answer(reply);
  }
  std::_Exit(0);
}

}  // namespace joints::testing::remote

int main() {
  namespace remote = joints::testing::remote;
  remote::from = dup(STDIN_FILENO);
  remote::to = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  close(STDIN_FILENO);
  static char stack[1 << 16];  // for the word that the other one is full
  stack_t other{};
  other.ss_sp = stack;
  other.ss_size = sizeof stack;
  sigaltstack(&other, nullptr);
  struct sigaction action {};
  action.sa_handler = [](int) {};
  action.sa_flags = SA_ONSTACK | int(SA_RESETHAND);
  sigaction(SIGSEGV, &action, nullptr);  // tests/checker/stack.cpp listens
  remote::serve_all();
  joints::Bytes call;
  for (remote::Kind kind; remote::receive(remote::from, kind, call);) remote::answer(call);
  std::_Exit(0);
}
