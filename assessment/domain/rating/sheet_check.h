// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"

namespace torsio {

/// Code of the overall mark among the rows of a sheet.
inline const std::string kOverallRow{};

/// A score, the reason for a missing one, or neither (unanswered).
struct SheetAnswer {
  std::optional<std::int64_t> score_steps{};
  std::string notAssessableReason{};
  [[nodiscard]] bool given() const noexcept {
    return score_steps.has_value() || !notAssessableReason.empty();
  }
  friend bool operator==(const SheetAnswer&, const SheetAnswer&) = default;
};

/// Reasons why an answer cannot be submitted.
enum class AnswerFault {
  kNone,
  kMissing,       ///< neither a score nor a reason
  kContradicts,   ///< both a score and a reason for a missing one
  kOutsideScale,  ///< a score off its scale
};
[[nodiscard]] AnswerFault faultOf(const SheetAnswer& answer, const ScoreScale& scale) noexcept;

struct SheetLine {
  std::string code{};  ///< of the rubric's row; kOverallRow: the overall mark
  ScoreScale scale{};
  SheetAnswer answer{};
};

/// How a recording was watched before the sheet was filled in.
struct RecordingWatched {
  double share = 0.0;    ///< 0..1
  double slowest = 1.0;  ///< playback speeds; 1: real time
  double fastest = 1.0;
};

/// The centre's rules for scoring from a recording.
struct ViewingRules {
  double minimumWatched = 0.8;      ///< share of the recording, 0..1
  std::vector<double> speeds{1.0};  ///< allowed playback speeds, ascending, never empty; 1 is always allowed
};

/// Result of checking a sheet: what prevents its submission, and what merits a second look.
struct SheetCheck {
  std::vector<std::string> unanswered{};  ///< row codes in the order of the sheet
  bool watchedTooLittle = false;
  bool speedNotAllowed = false;
  bool allTheSame = false;      ///< three or more rows with the same score relative to their scales
  bool farApart = false;        ///< three or more rows that span at least 0.7 of their scales
  bool overallOutside = false;  ///< the overall mark lies outside the range of three or more rows
  double watchedShare = 1.0;    ///< 0..1; 1 for a live case
  /// Time since the trainee was called, if it is too short for a performance; live cases only.
  std::optional<std::int64_t> soonAfterCall_us{};
  /// True if nothing prevents submission; suspected slips are only advice.
  [[nodiscard]] bool mayBeSubmitted() const noexcept {
    return unanswered.empty() && !watchedTooLittle && !speedNotAllowed;
  }
};

/// Checks a sheet; `lines`: the rows and the overall mark in order. `watched` empty: scored live. A sheet
/// whose overall mark is "not assessable" need not have been watched. Speeds may differ from the allowed ones
/// by 0.001, the precision at which they are stored.
[[nodiscard]] SheetCheck checkSheetLines(std::span<const SheetLine> lines,
                                         const std::optional<RecordingWatched>& watched,
                                         const ViewingRules& rules);

/// Returns the time since a call for SheetCheck::soonAfterCall_us; empty: long enough.
[[nodiscard]] std::optional<std::int64_t> soonAfterCall_us(std::int64_t calledUtc_us, std::int64_t now_us);

/// A paper sheet as typed in by one person.
struct PaperEntry {
  AssignmentId assignmentId{};
  UserId enteredBy{};
  Sheet sheet{};
  std::int64_t enteredUtc_us = 0;
};

/// Returns the codes of the rows (kOverallRow: the overall mark) in which two typed copies differ. Free text
/// (reasons, comments) is not compared.
[[nodiscard]] std::vector<std::string> differencesOf(const RubricRevision& rubric, const Sheet& first,
                                                     const Sheet& second);
/// Returns the codes of the rows with invalid answers: unanswered, contradictory, off the scale.
[[nodiscard]] std::vector<std::string> faultyRows(const RubricRevision& rubric, const Sheet& sheet);

/// Mean of the criteria of a sheet in points: each score as its relative position on its own scale, weighted
/// and mapped to the scale of the overall mark. Shown beside the overall mark, never in place of it. Empty if
/// a criterion with a weight was not scored.
[[nodiscard]] std::optional<double> criteriaMean(const RubricRevision& rubric,
                                                 std::span<const SheetRow> answers);

}  // namespace torsio
