// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "app/services/people/roster_undo.h"
#include "assessment/results/number_format.h"

namespace torsio::cli {

namespace {

struct RosterArguments {
  DatabaseOption database;
  MaintenanceOptions maintenance;
  std::vector<std::string> ids;
  std::string reason;
  bool json = false;
};

std::string stateOf(const ImportedRoster& one) {
  if (one.takenBack) {
    return "taken back";
  }
  return one.hindrance.empty() ? "can be undone" : one.hindrance.str();
}

void listImports(const RosterArguments& arguments) {
  MaintenanceDesk desk(arguments.maintenance.maintainer(), arguments.database.locator());
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const ImportedRoster& one : importedRosters(desk.session())) {
    const char* kind = one.kind == RosterKind::kTrainees ? "trainees" : "raters";
    if (arguments.json) {
      all.push_back({{"id", one.id},
                     {"imported", formatUtc(one.importedUtc_us)},
                     {"by", one.importedBy},
                     {"kind", kind},
                     {"added", one.added},
                     {"changed", one.changed},
                     {"codes", one.codes},
                     {"taken_back", one.takenBack},
                     {"hindrance", one.hindrance.str()}});
      continue;
    }
    std::cout << one.id << "  " << formatUtc(one.importedUtc_us) << "  " << kind << ": " << one.added
              << " added, " << one.changed << " changed; " << stateOf(one) << "\n";
  }
  if (arguments.json) {
    printJson(all);
  }
}

void takeBack(const RosterArguments& arguments) {
  MaintenanceDesk desk(arguments.maintenance.maintainer(), arguments.database.locator());
  takeBackRosters(desk.session(), arguments.ids, arguments.reason);
  for (const std::string& id : arguments.ids) {
    std::cout << "Taken back: " << id << "\n";
  }
}

}  // namespace

void addRoster(CLI::App& program) {
  CLI::App* roster = program.add_subcommand("roster", "Imported rosters: list, undo");
  roster->require_subcommand(1);
  auto arguments = std::make_shared<RosterArguments>();
  CLI::App* list = roster->add_subcommand("imports", "Lists imports, and whether they can be undone");
  addDatabaseOption(*list, arguments->database);
  addSignIn(*list, arguments->maintenance, kLoginOrAs)->required();
  list->add_flag("--json", arguments->json, "JSON");
  list->callback([arguments] { listImports(*arguments); });
  CLI::App* back = roster->add_subcommand("take-back", "Undoes imports completely: all of them, or none");
  addDatabaseOption(*back, arguments->database);
  addSignIn(*back, arguments->maintenance, kLoginOrAs)->required();
  back->add_option("imports", arguments->ids, "Ids, as listed by 'torsio roster imports'")->required();
  back->add_option("--reason", arguments->reason, "Reason, for the audit trail")->required();
  back->callback([arguments] { takeBack(*arguments); });
}

}  // namespace torsio::cli
