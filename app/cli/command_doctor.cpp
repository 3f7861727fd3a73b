// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/installation/installation_check.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

struct DoctorArguments {
  Installation installation;
  bool strict = false;
  bool json = false;
};

void print(const std::vector<InstallationCheck>& checks) {
  for (const InstallationCheck& check : checks) {
    std::cout << storedText(check.state) << "  " << check.name << ": " << check.finding << "\n";
    if (!check.remedy.empty()) {
      std::cout << "         " << check.remedy << "\n";
    }
  }
  std::cout << summaryOf(checks) << "\n";
}

void runDoctor(DoctorArguments given) {
  given.installation.now_us = utcNow_us();
  const std::vector<InstallationCheck> checks = checkInstallation(given.installation);
  const CheckState worst = worstOf(checks);
  if (given.json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const InstallationCheck& check : checks) {
      all.push_back({{"name", check.name},
                     {"state", storedText(check.state)},
                     {"finding", check.finding.str()},
                     {"remedy", check.remedy.str()}});
    }
    printJson({{"state", storedText(worst)}, {"checks", all}});
  } else {
    print(checks);
  }
  if (worst == CheckState::kFailed || (given.strict && worst == CheckState::kWarning)) {
    throw Error(ErrorCode::kVerifyFailed, Text::verbatim("this installation needs attention"), "",
                Text::verbatim("Follow the advice below each line marked warning or failed"));
  }
}

}  // namespace

void addDoctor(CLI::App& program) {
  auto arguments = std::make_shared<DoctorArguments>();
  CLI::App* command = program.add_subcommand(
      "doctor", "Checks that this computer has what Torsio needs, and says how to fix what is missing");
  addDatabaseArgument(*command, "--database", arguments->installation.locator,
                      "SQLite file or postgresql://... address; default: the record of this station");
  command->add_option("--certificate", arguments->installation.certificate,
                      "Certificate of the browser desk (PEM), to check when it expires");
  command->add_flag("--strict", arguments->strict, "Exit with code 13 for warnings as well");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { runDoctor(*arguments); });
}

}  // namespace torsio::cli
