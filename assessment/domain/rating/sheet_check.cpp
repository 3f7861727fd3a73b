// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/rating/sheet_check.h"

#include <algorithm>
#include <cstdint>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr double kSpeedTolerance = 1e-3;  // stored in thousandths
constexpr double kFarApart = 0.7;         // of the scale, between the lowest and the highest row
constexpr std::int64_t kSoonAfterCall_us = 30'000'000;
constexpr std::size_t kMinRows = 3;  // needed to tell a pattern from chance

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
    if (faultOf(line.answer, line.scale) != AnswerFault::kNone) {
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

std::optional<std::int64_t> soonAfterCall_us(std::int64_t calledUtc_us, std::int64_t now_us) {
  const std::int64_t since_us = now_us - calledUtc_us;
  return since_us >= 0 && since_us < kSoonAfterCall_us ? std::optional(since_us) : std::nullopt;
}

namespace {

SheetAnswer answerIn(const Sheet& sheet, const std::string& code) {
  if (code == kOverallRow) {
    return {sheet.overall_steps, sheet.notAssessableReason};
  }
  const auto row = std::find_if(sheet.rows.begin(), sheet.rows.end(),
                                [&](const SheetRow& one) { return one.code == code; });
  return row == sheet.rows.end() ? SheetAnswer{} : SheetAnswer{row->score_steps, row->notAssessableReason};
}

/// Codes of the rows for which `wrong` is true, in the order of the sheet.
template <class Wrong>
std::vector<std::string> rowsWhere(const RubricRevision& rubric, const Wrong& wrong) {
  std::vector<std::string> codes;
  for (const RubricLine& row : rubric.rows) {
    if (wrong(row.code, row.scale)) {
      codes.push_back(row.code);
    }
  }
  if (wrong(kOverallRow, rubric.overall)) {
    codes.push_back(kOverallRow);
  }
  return codes;
}

}  // namespace

std::vector<std::string> differencesOf(const RubricRevision& rubric, const Sheet& first,
                                       const Sheet& second) {
  return rowsWhere(rubric, [&](const std::string& code, const ScoreScale&) {
    return answerIn(first, code).score_steps != answerIn(second, code).score_steps;
  });
}

std::vector<std::string> faultyRows(const RubricRevision& rubric, const Sheet& sheet) {
  return rowsWhere(rubric, [&](const std::string& code, const ScoreScale& scale) {
    return faultOf(answerIn(sheet, code), scale) != AnswerFault::kNone;
  });
}

std::optional<double> criteriaMean(const RubricRevision& rubric, std::span<const SheetRow> answers) {
  double sum = 0.0;
  std::int64_t weights_milli = 0;
  for (const RubricLine& line : rubric.rows) {
    if (line.weight_milli == 0) {
      continue;
    }
    const auto answer = std::find_if(answers.begin(), answers.end(),
                                     [&](const SheetRow& one) { return one.code == line.code; });
    if (answer == answers.end() || !answer->score_steps) {
      return std::nullopt;
    }
    const auto above = static_cast<double>(*answer->score_steps - line.scale.lo);
    sum +=
        static_cast<double>(line.weight_milli) * above / static_cast<double>(line.scale.hi - line.scale.lo);
    weights_milli += line.weight_milli;
  }
  if (weights_milli == 0) {
    return std::nullopt;
  }
  const double lo = pointsFromSteps(rubric.overall.lo, rubric.overall);
  const double hi = pointsFromSteps(rubric.overall.hi, rubric.overall);
  return lo + (hi - lo) * sum / static_cast<double>(weights_milli);
}

}  // namespace torsio
