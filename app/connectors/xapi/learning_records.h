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

/// An entry that the store refused for good.
struct DeadLetter {
  LearningEvent event{};
  Text answer{};
};

/// How it stands with the learning records of the centre.
struct LearningRecordsView {
  LrsSettings settings{};
  bool hasKey = false;  ///< of this station
  LearningEventCounts counts{};
  Text trouble{};                  ///< what the store answered last to something that waits; empty: nothing
  std::vector<DeadLetter> dead{};  ///< newest answer first, a thousand at most
};

/// kSettingsEdit.
[[nodiscard]] LearningRecordsView learningRecords(SessionContext& session);
/// Lets everything that waits or was refused for good be tried at once. Audited. Returns how many had been
/// refused. kSettingsEdit.
std::int64_t retryLearningRecords(SessionContext& session);
/// Gives up what was refused for good. Audited. Returns how many. kSettingsEdit.
std::int64_t dropLearningRecords(SessionContext& session);

/// Sends what is due from this station, now. kReportExportCoded. Throws Error{kBadData} while the centre
/// sends nothing or this station has no key; DbError. A worker thread or the command line; takes as long as
/// it takes.
LrsDelivery sendLearningRecords(SessionContext& session);

}  // namespace torsio
