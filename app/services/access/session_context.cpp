// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/session_context.h"

#include <algorithm>
#include <utility>

#include <QString>
#include <nlohmann/json.hpp>

#include "app/services/access/moved_record.h"
#include "app/services/access/station_name.h"
#include "app/services/base/build_info.h"
#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/server_roles.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"

namespace torsio {

Connection openUpToDate(const std::string& locator) {
  MigrationOptions options;
  options.softwareVersion = softwareVersion();
  options.station = stationName();
  return openRecord(locator, OpenMode::kCreate, options);
}

struct SessionContext::Owned {
  explicit Owned(const std::string& locator) : connection(openUpToDate(locator)) {}
  Connection connection;
  SystemIdSource ids;
};

namespace {

/// Returns the actor's identification for the audit trail.
std::string actorText(const Actor& actor) {
  if (!actor.systemAccount.empty()) {
    return "system:" + actor.systemAccount;
  }
  return actor.userId.empty() ? std::string("torsio") : std::string(actor.userId);
}

}  // namespace

bool Actor::hasRole(const std::string& role) const {
  return std::find(roles.begin(), roles.end(), role) != roles.end();
}

SessionContext::SessionContext(const SessionKey& key)
    : owned_(std::make_unique<Owned>(key.locator)),
      connection_(&owned_->connection),
      ids_(&owned_->ids),
      key_(key),
      now_(utcNow_us) {}

SessionContext::SessionContext(Connection& connection, IdSource& ids, SessionKey key, UtcClock now)
    : connection_(&connection), ids_(&ids), key_(std::move(key)), now_(std::move(now)) {}

SessionContext::~SessionContext() = default;
SessionContext::SessionContext(SessionContext&&) noexcept = default;

void SessionContext::reconnect() {
  if (owned_) {
    owned_->connection = openUpToDate(key_.locator);
  }
}

Connection& SessionContext::connection() const {
  if (!asked_) {
    throw ContractError("a service reached for the record and had asked for no right");
  }
  return *connection_;
}

Connection& SessionContext::connectionWithoutRight() const {
  tellSession(*connection_, key_.actor.serverToken);
  return *connection_;
}

bool SessionContext::may(Operation operation) const {
  if (!key_.actor.systemAccount.empty()) {
    switch (operation) {
      case Operation::kDatabaseBackup:
      case Operation::kDatabaseRestore:
      case Operation::kResultsCompute:
      case Operation::kMarkViewCoded:
      case Operation::kReportExportCoded:
      case Operation::kReportExportNamed:
        return true;
      default:
        return false;
    }
  }
  tellSession(*connection_, key_.actor.serverToken);
  if (key_.actor.userId.empty()) {
    return false;
  }
  if (key_.actor.practiceOnly && operation != Operation::kPractice) {
    return false;
  }
  return AccessRepository(*connection_).allowed(key_.actor.userId, std::string(operationCode(operation)));
}

namespace {

/// Throws if the operation would add something to a record that was moved elsewhere.
void requireLiving(Connection& connection, Operation operation) {
  if (!addsToTheRecord(operation)) {
    return;
  }
  if (const std::string place = movedTo(connection); !place.empty()) {
    throw Error(ErrorCode::kDatabase, Text::tr("this record has moved to %1 and takes nothing new", place),
                connection.location(),
                Text::tr("Work with the record there; an administrator can take the move back"));
  }
  if (const Text moving = moveNotice(connection); !moving.empty()) {
    throw Error(ErrorCode::kDatabase, Text::tr("this record is being moved"), connection.location(),
                Text::tr("Wait until the move has ended; if it was interrupted, start Torsio again"));
  }
}

}  // namespace

void SessionContext::require(Operation operation) const {
  if (may(operation)) {
    requireLiving(*connection_, operation);
    asked_ = true;
    return;
  }
  const std::string code(operationCode(operation));
  if (key_.actor.userId.empty()) {
    throw Error(ErrorCode::kPermission, Text::tr("nobody is signed in"), code, Text::tr("Sign in first"));
  }
  throw Error(ErrorCode::kPermission,
              Text::tr("you are signed in as %1, who may not do this", key_.actor.login), code,
              Text::tr("Ask an administrator, or sign in as somebody who may"));
}

void SessionContext::requireEither(Operation first, Operation second) const {
  require(may(first) ? first : second);
}

void SessionContext::requireOwn(Operation operation, const PersonId& personId) const {
  require(operation);
  if (!key_.actor.personId.empty() && key_.actor.personId == personId) {
    return;
  }
  throw Error(ErrorCode::kPermission, Text::tr("this belongs to somebody else"),
              std::string(operationCode(operation)), Text::tr("Open your own record"));
}

void SessionContext::note(const AuditNote& note) const {
  tellSession(*connection_, key_.actor.serverToken);
  AuditRepository(*connection_)
      .append({.atUtc_us = now_us(),
               .actor = actorText(key_.actor),
               .station = key_.station,
               .action = note.action,
               .objectKind = note.objectKind,
               .objectId = note.objectId,
               .oldJson = note.oldJson,
               .newJson = note.newJson,
               .reason = note.reason});
}

void SessionContext::note(AuditAction action, AuditObject objectKind, const std::string& objectId) const {
  note({action, objectKind, objectId});
}

void SessionContext::note(AuditAction action, AuditObject objectKind, const std::string& objectId,
                          const nlohmann::json& now, const std::string& reason) const {
  noteChange(action, objectKind, objectId, {}, now, reason);
}

void SessionContext::noteChange(AuditAction action, AuditObject objectKind, const std::string& objectId,
                                const nlohmann::json& before, const nlohmann::json& now,
                                const std::string& reason) const {
  const auto told = [](const nlohmann::json& json) { return json.is_null() ? std::string() : json.dump(); };
  note({action, objectKind, objectId, told(before), told(now), reason});
}

}  // namespace torsio
