// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/database_copy.h"

#include <filesystem>
#include <system_error>

#include "app/services/base/build_info.h"
#include "app/services/maintenance/copies.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/migrations/backup.h"
#include "db/migrations/file_in_the_making.h"
#include "db/migrations/migrations.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

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

CopyReport copyDatabase(SessionContext& session, const std::string& to, const ProgressCallback& progress) {
  session.require(Operation::kDatabaseRestore);
  requireOther(session.key().locator, to);
  AuditNote note{.action = AuditAction::kDatabaseMove,
                 .objectKind = AuditObject::kDatabase,
                 .objectId = parseLocator(to).shown()};
  // Before copying, so that both records contain the entry.
  Transaction together(session.connection());
  RegisteredMove move(session.connection(), session.key().locator, to, session.now_us());
  session.note(note);
  together.commit();
  try {
    return copyAll(session.key().locator, to, progress);
  } catch (...) {
    Transaction givenUp(session.connection());
    move.giveUp(session.now_us());
    note.action = AuditAction::kDatabaseMoveGivenUp;
    session.note(note);
    givenUp.commit();
    throw;
  }
}

}  // namespace torsio
