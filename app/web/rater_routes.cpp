// SPDX-License-Identifier: GPL-3.0-or-later
// Calibration on reference runs, rater severity, and cases with strongly differing marks.
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "app/services/base/assets.h"
#include "app/services/review/discrepancy_review.h"
#include "app/services/review/rater_calibration.h"
#include "app/web/case_json.h"
#include "app/web/router.h"
#include "app/web/web_desk.h"
#include "assessment/domain/rating/written_words.h"
#include "sim/core/error.h"

namespace torsio::web {

namespace {

using nlohmann::json;

constexpr std::int64_t kMaxReferenceSteps = 1'000'000;

json calibrationJson(const Call& call, const RaterCalibration& calibration) {
  json runs = jsonList(calibration.runs, [&](const CalibrationRun& run) -> json {
    return {{"number", run.number},
            {"own_steps", orNull(run.own_steps)},
            {"panel_points", orNull(run.panel_points)},
            {"offset_points", orNull(run.offset_points)},
            {"panel_raters", run.panelRaters},
            {"tries", run.tries}};
  });
  return {{"rubric", rubricJson(calibration.rubric, call.wording)},
          {"runs", std::move(runs)},
          {"complete", calibration.complete()},
          {"mean_offset_points", orNull(calibration.meanOffset_points())}};
}

std::size_t numberOf(const Call& call) {
  const std::string& text = call.parts.front();
  std::size_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || number == 0) {
    refuseParameter(Text::tr("there is no such reference run"), "", Text::tr("Load the page again"));
  }
  return number;
}

HttpResponse answerCalibration(Call& call) {
  return jsonAnswer(calibrationJson(call, raterCalibration(call.context)));
}

HttpResponse answerReferenceScore(Call& call) {
  scoreReferenceRun(call.context, numberOf(call),
                    call.body.whole("score_steps", -kMaxReferenceSteps, kMaxReferenceSteps));
  return answerCalibration(call);
}

/// Reference runs may be withdrawn and later ones move up, so the loaded one identifies itself.
std::shared_ptr<const CasePicture> referencePicture(Call& call) {
  BlindedRecording recording = loadReferenceRun(call.context, numberOf(call));
  const std::string key = "reference " + recording.label + " " + recording.digest;
  return call.desk.pictures().of(
      key, [&] { return casePicture(std::move(recording), assetsFolder(), call.desk.shelf()); });
}

HttpResponse answerSeverity(Call& call) {
  const OwnSeverity severity = ownSeverity(call.context);
  json cases = jsonList(severity.cases, [&](const SeverityCase& one) -> json {
    return {{"label", one.label}, {"own", one.own}, {"panel", one.panel}};
  });
  return jsonAnswer({{"cases", std::move(cases)},
                     {"difference_points", orNull(severity.difference_points)},
                     {"interval_points", severity.interval_points ? json{severity.interval_points->lower,
                                                                         severity.interval_points->upper}
                                                                  : json(nullptr)},
                     {"own_mean_points", orNull(severity.ownMean_points)},
                     {"panel_mean_points", orNull(severity.panelMean_points)},
                     {"waiting", severity.waiting},
                     {"sealed", severity.sealed},
                     {"lowest_points", severity.lowest_points},
                     {"used", severity.used}});
}

json discrepancyJson(const Call& call, const DiscrepancyCase& one) {
  json rows = jsonList(one.rows, [&](const RowComparison& row) -> json {
    return {{"label", row.label.empty() ? "" : said(call, Text(row.label))},
            {"own", row.own},
            {"mean", row.mean},
            {"lowest", row.lowest},
            {"highest", row.highest},
            {"apart", row.apart}};
  });
  const char* const decisions[] = {"keep", "move", "third"};
  return {
      {"case", call.session->handleOf(one.shown.assignmentId)},
      {"label", one.shown.label},
      {"largest", one.largest},
      {"decision", one.decision ? json(decisions[static_cast<std::size_t>(*one.decision)]) : json(nullptr)},
      {"reason", one.reason},
      {"rows", std::move(rows)}};
}

HttpResponse answerDiscrepancies(Call& call) {
  json cases = jsonList(discrepancyCases(call.context),
                        [&](const DiscrepancyCase& one) { return discrepancyJson(call, one); });
  return jsonAnswer({{"cases", std::move(cases)}, {"opens", said(call, whenCasesAreCompared(call.context))}});
}

HttpResponse answerKeep(Call& call) {
  keepMark(call.context, caseOf(call), call.body.text("reason", kLongestReason * kMaxBytesOfALetter));
  return answerDiscrepancies(call);
}

HttpResponse answerAdjudicator(Call& call) {
  askForAdjudicator(call.context, caseOf(call),
                    call.body.text("reason", kLongestReason * kMaxBytesOfALetter));
  return answerDiscrepancies(call);
}

}  // namespace

std::vector<Route> raterRoutes() {
  constexpr auto kIn = RouteAccess::kSignedIn;
  return withPicture({{"GET", "/api/calibration", kIn, answerCalibration},
                      {"PUT", "/api/calibration/*", kIn, answerReferenceScore},
                      {"GET", "/api/severity", kIn, answerSeverity},
                      {"GET", "/api/discrepancies", kIn, answerDiscrepancies},
                      {"POST", "/api/discrepancies/*/keep", kIn, answerKeep},
                      {"POST", "/api/discrepancies/*/third", kIn, answerAdjudicator}},
                     "/api/calibration/*", referencePicture);
}

}  // namespace torsio::web
