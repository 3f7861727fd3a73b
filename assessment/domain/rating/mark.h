// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// One row of the sheet behind a mark: a score on the scale of its rubric row, or the reason for a missing
/// one.
struct MarkRow {
  RubricRevisionId rubricRevisionId{};
  std::string rowCode{};
  std::optional<std::int64_t> score_steps{};
  std::string notAssessableReason{};
  friend bool operator==(const MarkRow&, const MarkRow&) = default;
};

/// One submitted mark of the training study: one rater, one trainee, one occasion. Sealed by the
/// database; a correction is a new version with a reason.
struct SubmittedMark {
  MarkId id{};
  EnrolmentId enrolmentId{};
  RaterId raterId{};
  std::string occasionCode{};  ///< "pre", "mid", "post"
  std::int64_t version = 1;
  TrialId trialId{};                          ///< the recording that was scored; empty: live, on the real arm
  std::optional<std::int64_t> score_steps{};  ///< empty: not assessable, with a reason
  ScoreScale scale{.lo = 10, .hi = 100, .stepsPerPoint = 10};  ///< paper section 6: 1 to 10
  std::string notAssessableReason{};
  std::string comment{};
  AssignmentId assignmentId{};  ///< the assignment it fulfils; empty: entered without one
  std::vector<MarkRow> rows{};  ///< written by submit(); read by SheetRepository::submitted()
  std::string amendReason{};    ///< required from version 2 on
  std::int64_t submittedUtc_us = 0;
  bool demonstration = false;
  ImportId importId{};             ///< the import it came with; empty: given in this record
  std::string traineeCode{};       ///< filled when read
  std::string raterCode{};         ///< filled when read
  std::string groupCode{};         ///< filled when read
  std::int64_t numberInGroup = 0;  ///< filled when read
};

/// The newest version of a rater's mark for a case, with its rows.
struct CaseMark {
  MarkId markId{};
  AssignmentId assignmentId{};
  RaterId raterId{};
  std::int64_t version = 1;
  std::optional<std::int64_t> score_steps{};
  ScoreScale scale{};
  std::vector<SheetRow> rows{};
};

/// The decision about a mark that differs strongly from the others.
struct DiscrepancyDecision {
  AssignmentId assignmentId{};
  std::int64_t sequence = 0;  ///< given by add(): 1, 2, 3 ... of the assignment
  DiscrepancyChoice choice = DiscrepancyChoice::kKeep;
  std::string reason{};
  std::string decidedBy{};
  std::int64_t decidedUtc_us = 0;
};

/// One row of a self-assessment.
struct SelfScoreLine {
  RubricRevisionId rubricRevisionId{};
  std::string rowCode{};
  std::int64_t score_steps = 0;
  friend bool operator==(const SelfScoreLine&, const SelfScoreLine&) = default;
};

/// A trainee's self-assessment of one of their trials. Append-only; a correction is the next version.
struct SelfScore {
  SelfScoreId id{};
  TrialId trialId{};
  TraineeId traineeId{};
  std::int64_t version = 1;             ///< 1, 2, 3 ... of this trial and trainee
  RubricRevisionId rubricRevisionId{};  ///< empty: the overall mark only
  std::int64_t score_steps = 0;
  ScoreScale scale{.lo = 10, .hi = 100, .stepsPerPoint = 10};
  std::vector<SelfScoreLine> rows{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// A run scored by a panel, used to calibrate raters.
struct ReferenceRun {
  TrialId trialId{};
  std::int64_t position = 0;
  RubricRevisionId rubricRevisionId{};
  double panel_steps = 0.0;  ///< mean of the panel, steps of the rubric's overall scale
  std::int64_t panelRaters = 1;
  std::string setBy{};
  std::int64_t setUtc_us = 0;
  bool demonstration = false;
};

/// Withdrawal of a reference run, which is then no longer handed out.
struct ReferenceWithdrawal {
  TrialId trialId{};
  std::string reason{};
  std::string withdrawnBy{};
  std::int64_t withdrawnUtc_us = 0;
};

/// A rater's calibration score of a reference run, given before real ones. Append-only.
struct CalibrationScore {
  CalibrationScoreId id{};
  RaterId raterId{};
  TrialId referenceTrialId{};
  RubricRevisionId rubricRevisionId{};  ///< empty: the overall mark only
  std::int64_t score_steps = 0;
  ScoreScale scale{.lo = 10, .hi = 100, .stepsPerPoint = 10};
  double panelOffset_steps = 0.0;  ///< rater minus panel
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

}  // namespace torsio
