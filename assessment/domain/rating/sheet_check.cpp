// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/rating/sheet_check.h"

#include <algorithm>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr double kSpeedTolerance = 1e-3;  // stored in thousandths
constexpr double kFarApart = 0.7;         // of the scale, between the lowest and the highest row
constexpr std::size_t kMinRows = 3;       // needed to tell a pattern from chance

double shareOfScale(std::int64_t steps, const ScoreScale& scale) {
  return static_cast<double>(steps - scale.lo) / static_cast<double>(scale.hi - scale.lo);
}

/// Flags patterns of answers that suggest a slip.
void lookForSlips(std::span<const SheetLine> lines, SheetCheck& check) {
  std::vector<double> shares;
  std::optional<double> overall;
  for (const SheetLine& line : lines) {
    if (!line.answer.score_steps) {
      continue;
    }
    const double share = shareOfScale(*line.answer.score_steps, line.scale);
    if (line.code == kOverallRow) {
      overall = share;
    } else {
      shares.push_back(share);
    }
  }
  if (shares.size() < kMinRows) {
    return;
  }
  const auto [low, high] = std::minmax_element(shares.begin(), shares.end());
  check.allTheSame = *low == *high;
  check.farApart = *high - *low >= kFarApart;
  check.overallOutside = overall && (*overall < *low || *overall > *high);
}

}  // namespace

AnswerFault faultOf(const SheetAnswer& answer, const ScoreScale& scale) noexcept {
  if (!answer.given()) {
    return AnswerFault::kMissing;
  }
  if (!answer.score_steps) {
    return AnswerFault::kNone;
  }
  if (!answer.notAssessableReason.empty()) {
    return AnswerFault::kContradicts;
  }
  return isOnScale(*answer.score_steps, scale) ? AnswerFault::kNone : AnswerFault::kOutsideScale;
}

SheetCheck checkSheetLines(std::span<const SheetLine> lines, const std::optional<RecordingWatched>& watched,
                           const ViewingRules& rules) {
  TORSIO_EXPECTS(!rules.speeds.empty());
  SheetCheck check;
  bool excused = false;
  for (const SheetLine& line : lines) {
    if (!line.answer.given()) {
      check.unanswered.push_back(line.code);
    }
    excused = excused || (line.code == kOverallRow && !line.answer.notAssessableReason.empty());
  }
  lookForSlips(lines, check);
  if (!watched) {
    return check;
  }
  check.watchedShare = watched->share;
  const double slowest = std::min(1.0, rules.speeds.front());
  const double fastest = std::max(1.0, rules.speeds.back());
  check.watchedTooLittle = !excused && watched->share < rules.minimumWatched;
  check.speedNotAllowed = !excused && (watched->slowest < slowest - kSpeedTolerance ||
                                       watched->fastest > fastest + kSpeedTolerance);
  return check;
}

}  // namespace torsio
