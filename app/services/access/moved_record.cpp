// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/moved_record.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "assessment/domain/people/audit_terms.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

// Names of settings.
constexpr const char* kMovedTo = "record.moved_to";
constexpr const char* kMovingTo = "record.moving_to";  // "LENGTH HASH LOCATOR"

constexpr std::array kHarmless = {
    Operation::kPractice,          Operation::kTrialViewOwn,       Operation::kTrialViewAssigned,
    Operation::kTrialViewCoded,    Operation::kMarkViewOwn,        Operation::kMarkViewCoded,
    Operation::kPersonViewCoded,   Operation::kPersonViewIdentity, Operation::kPersonExport,
    Operation::kPersonErase,       Operation::kRetentionManage,    Operation::kAllocationView,
    Operation::kReportExportCoded, Operation::kReportExportNamed,  Operation::kAuditView,
    Operation::kDatabaseBackup,    Operation::kDatabaseRestore};

}  // namespace

std::string movedTo(Connection& connection) {
  return SettingRepository(connection).value(kMovedTo).value_or("");
}

bool addsToTheRecord(Operation operation) {
  return std::find(kHarmless.begin(), kHarmless.end(), operation) == kHarmless.end();
}

BegunMove begunMove(Connection& connection) {
  std::istringstream mark(SettingRepository(connection).value(kMovingTo).value_or(""));
  BegunMove move;
  mark >> move.head.length >> move.head.hash >> std::ws;
  std::getline(mark, move.locator);
  return move;
}

void noteMoving(SessionContext& session, const std::string& locator) {
  session.require(Operation::kDatabaseRestore);
  Locator place = parseLocator(locator);
  place.password.clear();
  std::error_code ignored;
  const std::string kept = place.engine == Engine::kPostgresql
                               ? addressOf(place)
                               : std::filesystem::absolute(place.file, ignored).string();
  const TrailHead head = AuditRepository(session.connection()).head();
  SettingRepository(session.connection())
      .set(kMovingTo, std::to_string(head.length) + " " + head.hash + " " + kept, session.now_us());
}

void finishMove(Connection& connection, const std::string& place, std::int64_t utc_us) {
  Transaction transaction(connection);
  SettingRepository(connection).set(kMovedTo, place, utc_us);
  clearMoving(connection, utc_us);
  transaction.commit();
}

void clearMoving(Connection& connection, std::int64_t utc_us) {
  if (!begunMove(connection).locator.empty()) {
    SettingRepository(connection).set(kMovingTo, "", utc_us);
  }
}

Text moveNotice(Connection& connection) {
  if (const std::string place = movedTo(connection); !place.empty()) {
    return Text::tr("This record has moved to %1 and takes nothing new: work with the record there", place);
  }
  if (const std::string locator = begunMove(connection).locator; !locator.empty()) {
    return Text::tr("This record is being moved to %1 and takes nothing new meanwhile",
                    parseLocator(locator).shown());
  }
  return {};
}

void noteMoved(SessionContext& session) {
  session.require(Operation::kDatabaseRestore);
  finishMove(session.connection(), parseLocator(begunMove(session.connection()).locator).shown(),
             session.now_us());
}

void takeBackMove(SessionContext& session, const std::string& reason) {
  session.require(Operation::kDatabaseRestore);
  const std::string locator = begunMove(session.connection()).locator;
  const std::string place = locator.empty() ? movedTo(session.connection()) : parseLocator(locator).shown();
  if (reason.empty()) {
    refuseParameter(Text::tr("the reason is missing"), Text::tr("record"), Text::tr("Write why you do it"));
  }
  if (place.empty()) {
    refuse(Text::tr("this record was not moved"), session.connection().location(),
           Text::tr("Go on working with it"));
  }
  Transaction transaction(session.connection());
  SettingRepository(session.connection()).set(kMovedTo, "", session.now_us());
  clearMoving(session.connection(), session.now_us());
  session.note({.action = AuditAction::kDatabaseMoveGivenUp,
                .objectKind = AuditObject::kDatabase,
                .objectId = place,
                .reason = reason});
  transaction.commit();
}

}  // namespace torsio
