// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/progress_line.h"
#include "app/maintenance/anchor.h"
#include "app/maintenance/copies.h"
#include "app/maintenance/database_copy.h"
#include "app/maintenance/database_maintenance.h"
#include "app/maintenance/station_anchor.h"
#include "assessment/people/audit_entry.h"
#include "assessment/report/number_format.h"
#include "sim/base/clock.h"
#include "sim/base/error.h"

namespace torsio::cli {

namespace {

struct DbArguments {
  std::string database = "torsio.sqlite";
  std::string file;
  std::string target;
  bool replace = false;
};

void printContent(const BackupContent& content) {
  std::cout << "  schema " << content.schemaVersion << ", " << content.trials << " trials, " << content.marks
            << " marks\n";
}

/// Says what is wrong, and ends with the exit code for it.
void requireSound(const DatabaseCheck& check, const std::string& remedy) {
  for (const std::string& damage : check.damage) {
    std::cout << "damaged: " << damage << "\n";
  }
  for (const AuditFinding& finding : check.audit) {
    std::cout << finding.objectKind << " " << finding.objectId << ": " << finding.what << "\n";
  }
  if (check.sound()) {
    return;
  }
  throw Error(ErrorCode::kVerifyFailed,
              std::to_string(check.damage.size() + check.audit.size()) + " things are wrong", check.location,
              remedy);
}

/// Every place that holds the record besides itself, with the day by which it should be gone.
void printCopies(const DbArguments& arguments) {
  for (const ListedCopy& listed : copiesOf(arguments.database)) {
    const RecordCopy& copy = listed.copy;
    std::cout << "  " << copyKindLabel(copy.kind).english() << " at " << copy.station << ": " << copy.place
              << ", made " << formatUtc(copy.madeUtc_us) << ", to be deleted by "
              << formatUtc(listed.dueUtc_us) << "\n";
  }
}

void backUp(const DbArguments& arguments) {
  const BackupContent content = backUpDatabase(arguments.database, arguments.file,
                                               arguments.replace ? Replace::kBackup : Replace::kNothing);
  std::cout << "Backup written and checked: " << arguments.file << "\n";
  printContent(content);
  const StationAnchor anchor = stationAnchor();
  std::cout << "  " << anchoredHead(arguments.file, anchor.key, utcNow_us()) << "\n";
  if (anchor.key.empty()) {
    std::cerr
        << "torsio: this head is not signed: whoever can change the place where it is kept can replace it. "
           "torsio audit key FILE makes a key, torsio audit station sets it\n";
  }
  printCopies(arguments);
}

void listCopies(const DbArguments& arguments) {
  if (copiesOf(arguments.database).empty()) {
    std::cout << "No copy of this record is known.\n";
    return;
  }
  printCopies(arguments);
}

void verify(const DbArguments& arguments) {
  const BackupCheck check = verifyBackup(arguments.file);
  requireSound(check.database, "Do not rely on this backup; make a new one");
  std::cout << "The backup is sound: read from end to end, " << check.database.auditEntries
            << " entries of the audit trail fit.\n";
  printContent(check.content);
}

void restore(const DbArguments& arguments) {
  const Restored restored = restoreDatabase(arguments.file, arguments.database);
  std::cout << "Restored " << arguments.database;
  if (!restored.before.empty()) {
    std::cout << "; what was there is kept as " << restored.before.string();
  }
  std::cout << "\n";
  printContent(restored.content);
}

void check(const DbArguments& arguments) {
  const DatabaseCheck result = checkDatabase(arguments.database);
  requireSound(result, "Restore the latest backup with torsio db restore");
  std::cout << "The database is sound: schema " << result.schemaVersion << ", " << result.auditEntries
            << " entries of the audit trail fit.\n";
}

void copy(const DbArguments& arguments) {
  CopyReport report;
  {
    ProgressLine line;
    report = copyDatabase(arguments.file, arguments.target,
                          [&line](const Progress& progress) { line.show(progress); });
  }
  for (const TableDigest& table : report.tables) {
    if (table.rows > 0) {
      std::cout << "  " << table.table << ": " << table.rows << " rows\n";
    }
  }
  std::cout << "Copied and compared: " << report.rows << " rows of " << report.tables.size()
            << " tables have the same counts and hashes on both sides, " << report.auditEntries
            << " entries of the audit trail fit.\n";
}

void addDatabase(CLI::App& command, const std::shared_ptr<DbArguments>& arguments) {
  command.add_option("--database", arguments->database, "SQLite file or postgresql://... address")
      ->capture_default_str();
}

}  // namespace

void addDb(CLI::App& program) {
  auto arguments = std::make_shared<DbArguments>();
  CLI::App* db = program.add_subcommand("db", "Care of the database: backup, verify, restore, check, copy");
  db->require_subcommand(1);

  CLI::App* command = db->add_subcommand("backup", "Copies a database in use into one checked file");
  command->add_option("FILE", arguments->file, "The backup to write")->required();
  command->add_flag("--replace", arguments->replace, "An older backup of that name may go; a record never");
  addDatabase(*command, arguments);
  command->callback([arguments] { backUp(*arguments); });

  command = db->add_subcommand("verify", "Test restore of a backup: reads all of it and its audit trail");
  command->add_option("FILE", arguments->file, "The backup")->required();
  command->callback([arguments] { verify(*arguments); });

  command = db->add_subcommand("restore", "Puts a backup in the place of a database that nobody has open");
  command->add_option("FILE", arguments->file, "The backup")->required();
  addDatabase(*command, arguments);
  command->callback([arguments] { restore(*arguments); });

  command = db->add_subcommand("copies", "Lists the places that hold this record besides itself");
  addDatabase(*command, arguments);
  command->callback([arguments] { listCopies(*arguments); });

  command = db->add_subcommand("check", "Looks for damage, and for anything changed behind the audit trail");
  addDatabase(*command, arguments);
  command->callback([arguments] { check(*arguments); });

  command = db->add_subcommand("copy", "Moves a centre to another database: SQLite to PostgreSQL, or back");
  command->add_option("FROM", arguments->file, "SQLite file or postgresql://... address")->required();
  command->add_option("TO", arguments->target, "New file or empty database")->required();
  command->callback([arguments] { copy(*arguments); });
}

}  // namespace torsio::cli
