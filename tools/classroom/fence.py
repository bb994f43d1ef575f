"""A fence around a command that compiles or runs what somebody has handed in: it reads and writes
only what it is given, has no network, reaches no other process and leaves none behind.

bubblewrap gives it a file system of its own, without anything else in it, and ends all that it has
started. Where there is none, this file runs the command itself under Linux's Landlock:
fence.py FENCE COMMAND, with the fence in JSON. Where there is libseccomp for Python, tests that ask
the system for something that no exercise needs are ended at once, in both.
"""
import ctypes
import functools
import json
import os
import resource
import shutil
import signal
import struct
import subprocess
import sys
from dataclasses import asdict, dataclass, field
from pathlib import Path

try:
    import seccomp
except ImportError:
    seccomp = None

BUBBLEWRAP, LANDLOCK, NONE = "bubblewrap", "landlock", "none"
# Libraries, for all; what a compiler needs beside them.
LIBRARIES = ["/usr/lib", "/usr/lib32", "/usr/lib64", "/usr/local/lib", "/lib", "/lib32", "/lib64",
             "/etc/ld.so.cache"]
COMPILER = ["/usr/bin", "/usr/local/bin", "/bin", "/usr/libexec", "/usr/include",
            "/usr/local/include", "/etc/alternatives", *map(str, Path("/usr/share").glob("cmake*"))]
DEVICES = ["/dev/null", "/dev/urandom"]
ENVIRONMENT = {"PATH": "/usr/local/bin:/usr/bin:/bin", "LC_ALL": "C.UTF-8", "CCACHE_DISABLE": "1"}
PROCESSES = 100  # more than there are, at most, where only a limit keeps their number small
# What tests of an exercise never ask the system for: processes and threads, the network, signals to
# others, files' names and modes, memory that counts for nobody, more rights.
NEVER = """fork vfork clone clone3 execveat setsid setpgid kill tkill ptrace process_vm_readv
process_vm_writev pidfd_open pidfd_send_signal socket socketpair chmod fchmod fchmodat fchmodat2
chown fchown lchown fchownat utime utimes utimensat futimesat setxattr truncate rename renameat
renameat2 link linkat symlink symlinkat unlink unlinkat mkdir mkdirat rmdir mknod mknodat
memfd_create memfd_secret shmget msgget semget mq_open userfaultfd io_uring_setup mount umount2
move_mount fsopen open_tree pivot_root chroot unshare setns setuid setgid setresuid setresgid bpf
perf_event_open add_key request_key keyctl inotify_init inotify_init1 fanotify_init setpriority
sched_setscheduler sched_setattr personality""".split()


@dataclass
class Fence:
    """What a command may see. The folder is where it runs."""
    folder: str
    reads: list = field(default_factory=list)   # files and folders
    writes: list = field(default_factory=list)  # these it may also change
    quiet: bool = True                          # asks for nothing of NEVER

    def around(self, words):
        """The command line of a command within the fence."""
        words, which = list(map(str, words)), kind()
        if which == BUBBLEWRAP:
            return self.bubblewrap(words)
        if which == LANDLOCK:
            return [sys.executable, "-IB", __file__, json.dumps(asdict(self)), *words]
        return words

    def bubblewrap(self, words):
        said = ["bwrap", "--unshare-all", "--unshare-user", "--disable-userns", "--uid", "65534",
                "--gid", "65534", "--cap-drop", "ALL", "--die-with-parent", "--new-session",
                "--clearenv"]
        for name, value in self.environment().items():
            said += ["--setenv", name, value]
        for path in self.all_reads():
            said += ["--symlink", os.readlink(path), path] if os.path.islink(path) else \
                ["--ro-bind", path, path]
        for path in self.writes:
            said += ["--bind", path, path]
        for path in DEVICES:
            said += ["--dev-bind", path, path]
        said += ["--remount-ro", "/", "--chdir", self.folder]
        if self.quiet and seccomp:
            return ["sh", "-c", 'exec "$@" 9<"$0"', rules_file(), *said, "--seccomp", "9", *words]
        return [*said, *words]

    def environment(self):
        return ENVIRONMENT | {"HOME": self.folder, "TMPDIR": self.folder,
                              "WORKBOOK_SEED": os.environ.get("WORKBOOK_SEED", "1")}

    def all_reads(self):
        own = LIBRARIES + ([] if self.quiet else COMPILER)
        return [path for path in own if os.path.exists(path)] + self.reads

    def close(self):
        """From now on this process is within the fence, as far as Landlock goes."""
        most = resource.getrlimit(resource.RLIMIT_NPROC)[1]
        count = tasks() + PROCESSES
        resource.setrlimit(resource.RLIMIT_NPROC, 2 * (
            count if most == resource.RLIM_INFINITY else min(count, most),))
        landlock(self.all_reads(), self.writes)
        if self.quiet and seccomp:
            rules().load()


# ---- which one -----------------------------------------------------------------------------------

@functools.cache
def kind():
    """The fence of this system."""
    if not refusal():
        return BUBBLEWRAP
    return LANDLOCK if version() else NONE


@functools.cache
def refusal():
    """Why bubblewrap cannot be used here; "": it can."""
    if "WORKBOOK_NO_BUBBLEWRAP" in os.environ:
        return "bubblewrap is switched off (WORKBOOK_NO_BUBBLEWRAP)"
    if not shutil.which("bwrap"):
        return "bubblewrap is not installed (./wb setup installs it)"
    tried = subprocess.run(Fence("/", quiet=False).bubblewrap(["true"]), capture_output=True,
                           text=True)
    why = (tried.stderr.strip() or "no word").split("\n")[0]
    return "" if tried.returncode == 0 else f"bubblewrap cannot make a fence here ({why})"


