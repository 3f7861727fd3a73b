// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/rating/instrument.h"

namespace torsio {

/// Code of the overall mark among the rows of a sheet.
inline const std::string kOverallRow{};

/// A score, or why there is none, or neither yet.
struct SheetAnswer {
  std::optional<std::int64_t> score_steps{};
  std::string notAssessableReason{};
  [[nodiscard]] bool given() const noexcept {
    return score_steps.has_value() || !notAssessableReason.empty();
  }
  friend bool operator==(const SheetAnswer&, const SheetAnswer&) = default;
};

/// What keeps an answer from being sealed.
enum class AnswerFault {
  kNone,
  kMissing,       ///< neither a score nor a reason
  kContradicts,   ///< a score and a reason why there is none
  kOutsideScale,  ///< a score that its scale does not have
};
/// Checks one answer against its scale.
[[nodiscard]] AnswerFault faultOf(const SheetAnswer& answer, const ScoreScale& scale) noexcept;

/// One line of a sheet: what the rubric asks and what was answered.
struct SheetLine {
  std::string code{};  ///< of the rubric's row; kOverallRow: the overall mark
  ScoreScale scale{};
  SheetAnswer answer{};
};

/// How much of a recording was played before the sheet was filled in.
struct RecordingWatched {
  double share = 0.0;    ///< 0..1
  double slowest = 1.0;  ///< speeds; 1: as it happened
  double fastest = 1.0;
};

/// What the centre asks of a rater who scores from a recording.
struct ViewingRules {
  double minimumWatched = 0.8;      ///< share of the recording, 0..1
  std::vector<double> speeds{1.0};  ///< allowed ones, rising, never empty; the natural one always is
};

/// What stands between a sheet and its submission, and what is worth a second look.
struct SheetCheck {
  std::vector<std::string> unanswered{};  ///< row codes in the order of the sheet
  bool watchedTooLittle = false;
  bool speedNotAllowed = false;
  bool allTheSame = false;      ///< three rows or more and one and the same score, in share of their scales
  bool farApart = false;        ///< three rows or more that span at least 0.7 of their scales
  bool overallOutside = false;  ///< the overall mark lies outside the range of three rows or more
  double watchedShare = 1.0;    ///< 0..1; 1 for a live case
  /// Says whether nothing stands in the way; what looks like a slip is advice, not a bar.
  [[nodiscard]] bool mayBeSubmitted() const noexcept {
    return unanswered.empty() && !watchedTooLittle && !speedNotAllowed;
  }
};

/// Checks a sheet of `lines` (rows and overall mark in their order). `watched` empty: the case was scored
/// live. A sheet whose overall mark is "not assessable" need not have been watched. Speeds may differ from
/// the allowed ones by 0.001, the precision at which they are stored.
[[nodiscard]] SheetCheck checkSheetLines(std::span<const SheetLine> lines,
                                         const std::optional<RecordingWatched>& watched,
                                         const ViewingRules& rules);

}  // namespace torsio
