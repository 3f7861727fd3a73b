// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/occasion.h"

namespace torsio {

class Connection;
class SessionContext;
struct ProtocolDeviation;

/// Live sheets that should be in before the trainee continues training: afterwards they can no longer be
/// scored.
struct ScoringDue {
  Occasion occasion{};
  std::size_t asked = 0;
  std::size_t submitted = 0;
};
/// Returns missing sheets of the latest occasion reached. Empty if there are none, none were requested, or
/// the deviation was recorded already. The caller has checked a right.
[[nodiscard]] std::optional<ScoringDue> scoringDue(Connection& connection, const CohortId& cohortId,
                                                   const EnrolmentId& enrolmentId, std::int64_t trained_us);

/// Returns, without storing it, the deviation that training continued anyway, with its reason.
[[nodiscard]] ProtocolDeviation trainedBeforeScoring(const SessionContext& session, const ScoringDue& due,
                                                     const CohortId& cohortId, const EnrolmentId& enrolmentId,
                                                     const std::string& reason, bool demonstration);

}  // namespace torsio
