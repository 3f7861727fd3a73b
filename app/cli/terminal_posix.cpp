// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include "app/cli/options.h"
#include "app/cli/terminal.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

constexpr std::size_t kLongestSecret = 4096;

/// Switches off the terminal's echo while it lives.
class Unseen {
 public:
  explicit Unseen(int terminal) : terminal_(terminal), known_(tcgetattr(terminal, &before_) == 0) {
    if (known_) {
      termios quiet = before_;
      quiet.c_lflag &= ~static_cast<tcflag_t>(ECHO);
      tcsetattr(terminal_, TCSAFLUSH, &quiet);
    }
  }
  Unseen(const Unseen&) = delete;
  Unseen& operator=(const Unseen&) = delete;
  ~Unseen() {
    if (known_) {
      tcsetattr(terminal_, TCSAFLUSH, &before_);
    }
  }

 private:
  int terminal_;
  termios before_{};
  bool known_;
};

std::string lineOf(int descriptor) {
  std::string line;
  char one = 0;
  for (;;) {
    const ssize_t got = read(descriptor, &one, 1);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got <= 0 || one == '\n' || line.size() >= kLongestSecret) {
      return line;
    }
    line += one;
  }
}

}  // namespace

bool standardErrorIsTerminal() noexcept {
  return isatty(STDERR_FILENO) != 0;
}

std::string typedSecret(const std::string& question) {
  const int terminal = open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal < 0) {
    refuseUsage("there is no terminal to ask for the password", "password",
                "Pass the password with --password-fd N");
  }
  std::string line;
  {
    const Unseen unseen(terminal);
    (void)!write(terminal, question.data(), question.size());
    line = lineOf(terminal);
    (void)!write(terminal, "\n", 1);
  }
  close(terminal);
  return line;
}

std::string secretFrom(int descriptor) {
  std::string line = lineOf(descriptor);
  if (line.ends_with('\r')) {
    line.pop_back();  // CR of a Windows line end
  }
  if (line.empty()) {
    refuseUsage("no password or code can be read", "file descriptor " + std::to_string(descriptor),
                "Open it for the program, with the password in its first line, and the code of a second "
                "factor in the next");
  }
  return line;
}

bool ownsFile(const std::string& file) {
  struct stat found {};
  return stat(file.c_str(), &found) == 0 && found.st_uid == geteuid();
}

std::string systemAccount() {
  return std::to_string(geteuid());
}

}  // namespace torsio::cli
