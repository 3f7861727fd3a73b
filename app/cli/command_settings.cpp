// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/access/centre_settings.h"
#include "app/services/maintenance/maintenance_desk.h"

namespace torsio::cli {

namespace {

struct SettingsArguments {
  DatabaseOption database;
  MaintenanceOptions maintenance;
  std::string name;
  std::string value;
  bool json = false;
};

void listSettings(const SettingsArguments& given) {
  MaintenanceDesk desk(given.maintenance.maintainer(), given.database.locator());
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const CentreSetting* setting : kCentreSettings) {
    if (setting->kind == SettingKind::kWords) {
      continue;  // an address, a server: its own command or page shows it
    }
    const std::string value = storedCentreSetting(desk.session(), *setting);
    all.push_back({{"name", setting->name},
                   {"value", value},
                   {"initial", setting->initial},
                   {"meaning", setting->label.english()},
                   {"in_report", setting->inReport}});
    if (!given.json) {
      std::cout << setting->name << " = " << value << "  (" << setting->label.english() << ")\n";
    }
  }
  if (given.json) {
    printJson(all);
  }
}

void setSetting(const SettingsArguments& given) {
  const Maintainer maintainer = given.maintenance.maintainer();
  MaintenanceDesk desk(maintainer, given.database.locator());
  if (given.name == kTwoPeople.name) {
    desk.handOver(
        maintainer,
        {.act = DutyAct::kOnePerson, .subject = given.name, .reason = "one person is to be enough"});
  }
  setCentreSettingNamed(desk.session(), given.name, given.value);
  std::cout << "Saved; it holds at every station from the next sign-in\n";
}

}  // namespace

void addSettings(CLI::App& program) {
  auto arguments = std::make_shared<SettingsArguments>();
  CLI::App* settings =
      program.add_subcommand("settings", "Choices of the centre, the same for all its stations");
  settings->require_subcommand(1);
  const auto add = [&](const char* name, const char* what) {
    CLI::App* command = settings->add_subcommand(name, what);
    addDatabaseOption(*command, arguments->database);
    addMaintenanceOptions(*command, arguments->maintenance);
    return command;
  };
  CLI::App* command = add("list", "Each setting with its value");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { listSettings(*arguments); });
  command = add("set", "Changes one setting");
  command->add_option("name", arguments->name, "Name, as list shows it")->required();
  command
      ->add_option("value", arguments->value,
                   "yes or no, a number, speeds like 0.5,1,1.5, or one of the words")
      ->required();
  addSecondPerson(*command, arguments->maintenance);
  command->callback([arguments] { setSetting(*arguments); });
}

}  // namespace torsio::cli
