"""A fence around a command that compiles or runs what somebody has handed in: it reads and writes
only what it is given, has no network, reaches no other process and leaves none behind.

bubblewrap gives it a file system of its own, without anything else in it, and ends all that it has
started. Where there is libseccomp for Python, too, a program that asks the system for something
that no exercise needs is ended at once.
"""
import contextlib
import functools
import os
import shutil
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

try:
    import seccomp
except ImportError:
    seccomp = None

# Libraries, for all; what a compiler needs beside them.
LIBRARIES = ["/usr/lib", "/usr/lib32", "/usr/lib64", "/usr/local/lib", "/lib", "/lib32", "/lib64",
             "/etc/ld.so.cache"]
COMPILER = ["/usr/bin", "/usr/local/bin", "/bin", "/usr/libexec", "/usr/include",
            "/usr/local/include", "/etc/alternatives", *map(str, Path("/usr/share").glob("cmake*"))]
DEVICES = ["/dev/null", "/dev/urandom"]
ENVIRONMENT = {"PATH": "/usr/local/bin:/usr/bin:/bin", "LC_ALL": "C.UTF-8", "CCACHE_DISABLE": "1"}
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
        return self.bubblewrap(list(map(str, words))) if not refusal() else list(map(str, words))

    def bubblewrap(self, words):
        said = ["bwrap", "--unshare-all", "--unshare-user", "--disable-userns", "--uid", "65534",
                "--gid", "65534", "--cap-drop", "ALL", "--die-with-parent", "--new-session",
                "--clearenv"]
        for name, value in {**ENVIRONMENT, "HOME": self.folder, "TMPDIR": self.folder}.items():
            said += ["--setenv", name, value]
        own = LIBRARIES + ([] if self.quiet else COMPILER)
        for path in [path for path in own if os.path.exists(path)] + self.reads:
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


@functools.cache
def refusal():
    """Why there is no fence here; "": there is one."""
    if not shutil.which("bwrap"):
        return "bubblewrap is not installed (./wb setup installs it)"
    tried = subprocess.run(Fence("/", quiet=False).bubblewrap(["true"]), capture_output=True,
                           text=True)
    why = (tried.stderr.strip() or "no word").split("\n")[0]
    return "" if tried.returncode == 0 else f"bubblewrap cannot make a fence here ({why})"


def warning():
    """What the teacher must know of a fence that is not whole; "": nothing."""
    if refusal():
        return (f"{refusal()}: nothing keeps a submission from reading and writing where you may, "
                "from the network and from your processes, also from those that grade. Grade only "
                "what you trust.")
    return "" if seccomp else (
        "python3-seccomp is not installed (./wb setup installs it). Without it, answers that start "
        "processes are not named in the feedback.")


# ---- libseccomp ----------------------------------------------------------------------------------

@functools.cache
def rules_file():
    """A file in the form that bubblewrap reads, beside the graded one: a process that makes a
    system call that is never needed is ended with SIGSYS."""
    found = seccomp.SyscallFilter(seccomp.ALLOW)
    for name in NEVER:  # this processor may not have it, or the library be older than it
        with contextlib.suppress(RuntimeError, ValueError, OSError):
            found.add_rule(seccomp.KILL_PROCESS, name)
    path = os.path.join(os.environ.get("TMPDIR", "/tmp"), f"seccomp_{os.getpid()}")
    with open(path, "wb") as file:
        found.export_bpf(file)
    return path
