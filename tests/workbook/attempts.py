"""Attempts of a submission to reach what is not its own: code that is put in front of the answers
of chapter 1.

ASKED are calls that no exercise needs; where libseccomp is there they end the tests. VAIN are
expressions that are true where an attempt succeeds; SHUT is a file that even the compiler may not
read. {root} is the workbook, {other} another submission, {victim} a file that may be written,
{port} a port of this machine.
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

# A call, and its word that the feedback names.
ASKED = {
    "for (int k = 0; k < 150; ++k) if (fork() == 0) for (;;) pause();": "fork",
    'std::system("sleep 1000");': "system",
    'if (!popen("sleep 1000", "r")) std::puts("none");': "popen",
    "setsid();": "setsid",
    "kill(getppid(), SIGKILL);": "kill",
    "kill(-1, SIGKILL);": "kill",
    'chmod("{victim}", 0777);': "chmod",
    "sends(SOCK_DGRAM);": "socket",
    "sends(SOCK_STREAM);": "socket",
    "socket(AF_UNIX, SOCK_STREAM, 0);": "socket",
    "std::thread([] {{ sleep(1000); }}).detach();": "thread",
    'unlink("{victim}");': "unlink",
    'rename("{victim}", "{victim}.old");': "rename",
    'mkdir("{root}/new_folder", 0777);': "mkdir",
    'memfd_create("memory", 0);': "memfd_create",
    "shmget(IPC_PRIVATE, 1 << 28, IPC_CREAT | 0600);": "shmget",
    "ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr);": "ptrace",
    'symlink("{victim}", "link");': "symlink",
}

# True where it succeeds, and a word of it that the feedback names.
VAIN = {
    'reads("/etc/passwd")': "etc/passwd",
    'reads("{root}/solutions/01_distance/distance.cpp")': "",
    'reads("{root}/solutions/01_distance/answers.md")': "",
    'reads("{other}")': "",
    'reads("{root}/tools/wb.py")': "",
    'reads("/proc/self/environ")': "",
    'opendir("{root}") != nullptr && readdir(opendir("{root}/solutions")) != nullptr': "opendir",
    'std::getenv("WORKBOOK_SECRET") != nullptr': "getenv",
    'writes("{victim}")': "ofstream",
    'writes("{root}/new_file")': "",
    'writes("/tmp/workbook_attempt")': "",
    'writes("/dev/shm/workbook_attempt")': "",
    'writes("chapters/01_distance/distance.cpp")': "",
    "fills()": "",
    "raises_limit()": "setrlimit",
    'execl("{root}/wb", "wb", "help", nullptr) == 0': "execl",
}

SHUT = {
    '#include "{root}/solutions/01_distance/distance.cpp"': "is no part of an exercise",
    '#include "../../solutions/01_distance/distance.cpp"': "is no part of an exercise",
    '#include "{other}"': "is no part of an exercise",
    '#define FROM "{root}/solutions/01_distance/distance.cpp"\n#include FROM':
        "given lines were put in its place",
    'asm(".incbin \\"{root}/solutions/01_distance/distance.cpp\\"");':
        "given lines were put in its place",
    'asm(".incbin \\"/etc/passwd\\"");': "given lines were put in its place",
}
