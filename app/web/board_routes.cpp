// SPDX-License-Identifier: GPL-3.0-or-later
// The administrators' boards of the day and of marks. Read only.
#include <cstdint>
#include <string>

#include <QDateTime>

#include "app/services/study/cohort_service.h"
#include "app/services/study/day_board.h"
#include "app/services/study/scoring_plan.h"
#include "app/web/router.h"
#include "app/web/web_desk.h"
#include "sim/core/error.h"

namespace torsio::web {

namespace {

using nlohmann::json;

const char* const kCohort = "cohort ";

HttpResponse answerCohorts(Call& call) {
  const std::vector<CohortRow> rows = cohorts(call.context);
  json all = json::array();
  for (const CohortRow& row : rows) {
    all.push_back({{"cohort", call.session->handleFor(kCohort + row.cohort.id.text())},
                   {"name", row.cohort.name},
                   {"enrolled", row.enrolled},
                   {"today", row.today}});
  }
  return jsonAnswer({{"cohorts", std::move(all)}, {"first", cohortShownFirst(rows)}});
}

CohortId cohortOf(const Call& call) {
  const std::string what = call.session->objectOf(call.parts.front());
  if (what.rfind(kCohort, 0) != 0) {
    refuseParameter(Text::tr("there is no such cohort"), "", Text::tr("Load the page again"));
  }
  return CohortId(what.substr(std::string(kCohort).size()));
}

/// Formats a time in the server's time zone: "14:05", with the date if that is not today.
std::string hourOf(std::int64_t utc_us) {
  const QDateTime time = QDateTime::fromMSecsSinceEpoch(utc_us / 1000);
  return time
      .toString(time.date() == QDate::currentDate() ? QStringLiteral("HH:mm")
                                                    : QStringLiteral("yyyy-MM-dd HH:mm"))
      .toStdString();
}

json stationJson(const StationState& station, std::int64_t asOfUtc_us) {
  return {{"station", station.station},
          {"trainee", station.ended ? "" : station.traineeCode},
          {"seen_s", (asOfUtc_us - station.heartbeatUtc_us) / 1'000'000},
          {"silent", asOfUtc_us - station.heartbeatUtc_us > kStationSilence_us},
          {"light", station.deviceLight}};
}

HttpResponse answerBoard(Call& call) {
  const DayBoard board = dayBoard(call.context, cohortOf(call));
  const auto said = [&call](const std::string& text) { return call.wording(Text(text)).toStdString(); };
  json rows = json::array();
  for (const DayBoardRow& row : board.rows) {
    rows.push_back({{"trainee", row.traineeCode},
                    {"group", row.groupCode},
                    {"phase", said(row.phaseLabel)},
                    {"done", row.done},
                    {"withdrawn", row.state == EnrolmentState::kWithdrawn},
                    {"left_us", row.progress.left_us},
                    {"station", row.runningTrialId.empty() ? "" : row.station},
                    {"occasion", said(row.occasionDue.label)},
                    {"sheets_missing", row.allSheetsMissing()},
                    {"deviations", row.deviations},
                    {"planned_utc_us", row.slot ? json(row.slot->startsUtc_us) : json(nullptr)},
                    {"overdue", row.overdue}});
  }
  json stations = json::array();
  for (const StationState& station : board.stations) {
    stations.push_back(stationJson(station, board.asOfUtc_us));
  }
  json alerts = json::array();
  for (const DayAlert& alert : dayAlerts(board)) {
    alerts.push_back(
        call.wording(alertText(alert, hourOf(alert.sinceUtc_us), Text(alert.occasion.label))).toStdString());
  }
  return jsonAnswer({{"name", board.cohortName},
                     {"alerts", std::move(alerts)},
                     {"rows", std::move(rows)},
                     {"stations", std::move(stations)}});
}

HttpResponse answerScored(Call& call) {
  const ScoringMatrix matrix = scoringMatrix(call.context, cohortOf(call));
  const char* const states[] = {"open", "draft", "submitted"};
  json raters = json::array();
  for (const ScoringMatrix::Rater& rater : matrix.raters) {
    raters.push_back({{"code", rater.code}, {"open", rater.open}, {"submitted", rater.submitted}});
  }
  json lines = json::array();
  for (const ScoringMatrix::Line& line : matrix.lines) {
    json cells = json::array();
    for (const ScoringCell& cell : line.cells) {
      const std::size_t state = cell.state == SheetState::kSubmitted ? 2
                                : cell.state == SheetState::kDraft   ? 1
                                                                     : 0;
      cells.push_back(cell.assignmentId.empty() ? "" : states[state]);
    }
    lines.push_back({{"trainee", line.traineeCode},
                     {"occasion", call.wording(Text(line.occasion.label)).toStdString()},
                     {"cells", std::move(cells)},
                     {"missing", line.missing}});
  }
  return jsonAnswer({{"raters", std::move(raters)}, {"lines", std::move(lines)}});
}

}  // namespace

std::vector<Route> boardRoutes() {
  constexpr auto kIn = RouteAccess::kSignedIn;
  return {{"GET", "/api/cohorts", kIn, answerCohorts},
          {"GET", "/api/cohorts/*/board", kIn, answerBoard},
          {"GET", "/api/cohorts/*/scored", kIn, answerScored}};
}

}  // namespace torsio::web
