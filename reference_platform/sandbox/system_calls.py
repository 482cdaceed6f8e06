"""The filter of system calls, which libseccomp compiles for the kernel.

A call that is not named here does not exist for a policy (ENOSYS); so it is with those
that later kernels add. Calls that no policy needs and that attack the kernel, the host
or other processes kill their process, so that its end names them; programs that ask
whether a call exists are not killed for it.
"""

from __future__ import annotations

import ctypes
import errno
import os
import socket
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager

from reference_platform.sandbox.sandbox_interface import SandboxUnavailable
from reference_record.this_machine import temporary_folder

_ALLOW = 0x7FFF0000
_KILL_PROCESS = 0x80000000
_ERRNO = 0x00050000
_BAD_ARCHITECTURE_ACTION = 2  # enum scmp_filter_attr
_EQUAL, _MASKED_EQUAL = 4, 7  # enum scmp_compare
# CLONE_NEWNS, CGROUP, UTS, IPC, USER, PID, NET and TIME: no new namespaces.
_NEW_NAMESPACES = 0x7E020080
_FAMILIES = (socket.AF_UNIX, socket.AF_INET, socket.AF_INET6)

_KILLED = """
acct add_key adjtimex bpf chroot clock_adjtime clock_settime delete_module finit_module
fsconfig fsmount fsopen fspick init_module ioperm iopl kcmp kexec_file_load kexec_load
keyctl lookup_dcookie mount mount_setattr move_mount open_by_handle_at open_tree
perf_event_open pidfd_getfd pivot_root process_madvise process_vm_readv
process_vm_writev ptrace quotactl reboot request_key setdomainname sethostname setns
settimeofday swapoff swapon syslog umount2 unshare userfaultfd
"""

_ALLOWED = """
accept accept4 access alarm arch_prctl bind brk capget capset chdir chmod chown
clock_getres clock_gettime clock_nanosleep close close_range connect copy_file_range
creat dup dup2 dup3 epoll_create epoll_create1 epoll_ctl epoll_pwait epoll_pwait2
epoll_wait eventfd eventfd2 execve execveat exit exit_group faccessat faccessat2
fadvise64 fallocate fchdir fchmod fchmodat fchmodat2 fchown fchownat fcntl fdatasync
fgetxattr flistxattr flock fork fremovexattr fsetxattr fstat fstatfs fsync ftruncate
futex futex_waitv futimesat get_mempolicy get_robust_list get_thread_area getcpu getcwd
getdents getdents64 getegid geteuid getgid getgroups getitimer getpeername getpgid
getpgrp getpid getppid getpriority getrandom getresgid getresuid getrlimit getrusage
getsid getsockname getsockopt gettid gettimeofday getuid getxattr inotify_add_watch
inotify_init inotify_init1 inotify_rm_watch io_cancel io_destroy io_getevents io_setup
io_submit ioctl ioprio_get ioprio_set kill landlock_add_rule landlock_create_ruleset
landlock_restrict_self lchown lgetxattr link linkat listen listxattr llistxattr
lremovexattr lseek lsetxattr lstat madvise mbind membarrier memfd_create mincore mkdir
mkdirat mknod mknodat mlock mlock2 mlockall mmap mprotect mq_getsetattr mq_notify
mq_open mq_timedreceive mq_timedsend mq_unlink mremap msgctl msgget msgrcv msgsnd msync
munlock munlockall munmap nanosleep newfstatat open openat openat2 pause pidfd_open
pidfd_send_signal pipe pipe2 pkey_alloc pkey_free pkey_mprotect poll ppoll prctl pread64
preadv preadv2 prlimit64 pselect6 pwrite64 pwritev pwritev2 read readahead readlink
readlinkat readv recvfrom recvmmsg recvmsg removexattr rename renameat renameat2
restart_syscall rmdir rseq rt_sigaction rt_sigpending rt_sigprocmask rt_sigqueueinfo
rt_sigreturn rt_sigsuspend rt_sigtimedwait rt_tgsigqueueinfo sched_get_priority_max
sched_get_priority_min sched_getaffinity sched_getattr sched_getparam
sched_getscheduler sched_rr_get_interval sched_setaffinity sched_setattr sched_setparam
sched_setscheduler sched_yield seccomp select semctl semget semop semtimedop sendfile
sendmmsg sendmsg sendto set_mempolicy set_robust_list set_thread_area set_tid_address
setfsgid setfsuid setgid setgroups setitimer setpgid setpriority setregid setresgid
setresuid setreuid setrlimit setsid setsockopt setuid setxattr shmat shmctl shmdt shmget
shutdown sigaltstack signalfd signalfd4 socketpair splice stat statfs statx symlink
symlinkat sync_file_range sysinfo tee tgkill time timer_create timer_delete
timer_getoverrun timer_gettime timer_settime timerfd_create timerfd_gettime
timerfd_settime times tkill truncate umask uname unlink unlinkat utime utimensat utimes
vfork wait4 waitid write writev
"""


