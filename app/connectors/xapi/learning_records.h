// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "app/connectors/xapi/lrs_delivery.h"
#include "app/connectors/xapi/lrs_settings.h"
#include "app/services/access/session_context.h"
#include "assessment/domain/people/learning_event.h"
#include "sim/core/text.h"

namespace torsio {

/// An entry that the store refused permanently.
struct DeadLetter {
  LearningEvent event{};
  Text answer{};
};

/// State of the centre's learning records.
struct LearningRecordsView {
  LrsSettings settings{};
  bool hasKey = false;  ///< on this station
  LearningEventCounts counts{};
  Text trouble{};                  ///< the store's last answer to a waiting entry; empty: none
  std::vector<DeadLetter> dead{};  ///< newest answer first, at most a thousand
};

/// kSettingsEdit.
[[nodiscard]] LearningRecordsView learningRecords(SessionContext& session);
/// Makes all waiting and refused entries due now. Audited. Returns how many had been refused. kSettingsEdit.
std::int64_t retryLearningRecords(SessionContext& session);
/// Discards permanently refused entries. Audited. Returns how many. kSettingsEdit.
std::int64_t dropLearningRecords(SessionContext& session);

/// Sends due entries from this station now; may take long. kReportExportCoded. Throws Error{kBadData} if the
/// centre sends nothing or this station has no key; DbError. A worker thread or the command line.
LrsDelivery sendLearningRecords(SessionContext& session);

}  // namespace torsio
