// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/options.h"
#include "app/cli/progress_line.h"
#include "app/services/access/moved_record.h"
#include "app/services/access/outdated_access.h"
#include "app/services/base/configuration.h"
#include "app/services/maintenance/anchor.h"
#include "app/services/maintenance/copies.h"
#include "app/services/maintenance/database_maintenance.h"
#include "app/services/maintenance/interrupted_move.h"
#include "app/services/maintenance/kept_backups.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "app/services/maintenance/record_restore.h"
#include "app/services/maintenance/server_dump.h"
#include "app/services/maintenance/server_move.h"
#include "app/services/maintenance/station_anchor.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/results/number_format.h"
#include "db/connection/locator.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "sim/core/text.h"

namespace torsio::cli {

namespace {

constexpr const char* kDefaultKeep = "7,5,12";

struct DbArguments {
  DatabaseOption database;
  MaintenanceOptions maintenance;
  std::string file;
  std::string folder;
  std::string keep;
  std::string target;
  std::string role = "torsio_station";
  std::string reason;
  bool replace = false;
  bool otherCentre = false;
};

void printContent(const BackupContent& content) {
  std::cout << "  "
            << Text::verbatim("schema %1, %2 {run|runs}, %3 {mark|marks}", content.schemaVersion,
                              content.trials, content.marks)
            << "\n";
}

/// Prints the findings and throws with the exit code for them.
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

/// Prints every copy of the record with the date by which it should be deleted.
void printCopies(const DbArguments& arguments) {
  for (const ListedCopy& listed : copiesOf(arguments.database.locator())) {
    const RecordCopy& copy = listed.copy;
    std::cout << "  " << labelOf(copy.kind).english() << (copy.station.empty() ? "" : " at " + copy.station)
              << ": " << copy.place << ", made " << formatUtc(copy.madeUtc_us) << ", to be deleted by "
              << formatUtc(listed.dueUtc_us) << "\n";
  }
}

/// Returns the folder of backups that was named or is configured. Throws Error{kUsage} if neither.
std::string backupFolder(const std::string& named) {
  const std::string folder = named.empty() ? configured(kConfiguredBackupFolder).value_or("") : named;
  if (folder.empty()) {
    refuseUsage("it is not clear which backup is meant", "",
                "Name a file or a folder, or set backup.folder in /etc/torsio/torsio.conf");
  }
  return folder;
}

void backUp(const DbArguments& arguments) {
  const std::string locator = arguments.database.locator();
  if (!arguments.file.empty() && !arguments.folder.empty()) {
    refuseUsage("a backup goes to one place", arguments.file, "Leave out FILE or --into");
  }
  const std::string folder = arguments.file.empty() ? backupFolder(arguments.folder) : "";
  const KeepRule rule = keepRule(
      arguments.keep.empty() ? configured(kConfiguredBackupKeep).value_or(kDefaultKeep) : arguments.keep);
  sweepLeftovers(locator);
  MaintenanceDesk desk(arguments.maintenance.maintainer(), locator);
  KeptBackup made{.file = arguments.file};
  if (folder.empty()) {
    made.content = backUpDatabase(desk.session(), arguments.file, {},
                                  arguments.replace ? Replace::kBackup : Replace::kNothing);
  } else {
    made = keepBackup(desk.session(), folder, rule);
  }
  std::cout << "Backup written and checked: " << made.file.string() << "\n";
  printContent(made.content);
  for (const std::filesystem::path& removed : made.removed) {
    std::cout << "  removed, as --keep says: " << removed.string() << "\n";
  }
  const StationAnchor anchor = stationAnchor();
  std::cout << "  " << anchoredHead(isDump(made.file) ? locator : made.file.string(), anchor.key, utcNow_us())
            << "\n";
  if (anchor.key.empty()) {
    std::cerr
        << "torsio: this checkpoint is not signed: anybody who can write to the place where it is kept can "
           "replace it. torsio audit key FILE makes a key, torsio audit station sets it\n";
  }
  printCopies(arguments);
}

void listCopies(const DbArguments& arguments) {
  if (copiesOf(arguments.database.locator()).empty()) {
    std::cout << "No copy of this record is known.\n";
    return;
  }
  printCopies(arguments);
}

void verify(const DbArguments& arguments) {
  const std::string named = backupFolder(arguments.file);
  const bool folder = std::filesystem::is_directory(named);
  const std::filesystem::path file = folder ? newestBackup(named) : std::filesystem::path(named);
  if (folder) {
    std::cout << file.string() << "\n";
  }
  if (isDump(file)) {
    readDump(file);
    std::cout
        << "The backup of a server can be read from end to end. To check its audit trail, restore it into an "
           "empty database (pg_restore) and run torsio audit verify there.\n";
    return;
  }
  const BackupCheck check = verifyBackup(file);
  requireSound(check.database, "Do not rely on this backup; make a new one");
  std::cout << "The backup is sound: read from end to end, "
            << Text::verbatim("%1 {entry of the audit trail fits|entries of the audit trail fit}.",
                              check.database.auditEntries)
            << "\n";
  printContent(check.content);
}

void restore(const DbArguments& arguments) {
  const std::string file = arguments.database.locator();
  const Restored restored =
      restoreRecord(arguments.maintenance.maintainer(), arguments.file, file, arguments.otherCentre);
  if (restored.plan) {
    std::cout << Text::verbatim(
        "Not in the backup: %1 {person|people}, %2 {run|runs}, %3 {mark|marks}; erased again: %4 "
        "{person|people}\n",
        restored.plan->lostPeople, restored.plan->lostTrials, restored.plan->lostMarks,
        restored.plan->erasedSince);
  }
  if (!restored.unreadable.empty()) {
    std::cerr << "torsio: what was there cannot be read (" << restored.unreadable
              << "); people who were erased after the backup are in the record again\n";
  }
  std::cout << "Restored " << file;
  if (!restored.before.empty()) {
    std::cout << "; what was there is kept as " << restored.before.string();
  }
  std::cout << "\n";
  printContent(restored.content);
}

void check(const DbArguments& arguments) {
  const DatabaseCheck result = checkDatabase(arguments.database.locator());
  requireSound(result, "Restore the latest backup with torsio db restore");
  for (const Text& note : result.clock) {
    std::cout << "Note: " << note << "\n";
  }
  std::cout << "The database is sound: schema " << result.schemaVersion << ", "
            << Text::verbatim("%1 {entry of the audit trail fits|entries of the audit trail fit}.",
                              result.auditEntries)
            << "\n";
}

void copy(const DbArguments& arguments) {
  CopyReport report;
  {
    MaintenanceDesk desk(arguments.maintenance.maintainer(), arguments.file);
    ProgressLine line;
    if (const Text settled = settleMove(desk.session()); !settled.empty()) {
      std::cout << settled << ".\n";
      const std::string place = movedTo(desk.session().connectionWithoutRight());
      const std::string target = parseLocator(arguments.target).shown();
      if (place == target || place == std::filesystem::absolute(target).string()) {
        return;
      }
    }
    report = copyDatabase(
        desk.session(), arguments.target, [&line](const Progress& progress) { line.show(progress); },
        CopyUse::kMove);
    noteMoved(desk.session());
  }
  for (const TableDigest& table : report.tables) {
    if (table.rows > 0) {
      std::cout << Text::verbatim("  %1: %2 {row|rows}\n", std::string(table.table), table.rows);
    }
  }
  std::cout << "Copied and compared: rows " << report.rows << ", tables " << report.tables.size()
            << "; counts and hashes are the same on both sides, "
            << Text::verbatim("%1 {entry of the audit trail fits|entries of the audit trail fit}.",
                              report.auditEntries)
            << "\n"
            << "The record at " << parseLocator(arguments.file).shown()
            << " takes nothing new from now on; torsio db reopen takes the move back.\n";
}

void reopen(const DbArguments& arguments) {
  MaintenanceDesk desk(arguments.maintenance.maintainer(), arguments.database.locator());
  if (const Text settled = settleMove(desk.session()); !settled.empty()) {
    std::cerr << "torsio: " << settled << "\n";
  }
  takeBackMove(desk.session(), arguments.reason);
  std::cout << "The move is taken back: this record is the living one again.\n";
}

void prepareServerRoles(const DbArguments& arguments) {
  const OutdatedAccess outdated =
      prepareServer(arguments.maintenance.maintainer(), arguments.database.locator(), arguments.role);
  std::cout << "The roles are written. Stations work as " << arguments.role
            << "; this account brings the schema up to date, and nobody else uses it.\n"
            << "Give the role a password: psql -c '\\password " << arguments.role << "'\n";
  if (const Text found = sentenceOf(outdated); !found.empty()) {
    std::cout << "Note: " << found << ". " << remedyForOutdatedAccess() << ".\n";
  }
}

}  // namespace

void addDb(CLI::App& program) {
  auto arguments = std::make_shared<DbArguments>();
  CLI::App* db = program.add_subcommand(
      "db", "Database maintenance: backup, verify, restore, check, copy, copies, reopen, prepare-server");
  db->require_subcommand(1);

  CLI::App* command = db->add_subcommand("backup", "Copies a database in use into one checked file");
  command->add_option("FILE", arguments->file, "The backup to write");
  command->add_option(
      "--into", arguments->folder,
      "Folder of backups instead: one more, named by its time; default: backup.folder of torsio.conf");
  command->add_option("--keep", arguments->keep,
                      "Newest backups of so many days, weeks and months that stay in that folder; default: "
                      "backup.keep of torsio.conf, or 7,5,12");
  command->add_flag("--replace", arguments->replace,
                    "Replaces an older backup of that name, but never a record");
  addDatabaseOption(*command, arguments->database);
  addMaintenanceOptions(*command, arguments->maintenance);
  command->callback([arguments] { backUp(*arguments); });

  command = db->add_subcommand("verify", "Test restore of a backup: reads all of it and its audit trail");
  command->add_option("FILE", arguments->file,
                      "The backup, or a folder: its newest; default: backup.folder of torsio.conf");
  command->callback([arguments] { verify(*arguments); });

  command = db->add_subcommand("restore", "Replaces a database that nobody has open by a backup");
  command->add_option("FILE", arguments->file, "The backup")->required();
  addDatabaseOption(*command, arguments->database);
  addMaintenanceOptions(*command, arguments->maintenance);
  addSecondPerson(*command, arguments->maintenance);
  command->add_flag("--other-centre", arguments->otherCentre,
                    "The backup of another centre is meant to replace this record: takes two people");
  command->callback([arguments] { restore(*arguments); });

  command = db->add_subcommand("copies", "Lists all copies of this record");
  addDatabaseOption(*command, arguments->database);
  command->callback([arguments] { listCopies(*arguments); });

  command = db->add_subcommand("check", "Checks for damage, and for changes not in the audit trail");
  addDatabaseOption(*command, arguments->database);
  command->callback([arguments] { check(*arguments); });

  command = db->add_subcommand("copy", "Moves a centre to another database: SQLite to PostgreSQL, or back");
  addDatabaseArgument(*command, "FROM", arguments->file, "SQLite file or postgresql://... address")
      ->required();
  addDatabaseArgument(*command, "TO", arguments->target, "New file or empty database")->required();
  addMaintenanceOptions(*command, arguments->maintenance);
  command->callback([arguments] { copy(*arguments); });

  command = db->add_subcommand("reopen", "Takes a move back: the record here is the living one again");
  addDatabaseOption(*command, arguments->database);
  command->add_option("--reason", arguments->reason, "Reason, for the audit trail")->required();
  addMaintenanceOptions(*command, arguments->maintenance);
  command->callback([arguments] { reopen(*arguments); });

  command = db->add_subcommand("prepare-server", "Creates the roles of a PostgreSQL server, as its owner");
  addDatabaseArgument(*command, "ADDRESS", arguments->database.address, "postgresql://owner@... address")
      ->required();
  command->add_flag("--ask-server-password", arguments->database.askPassword,
                    "Asks at the terminal for the password of the server");
  addDefaulted(*command, "--station-role", arguments->role, "Role of the stations");
  addMaintenanceOptions(*command, arguments->maintenance);
  command->callback([arguments] { prepareServerRoles(*arguments); });
}

}  // namespace torsio::cli
