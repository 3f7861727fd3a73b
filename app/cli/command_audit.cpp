// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/maintenance/database_maintenance.h"
#include "assessment/people/audit_entry.h"
#include "sim/base/error.h"

namespace torsio::cli {

namespace {

struct AuditArguments {
  std::string database = "torsio.sqlite";
  bool json = false;
};

nlohmann::ordered_json jsonOf(const DatabaseCheck& check) {
  nlohmann::ordered_json findings = nlohmann::ordered_json::array();
  for (const AuditFinding& finding : check.audit) {
    findings.push_back({{"entry", finding.sequence},
                        {"kind", finding.objectKind},
                        {"id", finding.objectId},
                        {"what", finding.what}});
  }
  return {{"entries", check.auditEntries}, {"findings", std::move(findings)}};
}

void verify(const AuditArguments& arguments) {
  const DatabaseCheck check = checkDatabase(arguments.database);
  if (!check.damage.empty()) {
    throw Error(ErrorCode::kVerifyFailed, "the database is damaged: " + check.damage.front(), check.location,
                Text::verbatim("Run torsio db check, and restore a backup"));
  }
  if (arguments.json) {
    printJson(jsonOf(check));
  } else {
    for (const AuditFinding& finding : check.audit) {
      std::cout << finding.objectKind << " " << finding.objectId << ": " << finding.what;
      if (finding.sequence > 0) {
        std::cout << " (entry " << finding.sequence << ")";
      }
      std::cout << "\n";
    }
    if (check.audit.empty()) {
      std::cout << "The audit trail is whole: " << check.auditEntries
                << " entries; every mark and every trial is as it was recorded.\n";
    }
  }
  if (!check.audit.empty()) {
    throw Error(ErrorCode::kVerifyFailed,
                (check.audit.size() == 1 ? std::string("one row is")
                                         : std::to_string(check.audit.size()) + " rows are") +
                    " not as recorded",
                check.location, Text::verbatim("Keep this file as it is, and compare it with a backup"));
  }
}

}  // namespace

void addAudit(CLI::App& program) {
  auto arguments = std::make_shared<AuditArguments>();
  CLI::App* audit = program.add_subcommand("audit", "The audit trail");
  audit->require_subcommand(1);
  CLI::App* command = audit->add_subcommand("verify", "Finds any change to audit entries, marks or trials");
  command->add_option("--database", arguments->database, "SQLite file or postgresql://... address")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { verify(*arguments); });
}

}  // namespace torsio::cli
