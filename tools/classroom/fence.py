"""Keeps a process, and all that it starts, from writing outside one folder, from the network and
from ending others: Linux's Landlock, which asks for no rights and gives none back."""
import ctypes
import os
import struct
import sys

# System calls, and their numbers on every processor.
CREATE_RULESET, ADD_RULE, RESTRICT_SELF = 444, 445, 446
NO_NEW_PRIVILEGES = 38  # of prctl
WRITE_FILE, TRUNCATE = 1 << 1, 1 << 14
# Write, remove and make files of every kind; Landlock 2 knows moving, 3 cutting off.
WRITING = {1: WRITE_FILE | sum(1 << bit for bit in range(4, 13)), 2: 1 << 13, 3: TRUNCATE}
PATH_BENEATH = 1


def version():
    """Which Landlock this system has; 0: none."""
    if sys.platform != "linux":
        return 0
    return max(0, ctypes.CDLL(None).syscall(CREATE_RULESET, None, ctypes.c_size_t(0), 1))


def close(folder):
    """From now on this process writes only in the folder and to /dev/null. False where the system
    knows no Landlock."""
    known, system = version(), ctypes.CDLL(None, use_errno=True)
    if not known:
        return False
    writing = sum(bits for since, bits in WRITING.items() if since <= known)
    everything = struct.pack("QQQ", writing, 3 if known >= 4 else 0,  # TCP: bind, connect
                             3 if known >= 6 else 0)  # scope: signals, abstract sockets
    rules = checked(system.syscall(CREATE_RULESET, everything, ctypes.c_size_t(24), 0))
    for path, allowed in ((folder, writing), ("/dev/null", writing & (WRITE_FILE | TRUNCATE))):
        opened = os.open(path, os.O_PATH | os.O_CLOEXEC)
        rule = struct.pack("=Qi", allowed, opened)
        checked(system.syscall(ADD_RULE, rules, PATH_BENEATH, rule, 0))
        os.close(opened)
    checked(system.prctl(NO_NEW_PRIVILEGES, 1, 0, 0, 0))
    checked(system.syscall(RESTRICT_SELF, rules, 0))
    os.close(rules)
    return True


def checked(result):
    """The result of a system call that must not fail."""
    if result < 0:
        raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))
    return result
