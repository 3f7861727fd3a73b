// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <io.h>

#include "app/cli/terminal.h"

namespace torsio::cli {

bool standardErrorIsTerminal() noexcept {
  return _isatty(_fileno(stderr)) != 0;
}

}  // namespace torsio::cli
