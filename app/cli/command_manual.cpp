// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/manual.h"
#include "app/services/base/build_info.h"

namespace torsio::cli {

void addManual(CLI::App& program) {
  CLI::App* manual = program.add_subcommand("manual", "The manual page, and the completion for bash");
  manual->require_subcommand(1);
  manual->add_subcommand("page", "Prints the manual page of all commands, for man")->callback([&program] {
    std::cout << manualPage(program, softwareVersion());
  });
  manual->add_subcommand("completion", "Prints the script that completes commands and options in bash")
      ->callback([&program] { std::cout << bashCompletion(program); });
}

}  // namespace torsio::cli
