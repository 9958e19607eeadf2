/* Faults that no limit of the system makes, for programs that are started with LD_PRELOAD. FAULT
   names one: "clock" (the time of day jumps by years), "proc" (nothing below /proc can be opened),
   "threads" (none can be started), "kill" (SIGKILL before a file is renamed), "interrupt" (SIGINT
   in the middle of a copy) or "read" (the first large read() makes the file "reading" and waits
   until that is removed). Without it, nothing changes. */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/sendfile.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#define ORIGINAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static int has_fault(const char* name) {
  const char* fault = getenv("FAULT");
  return fault != NULL && strcmp(fault, name) == 0;
}

static int is_denied(const char* path) {
  if (path == NULL || strncmp(path, "/proc", 5) != 0 || !has_fault("proc")) return 0;
  errno = EACCES;
  return 1;
}

/* Forwards and backwards, by two years. */
static time_t jump(void) {
  static atomic_int calls;
  return has_fault("clock") ? (atomic_fetch_add(&calls, 1) % 2 == 0 ? 1 : -1) * 63072000L : 0;
}

int clock_gettime(clockid_t clock, struct timespec* time) {
  const int status = ORIGINAL(clock_gettime)(clock, time);
  if (status == 0 && clock == CLOCK_REALTIME) time->tv_sec += jump();
  return status;
}

int gettimeofday(struct timeval* restrict now, void* restrict zone) {
  const int status = ORIGINAL(gettimeofday)(now, zone);
  if (status == 0) now->tv_sec += jump();
  return status;
}

time_t time(time_t* to) {
  const time_t now = ORIGINAL(time)(NULL) + jump();
  if (to != NULL) *to = now;
  return now;
}

int pthread_create(pthread_t* restrict thread, const pthread_attr_t* restrict attributes,
                   void* (*start)(void*), void* restrict argument) {
  if (has_fault("threads")) return EAGAIN;
  return ORIGINAL(pthread_create)(thread, attributes, start, argument);
}

static mode_t mode_of(int flags, va_list more) {
  return (flags & (O_CREAT | __O_TMPFILE)) != 0 ? va_arg(more, mode_t) : 0;
}

#define OPEN(name)                                                   \
  int name(const char* path, int flags, ...) {                       \
    va_list more;                                                    \
    va_start(more, flags);                                           \
    const mode_t mode = mode_of(flags, more);                        \
    va_end(more);                                                    \
    return is_denied(path) ? -1 : ORIGINAL(name)(path, flags, mode); \
  }
OPEN(open)
OPEN(open64)

#define FOPEN(name)                                                  \
  FILE* name(const char* restrict path, const char* restrict mode) { \
    return is_denied(path) ? NULL : ORIGINAL(name)(path, mode);      \
  }
FOPEN(fopen)
FOPEN(fopen64)

DIR* opendir(const char* path) {
  return is_denied(path) ? NULL : ORIGINAL(opendir)(path);
}

ssize_t readlink(const char* restrict path, char* restrict to, size_t size) {
  return is_denied(path) ? -1 : ORIGINAL(readlink)(path, to, size);
}

ssize_t read(int from, void* to, size_t count) {
  const ssize_t got = ORIGINAL(read)(from, to, count);
  static atomic_int reads;
  if (count > 1000000 && has_fault("read") && atomic_fetch_add(&reads, 1) == 0) {
    close(ORIGINAL(open)("reading", O_CREAT | O_WRONLY, 0666));
    while (access("reading", F_OK) == 0) usleep(1000);
  }
  return got;
}

/* A process that is killed when its result is complete but has not its name. */
int rename(const char* from, const char* to) {
  if (has_fault("kill")) raise(SIGKILL);
  return ORIGINAL(rename)(from, to);
}

/* Half of it is copied. */
ssize_t sendfile(int to, int from, off_t* offset, size_t count) {
  const int interrupts = has_fault("interrupt");
  const ssize_t copied = ORIGINAL(sendfile)(to, from, offset, interrupts ? count / 2 : count);
  if (interrupts) raise(SIGINT);
  return copied;
}
