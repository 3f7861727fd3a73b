// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/retention.h"

#include <algorithm>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/services/access/two_people.h"
#include "app/services/maintenance/person_package.h"
#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/migrations/backup.h"
#include "db/repository/people/retention_repository.h"
#include "db/repository/system/demonstration_data.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

void requireReason(const std::string& reason, const std::string& where) {
  if (reason.empty()) {
    refuseParameter(Text::tr("this needs a reason"), where, Text::tr("Say why, for the audit trail"));
  }
}

AuditAction actionOf(HoldKind kind) {
  switch (kind) {
    case HoldKind::kLock:
      return AuditAction::kRetentionLock;
    case HoldKind::kExtend:
      return AuditAction::kRetentionExtend;
    case HoldKind::kRelease:
      return AuditAction::kRetentionRelease;
  }
  throw ContractError("no such decision");
}

void hold(SessionContext& session, std::span<const PersonId> personIds, RetentionHold decision) {
  session.require(Operation::kRetentionManage);
  if (personIds.empty()) {
    refuseParameter(Text::tr("nobody was chosen"), Text::tr("retention"),
                    Text::tr("Choose at least one person"));
  }
  requireReason(decision.reason, personIds.front());
  Transaction transaction(session.connection());
  decision.decidedBy = session.actor().userId;
  decision.decidedUtc_us = session.now_us();
  for (const PersonId& id : personIds) {
    decision.personId = id;
    RetentionRepository(session.connection()).addHold(decision);
    session.note(actionOf(decision.kind), AuditObject::kPerson, id, {}, decision.reason);
  }
  transaction.commit();
}

std::int64_t recordingsOf(Connection& connection, const std::string& code) {
  return static_cast<std::int64_t>(
      TrialRepository(connection).list({.traineeCode = code, .limit = 1'000'000}).size());
}

}  // namespace

std::vector<RetentionRule> retentionRules(SessionContext& session) {
  session.require(Operation::kRetentionManage);
  return RetentionRepository(session.connection()).rules();
}

void setRetentionRule(SessionContext& session, const std::string& category, std::int64_t keep_days,
                      const std::string& basis) {
  session.require(Operation::kRetentionManage);
  Transaction transaction(session.connection());
  RetentionRepository(session.connection()).setRule({category, keep_days, basis, session.now_us()});
  session.note(AuditAction::kRetentionRule, AuditObject::kRetentionRule, category, {{"keep_days", keep_days}},
               basis);
  transaction.commit();
}

void removeRetentionRule(SessionContext& session, const std::string& category) {
  session.require(Operation::kRetentionManage);
  Transaction transaction(session.connection());
  RetentionRepository(session.connection()).removeRule(category);
  session.note(AuditAction::kRetentionRemoveRule, AuditObject::kRetentionRule, category);
  transaction.commit();
}

std::vector<RetentionItem> retentionQueue(SessionContext& session) {
  session.require(Operation::kRetentionManage);
  return RetentionRepository(session.connection()).due(session.now_us());
}

void lockRecords(SessionContext& session, std::span<const PersonId> personIds, const std::string& reason) {
  hold(session, personIds, {.kind = HoldKind::kLock, .reason = reason});
}

void extendRecords(SessionContext& session, std::span<const PersonId> personIds, std::int64_t untilUtc_us,
                   const std::string& reason) {
  session.require(Operation::kRetentionManage);
  if (untilUtc_us <= session.now_us()) {
    refuseParameter(Text::tr("this day has passed"), Text::tr("retention"), Text::tr("Choose a later day"));
  }
  hold(session, personIds, {.kind = HoldKind::kExtend, .untilUtc_us = untilUtc_us, .reason = reason});
}

void releaseRecords(SessionContext& session, std::span<const PersonId> personIds, const std::string& reason) {
  hold(session, personIds, {.kind = HoldKind::kRelease, .reason = reason});
}

RetentionOutcome eraseDue(SessionContext& session, std::span<const PersonId> personIds,
                          const std::string& reason, bool dryRun) {
  if (!dryRun) {
    session.require(Operation::kPersonErase);
    requireReason(reason, "retention");
  }
  const std::vector<RetentionItem> queue = retentionQueue(session);
  RetentionOutcome outcome{.dryRun = dryRun};
  for (const PersonId& id : personIds) {
    const auto item = std::find_if(queue.begin(), queue.end(),
                                   [&](const RetentionItem& due) { return due.personId == id; });
    if (item == queue.end()) {
      refuse(Text::tr("this record is not due; nothing was erased"), id, Text::tr("Read the queue again"));
    }
    (item->held ? outcome.skipped : outcome.erased).push_back(*item);
  }
  for (const RetentionItem& item : outcome.erased) {
    if (!dryRun && !mayEraseNow(session, item.personId)) {
      throw SecondPersonNeeded(DutyAct::kErase, item.personId);  // checked before anybody is erased
    }
  }
  for (const RetentionItem& item : outcome.erased) {
    outcome.recordings += recordingsOf(session.connection(), item.code);
    if (dryRun) {
      continue;
    }
    eraseGuarded(session, item.personId, reason + " (retention: " + item.category + ")");
  }
  return outcome;
}

namespace {

DemonstrationSize sizeOf(const std::vector<DemonstrationRows>& tables) {
  DemonstrationSize size;
  for (const DemonstrationRows& table : tables) {
    size.rows += table.rows;
    if (table.table == "person") {
      size.people += table.rows;
    }
    if (table.table == "trial") {
      size.trials += table.rows;
    }
    if (table.table == "training_mark" || table.table == "evaluation_mark") {
      size.marks += table.rows;
    }
  }
  return size;
}

}  // namespace

DemonstrationSize demonstrationSize(SessionContext& session) {
  session.require(Operation::kPersonErase);
  return sizeOf(demonstrationRows(session.connection()));
}

DemonstrationSize removeDemonstrationData(SessionContext& session, const std::string& reason) {
  session.require(Operation::kPersonErase);
  const DemonstrationSize size = sizeOf(removeDemonstration(session.connection(), session.actor().userId,
                                                            session.station(), reason, session.now_us()));
  compactDatabase(session.connection());
  return size;
}

}  // namespace torsio
