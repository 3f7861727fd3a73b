// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/services/access/station_name.h"

namespace torsio::cli {

namespace {

void showStation(bool json) {
  const StationSign sign = stationSign();
  if (json) {
    printJson({{"name", sign.name},
               {"own_name", sign.made},
               {"computer", sign.computer},
               {"settings", sign.settings.string()}});
    return;
  }
  std::cout << "station   " << sign.name << (sign.made ? "" : "  (of the computer: no window started yet)")
            << "\ncomputer  " << sign.computer << "\nsettings  " << sign.settings.string() << "\n";
}

}  // namespace

void addStation(CLI::App& program) {
  CLI::App* station = program.add_subcommand("station", "The name under which this station records");
  station->require_subcommand(1);
  auto json = std::make_shared<bool>(false);
  CLI::App* show = station->add_subcommand("show", "Name, computer and file of the settings");
  show->add_flag("--json", *json, "JSON");
  show->callback([json] { showStation(*json); });
  CLI::App* renew =
      station->add_subcommand("renew", "Gives this station another name, if it is a copy of another");
  renew->add_flag("--json", *json, "JSON");
  renew->callback([json] {
    renewStationName();
    showStation(*json);
  });
}

}  // namespace torsio::cli
