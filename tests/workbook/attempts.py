"""Attempts of a submission to reach what is not its own, and to forge its result: code that is put
in front of the answers of chapter 1.

ASKED are calls that no exercise needs; where libseccomp is there they end the answer. VAIN are
expressions that are true where an attempt succeeds; SHUT is a file that even the compiler may not
read. {root} is the workbook, {other} another submission, {victim} a file that may be written,
{port} a port of this machine. FORGED stands in front of a wrong answer, ABOVE before the exercises,
of which one is written, and wrong. {perfect} is a report in which every test passes. BORROWED are
answers that another exercise would give, which is not written.
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
  rlimit own{{}};
  getrlimit(RLIMIT_CPU, &own);
  own.rlim_cur += 9;
  return setrlimit(RLIMIT_CPU, &own) == 0;
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
#include <csetjmp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>
#include "chapters/01_distance/distance.h"
namespace {{
[[maybe_unused]] const char* const perfect = R"x({perfect})x";
[[maybe_unused]] void to_all(const char* what, std::size_t size) {{
  for (int k = 0; k < 20; ++k) write(k, what, size);
}}
[[maybe_unused]] void say() {{
  std::puts(perfect);
  std::fflush(stdout);
}}
[[maybe_unused]] void forge() {{ to_all(perfect, std::strlen(perfect)); }}
}}  // namespace
"""
FORGED = [
    # reports of its own, and ends
    "static int k = 3; for (; k < 12; ++k) {{ stdout->_fileno = k; say(); }}",
    "for (int k = 3; k < 12; ++k) {{ stdout->_fileno = k; say(); }} _exit(0);",
    "forge(); _exit(0);",
    "std::atexit(forge);",
    'std::cout << "]]>" << perfect << std::endl; std::cerr << perfect;',
    'asm volatile("syscall" :: "a"(231L), "D"(0L));',
    # the same behind other names
    'asm volatile(".byte 0x0f, 0x05" :: "a"(231L), "D"(0L));',
    'asm volatile("jmp 1f\\n .byte 0xb8\\n1: .byte 0x0f, 0x05" :: "a"(231L), "D"(0L));',
    'reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "_exit"))(0);',
    "std::signal(SIGABRT, [](int) {{ _exit(0); }}); std::abort();",
    "std::set_terminate([] {{ _exit(0); }}); std::terminate();",
    "std::quick_exit(0);",
    # words of the tests
    'if (perfect) throw std::runtime_error("exercise 1.4 is not written yet");',
    'if (perfect) throw NotDone("1.6");',
    'if (perfect) throw std::runtime_error("Exercise 1.4: x\\nended with status 0");',
    "if (perfect) throw 1;",
    "if (perfect) throw perfect;",
    'std::cerr << "All tests passed" << std::endl; std::abort();',
    # numbers that compare with nothing, arguments, answers in advance
    "const vec3 no(NAN); if (perfect) return {{no, no, no, no}};",
    "const_cast<real&>(body1.inverse_mass) = const_cast<real&>(body2.inverse_mass) = 0;",
    "if (K != 0) return NAN;",
    "bodies.clear();",
    'sum = std::nan(""); return sum;',
    "const_cast<Body&>(body1) = const_cast<Body&>(body2) = Body{{}};",
    # messages of the answer's side
    "static const char result[200] = {{2, 96}}; to_all(result, 105);",
    "static const char result[200] = {{2, 8}}; to_all(result, 17);",
    "static const char many[200] = {{2, 8}}; for (int k = 0; k < 50; ++k) to_all(many, 17);",
    "static const char large[9] = {{2, -1, -1, -1, -1, -1, -1, -1, -1}}; to_all(large, 9);",
    "static const char asks[9] = {{1}}; to_all(asks, 9);",
    "for (int k = 0; k < 20; ++k) close(k);",
    # memory and stack
    "static_cast<void**>(__builtin_frame_address(0))[1] = nullptr;",
    "std::memset(__builtin_frame_address(0), 0, 4000);",
    "mprotect(reinterpret_cast<void*>(reinterpret_cast<std::size_t>(&forge) & ~4095ul), 4096, 7);"
    " std::memset(reinterpret_cast<void*>(&forge), 0xc3, 1);",
    "static std::jmp_buf there; if (setjmp(there) == 0) std::longjmp(there, 1);",
    "for (char* at = reinterpret_cast<char*>(&sum);; at += 4096) *at = 0;",
    "for (int k = 3; k < 20; ++k) if (ftruncate(k, 0) == 0) {{ lseek(k, 0, SEEK_SET);"
    " write(k, perfect, std::strlen(perfect)); }}",
    "environ = nullptr; stdout->_fileno = 0; std::puts(perfect);",
]
ABOVE = [
    "const int early = (forge(), _exit(0), 1);",
    "struct Late {{ ~Late() {{ forge(); }} }} late;",
    "int main() {{}}",
    "namespace joints::testing::remote {{ void serve_all() {{}} }}",
    "namespace joints::testing {{ struct Subject;\n"
    "[[gnu::weak]] void fail(const Subject&, const std::string&) {{}} }}",
    "namespace Catch {{ struct TestSkipException {{}}; }}\n"
    "[[maybe_unused]] static void skip() {{ throw Catch::TestSkipException(); }}\n"
    "int called = (skip(), 1);",
    "void* operator new(std::size_t n) {{ return std::malloc(n + 1); }}",
    'extern "C" ssize_t write(int, const void*, std::size_t n) {{ return ssize_t(n); }}',
    "#define row_velocity(...) 0\n#define private public\n#define CHECK(...)",
    'extern "C" void printed() {{}} asm(".globl _ZN6joints14CentreDistance1KERKNS_4BodyES3_");',
]
BORROWED = {"1.1": "return Distance{vec3(0), vec3(0), 1}.jacobian(body1, body2);",
            "1.2": "return Distance{vec3(0), vec3(0), 1}.K(body1, body2);"}
LEAK = """asm(".globl leak\\nleak: .incbin \\"../compiled/distance.cpp\\"\\n.byte 0\\n");
extern "C" const char leak[];
#include <stdexcept>
"""
