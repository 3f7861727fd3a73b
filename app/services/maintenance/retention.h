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

/// All functions below require kRetentionManage; changes are audited.
[[nodiscard]] std::vector<RetentionRule> retentionRules(SessionContext& session);
void setRetentionRule(SessionContext& session, const std::string& category, std::int64_t keep_days,
                      const std::string& basis);
/// Removes the rule of a category: its records are kept indefinitely.
void removeRetentionRule(SessionContext& session, const std::string& category);

/// Returns the review queue: whose record is due now and why, including those on hold, longest due first.
[[nodiscard]] std::vector<RetentionItem> retentionQueue(SessionContext& session);

/// Puts records on hold, indefinitely or until a date, or releases them; all or nothing. Throws Error
/// (kBadParameter) if nobody is chosen, without a reason, or for a past date.
void lockRecords(SessionContext& session, std::span<const PersonId> personIds, const std::string& reason);
void extendRecords(SessionContext& session, std::span<const PersonId> personIds, std::int64_t untilUtc_us,
                   const std::string& reason);
void releaseRecords(SessionContext& session, std::span<const PersonId> personIds, const std::string& reason);

/// Result of erasing due records, or of its dry run.
struct RetentionOutcome {
  std::vector<RetentionItem> erased{};   ///< erased, or to be erased
  std::vector<RetentionItem> skipped{};  ///< on hold
  std::int64_t recordings = 0;           ///< trials whose samples are erased
  bool dryRun = true;
};
/// Erases the people chosen from the queue, each in a separate transaction through erasePerson(); also
/// requires kPersonErase. A dry run changes nothing. Throws Error (kBadData), before anything is erased, if
/// somebody is not due.
RetentionOutcome eraseDue(SessionContext& session, std::span<const PersonId> personIds,
                          const std::string& reason, bool dryRun);

/// Amount of simulated data in the record.
struct DemonstrationSize {
  std::int64_t people = 0;
  std::int64_t trials = 0;
  std::int64_t marks = 0;
  std::int64_t rows = 0;  ///< in all tables
};

/// For the confirmation question. kPersonErase.
[[nodiscard]] DemonstrationSize demonstrationSize(SessionContext& session);

/// Removes all demonstration data at once; real data are not touched (removeDemonstration in
/// db/repository/system/demonstration_data.h). kPersonErase, audited. Returns what was removed. Throws Error
/// (kBadData) if real data depend on simulated ones; nothing is removed then.
DemonstrationSize removeDemonstrationData(SessionContext& session, const std::string& reason);

}  // namespace torsio
