// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/database_maintenance.h"

#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

#include <QDir>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

#include "app/services/access/moved_record.h"
#include "app/services/base/build_info.h"
#include "app/services/maintenance/copies.h"
#include "app/services/maintenance/server_dump.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/results/number_format.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/connection/locator.h"
#include "db/migrations/backup.h"
#include "db/migrations/file_in_the_making.h"
#include "db/migrations/migrations.h"
#include "db/migrations/schema_check.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/row_ledger.h"
#include "db/repository/people/server_roles.h"
#include "db/repository/system/audit_verification.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

void requireSqlite(const std::string& locator, Phrase remedy) {
  const Locator parsed = parseLocator(locator);
  if (parsed.engine == Engine::kSqlite) {
    return;
  }
  throw Error(ErrorCode::kUsage, Text::tr("a PostgreSQL database is backed up and restored by its own tools"),
              parsed.shown(), remedy);
}

constexpr std::size_t kCopyStep_bytes = 4 << 20;
constexpr double kReferencesShare = 0.3;  // share of a check; the rest is for the recordings

constexpr const char* kCheckFolder = "torsio-check-";  // prefix for copies being checked
constexpr const char* kCheckLock = "in-use";

/// Compares the times of the trail with each other and with now. Stations' clocks may differ a little.
std::vector<Text> clockNotes(Connection& connection, std::int64_t now_us) {
  constexpr std::int64_t kTolerance_us = 10 * kMinute_us;
  constexpr std::size_t kMost = 20;
  std::vector<Text> notes;
  std::size_t more = 0;
  const auto add = [&](const Text& note) {
    if (notes.size() < kMost) {
      notes.push_back(note);
    } else {
      ++more;
    }
  };
  AuditEntry before;
  AuditRepository(connection).forEach([&](const AuditEntry& entry) {
    if (before.sequence > 0 && entry.atUtc_us + kTolerance_us < before.atUtc_us) {
      add(Text::tr("the clock went back: entry %1 is dated %2, entry %3 before it %4", entry.sequence,
                   formatUtc(entry.atUtc_us), before.sequence, formatUtc(before.atUtc_us)));
    }
    if (entry.atUtc_us > now_us + kTolerance_us) {
      add(Text::tr("entry %1 is dated %2, which is yet to come", entry.sequence, formatUtc(entry.atUtc_us)));
    }
    before.sequence = entry.sequence;
    before.atUtc_us = entry.atUtc_us;
  });
  if (more > 0) {
    notes.push_back(Text::tr("and %1 more such {note|notes} on the clock", more));
  }
  return notes;
}

DatabaseCheck check(Connection& connection, const ProgressCallback& progress = {}) {
  DatabaseCheck result;
  result.location = connection.location();
  result.schemaVersion = checkSchema(connection, embeddedMigrations()).version;
  tellProgress(progress, Text::tr("Checking tables and references"), 0.0);
  try {
    result.damage = integrityFindings(connection);
    if (!result.damage.empty()) {
      return result;  // a damaged file cannot be read completely
    }
    tellProgress(progress, Text::tr("Checking the audit trail"), kReferencesShare);
    const std::vector<SchemaFinding> schema = schemaFindings(connection, serverParts());
    result.audit = verifyAuditTrail(connection, [&](std::int64_t done, std::int64_t all) {
      tellProgress(
          progress, Text::tr("Checking recording %1 of %2", done + 1, all),
          kReferencesShare + (1.0 - kReferencesShare) * static_cast<double>(done) / static_cast<double>(all));
    });
    for (const SchemaFinding& finding : schema) {
      result.audit.push_back({0, "schema", finding.part, finding.what});
    }
    result.auditEntries = AuditRepository(connection).length();
    result.clock = clockNotes(connection, utcNow_us());
  } catch (const DbError& error) {
    if (error.fault() != DbFault::kCorrupt && error.fault() != DbFault::kOther) {
      throw;
    }
    result.damage.push_back(error.happened());  // an unreadable page or table
  }
  return result;
}

/// A copy in its own folder, because others may be checking a backup of the same name; removed by the
/// destructor. Its lock tells sweepLeftovers() that it is in use.
class ScratchFile {
 public:
  explicit ScratchFile(const fs::path& original)
      : folder_(QDir::tempPath() + QLatin1Char('/') + QLatin1String(kCheckFolder) + QStringLiteral("XXXXXX")),
        lock_(fs::path(folder_.path().toStdString()) / kCheckLock),
        path_(fs::path(folder_.path().toStdString()) / original.filename()) {
    if (!folder_.isValid() || !lock_.held()) {
      throw Error(ErrorCode::kFileUnwritable, Text::tr("no folder for the check can be made"),
                  fs::temp_directory_path().string(), Text::tr("Free some space in the temporary folder"));
    }
  }
  [[nodiscard]] const fs::path& path() const noexcept { return path_; }

