// kempe: the command line. Parses, runs the chosen command, chooses the exit code.

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "app/program.hpp"
#include "app/session.hpp"

namespace {

/// Opens what the caller has closed of stdin, stdout and stderr, so that no file of ours gets such a number and with it
/// what is meant for a person. Reading stays empty, and writing stays the error that a closed stream is.
void keep_standard_streams() {
  int file = -1;
  do {
    file = ::open("/dev/null", O_RDONLY);
  } while (file >= 0 && file <= STDERR_FILENO);
  if (file > STDERR_FILENO) ::close(file);
}

/// The exit code, unless what was printed has not arrived.
int told(int code) {
  using namespace kempe::app;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    return fail_told(cannot_write, "stdout cannot be written");
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace kempe::app;
  keep_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file larger than the shell allows is an error of writing, not the end
  Session session;
  return told(run_program({argv, argv + argc}, session));
}
