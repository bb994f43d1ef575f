"""Attempts of a submission to reach what is not its own, and to forge its result: code that is put
in front of the answers of chapter 1.

ASKED are calls that no exercise needs; where libseccomp is there they end the tests. VAIN are
expressions that are true where an attempt succeeds; SHUT is a file that even the compiler may not
read. {root} is the workbook, {other} another submission, {victim} a file that may be written,
{port} a port of this machine. FORGED stands in front of a wrong answer, ABOVE before the exercises,
of which one is written, and wrong; each has words of its feedback. {perfect} is a report in which
every test passes.
"""

HEAD = """#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <dirent.h>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <netinet/in.h>
#include <string>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <utime.h>
#include <arpa/inet.h>
#include <sys/un.h>
namespace {{
[[maybe_unused]] bool reads(const char* path) {{
  std::ifstream file(path);
  std::string words;
  while (file >> words) std::puts(words.c_str());
  return !words.empty();
}}
[[maybe_unused]] bool writes(const char* path) {{ return bool(std::ofstream(path) << 1); }}
[[maybe_unused]] bool sends(int kind) {{
  const int own = socket(AF_INET, kind, 0);
  sockaddr_in to{{}};
  to.sin_family = AF_INET;
  to.sin_port = htons({port});
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return connect(own, (sockaddr*)&to, sizeof to) == 0 && send(own, "hello", 5, 0) == 5;
}}
[[maybe_unused]] bool fills() {{
  bool any = false;
  for (int k = 0; k < 20; ++k) any |= writes(("fill_" + std::to_string(k)).c_str());
  return any;
}}
[[maybe_unused]] bool raises_limit() {{
  rlimit all{{RLIM_INFINITY, RLIM_INFINITY}};
  return getuid() != 0 && setrlimit(RLIMIT_CPU, &all) == 0;
}}
}}  // namespace
"""

ASKED = [
    "for (int k = 0; k < 150; ++k) if (fork() == 0) for (;;) pause();",
    'std::system("sleep 1000");',
    'if (!popen("sleep 1000", "r")) std::puts("none");',
    "setsid();",
    "kill(getppid(), SIGKILL);",
    "kill(-1, SIGKILL);",
    'chmod("{victim}", 0777);',
    "sends(SOCK_DGRAM);",
    "sends(SOCK_STREAM);",
    "socket(AF_UNIX, SOCK_STREAM, 0);",
    "std::thread([] {{ sleep(1000); }}).detach();",
    'unlink("{victim}");',
    'rename("{victim}", "{victim}.old");',
    'mkdir("{root}/new_folder", 0777);',
    'memfd_create("memory", 0);',
    "shmget(IPC_PRIVATE, 1 << 28, IPC_CREAT | 0600);",
    "ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr);",
    'symlink("{victim}", "link");',
]

VAIN = [
    'reads("/etc/passwd")',
    'reads("{root}/solutions/01_distance/distance.cpp")',
    'reads("{root}/solutions/01_distance/answers.md")',
    'reads("{other}")',
    'reads("{root}/tools/wb.py")',
    'reads("/proc/self/environ")',
    'opendir("{root}/solutions") != nullptr || opendir("{root}/tests") != nullptr',
    'std::getenv("WORKBOOK_SECRET") != nullptr',
    'writes("{victim}")',
    'writes("{root}/new_file")',
    'writes("/tmp/workbook_attempt")',
    'writes("/dev/shm/workbook_attempt")',
    'writes("chapters/01_distance/distance.cpp")',
    "fills()",
    "raises_limit()",
    'execl("{root}/wb", "wb", "help", nullptr) == 0',
]

SHUT = {
    '#include "{root}/solutions/01_distance/distance.cpp"': "is no part of an exercise",
    '#include "../../solutions/01_distance/distance.cpp"': "is no part of an exercise",
    '#include "{other}"': "is no part of an exercise",
    '#define FROM "{root}/solutions/01_distance/distance.cpp"\n#include FROM':
        "what counts are the given lines",
    'asm(".incbin \\"{root}/solutions/01_distance/distance.cpp\\"");':
        "added outside the exercises was left out",
    'asm(".incbin \\"/etc/passwd\\"");': "added outside the exercises was left out",
}

FORGER = """#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <unistd.h>
#include "chapters/01_distance/distance.h"
namespace {{
[[maybe_unused]] const char* const perfect = R"x({perfect})x";
[[maybe_unused]] const char* report() {{  // argv[5]
  const char* name = program_invocation_name;
  for (int k = 0; k < 5; ++k) name += std::strlen(name) + 1;
  return name;
}}
[[maybe_unused]] void forge() {{ std::ofstream(report()) << perfect; }}
}}  // namespace
"""
FORGED = [
    ("forge(); _exit(0);",
     "it calls _exit, program_invocation_name, std::basic_ofstream"),
    ("for (int k = 3; k < 20; ++k) write(k, perfect, std::strlen(perfect)); _exit(0);",
     "it calls _exit, write"),
    ('asm volatile("syscall" :: "a"(231L), "D"(0L));', "it calls the system"),
    ("std::atexit(forge);", "it calls atexit"),
    ("std::set_terminate([] {{ std::abort(); }}); throw 1;", "it calls std::set_terminate"),
    ('reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "_exit"))(0);', "it calls dlsym"),
    ('if (perfect) throw std::runtime_error("exercise 1.4 is not written yet");',
     "throws that exercise 1.4 is not written yet, which is not so"),
    ("const_cast<real&>(body1.inverse_mass) = const_cast<real&>(body2.inverse_mass) = 0;",
     "Exercise 1.2: K of a rod"),
    ("if (K != 0) return NAN;", "Exercise 1.3: the impulse of a row"),
    ('std::cout << "]]>" << perfect << std::endl; std::cerr << perfect;',
     "Exercise 1.4: the step"),
    ("sum = std::nan(\"\"); return sum;", "Exercise 1.5: the clamped sum"),
    ("std::signal(SIGABRT, [](int) {{ _exit(0); }}); std::abort();", "it calls _exit, signal"),
]
ABOVE = {
    "const int early = (forge(), _exit(0), 1);": "left out. It was not run: it calls",
    "struct Late {{ ~Late() {{ forge(); }} }} late;": "left out. It was not run: it calls",
    "int main() {{}}": "multiple definition of",
    "namespace joints::testing {{ struct Subject;\n"
    "[[gnu::weak]] void fail(const Subject&, const std::string&) {{}} }}":
        "it defines joints::testing::fail",
    "namespace Catch {{ struct TestSkipException {{}}; }}\n"
    "[[maybe_unused]] static void skip() {{ throw Catch::TestSkipException(); }}\n"
    "int called = (skip(), 1);": "it defines Catch::TestSkipException",
    "void* operator new(std::size_t n) {{ return std::malloc(n); }}": "it defines operator new",
    "#define row_velocity(...) 0\n#define private public\n#define CHECK(...)":
        "what counts are the given lines",
}
