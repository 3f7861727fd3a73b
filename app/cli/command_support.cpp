// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/services/installation/support_report.h"
#include "sim/core/clock.h"

namespace torsio::cli {

void addSupport(CLI::App& program) {
  struct Arguments {
    Installation installation;
    std::string out;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "support", "Saves a report on this installation for somebody who helps; nobody's data are in it");
  command->add_option("--out", arguments->out, "File that is written (JSON)")->required();
  addDatabaseArgument(*command, "--database", arguments->installation.locator,
                      "SQLite file or postgresql://... address; default: the record of this station");
  command->callback([arguments] {
    arguments->installation.now_us = utcNow_us();
    writeSupportReport(arguments->out, arguments->installation);
    std::cout << "Written: " << arguments->out << ". Read it before you send it\n";
  });
}

}  // namespace torsio::cli
