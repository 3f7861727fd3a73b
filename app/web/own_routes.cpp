// SPDX-License-Identifier: GPL-3.0-or-later
// A trainee's own record: runs, debrief, trend, remarks, transcript. Read only, except for replies to
// remarks.
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "app/services/base/assets.h"
#include "app/services/recording/competence.h"
#include "app/services/training/attempts.h"
#include "app/services/training/debrief.h"
#include "app/services/training/detorsion_story.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/remarks.h"
#include "app/services/training/trainee_record.h"
#include "app/services/training/transcript.h"
#include "app/services/training/trend.h"
#include "app/web/case_json.h"
#include "app/web/router.h"
#include "app/web/web_desk.h"
#include "assessment/domain/rating/written_words.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"

namespace torsio::web {

namespace {

using nlohmann::json;

const char* const kRun = "run ";
const char* const kOwnRemark = "remark ";
constexpr std::int64_t kMaxVersions = 1'000'000;

/// A level is never reported alone, but with its criterion and error rates.
json verdictJson(const Call& call, const CompetenceVerdict& verdict) {
  return {{"level", said(call, competenceLevelText(verdict))},
          {"able", isAble(verdict.level)},
          {"design", said(call, competenceRuleText(verdict))},
          {"chance", said(call, competenceChanceText(verdict.design))},
          {"made", said(call, competenceMadeText(verdict))},
          {"errors", said(call, competenceErrorText(verdict.design))}};
}

/// The verdict on a run: its stored word for the page, and the word that the page shows.
json outcomeJson(const Call& call, RunOutcome outcome) {
  return {{"code", storedText(outcome)}, {"word", said(call, wordOf(outcome))}};
}

json attemptJson(const Call& call, const Attempt& attempt, const std::string& title) {
  return {{"run", call.session->handleFor(kRun + attempt.trialId.text())},
          {"title", title},
          {"started_utc_us", attempt.startedUtc_us},
          {"duration_s", attempt.duration_s},
          {"result", attempt.ended ? said(call, attempt.result()) : ""},
          {"outcome", outcomeJson(call, attempt.verdict.outcome)}};
}

json trendJson(const Call& call, const Trend& trend) {
  const ShownUnit& shown = rowOf(trend.quantity).shown;
  const auto scaled = [&shown](const std::optional<double>& value) {
    return value ? json(shown.scale * *value) : json(nullptr);
  };
  const auto inWords = [&](const std::optional<double>& value) {
    return value ? json(said(call, shownValue(trend.quantity, *value))) : json(nullptr);
  };
  json points = jsonList(trend.points, [&](const TrendPoint& point) -> json {
    return {{"attempt", point.attempt},     {"started_utc_us", point.startedUtc_us},
            {"value", scaled(point.value)}, {"told", inWords(point.value)},
            {"counted", point.counted},     {"outcome", outcomeJson(call, point.outcome)}};
  });
  json curve = jsonList(trend.curve, [&](const TrendCurvePoint& point) -> json {
    return {point.attempt, shown.scale * point.value, shown.scale * point.lower, shown.scale * point.upper};
  });
  return {{"metric", said(call, rowOf(trend.quantity).name)},
          {"last", inWords(trend.points.empty() ? std::nullopt : trend.points.back().value)},
          {"wanted", inWords(trend.threshold)},
          {"points", std::move(points)},
          {"curve", std::move(curve)},
          {"threshold", scaled(trend.threshold)},
          {"attempts_left", orNull(trend.attemptsLeft)},
          {"verdict", verdictJson(call, trend.competence)}};
}

/// Returns the tracker's recordings on the real arm, in the words of the window.
json realArmJson(const Call& call, const std::vector<RealArmRun>& runs) {
  return jsonList(runs, [&](const RealArmRun& run) -> json {
    return {{"started_utc_us", run.startedUtc_us},
            {"duration_s", run.duration_s},
            {"told", jsonList(run.sentences, [&](const Text& one) -> json { return said(call, one); })}};
  });
}

HttpResponse answerOwn(Call& call) {
  const PersonId person = call.context.actor().personId;
  const NextSteps steps = nextSteps(call.context, person);
  json modules = json::array();
  std::map<ModuleId, std::string> titles;
  for (const ModuleStep& step : steps.modules) {
    titles[step.module.id] = said(call, Text(step.module.title));
    json module = trendJson(call, trend(call.context, person, step.module.id));
    module["title"] = titles[step.module.id];
    modules.push_back(std::move(module));
  }
  json runs = json::array();
  const std::vector<Attempt> attempts = attemptsOf(call.context, person);
  for (auto attempt = attempts.rbegin(); attempt != attempts.rend(); ++attempt) {
    runs.push_back(attemptJson(call, *attempt, titles[attempt->moduleId]));
  }
  return jsonAnswer({{"code", steps.traineeCode},
                     {"unread", steps.unreadRemarks},
                     {"modules", std::move(modules)},
                     {"real_arm", realArmJson(call, realArmRuns(call.context, person))},
                     {"runs", std::move(runs)}});
}

/// Returns the trainee's run or remark of a handle; an unknown handle and one of another session are answered
/// alike.
std::string ownOf(const Call& call, const char* kind) {
  if (const auto found = objectOf(call, call.parts.front(), kind)) {
    return *found;
  }
  throw Error(ErrorCode::kPermission, Text::tr("this recording belongs to somebody else"), "",
              Text::tr("Open your own record"));
}

json twistJson(const TwistResult& twist) {
  return {{"from_s", twist.when.from_s},
          {"to_s", twist.when.to_s},
          {"target_deg", degrees(twist.target_rad)},
          {"released_deg", degrees(twist.released_rad)},
          {"held_s", twist.held_s},
          {"passed", twist.passed}};
}

json findingJson(const Call& call, const DebriefFinding& finding) {
  return {{"text", said(call, finding.text())},
          {"advice", said(call, finding.advice())},
          {"from_s", finding.when.from_s}};
}

/// Returns the targets and the findings of the debrief, in the words of the window.
json debriefJson(const Call& call, const Debrief& shown) {
  json told{{"checks", json::array()},
            {"strengths", json::array()},
            {"weaknesses", json::array()},
            {"findings", json::array()}};
  for (std::size_t i = 0; i < shown.verdict.checks.size(); ++i) {
    const TargetCheck& check = shown.verdict.checks[i];
    const MissedTarget missed = shown.missed[i].value_or(MissedTarget());
    told["checks"].push_back({{"text", said(call, check.text())},
                              {"passed", check.passed},
                              {"lost", shown.verdict.torn && !check.value},
                              {"advice", said(call, missed.advice)},
                              {"from_s", missed.when ? json(missed.when->from_s) : json(nullptr)}});
  }
  for (const DebriefFinding& finding : shown.strengths) {
    told["strengths"].push_back(findingJson(call, finding));
  }
  for (const DebriefFinding& finding : shown.weaknesses) {
    told["weaknesses"].push_back(findingJson(call, finding));
  }
  if (shown.detorsion) {
    for (const UntwistingFinding& finding : findingsOf(*shown.detorsion)) {
      told["findings"].push_back({{"text", said(call, finding.text())}, {"from_s", orNull(finding.at_s)}});
    }
  }
  return told;
}

json runVerdictJson(const Call& call, const RunVerdict& verdict) {
  return {{"code", storedText(verdict.outcome)},
          {"sentence", said(call, verdict.sentence())},
          {"cause", said(call, verdict.cause())},
          {"remedy", said(call, verdict.remedy())}};
}

HttpResponse answerRun(Call& call) {
  const Debrief shown = debrief(call.context, ownOf(call, kRun), assetsFolder());
  json twists = jsonList(shown.twists, [&](const TwistResult& twist) { return twistJson(twist); });
  json bookmarks = jsonList(shown.bookmarks, [&](const DebriefBookmark& bookmark) -> json {
    return {{"at_s", bookmark.at_s}, {"text", bookmark.text}};
  });
  return jsonAnswer({{"title", said(call, Text(shown.moduleTitle))},
                     {"started_utc_us", shown.startedUtc_us},
                     {"duration_s", shown.duration_s},
                     {"outcome", runVerdictJson(call, shown.verdict)},
                     {"verdict", shown.competence.planned.attempts > 0 ? verdictJson(call, shown.competence)
                                                                       : json(nullptr)},
                     {"force_felt", shown.forceFelt},
                     {"untwisting", shown.detorsion.has_value()},
                     {"tolerance_deg", degrees(shown.tolerance_rad)},
                     {"unfinished", shown.unfinishedTwists},
                     {"told", debriefJson(call, shown)},
                     {"twists", std::move(twists)},
                     {"bookmarks", std::move(bookmarks)}});
}

std::shared_ptr<const CasePicture> runPicture(Call& call) {
  const TrialId id = ownOf(call, kRun);
  (void)ownTrial(call.context, ownRecord(call.context, Operation::kTrialViewOwn), id);
  return call.desk.pictures().of(kRun + id.text(), [&] {
    return casePicture(blindedRecordingOf(call.context.connection(), id, "", ""), assetsFolder(),
                       call.desk.shelf());
  });
}

json remarkJson(const Call& call, const TraineeRemark& remark) {
  json replies =
      jsonList(remark.replies, [&](const TraineeRemark& reply) { return remarkJson(call, reply); });
  return {{"remark", call.session->handleFor(kOwnRemark + remark.id.text())},
          {"at_s", remark.at_s},
          {"text", remark.text},
          {"version", remark.version},
          {"written_utc_us", remark.writtenUtc_us},
          {"edited", remark.editedUtc_us != 0},
          {"own", remark.own},
          {"question", remark.question},
          {"read", remark.read},
          {"replies", std::move(replies)}};
}

HttpResponse answerRemarks(Call& call) {
  json trials = json::array();
  for (const TrialRemarks& trial : ownRemarks(call.context)) {
    json remarks =
        jsonList(trial.remarks, [&](const TraineeRemark& remark) { return remarkJson(call, remark); });
    trials.push_back({{"run", call.session->handleFor(kRun + trial.trialId.text())},
                      {"title", said(call, Text(trial.moduleTitle))},
                      {"started_utc_us", trial.startedUtc_us},
                      {"unread", trial.unread},
                      {"remarks", std::move(remarks)}});
  }
  return jsonAnswer({{"trials", std::move(trials)}});
}

HttpResponse answerReply(Call& call) {
  (void)replyToRemark(call.context, ownOf(call, kOwnRemark),
                      call.body.text("text", kLongestRemark * kMaxBytesOfALetter));
  return answerRemarks(call);
}

HttpResponse answerRead(Call& call) {
  markRemarkRead(call.context, ownOf(call, kOwnRemark), call.body.whole("version", 1, kMaxVersions));
  return answerRemarks(call);
}

HttpResponse answerTranscript(Call& call) {
  const Transcript made = transcript(call.context, call.context.actor().personId);
  json modules = json::array();
  for (const TranscriptModule& module : made.modules) {
    json attempts =
        jsonList(module.attempts, [&](const Attempt& attempt) { return attemptJson(call, attempt, ""); });
    modules.push_back({{"title", said(call, Text(module.step.module.title))},
                       {"mastered", module.step.state == StepState::kMastered},
                       {"verdict", verdictJson(call, module.competence)},
                       {"attempts", std::move(attempts)}});
  }
  return jsonAnswer({{"centre", made.centre},
                     {"name", made.fullName},
                     {"code", made.traineeCode},
                     {"cohort", made.cohortName},
                     {"arm", said(call, Text(made.armLabel))},
                     {"made_utc_us", made.madeUtc_us},
                     {"version", made.softwareVersion},
                     {"virtual_min", made.virtual_min},
                     {"real_min", made.real_min},
                     {"rest_min", made.rest_min},
                     {"demonstration", made.demonstration},
                     {"real_arm", realArmJson(call, made.realArm)},
                     {"modules", std::move(modules)}});
}

}  // namespace

std::vector<Route> ownRoutes() {
  constexpr auto kIn = RouteAccess::kSignedIn;
  return withPicture({{"GET", "/api/own", kIn, answerOwn, true},
                      {"GET", "/api/own/transcript", kIn, answerTranscript, true},
                      {"GET", "/api/own/remarks", kIn, answerRemarks},
                      {"POST", "/api/own/remarks/*/reply", kIn, answerReply},
                      {"POST", "/api/own/remarks/*/read", kIn, answerRead},
                      {"GET", "/api/own/runs/*", kIn, answerRun, true}},
                     "/api/own/runs/*", runPicture);
}

}  // namespace torsio::web
