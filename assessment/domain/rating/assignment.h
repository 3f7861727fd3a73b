// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

enum class SheetState : std::uint8_t {
  kOpen,       ///< assigned, nothing entered
  kDraft,      ///< begun, not submitted
  kSubmitted,  ///< sealed in at least one version
  kWithdrawn,  ///< assignment withdrawn from the rater
};
inline constexpr std::array<Term<SheetState>, 4> kSheetStates{{
    {SheetState::kOpen, "open", Text::tr("open")},
    {SheetState::kDraft, "draft", Text::tr("draft")},
    {SheetState::kSubmitted, "submitted", Text::tr("submitted")},
    {SheetState::kWithdrawn, "withdrawn", Text::tr("taken back")},
}};
[[nodiscard]] constexpr const auto& termsOf(SheetState) noexcept {
  return kSheetStates;
}

/// Derives the state from the three stored facts. Withdrawal takes precedence over submission, submission
/// over the draft.
[[nodiscard]] constexpr SheetState sheetStateOf(bool withdrawn, bool submitted, bool drafted) noexcept {
  return withdrawn   ? SheetState::kWithdrawn
         : submitted ? SheetState::kSubmitted
         : drafted   ? SheetState::kDraft
                     : SheetState::kOpen;
}

/// True while a submission is expected: open or draft.
[[nodiscard]] constexpr bool isOutstanding(SheetState state) noexcept {
  return state == SheetState::kOpen || state == SheetState::kDraft;
}

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

/// The one deadline shown to a rater for all recorded cases, UTC in microseconds: the latest of them.
/// Individual deadlines would sort the cases by occasion, and a deadline that moved with each submitted sheet
/// would reveal the occasion of the remaining ones.
class BlindedDue {
 public:
  /// Adds the deadline of a recorded case, submitted or not; empty if it has none.
  void add(std::optional<std::int64_t> due_us) {
    if (due_us) {
      latest_us_ = std::max(latest_us_.value_or(*due_us), *due_us);
    }
  }
  /// Returns the deadline to show; empty if no case has one.
  [[nodiscard]] std::optional<std::int64_t> latest() const noexcept { return latest_us_; }

 private:
  std::optional<std::int64_t> latest_us_;
};

/// A trainee called to the real arm at one occasion, which opens the raters' live sheets of this case.
struct LiveCall {
  LiveCallId id{};
  EnrolmentId enrolmentId{};
  std::string occasionCode{};
  std::string room{};
  std::string calledBy{};  ///< user id
  std::int64_t calledUtc_us = 0;
  std::optional<std::int64_t> endedUtc_us{};  ///< empty: the trainee is at the arm
  bool cancelled = false;                     ///< called by mistake: the sheets are closed again
};

/// A call as shown to a rater. Blinded: reveals neither trainee nor group nor stage.
struct CallNotice {
  AssignmentId assignmentId{};
  std::string room{};
  std::int64_t calledUtc_us = 0;
  bool open = false;  ///< the trainee is at the arm now
};

}  // namespace torsio
