// Preloaded into kempe by faults_test.py: brings a fault to exactly one moment of a run.
//
//   KEMPE_FAULT=kill|full|readonly|broken  what happens ...
//   KEMPE_FAULT_AT=N                       ... at the N-th call that changes a file, counted from 1
//   KEMPE_FAULT_COUNT=FILE                 at the end the number of such calls is written to FILE
//   KEMPE_FAULT_SLOW_RENAME_MS=N           every rename waits so long: two runs are sure to meet
//   KEMPE_FAULT_CLOCK=jumps|leaps          the calendar jumps by years, or the steady clock leaps ahead by hours
//   KEMPE_FAULT_THREADS=N                  no more than N threads can be made
//   KEMPE_FAULT_LOCALE=1                   the program obeys the environment's locale, as a host program might ask for

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <locale>
#include <string_view>

namespace {

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

std::string_view setting(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

long number(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? 0 : std::atol(value);
}

std::atomic<long> calls{0};

/// Counts a call that changes a file. True from the chosen moment on: a full disk stays full.
bool struck() {
  const long at = number("KEMPE_FAULT_AT"), now = ++calls;
  return at > 0 && now >= at;
}

/// What the chosen fault does to a call: ends the program, or gives the errno to fail with.
int fault() {
  const std::string_view what = setting("KEMPE_FAULT");
  if (what == "kill") {
    raise(SIGKILL);
    pause();
  }
  return what == "full" ? ENOSPC : what == "readonly" ? EROFS : EIO;
}

int failure(int error) {
  errno = error;
  return -1;
}

struct AtTheStart {
  AtTheStart() {
    if (setting("KEMPE_FAULT_LOCALE").empty()) return;
    if (std::setlocale(LC_ALL, "") == nullptr) std::abort();
    std::locale::global(std::locale(""));
  }
};
const AtTheStart at_the_start;

struct AtTheEnd {
  ~AtTheEnd() {
    const char* path = std::getenv("KEMPE_FAULT_COUNT");
    if (path == nullptr) return;
    if (std::FILE* file = std::fopen(path, "w")) {
      std::fprintf(file, "%ld\n", calls.load());
      std::fclose(file);
    }
  }
};
const AtTheEnd at_the_end;

}  // namespace

extern "C" {

ssize_t write(int file, const void* data, size_t size) {
  static const auto next = real<ssize_t(int, const void*, size_t)>("write");
  if (file <= STDERR_FILENO || !struck()) return next(file, data, size);
  // Half of it reaches the disk: the worst that can happen.
  if (setting("KEMPE_FAULT") == "kill") (void)next(file, data, size / 2);
  return failure(fault());
}

int mkstemps(char* pattern, int suffix) {
  static const auto next = real<int(char*, int)>("mkstemps");
  return struck() ? failure(fault()) : next(pattern, suffix);
}

int open(const char* path, int flags, ...) {
  static const auto next = real<int(const char*, int, ...)>("open");
  mode_t mode = 0;
  if ((flags & O_CREAT) != 0) {
    va_list arguments;
    va_start(arguments, flags);
    mode = va_arg(arguments, mode_t);
    va_end(arguments);
    if (struck()) return failure(fault());
  }
  return next(path, flags, mode);
}

int mkdir(const char* path, mode_t mode) {
  static const auto next = real<int(const char*, mode_t)>("mkdir");
  return struck() ? failure(fault()) : next(path, mode);
}

int rename(const char* from, const char* to) {
  static const auto next = real<int(const char*, const char*)>("rename");
  if (const long wait = number("KEMPE_FAULT_SLOW_RENAME_MS"); wait > 0)
    usleep(static_cast<useconds_t>(1000 * wait));
  return struck() ? failure(fault()) : next(from, to);
}

int fsync(int file) {
  static const auto next = real<int(int)>("fsync");
  return struck() ? failure(fault()) : next(file);
}

int fdatasync(int file) {
  static const auto next = real<int(int)>("fdatasync");
  return struck() ? failure(fault()) : next(file);
}

int fchmod(int file, mode_t mode) {
  static const auto next = real<int(int, mode_t)>("fchmod");
  return struck() ? failure(fault()) : next(file, mode);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  static const auto next =
      real<int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create");
  static std::atomic<long> made{0};
  if (!setting("KEMPE_FAULT_THREADS").empty() && made++ >= number("KEMPE_FAULT_THREADS")) return EAGAIN;
  return next(thread, attributes, run, argument);
}

int clock_gettime(clockid_t clock, timespec* now) {
  static const auto next = real<int(clockid_t, timespec*)>("clock_gettime");
  static std::atomic<unsigned> asked{0};
  const int result = next(clock, now);
  const std::string_view what = setting("KEMPE_FAULT_CLOCK");
  if (what.empty() || result != 0) return result;
  const unsigned time = ++asked;
  if (clock == CLOCK_MONOTONIC && what == "leaps") now->tv_sec += 3600L * time;
  if (clock == CLOCK_REALTIME && what == "jumps")
    now->tv_sec += (time % 2 == 0 ? -1 : 1) * 30'000'000L * (time % 7);
  return result;
}

int gettimeofday(timeval* __restrict now, void* __restrict) {
  timespec exact{};
  const int result = clock_gettime(CLOCK_REALTIME, &exact);
  now->tv_sec = exact.tv_sec;
  now->tv_usec = static_cast<suseconds_t>(exact.tv_nsec / 1000);
  return result;
}

time_t time(time_t* stored) {
  timespec exact{};
  clock_gettime(CLOCK_REALTIME, &exact);
  if (stored != nullptr) *stored = exact.tv_sec;
  return exact.tv_sec;
}

}  // extern "C"
