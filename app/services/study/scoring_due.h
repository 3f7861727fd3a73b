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

/// Live sheets that should be in before somebody trains on: what was not scored by then can never be scored.
struct ScoringDue {
  Occasion occasion{};
  std::size_t asked = 0;
  std::size_t submitted = 0;
};
/// Of the newest occasion that this much training has reached. Empty: all are in, nobody was asked, or the
/// deviation was noted already. The caller has asked for a right.
[[nodiscard]] std::optional<ScoringDue> scoringDue(Connection& connection, const CohortId& cohortId,
                                                   const EnrolmentId& enrolmentId, std::int64_t trained_us);

/// The deviation that training went on nevertheless, with the reason that was given; not stored yet.
[[nodiscard]] ProtocolDeviation trainedBeforeScoring(const SessionContext& session, const ScoringDue& due,
                                                     const CohortId& cohortId, const EnrolmentId& enrolmentId,
                                                     const std::string& reason, bool demonstration);

}  // namespace torsio
