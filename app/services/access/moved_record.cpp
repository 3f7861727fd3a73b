// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/moved_record.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "assessment/domain/people/audit_terms.h"
#include "db/connection/connection.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr const char* kMovedTo = "record.moved_to";  // name of the setting

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

void noteMoved(SessionContext& session, const std::string& place) {
  session.require(Operation::kDatabaseRestore);
  SettingRepository(session.connection()).set(kMovedTo, place, session.now_us());
}

void takeBackMove(SessionContext& session, const std::string& reason) {
  session.require(Operation::kDatabaseRestore);
  const std::string place = movedTo(session.connection());
  if (reason.empty()) {
    refuseParameter(Text::tr("the reason is missing"), Text::tr("record"), Text::tr("Write why you do it"));
  }
  if (place.empty()) {
    refuse(Text::tr("this record was not moved"), session.connection().location(),
           Text::tr("Go on working with it"));
  }
  Transaction transaction(session.connection());
  SettingRepository(session.connection()).set(kMovedTo, "", session.now_us());
  session.note({.action = AuditAction::kDatabaseMoveGivenUp,
                .objectKind = AuditObject::kDatabase,
                .objectId = place,
                .reason = reason});
  transaction.commit();
}

}  // namespace torsio
