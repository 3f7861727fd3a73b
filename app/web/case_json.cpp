// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/case_json.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "app/services/review/sheet_editor.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/written_words.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio::web {

namespace {

using nlohmann::json;

constexpr std::size_t kMaxRows = 200;
constexpr std::size_t kMaxStretches = 200;
constexpr std::int64_t kLargestScore_steps = 1'000'000'000;

json scaleJson(const ScoreScale& scale) {
  return {{"lowest_steps", scale.lo},
          {"highest_steps", scale.hi},
          {"steps_per_point", scale.stepsPerPoint},
          {"arrow_steps", arrowSteps(scale)}};
}

json loadJson(Quantity quantity, const std::optional<double>& limit) {
  const ShownUnit& shown = rowOf(quantity).shown;
  return {{"limit", orNull(limit)}, {"unit", shown.unit}, {"decimals", shown.decimals}};
}

std::string wordsOf(const JsonBody& body, const char* field, std::size_t characters) {
  return body.textOrNone(field, characters * kMaxBytesOfALetter);
}

}  // namespace

const char* stateName(SheetState state) {
  return state == SheetState::kSubmitted ? "submitted" : state == SheetState::kDraft ? "draft" : "open";
}

json queueJson(const ReviewQueue& queue, WebSession& session) {
  json lines = jsonList(queue.lines, [&](const QueueLine& line) -> json {
    return {{"case", session.handleOf(line.shown.assignmentId)},
            {"label", line.shown.label},
            {"live", line.shown.live},
            {"state", stateName(line.state)},
            {"estimate_min", line.estimate_min},
            {"due_utc_us", orNull(line.shown.dueUtc_us)},
            {"overdue", line.overdue}};
  });
  return {{"lines", lines},
          {"waiting", queue.waiting},
          {"drafts", queue.drafts},
          {"submitted", queue.submitted},
          {"overdue", queue.overdue},
          {"minutes", queue.minutes},
          {"in_ten_minutes", queue.inTenMinutes},
          {"live_called", queue.liveCalled},
          {"live_waiting", queue.liveWaiting},
          {"next", queue.next ? json(session.handleOf(*queue.next)) : json(nullptr)}};
}

json sheetJson(const Sheet& sheet) {
  json rows = jsonList(sheet.rows, [&](const SheetRow& row) -> json {
    return {{"code", row.code},
            {"score_steps", orNull(row.score_steps)},
            {"not_assessable", row.notAssessableReason}};
  });
  return {{"revision", sheet.revision},
          {"rows", rows},
          {"overall_steps", orNull(sheet.overall_steps)},
          {"overall_not_assessable", sheet.notAssessableReason},
          {"comment", sheet.comment}};
}

json rubricJson(const RubricRevision& rubric, const Wording& wording) {
  const auto said = [&wording](const std::string& words) { return wording(Text(words)).toStdString(); };
  json rows = json::array();
  for (const RubricLine& line : rubric.rows) {
    json anchors = jsonList(line.anchors, [&](const RubricAnchor& anchor) -> json {
      return {{"steps", anchor.score_steps}, {"text", said(anchor.meaning)}};
    });
    rows.push_back({{"code", line.code},
                    {"label", said(line.label)},
                    {"anchors", anchors},
                    {"scale", scaleJson(line.scale)}});
  }
  return {{"rows", rows}, {"overall", scaleJson(rubric.overall)}};
}

json checkJson(const SheetCheck& check) {
  return {{"may_submit", check.mayBeSubmitted()},
          {"unanswered", check.unanswered},
          {"watched_too_little", check.watchedTooLittle},
          {"watched_share", check.watchedShare},
          {"speed_not_allowed", check.speedNotAllowed},
          {"soon_after_call_s",
           check.soonAfterCall_us ? json(*check.soonAfterCall_us / kSecond_us) : json(nullptr)},
          {"all_the_same", check.allTheSame},
          {"far_apart", check.farApart},
          {"overall_outside", check.overallOutside}};
}

json watchedJson(const WatchLog& watched) {
  return watched.spans();
}

json remarksJson(const std::vector<CaseRemark>& remarks) {
  json all = jsonList(remarks, [&](const CaseRemark& remark) -> json {
    return {{"id", std::string(remark.id)},
            {"time_us", remark.time_us},
            {"text", remark.text},
            {"edited", remark.editedUtc_us != 0}};
  });
  return all;
}

json versionsJson(const std::vector<SheetVersion>& versions) {
  json all = jsonList(versions, [&](const SheetVersion& version) -> json {
    return {{"version", version.version},
            {"submitted_utc_us", version.submittedUtc_us},
            {"reason", version.amendReason},
            {"overall_steps", orNull(version.overall_steps)},
            {"after_panel", version.afterPanel}};
  });
  return all;
}

json taskJson(const BlindedTask& task) {
  return {{"untwisting", task.untwisting()},
          {"target_deg", degrees(task.target_rad)},
          {"tolerance_deg", degrees(task.rules.tolerance_rad)},
          {"hold_s", task.rules.hold_s},
          {"least_twists", task.rules.leastTwists},
          {"force", loadJson(Quantity::kPeakForce, task.rules.forceLimit_N)},
          {"torque", loadJson(Quantity::kPeakTorque, task.rules.torqueLimit_Nm)}};
}

Sheet sheetOf(const JsonBody& body, const RubricRevision& rubric) {
  Sheet sheet;
  sheet.revision = body.whole("revision", 0, INT64_MAX - 1);
  sheet.overall_steps = body.wholeOrNone("overall_steps", -kLargestScore_steps, kLargestScore_steps);
  sheet.notAssessableReason = wordsOf(body, "overall_not_assessable", kLongestReason);
  sheet.comment = wordsOf(body, "comment", kLongestComment);
  for (const JsonBody& row : body.objects("rows", kMaxRows)) {
    SheetRow read{row.text("code", kLongestReason),
                  row.wholeOrNone("score_steps", -kLargestScore_steps, kLargestScore_steps),
                  wordsOf(row, "not_assessable", kLongestReason)};
    const auto sameCode = [&read](const auto& other) { return other.code == read.code; };
    if (std::none_of(rubric.rows.begin(), rubric.rows.end(), sameCode) ||
        std::any_of(sheet.rows.begin(), sheet.rows.end(), sameCode)) {
      refuseParameter(Text::tr("the page sent something that cannot be used"), read.code,
                      Text::tr("Load the page again"));
    }
    sheet.rows.push_back(std::move(read));
  }
  return sheet;
}

std::vector<PlayedStretch> playedOf(const JsonBody& body) {
  constexpr double kSlowest = 0.01;
  constexpr double kFastest = 100.0;
  std::vector<PlayedStretch> played;
  for (const JsonBody& one : body.objects("played", kMaxStretches)) {
    played.push_back({one.whole("from_us", 0, kDay_us), one.whole("to_us", 0, kDay_us),
                      one.number("speed", kSlowest, kFastest)});
  }
  return played;
}

}  // namespace torsio::web
