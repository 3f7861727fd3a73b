// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/own_severity.h"

#include <algorithm>
#include <cmath>

#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/reliability.h"
#include "db/repository/rating/desk_repository.h"
#include "db/repository/rating/sheet_repository.h"

namespace torsio {

namespace {

/// Own mark and mean of the others in points; empty when either is missing.
std::optional<SeverityCase> compared(const std::vector<CaseMark>& marks, const std::string& rater) {
  std::optional<double> own;
  std::vector<double> others;
  for (const CaseMark& mark : marks) {
    if (!mark.score_steps) {
      continue;
    }
    const double points = pointsFromSteps(*mark.score_steps, mark.scale);
    if (mark.raterId == rater) {
      own = points;
    } else {
      others.push_back(points);
    }
  }
  if (!own || others.empty()) {
    return std::nullopt;
  }
  return SeverityCase{{}, *own, meanOf(others)};
}

}  // namespace

OwnSeverity ownSeverity(SessionContext& session) {
  session.require(Operation::kMarkSubmit);
  const std::string& rater = session.actor().personId;
  DeskRepository desk(session.connection());
  OwnSeverity out;
  std::vector<double> own;
  std::vector<double> panel;
  const std::vector<Assignment> committed = desk.committed(rater);
  for (const Assignment& assignment : committed) {
    const std::vector<CaseMark> marks = desk.marksOfCase(assignment.enrolmentId, assignment.occasionCode);
    auto line = compared(marks, rater);
    if (!line) {
      continue;
    }
    const ScoreScale& scale = marks.front().scale;
    out.lowest_points = pointsFromSteps(scale.lo, scale);
    out.highest_points = pointsFromSteps(scale.hi, scale);
    line->label = assignment.caseLabel;
    own.push_back(line->own);
    panel.push_back(line->panel);
    out.cases.push_back(std::move(*line));
  }
  std::size_t submitted = 0;
  for (const QueueEntry& entry : SheetRepository(session.connection()).queue(rater)) {
    if (entry.state == SheetState::kSubmitted) {
      ++submitted;
    }
  }
  out.waiting = submitted - std::min(submitted, committed.size());
  if (own.empty()) {
    return out;
  }
  out.ownMean_points = meanOf(own);
  out.panelMean_points = meanOf(panel);
  out.difference_points = *out.ownMean_points - *out.panelMean_points;
  if (const auto agreement = blandAltman(own, panel)) {
    out.interval_points = agreement->meanInterval;
  }
  out.used.assign(static_cast<std::size_t>(std::lround(out.highest_points - out.lowest_points)) + 1, 0);
  for (const double points : own) {
    const auto bin = static_cast<std::size_t>(std::lround(points - out.lowest_points));
    ++out.used[std::min(bin, out.used.size() - 1)];
  }
  return out;
}

}  // namespace torsio
