// Starts the process of the answer, WORKBOOK_ANSWERER, and tells how it has ended.
#include "tests/remote/function.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#include <unordered_map>

#include "engine/instruments/todo.h"

namespace joints::testing::remote {

namespace {

/// The process, as long as it lives.
struct Answerer {
  int to = -1, from = -1;
  pid_t process = -1;
  std::FILE* words = std::tmpfile();  // what it prints

  void start() {
    int there[2], back[2];
    if (!words || pipe(there) != 0 || pipe(back) != 0) throw std::runtime_error("no pipe");
    process = fork();
    if (process == 0) {
      dup2(there[0], 0);
      dup2(back[1], 1);
      dup2(fileno(words), 2);
      for (int end = 3; end < 1024; ++end) close(end);  // the report is one of them
      execl("/bin/sh", "sh", "-c", std::getenv("WORKBOOK_ANSWERER"), nullptr);
      _exit(1);
    }
    close(there[0]);
    close(back[1]);
    to = there[1];
    from = back[0];
    std::signal(SIGPIPE, SIG_IGN);
  }

  /// Its last words, and the status with which it has ended. What was too late has been ended here.
  std::string end(bool late) {
    close(to);
    close(from);
    int status = 0;
    for (int tries = 0; waitpid(process, &status, WNOHANG) == 0; ++tries) {
      usleep(10000);
      if (tries == 50) kill(process, SIGKILL);  // it has closed its end and lives on
    }
    process = -1;
    char last[4000];
    const long size = lseek(fileno(words), 0, SEEK_END);
    const ssize_t count = pread(fileno(words), last, sizeof last,
                                std::max(0L, size - long(sizeof last)));
    const int code = late                  ? -SIGALRM
                     : WIFSIGNALED(status) ? -WTERMSIG(status)
                                           : WEXITSTATUS(status);
    return std::string(last, std::size_t(std::max<ssize_t>(0, count))) + "\nended with status " +
           std::to_string(code);
  }
};

}  // namespace

void exchange(const std::string& id, const std::string& key, Bytes& arguments,
              const Asked& asked) {
  static Answerer answerer;
  static std::map<std::string, std::string> ended;  // a function that has ended it is left alone
  if (ended.contains(key)) throw std::runtime_error(ended[key]);
  static std::unordered_map<std::string, std::string> known;  // reports ask again and again
  const std::string question = key + arguments.data;
  if (const auto found = known.find(question); found != known.end() && !asked) {
    arguments = {found->second};
    return;
  }
  if (answerer.process < 0) answerer.start();
  Bytes call;
  put(call, std::vector<char>(key.begin(), key.end()));
  pollfd back{answerer.from, POLLIN, 0};
  const bool early = poll(&back, 1, 0) > 0 && (back.revents & POLLIN);  // it was not asked
  if (early) kill(answerer.process, SIGKILL);
  if (!early) send(answerer.to, Kind::call, call.data + arguments.data);
  static const int patience = std::atoi(std::getenv("WORKBOOK_PATIENCE"));  // it may sleep [ms]
  bool late = false;
  for (Kind kind; !early && !(late = poll(&back, 1, patience) == 0) &&
                  receive(answerer.from, kind, arguments);) {
    if (kind == Kind::result) {
      if (known.size() > 100000) known.clear();
      known[question] = arguments.data;
      return;
    }
    const std::string words = arguments.data.substr(0, 4000);
    if (kind == Kind::not_done) throw NotDone(words);
    if (kind == Kind::thrown) throw std::runtime_error("Exercise " + id + ": " + words);
    if (kind != Kind::asks || !asked) break;
    Bytes reply;
    try {
      asked(arguments, reply);
      send(answerer.to, Kind::asks, reply.data);
    } catch (const std::exception& error) {
      send(answerer.to, Kind::thrown, error.what());
    }
  }
  ended[key] = "Exercise " + id + ": " + answerer.end(late);
  throw std::runtime_error(ended[key]);
}

}  // namespace joints::testing::remote
