// Preloaded into work_queue_worker: it makes the process group of each task too late, when the task has
// become another program. That happens by itself now and then on a busy machine. What a process does to its
// own group is done.
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

extern "C" __attribute__((visibility("default"))) int setpgid(pid_t process, pid_t group) noexcept {
    if (process != 0) {
        errno = EACCES;
        return -1;
    }
    return static_cast<int>(::syscall(SYS_setpgid, process, group));
}
