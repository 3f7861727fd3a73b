// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/review_queue.h"

#include <algorithm>
#include <map>

#include "app/services/review/blinded_case.h"
#include "app/services/review/discrepancy_review.h"
#include "app/services/review/evaluation_form.h"
#include "app/services/review/rater_calibration.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/statistics/descriptive.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/desk_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr std::int64_t kPaceCases = 20;
constexpr std::size_t kMinForPace = 3;
constexpr double kMinuteForTheSheet = 1.0;
constexpr double kLiveCase_min = 4.0;
constexpr double kShortSitting_min = 10.0;
constexpr std::int64_t kAllCases = 1'000'000;
constexpr std::int64_t kSitting_us = 12 * kHour_us;
constexpr std::int64_t kBetweenCalls_us = 30 * kMinute_us;

/// Returns this rater's minutes per case; empty with too few cases.
std::optional<double> ownPace_min(DeskRepository& desk, const RaterId& raterId) {
  const std::vector<std::int64_t> times_us = desk.workingTimes_us(raterId, kPaceCases);
  if (times_us.size() < kMinForPace) {
    return std::nullopt;
  }
  return medianOf(std::vector<double>(times_us.begin(), times_us.end())) / kMinute_us;
}

/// Returns how many of the first lines fit into a short session.
std::size_t fittingCases(const std::vector<QueueLine>& lines) {
  double needed_min = 0.0;
  std::size_t cases = 0;
  for (const QueueLine& line : lines) {
    needed_min += line.estimate_min;
    if (line.state == SheetState::kSubmitted || needed_min > kShortSitting_min) {
      break;
    }
    ++cases;
  }
  return cases;
}

