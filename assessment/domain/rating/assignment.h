// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/sheet_state.h"

namespace torsio {

/// A request to one rater for one sheet about one trainee at one occasion.
struct Assignment {
  AssignmentId id{};
  RaterId raterId{};
  EnrolmentId enrolmentId{};
  std::string occasionCode{};
  TrialId trialId{};  ///< empty: live, on the real arm
  RubricRevisionId rubricRevisionId{};
  std::string caseLabel{};    ///< all that the rater sees: "7F"
  std::int64_t position = 0;  ///< shuffled order of this rater
  std::optional<std::int64_t> dueUtc_us{};
  std::string assignedBy{};
  std::int64_t assignedUtc_us = 0;
  bool demonstration = false;
};

/// One row of a rater's queue. Blinded: reveals neither trainee nor group nor stage.
struct QueueEntry {
  AssignmentId assignmentId{};
  std::string caseLabel{};
  TrialId trialId{};
  RubricRevisionId rubricRevisionId{};
  std::optional<std::int64_t> dueUtc_us{};
  SheetState state = SheetState::kOpen;
  std::int64_t submittedUtc_us = 0;  ///< of the newest version; 0: not submitted
};

/// An assignment and the state of its sheet, without marks.
struct AssignmentStatus {
  Assignment assignment{};
  SheetState state = SheetState::kOpen;
  std::int64_t changedUtc_us = 0;  ///< of the draft or the newest mark; 0: neither exists
};

}  // namespace torsio
