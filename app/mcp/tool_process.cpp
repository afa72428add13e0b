#include "app/mcp/tool_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

#include "app/command.hpp"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define KEMPE_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define KEMPE_SANITIZED 1
#endif
#endif

namespace kempe::app {
namespace {

[[maybe_unused]] constexpr rlim_t most_memory = rlim_t{4} << 30;  // bytes
constexpr rlim_t largest_file = rlim_t{256} << 20;                // bytes
constexpr std::size_t longest_output = 1u << 20;                  // bytes of each stream, the rest is dropped
constexpr std::chrono::seconds time_to_obey{3};

void limit(int resource, rlim_t most) {
  rlimit now{};
  if (::getrlimit(static_cast<decltype(RLIMIT_DATA)>(resource), &now) != 0) return;
  now.rlim_cur = std::min(now.rlim_max, most);
  now.rlim_max = now.rlim_cur;
  ::setrlimit(static_cast<decltype(RLIMIT_DATA)>(resource), &now);
}

void set_limits() {
#ifndef KEMPE_SANITIZED  // a sanitiser's own memory is larger
  limit(RLIMIT_DATA, most_memory);
#endif
  limit(RLIMIT_FSIZE, largest_file);
  limit(RLIMIT_CORE, 0);
}

/// The new process: its streams, its limits, its work.
[[noreturn]] void work_apart(const std::function<int()>& work, int out, int error, pid_t server) {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // it does not outlive the server
  if (::getppid() != server) ::_exit(interrupted);
#else
  static_cast<void>(server);
#endif
  std::signal(SIGPIPE, SIG_DFL);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(error, STDERR_FILENO);
  for (const int file : {nothing, out, error})
    if (file > STDERR_FILENO) ::close(file);
  set_limits();
  int code = failed;
  try {
    code = work();
  } catch (const std::exception& fault) {
    code = fail_told(failed, std::string("internal error: ") + fault.what());
  }
  std::fflush(stdout);
  std::fflush(stderr);
  ::_exit(code);
}

/// Takes what is there of a stream; at its end closes it.
void take(int& file, std::string& all, bool& cut) {
  if (file < 0) return;
  pollfd waiting{file, POLLIN, 0};
  if (::poll(&waiting, 1, 0) <= 0) return;
  char piece[1u << 16];
  const ssize_t count = ::read(file, piece, sizeof piece);
  if (count < 0 && errno == EINTR) return;
  if (count <= 0) {
    ::close(std::exchange(file, -1));
    return;
  }
  const std::size_t room = longest_output - all.size(), come = static_cast<std::size_t>(count);
  cut = cut || come > room;
  all.append(piece, std::min(room, come));
}

struct Pipe {
  int to = -1, from = -1;
  bool open() {
    int ends[2];
    if (::pipe(ends) != 0) return false;
    from = ends[0];
    to = ends[1];
    return true;
  }
};

}  // namespace

tl::expected<ToolProcess, std::string> ToolProcess::start(const std::function<int()>& work, double seconds) {
  const auto no_process = [] {
    return tl::unexpected(std::string("no process can be started: ") + std::strerror(errno));
  };
  Pipe out, error;
  if (!out.open()) return no_process();
  ToolProcess process;
  process.out_ = out.from;
  if (!error.open()) {
    ::close(out.to);
    return no_process();
  }
  process.error_ = error.from;
  const pid_t server = ::getpid();
  process.id_ = ::fork();
  if (process.id_ == 0) {
    ::close(out.from);
    ::close(error.from);
    work_apart(work, out.to, error.to, server);
  }
  ::close(out.to);
  ::close(error.to);
  if (process.id_ < 0) return no_process();
  process.end_ =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  return process;
}

ToolProcess::ToolProcess(ToolProcess&& other) noexcept
    : id_(std::exchange(other.id_, -1)), out_(std::exchange(other.out_, -1)),
      error_(std::exchange(other.error_, -1)), end_(other.end_), asked_(other.asked_),
      output_(std::move(other.output_)) {}

ToolProcess::~ToolProcess() {
  for (const int file : {out_, error_})
    if (file >= 0) ::close(file);
  if (id_ <= 0) return;
  ::kill(id_, SIGKILL);
  ::waitpid(id_, nullptr, 0);
}

int ToolProcess::patience() const {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end_ - Clock::now()).count();
  return static_cast<int>(std::clamp<long long>(left + 1, 1, 60'000));
}

void ToolProcess::read() {
  take(out_, output_.object, output_.object_cut);
  take(error_, output_.text, output_.text_cut);
  if (Clock::now() < end_) return;
  if (asked_) {
    ::kill(id_, SIGKILL);
  } else {
    output_.late = true;
    stop();
  }
}

void ToolProcess::stop() {
  asked_ = true;
  end_ = Clock::now() + time_to_obey;
  ::kill(id_, SIGTERM);
}

ToolOutput ToolProcess::finish() {
  int status = 0;
  pid_t ended = -1;
  do {
    ended = ::waitpid(id_, &status, 0);
  } while (ended < 0 && errno == EINTR);
  id_ = -1;
  output_.code = WIFEXITED(status) ? WEXITSTATUS(status) : failed;
  output_.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return std::move(output_);
}

}  // namespace kempe::app