def warning():
    """What the teacher must know of a fence that is not whole; "": nothing."""
    ask = "" if seccomp else "python3-seccomp is not installed (./wb setup installs it). "
    if kind() == BUBBLEWRAP:
        return ask and ask + "Without it, tests that start processes are not named in the feedback."
    if kind() == LANDLOCK:
        words = f"{refusal()}. Landlock keeps a submission from reading and writing other files"
        words += ", from TCP" * (version() >= 4)
        words += ", from signals to other processes" * (version() >= 6)
        if seccomp:
            return f"{words}, and libseccomp from processes and the network of any kind."
        return (f"{words}, but neither from UDP nor from starting processes. {ask}Grade only what "
                "you trust, or grade in a container.")
    return (f"{refusal()}, and this system has no Landlock (Linux 5.13 and newer have it): nothing "
            "keeps a submission from reading and writing where you may, from the network and from "
            "your processes. Grade only what you trust, or grade in a container.")


# ---- libseccomp ----------------------------------------------------------------------------------

def rules():
    """A process that makes a system call that is never needed is ended with SIGSYS."""
    found = seccomp.SyscallFilter(seccomp.ALLOW)
    for name in NEVER:
        try:
            found.add_rule(seccomp.KILL_PROCESS, name)
        except (RuntimeError, ValueError, OSError):
            pass  # this processor has no such call, or the library is older than it
    return found


@functools.cache
def rules_file():
    """The rules in the form that bubblewrap reads, beside the graded file."""
    path = os.path.join(os.environ.get("TMPDIR", "/tmp"), f"seccomp_{os.getpid()}")
    with open(path, "wb") as file:
        rules().export_bpf(file)
    return path


# ---- Landlock ------------------------------------------------------------------------------------

# System calls, and their numbers on every processor.
CREATE_RULESET, ADD_RULE, RESTRICT_SELF = 444, 445, 446
NO_NEW_PRIVILEGES, ADOPT = 38, 36  # of prctl
EXECUTE, WRITE_FILE, READ_FILE, READ_DIR, TRUNCATE = 1 << 0, 1 << 1, 1 << 2, 1 << 3, 1 << 14
READING = EXECUTE | READ_FILE | READ_DIR
OF_FILES = EXECUTE | WRITE_FILE | READ_FILE | TRUNCATE
# Write, remove and make files of every kind; Landlock 2 knows moving, 3 cutting off.
WRITING = {1: WRITE_FILE | sum(1 << bit for bit in range(4, 13)), 2: 1 << 13, 3: TRUNCATE}
PATH_BENEATH = 1


def version():
    """Which Landlock this system has; 0: none."""
    if sys.platform != "linux":
        return 0
    return max(0, ctypes.CDLL(None).syscall(CREATE_RULESET, None, ctypes.c_size_t(0), 1))


def landlock(reads, writes):
    """From now on this process reads and writes only there, and uses the devices."""
    known, system = version(), ctypes.CDLL(None, use_errno=True)
    writing = sum(bits for since, bits in WRITING.items() if since <= known)
    everything = struct.pack("QQQ", READING | writing, 3 if known >= 4 else 0,  # TCP: bind, connect
                             3 if known >= 6 else 0)  # scope: signals, abstract sockets
    rules_ = checked(system.syscall(CREATE_RULESET, everything, ctypes.c_size_t(24), 0))
    for paths, allowed in ((reads, READING), (writes, READING | writing),
                           (DEVICES, READ_FILE | writing & (WRITE_FILE | TRUNCATE))):
        for path in paths:
            opened = os.open(path, os.O_PATH | os.O_CLOEXEC)
            bits = allowed if os.path.isdir(path) else allowed & OF_FILES
            checked(system.syscall(ADD_RULE, rules_, PATH_BENEATH,
                                   struct.pack("=Qi", bits, opened), 0))
            os.close(opened)
    checked(system.prctl(NO_NEW_PRIVILEGES, 1, 0, 0, 0))
    checked(system.syscall(RESTRICT_SELF, rules_, 0))
    os.close(rules_)


def checked(result):
    """The result of a system call that must not fail."""
    if result < 0:
        raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))
    return result


def tasks():
    """How many processes and threads of this user there are."""
    count = 0
    for entry in os.scandir("/proc"):
        try:
            if entry.name.isdigit() and entry.stat().st_uid == os.getuid():
                count += len(os.listdir(f"/proc/{entry.name}/task"))
        except OSError:
            pass  # it has just ended
    return count


# ---- what is left --------------------------------------------------------------------------------

def adopt():
    """From now on a process that a submission leaves running becomes a child of this process."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(ADOPT, 1, 0, 0, 0)


def end_children():
    """Ends what has become a child of this process, and its children, until there are none. No
    process of its own may run meanwhile."""
    while sys.platform == "linux" and (left := [
            int(number) for path in Path("/proc/self/task").glob("*/children")
            for number in path.read_text().split()]):
        for number in left:
            os.kill(number, signal.SIGKILL)
            os.waitpid(number, 0)


if __name__ == "__main__":
    fence = Fence(**json.loads(sys.argv[1]))
    for name in set(os.environ) - set(fence.environment()):
        del os.environ[name]
    os.environ.update(fence.environment())
    os.chdir(fence.folder)
    fence.close()
    os.execvp(sys.argv[2], sys.argv[2:])
