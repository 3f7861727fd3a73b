// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/discrepancy_review.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/services/access/centre_settings.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/panel_opening.h"
#include "app/services/review/sheet_editor.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/written_words.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/reliability.h"
#include "db/connection/connection.h"
#include "db/repository/rating/desk_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr double kRounding = 1e-9;  // marks are decimal steps

std::optional<std::int64_t> scoreOf(const CaseMark& mark, const std::string& row) {
  if (row == kOverallRow) {
    return mark.score_steps;
  }
  for (const SheetRow& line : mark.rows) {
    if (line.code == row) {
      return line.score_steps;
    }
  }
  return std::nullopt;
}

/// Returns empty if the actor or all others marked the row as "not assessable".
std::optional<RowComparison> compare(const std::vector<CaseMark>& marks, const std::string& rater,
                                     const std::string& row, const ScoreScale& scale, double threshold) {
  RowComparison line{.row = row, .scale = scale};
  std::optional<double> own;
  double sum = 0.0;
  for (const CaseMark& mark : marks) {
    const auto steps = scoreOf(mark, row);
    if (!steps) {
      continue;
    }
    const double points = pointsFromSteps(*steps, scale);
    if (mark.raterId == rater) {
      own = points;
      continue;
    }
    line.lowest = line.others == 0 ? points : std::min(line.lowest, points);
    line.highest = line.others == 0 ? points : std::max(line.highest, points);
    sum += points;
    ++line.others;
  }
  if (!own || line.others == 0) {
    return std::nullopt;
  }
  line.own = *own;
  line.mean = sum / static_cast<double>(line.others);
  line.apart = std::abs(line.own - line.mean) >= threshold - kRounding;
  return line;
}

/// Throws unless all raters have submitted this case of the actor.
Assignment committedCase(SessionContext& session, const AssignmentId& assignmentId) {
  Assignment found = ownAssignment(session, Operation::kMarkSubmit, assignmentId);
  if (!SheetRepository(session.connection()).allSubmitted(found.enrolmentId, found.occasionCode)) {
    refuse(Text::tr("not everybody has submitted this case yet"), Text::tr("case %1", found.caseLabel),
           Text::tr("Wait until all have committed"));
  }
  if (panelWaitsForOwnSheets(session.connection(), found.enrolmentId, found.occasionCode, found.raterId)) {
    refuse(Text::tr("the panel's marks wait until you have submitted all your own sheets of this occasion"),
           Text::tr("case %1", found.caseLabel), Text::tr("Finish your queue first"));
  }
  return found;
}

void decide(SessionContext& session, const AssignmentId& assignmentId, DiscrepancyChoice choice,
            const std::string& reason) {
  DiscrepancyRepository(session.connection(), session.station())
      .add({.assignmentId = assignmentId,
            .choice = choice,
            .reason = reason,
            .decidedBy = session.actor().userId,
            .decidedUtc_us = session.now_us()});
}

void requireReason(const std::string& reason, const std::string& label) {
  if (!reason.empty()) {
    return requireWords(reason, kLongestReason, Text::tr("case %1", label));
  }
  refuseParameter(Text::tr("a reason is needed"), Text::tr("case %1", label),
                  Text::tr("Write it in a few words"));
}

}  // namespace

std::vector<DiscrepancyCase> discrepancyCases(SessionContext& session) {
  session.require(Operation::kMarkSubmit);
  DeskRepository desk(session.connection());
  const RubricRepository rubrics(session.connection());
  DiscrepancyRepository decisions(session.connection());
  const double threshold = centreSetting<kDiscrepancy_points>(session.connection());
  const std::string& rater = session.actor().personId;
  std::vector<DiscrepancyCase> found;
  for (const Assignment& assignment : desk.committed(rater)) {
    if (panelWaitsForOwnSheets(session.connection(), assignment.enrolmentId, assignment.occasionCode,
                               assignment.raterId)) {
      continue;
    }
    const std::vector<CaseMark> marks = desk.marksOfCase(assignment.enrolmentId, assignment.occasionCode);
    const RubricRevision rubric = rubrics.revision(assignment.rubricRevisionId).value();
    DiscrepancyCase line;
    const auto add = [&](const std::string& row, const std::string& label, const ScoreScale& scale) {
      auto compared = compare(marks, rater, row, scale, threshold);
      if (!compared) {
        return;
      }
      compared->label = label;
      line.largest = std::max(line.largest, std::abs(compared->own - compared->mean));
      line.rows.push_back(std::move(*compared));
    };
    for (const RubricLine& row : rubric.rows) {
      add(row.code, row.label, row.scale);
    }
    add(kOverallRow, {}, rubric.overall);
    const bool apart =
        std::any_of(line.rows.begin(), line.rows.end(), [](const RowComparison& row) { return row.apart; });
    if (!apart) {
      continue;
    }
    line.shown = blindedCase(session, assignment.id);
    if (const auto decided = decisions.latest(assignment.id)) {
      line.decision = decided->choice;
      line.reason = decided->reason;
    }
    found.push_back(std::move(line));
  }
  return found;
}

std::size_t casesSealedForNow(SessionContext& session) {
  session.require(Operation::kMarkSubmit);
  const std::vector<Assignment> committed =
      DeskRepository(session.connection()).committed(session.actor().personId);
  return static_cast<std::size_t>(
      std::count_if(committed.begin(), committed.end(), [&](const Assignment& assignment) {
        return panelWaitsForOwnSheets(session.connection(), assignment.enrolmentId, assignment.occasionCode,
                                      assignment.raterId);
      }));
}

Text whenCasesAreCompared(SessionContext& session) {
  const std::size_t sealed = casesSealedForNow(session);
  if (!centreSetting<kPanelWaits>(session.connection())) {
    return Text::tr("A case is compared here when all its raters have submitted it.");
  }
  const Text rule = Text::tr(
      "A case is compared here when all its raters have submitted it and you have submitted all your own "
      "sheets of the occasion.");
  return sealed == 0 ? rule : Text::tr("%1 Cases that wait for your own sheets: %2.", rule, sealed);
}

void keepMark(SessionContext& session, const AssignmentId& assignmentId, const std::string& reason) {
  static_cast<void>(committedCase(session, assignmentId));
  decide(session, assignmentId, DiscrepancyChoice::kKeep, reason);
}

void moveMark(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet,
              const std::string& reason) {
  const Assignment found = committedCase(session, assignmentId);
  requireReason(reason, found.caseLabel);
  Transaction transaction(session.connection());
  amendSheet(session, assignmentId, sheet, reason, PanelMarks::kSeen);
  decide(session, assignmentId, DiscrepancyChoice::kMove, reason);
  transaction.commit();
}

void changeSubmitted(SessionContext& session, const AssignmentId& assignmentId, const Sheet& sheet,
                     const std::string& reason) {
  if (openSheet(session, assignmentId).panelOpen) {
    moveMark(session, assignmentId, sheet, reason);
  } else {
    amendSheet(session, assignmentId, sheet, reason);
  }
}

void askForAdjudicator(SessionContext& session, const AssignmentId& assignmentId, const std::string& reason) {
  const Assignment found = committedCase(session, assignmentId);
  requireReason(reason, found.caseLabel);
  decide(session, assignmentId, DiscrepancyChoice::kThird, reason);
}

namespace {

/// Returns the actor's mark and the mean of the others in points; empty if either is missing.
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
    if (panelWaitsForOwnSheets(session.connection(), assignment.enrolmentId, assignment.occasionCode,
                               assignment.raterId)) {
      ++out.sealed;
      continue;
    }
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
