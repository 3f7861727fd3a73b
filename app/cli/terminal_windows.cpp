// SPDX-License-Identifier: GPL-3.0-or-later
#include <conio.h>
#include <cstdio>
#include <cstdlib>
#include <io.h>

#include "app/cli/options.h"
#include "app/cli/terminal.h"
#include "sim/core/error.h"

namespace torsio::cli {

bool standardErrorIsTerminal() noexcept {
  return _isatty(_fileno(stderr)) != 0;
}

std::string typedSecret(const std::string& question) {
  _cputs(question.c_str());
  std::string line;
  for (int key = _getch(); key != '\r' && key != '\n' && key != EOF; key = _getch()) {
    if (key == '\b' && !line.empty()) {
      line.pop_back();
    } else if (key != '\b') {
      line += static_cast<char>(key);
    }
  }
  _cputs("\r\n");
  return line;
}

std::string secretFrom(int descriptor) {
  std::string line;
  char one = 0;
  while (_read(descriptor, &one, 1) == 1 && one != '\n') {
    if (one != '\r') {
      line += one;
    }
  }
  if (line.empty()) {
    refuseUsage("no password or code can be read", "file descriptor " + std::to_string(descriptor),
                "Open it for the program, with the password in its first line, and the code of a second "
                "factor in the next");
  }
  return line;
}

bool ownsFile(const std::string& file) {
  return _access(file.c_str(), 6) == 0;  // write access: Windows keeps owners in access lists
}

std::string systemAccount() {
  const char* name = std::getenv("USERNAME");
  return name == nullptr ? std::string() : name;
}

}  // namespace torsio::cli
