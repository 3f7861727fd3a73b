// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include "app/cli/terminal.h"

namespace torsio::cli {

bool standardErrorIsTerminal() noexcept {
  return isatty(STDERR_FILENO) != 0;
}

}  // namespace torsio::cli
