// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/viewing_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "db/connection/connection.h"
#include "db/repository/rating/desk_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr double kLateReport_us = 500'000.0;
constexpr double kSameSpeed = 0.001;

void requirePlayable(const PlayedStretch& stretch, const ViewingRules& rules, const Text& where) {
  const bool forwards = stretch.from_us >= 0 && stretch.to_us >= stretch.from_us;
  if (!forwards || !std::isfinite(stretch.speed)) {
    refuseParameter(Text::tr("what was watched is not a stretch of the recording"), where,
                    Text::tr("Open the case again"));
  }
  const bool allowed =
      stretch.speed == 1.0 || std::any_of(rules.speeds.begin(), rules.speeds.end(), [&](double speed) {
        return std::abs(speed - stretch.speed) <= kSameSpeed;
      });
  if (!allowed) {
    refuseParameter(Text::tr("the recording was played at a speed that is not allowed"), where,
                    Text::tr("Play it again at an allowed speed"));
  }
}

}  // namespace

WatchLog creditedLog(WatchLog log, const std::vector<PlayedStretch>& played, std::int64_t passed_us) {
  double left_us = static_cast<double>(std::max<std::int64_t>(passed_us, 0)) + kLateReport_us;
  for (const PlayedStretch& stretch : played) {
    const double most_us = left_us * stretch.speed;
    const double length_us = std::min(static_cast<double>(stretch.to_us - stretch.from_us), most_us);
    log.played(stretch.from_us, stretch.from_us + std::llround(length_us), stretch.speed);
    left_us -= length_us / stretch.speed;
  }
  log.worked(std::clamp<std::int64_t>(passed_us, 0, kLongestPause_us));
  return log;
}

OpenedSheet reportViewing(SessionContext& session, const AssignmentId& assignmentId,
                          const std::vector<PlayedStretch>& played, std::int64_t passed_us) {
  const ViewingRules rules = viewingRules(session);
  Transaction transaction(session.connection());
  OpenedSheet opened = openSheet(session, assignmentId);
  const Text where = Text::tr("case %1", opened.shown.label);
  for (const PlayedStretch& stretch : played) {
    requirePlayable(stretch, rules, where);
  }
  if (opened.shown.live || opened.state == SheetState::kSubmitted) {
    refuse(opened.shown.live ? Text::tr("this case is scored live and has no recording")
                             : Text::tr("the sheet was submitted already"),
           where, Text::tr("Read the queue again"));
  }
  opened.watched = creditedLog(std::move(opened.watched), played, passed_us);
  DeskRepository(session.connection()).saveDraftViewing(assignmentId, opened.watched.stored());
  transaction.commit();
  return opened;
}

}  // namespace torsio