std::vector<QueueLine> allLines(SessionContext& session, const std::optional<double>& pace_min) {
  DeskRepository desk(session.connection());
  const std::int64_t now_us = session.now_us();
  std::map<AssignmentId, CallNotice> calls;
  for (CallNotice& call : CallRepository(session.connection()).noticesFor(session.actor().personId)) {
    calls.emplace(call.assignmentId, std::move(call));
  }
  const std::vector<QueueEntry> entries =
      SheetRepository(session.connection()).queue(session.actor().personId);
  const std::optional<std::int64_t> due_us = blindedDue(entries);
  std::vector<QueueLine> lines;
  for (const QueueEntry& entry : entries) {
    QueueLine line;
    line.shown = {entry.assignmentId, entry.caseLabel, entry.trialId.empty(), entry.dueUtc_us, {}};
    if (!line.shown.live) {
      line.shown.dueUtc_us = due_us;
      line.shown.length_us = desk.trialLength_us(entry.trialId);
    } else if (const auto call = calls.find(entry.assignmentId); call != calls.end()) {
      line.call = call->second;
    }
    line.state = entry.state;
    line.submittedUtc_us = entry.submittedUtc_us;
    if (line.state != SheetState::kSubmitted) {
      const bool canBeScored = !line.shown.live || line.call.has_value();
      line.overdue = canBeScored && ((line.shown.dueUtc_us && *line.shown.dueUtc_us < now_us) ||
                                     (line.call && !line.call->open));
      const double length_min = static_cast<double>(line.shown.length_us.value_or(0)) / kMinute_us;
      line.estimate_min =
          line.shown.live ? kLiveCase_min : pace_min.value_or(length_min + kMinuteForTheSheet);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

ReviewQueue reviewQueue(SessionContext& session) {
  session.require(Operation::kMarkSubmit);
  ReviewQueue queue;
  DeskRepository desk(session.connection());
  const std::optional<double> pace_min = ownPace_min(desk, session.actor().personId);
  queue.fromOwnPace = pace_min.has_value();
  for (QueueLine& line : allLines(session, pace_min)) {
    const bool done = line.state == SheetState::kSubmitted;
    if (!done && line.shown.dueUtc_us &&
        (!queue.nextDueUtc_us || *line.shown.dueUtc_us < *queue.nextDueUtc_us)) {
      queue.nextDueUtc_us = line.shown.dueUtc_us;
    }
    if (line.overdue) {
      ++queue.overdue;
    }
    if (line.shown.live) {
      ++(done ? queue.liveSubmitted : line.call ? queue.liveCalled : queue.liveWaiting);
      continue;
    }
    ++(done ? queue.submitted : line.state == SheetState::kDraft ? queue.drafts : queue.waiting);
    queue.minutes += line.estimate_min;
    queue.lines.push_back(std::move(line));
  }
  // Submitted ones go to the end; the others keep the rater's order.
  std::stable_partition(queue.lines.begin(), queue.lines.end(),
                        [](const QueueLine& line) { return line.state != SheetState::kSubmitted; });
  queue.inTenMinutes = fittingCases(queue.lines);
  for (const std::int64_t worked_us : desk.workingTimes_us(session.actor().personId, kAllCases)) {
    queue.worked_us += worked_us;
  }
  for (const SheetState wanted : {SheetState::kDraft, SheetState::kOpen}) {
    const auto found = std::find_if(queue.lines.begin(), queue.lines.end(),
                                    [wanted](const QueueLine& line) { return line.state == wanted; });
    if (found == queue.lines.end()) {
      continue;
    }
    queue.next = found->shown.assignmentId;
    break;
  }
  const RaterCalibration calibration = raterCalibration(session);
  queue.calibrationWaiting = !calibration.runs.empty() && !calibration.complete();
  for (const DiscrepancyCase& open : discrepancyCases(session)) {
    if (!open.decision) {
      ++queue.disagreements;
    }
  }
  if (session.may(Operation::kEvaluationSubmit)) {
    for (const EvaluationForm& form : evaluationForms(session)) {
      for (const EvaluationFormModel& model : form.models) {
        queue.models += model.submitted ? 0 : 1;
      }
    }
  }
  return queue;
}

std::vector<QueueLine> liveLines(SessionContext& session) {
  session.require(Operation::kMarkSubmit);
  std::vector<QueueLine> lines;
  for (QueueLine& line : allLines(session, std::nullopt)) {
    if (line.shown.live && (line.call || line.state == SheetState::kSubmitted)) {
      lines.push_back(std::move(line));
    }
  }
  std::stable_sort(lines.begin(), lines.end(), [](const QueueLine& a, const QueueLine& b) {
    return (a.call ? a.call->calledUtc_us : 0) < (b.call ? b.call->calledUtc_us : 0);
  });
  return lines;
}

CallGuide guideToCall(const std::vector<QueueLine>& lines, const AssignmentId& shown, bool busy,
                      const AssignmentId& followed) {
  const auto called = std::find_if(lines.rbegin(), lines.rend(), [](const QueueLine& line) {
    return line.call && line.call->open && line.state != SheetState::kSubmitted;
  });
  if (called == lines.rend() || called->shown.assignmentId == shown) {
    return {};
  }
  const auto present = std::find_if(lines.begin(), lines.end(),
                                    [&](const QueueLine& line) { return line.shown.assignmentId == shown; });
  const bool open = present != lines.end() && present->state != SheetState::kSubmitted;
  CallGuide guide{.called = *called};
  guide.otherRoom = open && present->call && present->call->open;
  const bool begun = busy || (open && present->state == SheetState::kDraft);
  guide.opens = !begun && !guide.otherRoom && called->shown.assignmentId != followed;
  return guide;
}

bool callsGoOn(const std::vector<QueueLine>& lines, std::int64_t now_us) {
  return std::any_of(lines.begin(), lines.end(), [now_us](const QueueLine& line) {
    return line.call && (line.call->open || now_us - line.call->calledUtc_us < kBetweenCalls_us);
  });
}

bool isOfEarlierDay(const QueueLine& line, std::int64_t now_us) {
  return line.state == SheetState::kSubmitted && line.submittedUtc_us < now_us - kSitting_us;
}

}  // namespace torsio
