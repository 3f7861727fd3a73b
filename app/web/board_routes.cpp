// SPDX-License-Identifier: GPL-3.0-or-later
// The administrators' boards of the day and of marks: what they read.
#include <cstdint>
#include <string>

#include <QDateTime>

#include "app/services/study/cohort_service.h"
#include "app/services/study/day_board.h"
#include "app/services/study/scoring_plan.h"
#include "app/web/case_json.h"
#include "app/web/router.h"
#include "app/web/web_desk.h"
#include "sim/core/error.h"

namespace torsio::web {

namespace {

using nlohmann::json;

const char* const kCohort = "cohort ";

HttpResponse answerCohorts(Call& call) {
  const std::vector<CohortRow> rows = cohorts(call.context);
  json all = jsonList(rows, [&](const CohortRow& row) -> json {
    return {{"cohort", call.session->handleFor(kCohort + row.cohort.id.text())},
            {"name", row.cohort.name},
            {"enrolled", row.enrolled},
            {"today", row.today}};
  });
  return jsonAnswer({{"cohorts", std::move(all)}, {"first", cohortShownFirst(rows)}});
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
  json rows = jsonList(board.rows, [&](const DayBoardRow& row) -> json {
    return {{"trainee", row.traineeCode},
            {"group", row.groupCode},
            {"phase", said(call, Text(row.phaseLabel))},
            {"done", row.done},
            {"withdrawn", row.state == EnrolmentState::kWithdrawn},
            {"left_us", row.progress.left_us},
            {"station", row.runningTrialId.empty() ? "" : row.station},
            {"occasion", said(call, Text(row.occasionDue.label))},
            {"sheets", said(call, sheetsText(row))},
            {"sheets_missing", row.allSheetsMissing()},
            {"deviations", row.deviations},
            {"planned_utc_us", row.slot ? json(row.slot->startsUtc_us) : json(nullptr)},
            {"overdue", row.overdue}};
  });
  json stations = jsonList(
      board.stations, [&](const StationState& station) { return stationJson(station, board.asOfUtc_us); });
  json alerts = jsonList(dayAlerts(board), [&](const DayAlert& alert) {
    return said(call, alertText(alert, hourOf(alert.sinceUtc_us), Text(alert.occasion.label)));
  });
  json occasions = json::array();
  for (const Occasion& occasion : board.occasions) {
    occasions.push_back({{"code", occasion.code}, {"label", said(call, Text(occasion.label))}});
  }
  return jsonAnswer({{"name", board.cohortName},
                     {"occasions", std::move(occasions)},
                     {"alerts", std::move(alerts)},
                     {"rows", std::move(rows)},
                     {"stations", std::move(stations)}});
}

HttpResponse answerScored(Call& call) {
  const ScoringMatrix matrix = scoringMatrix(call.context, cohortOf(call));
  json raters = jsonList(matrix.raters, [&](const ScoringMatrix::Rater& rater) -> json {
    return {{"code", rater.code}, {"open", rater.open}, {"submitted", rater.submitted}};
  });
  json lines = json::array();
  for (const ScoringMatrix::Line& line : matrix.lines) {
    json cells = json::array();
    for (const ScoringCell& cell : line.cells) {
      cells.push_back(cell.assignmentId.empty() ? "" : stateName(cell.state));
    }
    lines.push_back({{"trainee", line.traineeCode},
                     {"occasion", said(call, Text(line.occasion.label))},
                     {"cells", std::move(cells)},
                     {"missing", line.missing}});
  }
  return jsonAnswer({{"raters", std::move(raters)}, {"lines", std::move(lines)}});
}

}  // namespace

CohortId cohortOf(const Call& call) {
  if (const auto found = objectOf(call, call.parts.front(), kCohort)) {
    return CohortId(*found);
  }
  refuseParameter(Text::tr("there is no such cohort"), "", Text::tr("Load the page again"));
}

std::vector<Route> boardRoutes() {
  constexpr auto kIn = RouteAccess::kSignedIn;
  return {{"GET", "/api/cohorts", kIn, answerCohorts},
          {"GET", "/api/cohorts/*/board", kIn, answerBoard},
          {"GET", "/api/cohorts/*/scored", kIn, answerScored}};
}

}  // namespace torsio::web