 private:
  QTemporaryDir folder_;
  FileLock lock_;
  fs::path path_;
};

/// Removes a check's folder if its program is gone.
void sweepCheck(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / kCheckLock, ignored)) {
    return;
  }
  if (const FileLock lock(folder / kCheckLock); lock.held()) {
    fs::remove_all(folder, ignored);
  }
}

}  // namespace

void sweepLeftovers(const std::string& locator) {
  if (const Locator record = parseLocator(locator); record.engine == Engine::kSqlite) {
    sweepUnfinished(fs::path(record.file).parent_path());
  }
  std::error_code unreadable;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(QDir::tempPath().toStdString(), unreadable)) {
    if (entry.path().filename().string().starts_with(kCheckFolder)) {
      sweepCheck(entry.path());
    }
  }
}

void requireOwnRestore(const std::string& locator) {
  requireSqlite(locator, Text::tr("Use pg_restore on the server"));
}

void copyStepwise(const fs::path& from, const fs::path& to, const ProgressCallback& progress) {
  std::ifstream in(from, std::ios::binary);
  if (!in) {
    throw Error(ErrorCode::kFileMissing, Text::tr("the file cannot be read"), from.string(),
                Text::tr("Choose another file"));
  }
  const std::uintmax_t whole = fs::file_size(from);
  try {
    std::ofstream out(to, std::ios::binary | std::ios::trunc);
    std::vector<char> piece(kCopyStep_bytes);
    for (std::uintmax_t done = 0; done < whole && out;) {
      tellProgress(progress, Text::tr("Copying"), static_cast<double>(done) / static_cast<double>(whole));
      in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
      if (in.gcount() <= 0) {
        break;
      }
      out.write(piece.data(), in.gcount());
      done += static_cast<std::uintmax_t>(in.gcount());
    }
    out.close();
    if (!out || fs::file_size(to) != whole) {
      throw Error(ErrorCode::kFileUnwritable, Text::tr("the file cannot be copied"), to.string(),
                  Text::tr("Check the folder and the free space"));
    }
  } catch (...) {
    std::error_code ignored;
    fs::remove(to, ignored);
    throw;
  }
}

BackupCheck verifyBackup(const fs::path& backup, const ProgressCallback& progress,
                         const std::function<void(Connection&)>& look) {
  BackupCheck result;
  tellProgress(progress, Text::tr("Reading the backup"), 0.0);
  result.content = checkBackup(backup);
  const ScratchFile copy(backup);
  copyStepwise(backup, copy.path(), partOf(progress, 0.1, 0.3));
  Connection connection = openRecord(copy.path().string(), OpenMode::kReadWrite, {.backup = false});
  result.database = check(connection, partOf(progress, 0.3, 1.0));
  result.database.location = backup.string();
  if (look && result.database.sound()) {
    look(connection);
  }
  return result;
}

DatabaseCheck checkDatabase(const std::string& locator) {
  Connection connection = openRecord(locator, OpenMode::kReadOnly);
  return check(connection);
}

BackupContent backUpDatabase(SessionContext& session, const fs::path& target,
                             const ProgressCallback& progress, Replace replace) {
  session.require(Operation::kDatabaseBackup);
  // Audited before copying, so that the backup contains the entry.
  requireReplaceable(target, replace);
  Transaction together(session.connection());
  registerCopy(session.connection(), CopyKind::kBackup, target, session.now_us());
  session.note(AuditAction::kDatabaseBackup, AuditObject::kDatabase, target.filename().string());
  together.commit();
  tellProgress(progress, Text::tr("Copying the record while others work"), 0.0);
  if (session.connection().engine() != Engine::kSqlite) {
    const BackupContent content = contentOfRecord(session.connection());
    dumpServer(session.key().locator, target);
    return content;
  }
  backupSqlite(session.connection(), target, replace);
  tellProgress(progress, Text::tr("Reading the backup from end to end"), 0.6);
  return checkBackup(target);
}

DatabaseCheck checkDatabase(SessionContext& session, const ProgressCallback& progress) {
  session.require(Operation::kDatabaseBackup);
  DatabaseCheck result = check(session.connection(), progress);
  session.note(AuditAction::kDatabaseCheck, AuditObject::kDatabase, {},
               {{"damage", result.damage.size()}, {"audit", result.audit.size()}});
  return result;
}

