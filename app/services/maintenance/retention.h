// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/retention.h"

namespace torsio {

/// kRetentionManage, as all below; every change is audited.
[[nodiscard]] std::vector<RetentionRule> retentionRules(SessionContext& session);
void setRetentionRule(SessionContext& session, const std::string& category, std::int64_t keep_days,
                      const std::string& basis);
/// Takes the rule of a category away: its records are kept without limit.
void removeRetentionRule(SessionContext& session, const std::string& category);

/// The review queue: whose record is due now and why, those who are held among them, longest due first.
[[nodiscard]] std::vector<RetentionItem> retentionQueue(SessionContext& session);

/// Keeps records for good, or until a day; release ends it: all of them or none. Throws Error (kBadParameter)
/// without anybody or a reason, or for a day that has passed.
void lockRecords(SessionContext& session, std::span<const PersonId> personIds, const std::string& reason);
void extendRecords(SessionContext& session, std::span<const PersonId> personIds, std::int64_t untilUtc_us,
                   const std::string& reason);
void releaseRecords(SessionContext& session, std::span<const PersonId> personIds, const std::string& reason);

/// What an erase of due records would do, or did.
struct RetentionOutcome {
  std::vector<RetentionItem> erased{};   ///< or would be
  std::vector<RetentionItem> skipped{};  ///< held
  std::int64_t recordings = 0;           ///< trials whose samples go with them
  bool dryRun = true;
};
/// The reviewer's choice out of the queue. A dry run changes nothing. Else also kPersonErase: each person is
/// erased in a transaction of their own through erasePerson. Throws Error (kBadData) before anything is
/// erased when somebody is not due.
RetentionOutcome eraseDue(SessionContext& session, std::span<const PersonId> personIds,
                          const std::string& reason, bool dryRun);

}  // namespace torsio
