// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/maintenance/retention.h"

#include <algorithm>

#include "db/repository/people/person_data.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

void requireReason(const std::string& reason, const std::string& where) {
  if (reason.empty()) {
    throw Error(ErrorCode::kBadParameter, "this needs a reason", where, "Say why, for the audit trail");
  }
}

void hold(SessionContext& workplace, const RetentionHold& decision) {
  workplace.require(Operation::kRetentionManage);
  requireReason(decision.reason, decision.personId);
  Transaction transaction(workplace.connection());
  RetentionHold stored = decision;
  stored.decidedBy = workplace.actor().userId;
  stored.decidedUtc_us = workplace.now_us();
  RetentionRepository(workplace.connection()).addHold(stored);
  workplace.note({.action = "retention." + decision.kind,
                  .objectKind = "person",
                  .objectId = decision.personId,
                  .reason = decision.reason});
  transaction.commit();
}

std::int64_t recordingsOf(Connection& connection, const std::string& code) {
  return static_cast<std::int64_t>(
      TrialRepository(connection).list({.traineeCode = code, .limit = 1'000'000}).size());
}

}  // namespace

std::vector<RetentionRule> retentionRules(SessionContext& workplace) {
  workplace.require(Operation::kRetentionManage);
  return RetentionRepository(workplace.connection()).rules();
}

void setRetentionRule(SessionContext& workplace, const std::string& category, std::int64_t keep_days,
                      const std::string& basis) {
  workplace.require(Operation::kRetentionManage);
  Transaction transaction(workplace.connection());
  RetentionRepository(workplace.connection()).setRule({category, keep_days, basis, workplace.now_us()});
  workplace.note({.action = "retention.rule",
                  .objectKind = "retention_rule",
                  .objectId = category,
                  .newJson = R"({"keep_days":)" + std::to_string(keep_days) + "}",
                  .reason = basis});
  transaction.commit();
}

void removeRetentionRule(SessionContext& workplace, const std::string& category) {
  workplace.require(Operation::kRetentionManage);
  Transaction transaction(workplace.connection());
  RetentionRepository(workplace.connection()).removeRule(category);
  workplace.note({.action = "retention.remove_rule", .objectKind = "retention_rule", .objectId = category});
  transaction.commit();
}

std::vector<RetentionItem> retentionQueue(SessionContext& workplace) {
  workplace.require(Operation::kRetentionManage);
  return RetentionRepository(workplace.connection()).due(workplace.now_us());
}

void lockRecord(SessionContext& workplace, const std::string& personId, const std::string& reason) {
  hold(workplace, {.personId = personId, .kind = "lock", .reason = reason});
}

void extendRecord(SessionContext& workplace, const std::string& personId, std::int64_t untilUtc_us,
                  const std::string& reason) {
  workplace.require(Operation::kRetentionManage);
  if (untilUtc_us <= workplace.now_us()) {
    throw Error(ErrorCode::kBadParameter, "this day has passed", personId, "Choose a later day");
  }
  hold(workplace, {.personId = personId, .kind = "extend", .untilUtc_us = untilUtc_us, .reason = reason});
}

void releaseRecord(SessionContext& workplace, const std::string& personId, const std::string& reason) {
  hold(workplace, {.personId = personId, .kind = "release", .reason = reason});
}

RetentionOutcome eraseDue(SessionContext& workplace, std::span<const std::string> personIds,
                          const std::string& reason, bool dryRun) {
  if (!dryRun) {
    workplace.require(Operation::kPersonErase);
    requireReason(reason, "retention");
  }
  const std::vector<RetentionItem> queue = retentionQueue(workplace);
  RetentionOutcome outcome{.dryRun = dryRun};
  for (const std::string& id : personIds) {
    const auto item = std::find_if(queue.begin(), queue.end(),
                                   [&](const RetentionItem& due) { return due.personId == id; });
    if (item == queue.end()) {
      throw Error(ErrorCode::kBadData, "this record is not due; nothing was erased", id,
                  "Read the queue again");
    }
    (item->held ? outcome.skipped : outcome.erased).push_back(*item);
  }
  for (const RetentionItem& item : outcome.erased) {
    outcome.recordings += recordingsOf(workplace.connection(), item.code);
    if (dryRun) {
      continue;
    }
    erasePerson(workplace.connection(), item.personId, workplace.actor().userId,
                reason + " (retention: " + item.category + ")", workplace.now_us());
  }
  return outcome;
}

}  // namespace torsio