namespace fs = std::filesystem;

namespace {

Text wordsOf(const CopyStep& step) {
  switch (step.phase) {
    case CopyPhase::kVerifying:
      return Text::tr("Checking the audit trail");
    case CopyPhase::kCopying:
      return Text::tr("Copying %1", step.table);
    case CopyPhase::kComparing:
      return Text::tr("Comparing %1", step.table);
    case CopyPhase::kVerifyingCopy:
      break;
  }
  return Text::tr("Checking the audit trail of the copy");
}

/// Progress fractions measured with recordings of an hour.
double fractionOf(const CopyStep& step) {
  constexpr double kFrom[] = {0.0, 0.15, 0.55, 0.85, 1.0};
  const auto phase = static_cast<std::size_t>(step.phase);
  const double part = step.all == 0 ? 1.0 : static_cast<double>(step.done) / static_cast<double>(step.all);
  return kFrom[phase] + (kFrom[phase + 1] - kFrom[phase]) * part;
}

void requireOther(const std::string& from, const std::string& to) {
  const Locator source = parseLocator(from);
  const Locator target = parseLocator(to);
  std::error_code ignored;
  if (from == to || (source.engine == Engine::kSqlite && target.engine == Engine::kSqlite &&
                     fs::equivalent(source.file, target.file, ignored))) {
    throw Error(ErrorCode::kUsage, Text::tr("source and target are the same database"), target.shown(),
                Text::tr("Name another target"));
  }
}

CopyReport copyInto(Connection& reading, const std::string& to, const ProgressCallback& progress) {
  Connection writing = openDatabase(to, OpenMode::kCreate);
  Transaction together(writing);  // tables and rows in one transaction
  migrate(writing, embeddedMigrations(), {.softwareVersion = softwareVersion(), .backup = false});
  CopyReport report = copyRecord(reading, writing, [&](const CopyStep& step) {
    tellProgress(progress, wordsOf(step), fractionOf(step));
  });
  sealChanges(writing);
  clearMoving(writing, utcNow_us());  // the copy is the living record
  together.commit();
  return report;
}

void refuseTaken(const fs::path& file) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(file, ignored))) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("exists already"), file.string(),
                Text::tr("Name another target"));
  }
}

/// A new file gets its name when it is complete.
CopyReport copyAll(const std::string& from, const std::string& to, const ProgressCallback& progress) {
  Connection reading = openRecord(from, OpenMode::kReadOnly);
  const Locator target = parseLocator(to);
  std::error_code failed;
  if (target.engine != Engine::kSqlite || fs::exists(target.file, failed)) {
    return copyInto(reading, to, progress);
  }
  const FileInTheMaking making(target.file);
  CopyReport report = copyInto(reading, making.path().string(), progress);
  if (!checkpointSqlite(making.path())) {
    refuseUnwritable(target.file);
  }
  refuseTaken(target.file);  // if another program was faster, keep its file
  fs::rename(making.path(), target.file, failed);
  if (failed) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("cannot be written"), target.file,
                Text::tr("Close other programs that use it"));
  }
  return report;
}

}  // namespace

CopyReport copyDatabase(SessionContext& session, const std::string& to, const ProgressCallback& progress,
                        CopyUse use) {
  session.require(Operation::kDatabaseRestore);
  requireOther(session.key().locator, to);
  if (const std::string place = movedTo(session.connection()); !place.empty()) {
    refuse(Text::tr("this record has moved to %1 already", place), session.connection().location(),
           Text::tr("Move the record there, or take the first move back"));
  }
  AuditNote note{.action = AuditAction::kDatabaseMove,
                 .objectKind = AuditObject::kDatabase,
                 .objectId = parseLocator(to).shown()};
  // Before copying, so that both records contain the entry.
  Transaction together(session.connection());
  RegisteredMove move(session.connection(), session.key().locator, to, session.now_us());
  session.note(note);
  if (use == CopyUse::kMove) {
    noteMoving(session, to);
  }
  together.commit();
  try {
    return copyAll(session.key().locator, to, progress);
  } catch (...) {
    Transaction givenUp(session.connection());
    move.giveUp(session.now_us());
    clearMoving(session.connection(), session.now_us());
    note.action = AuditAction::kDatabaseMoveGivenUp;
    session.note(note);
    givenUp.commit();
    throw;
  }
}

}  // namespace torsio