class _Comparison(ctypes.Structure):
    """struct scmp_arg_cmp: argument, operator, and what it is compared with."""

    _fields_ = (
        ("arg", ctypes.c_uint),
        ("op", ctypes.c_int),
        ("datum_a", ctypes.c_uint64),
        ("datum_b", ctypes.c_uint64),
    )


@contextmanager
def compiled_filter() -> Iterator[int]:
    """A file descriptor from which bubblewrap reads the filter.

    Raises SandboxUnavailable.
    """
    try:
        library = ctypes.CDLL("libseccomp.so.2")
    except OSError as error:
        raise SandboxUnavailable(
            "libseccomp.so.2 is missing. Install it (Debian: apt-get install "
            "libseccomp2)."
        ) from error
    library.seccomp_init.restype = ctypes.c_void_p
    context = ctypes.c_void_p(library.seccomp_init(_ERRNO | errno.ENOSYS))
    try:
        _add_rules(library, context)
        with tempfile.TemporaryFile(dir=temporary_folder()) as file:
            _check(library.seccomp_export_bpf(context, file.fileno()))
            os.lseek(file.fileno(), 0, os.SEEK_SET)
            yield file.fileno()
    finally:
        library.seccomp_release(context)


def _add_rules(library: ctypes.CDLL, context: ctypes.c_void_p) -> None:
    def add(action: int, name: str, *compared: tuple[int, int, int, int]) -> None:
        number = library.seccomp_syscall_resolve_name(name.encode())
        if number < 0:  # not on this architecture, or newer than the library
            return
        rules = (_Comparison * len(compared))(*(_Comparison(*c) for c in compared))
        _check(
            library.seccomp_rule_add_array(
                context, ctypes.c_uint32(action), number, len(compared), rules
            )
        )

    _check(
        library.seccomp_attr_set(
            context, _BAD_ARCHITECTURE_ACTION, ctypes.c_uint32(_KILL_PROCESS)
        )
    )
    for name in _ALLOWED.split():
        add(_ALLOW, name)
    for name in _KILLED.split():
        add(_KILL_PROCESS, name)
    for family in _FAMILIES:
        add(_ALLOW, "socket", (0, _EQUAL, family, 0))
    # `clone3` has its flags in memory, where no filter can read them. It does not
    # exist here, and C libraries fall back to `clone`.
    add(_ALLOW, "clone", (0, _MASKED_EQUAL, _NEW_NAMESPACES, 0))
    for persona in (0, 0x0008, 0xFFFFFFFF):  # the usual one, 32 bits, and a question
        add(_ALLOW, "personality", (0, _EQUAL, persona, 0))


def _check(status: int) -> None:
    if status < 0:
        raise SandboxUnavailable(
            f"libseccomp refuses the filter of system calls: {os.strerror(-status)}."
        )
