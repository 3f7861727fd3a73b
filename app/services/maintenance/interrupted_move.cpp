// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/interrupted_move.h"

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include <nlohmann/json.hpp>

#include "app/services/access/moved_record.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/migrations/file_in_the_making.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Returns whether the other database contains the whole copy; empty: it cannot be told now.
std::optional<bool> holdsCopy(const BegunMove& move) {
  const Locator place = parseLocator(move.locator);
  try {
    std::optional<FileInTheMaking> nobodyElse;
    if (place.engine == Engine::kSqlite) {
      nobodyElse.emplace(place.file);
      std::error_code failed;
      if (!std::filesystem::exists(place.file, failed)) {
        return failed ? std::nullopt : std::optional(false);
      }
    }
    Connection there = openDatabase(move.locator, OpenMode::kReadOnly);
    if (isBeingFilled(there)) {
      return std::nullopt;
    }
    return checkSchema(there, embeddedMigrations()).version > 0 && AuditRepository(there).contains(move.head);
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

Text settleMove(SessionContext& session) {
  Connection& connection = session.connectionWithoutRight();
  const BegunMove move = begunMove(connection);
  const std::optional<bool> complete = move.locator.empty() ? std::nullopt : holdsCopy(move);
  if (!complete) {
    return {};
  }
  const std::string place = parseLocator(move.locator).shown();
  Transaction transaction(connection);
  if (*complete) {
    finishMove(connection, place, session.now_us());
    session.note(AuditAction::kDatabaseMove, AuditObject::kDatabase, place, {{"finished", true}});
  } else {
    clearMoving(connection, session.now_us());
    session.note(AuditAction::kDatabaseMoveGivenUp, AuditObject::kDatabase, place, {{"interrupted", true}});
  }
  transaction.commit();
  return *complete ? Text::tr("The interrupted move to %1 was finished: the record lives there", place)
                   : Text::tr("The interrupted move to %1 was undone: the record lives here", place);
}

}  // namespace torsio
