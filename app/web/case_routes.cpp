// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "app/services/base/assets.h"
#include "app/services/review/blinded_case.h"
#include "app/services/review/case_remarks.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/discrepancy_review.h"
#include "app/services/review/evaluation_form.h"
#include "app/services/review/review_queue.h"
#include "app/web/case_json.h"
#include "app/web/router.h"
#include "app/web/web_desk.h"
#include "assessment/domain/people/signature.h"
#include "assessment/domain/rating/instrument.h"
#include "assessment/domain/rating/written_words.h"
#include "db/connection/db_error.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio::web {

namespace {

using nlohmann::json;

SheetCheck checkOf(SessionContext& context, const OpenedSheet& opened, const Sheet& sheet,
                   const WatchLog& watched) {
  return checkSheet(opened, sheet, watched, viewingRules(context), context.now_us());
}

json taskOf(SessionContext& context, const OpenedSheet& opened) {
  if (opened.shown.live) {
    return nullptr;
  }
  return taskJson(blindedTask(context, opened.shown.assignmentId));
}

HttpResponse answerQueue(Call& call) {
  const ReviewQueue queue = reviewQueue(call.context);
  if (queue.next) {
    call.desk.prepare(call.context.actor(), *queue.next);
  }
  return jsonAnswer(queueJson(queue, *call.session));
}

HttpResponse answerCase(Call& call) {
  const AssignmentId id = caseOf(call);
  const OpenedSheet opened = openSheet(call.context, id);
  const ViewingRules rules = viewingRules(call.context);
  if (!opened.shown.live && opened.state != SheetState::kSubmitted) {
    beginWatching(call.context, id.text());
  }
  return jsonAnswer({{"label", opened.shown.label},
                     {"live", opened.shown.live},
                     {"state", stateName(opened.state)},
                     {"length_us", opened.shown.length_us.value_or(0)},
                     {"digest", opened.shown.live ? "" : recordingName(call.context, id).digest},
                     {"kept_at", keptAt(call.context) == KeptAt::kServer ? "server" : "machine"},
                     {"task", taskOf(call.context, opened)},
                     {"rules", {{"minimum_watched", rules.minimumWatched}, {"speeds", rules.speeds}}},
                     {"rubric", rubricJson(opened.rubric, call.wording)},
                     {"sheet", sheetJson(opened.sheet)},
                     {"watched", watchedJson(opened.watched)},
                     {"share", opened.watched.share()},
                     {"worked_us", opened.watched.worked_us()},
                     {"remarks", remarksJson(caseRemarks(call.context, id))},
                     {"versions", versionsJson(sheetVersions(call.context, id))},
                     {"panel_open", opened.panelOpen},
                     {"check", checkJson(checkOf(call.context, opened, opened.sheet, opened.watched))}});
}

HttpResponse answerSave(Call& call) {
  const AssignmentId id = caseOf(call);
  const OpenedSheet opened = openSheet(call.context, id);
  const Sheet sheet = sheetOf(call.body, opened.rubric);
  try {
    const std::int64_t revision = saveSheet(call.context, id, sheet, opened.watched);
    return jsonAnswer(
        {{"revision", revision}, {"check", checkJson(checkOf(call.context, opened, sheet, opened.watched))}});
  } catch (const DbError& error) {
    if (error.fault() != DbFault::kConflict) {
      throw;
    }
    return refusal(409,
                   Error(ErrorCode::kBadData, error.happenedText(), Text::tr("case %1", opened.shown.label),
                         error.remedyText()),
                   call.wording, {{"sheet", sheetJson(openSheet(call.context, id).sheet)}});
  }
}

HttpResponse answerViewing(Call& call) {
  const AssignmentId id = caseOf(call);
  const OpenedSheet opened = reportViewing(call.context, id, playedOf(call.body));
  return jsonAnswer({{"watched", watchedJson(opened.watched)},
                     {"share", opened.watched.share()},
                     {"worked_us", opened.watched.worked_us()},
                     {"check", checkJson(checkOf(call.context, opened, opened.sheet, opened.watched))}});
}

HttpResponse answerSubmit(Call& call) {
  const AssignmentId id = caseOf(call);
  return sealing(call, SignatureMeaning::kScored, [&] {
    const OpenedSheet opened = openSheet(call.context, id);
    submitSheet(call.context, id, sheetOf(call.body.object("sheet"), opened.rubric), opened.watched);
    const auto next = reviewQueue(call.context).next;
    if (next) {
      call.desk.prepare(call.context.actor(), *next);
    }
    return jsonAnswer({{"next", next ? json(call.session->handleOf(*next)) : json(nullptr)}});
  });
}

HttpResponse answerAmend(Call& call) {
  const AssignmentId id = caseOf(call);
  return sealing(call, SignatureMeaning::kAmended, [&] {
    const OpenedSheet opened = openSheet(call.context, id);
    changeSubmitted(call.context, id, sheetOf(call.body.object("sheet"), opened.rubric),
                    call.body.text("reason", kLongestReason * kMaxBytesOfALetter));
    return jsonAnswer(json::object());
  });
}

HttpResponse answerRemark(Call& call) {
  const AssignmentId id = caseOf(call);
  addCaseRemark(call.context, id,
                {.time_us = call.body.whole("time_us", 0, kDay_us),
                 .text = call.body.textOrNone("text", kLongestRemark * kMaxBytesOfALetter)});
  return jsonAnswer({{"remarks", remarksJson(caseRemarks(call.context, id))}});
}

HttpResponse answerEditRemark(Call& call) {
  const AssignmentId id = caseOf(call);
  editCaseRemark(call.context, id, RemarkId(call.parts.back()),
                 call.body.text("text", kLongestRemark * kMaxBytesOfALetter));
  return jsonAnswer({{"remarks", remarksJson(caseRemarks(call.context, id))}});
}

std::shared_ptr<const CasePicture> pictureOf(Call& call) {
  return pictureOf(call.desk, call.context, caseOf(call));
}

/// Serves body and skin of an organ by the hash of their bytes: whoever knows it has already been shown the
/// organ.
HttpResponse answerShelf(Call& call) {
  const auto bytes = call.desk.shelf().find(call.parts.front());
  if (bytes == nullptr) {
    refuse(Text::tr("there is nothing at this address"), "", Text::tr("Load the page again"));
  }
  HttpResponse response = binaryAnswer(call, *bytes);
  response.headers.front().second = "private, max-age=604800, immutable";
  return response;
}

}  // namespace

std::shared_ptr<const CasePicture> pictureOf(WebDesk& desk, SessionContext& context,
                                             const AssignmentId& assignmentId) {
  return desk.pictures().of(recordingName(context, assignmentId).key, [&] {
    return casePicture(loadBlindedRecording(context, assignmentId), assetsFolder(), desk.shelf());
  });
}

std::vector<Route> caseRoutes() {
  constexpr auto kIn = RouteAccess::kSignedIn;
  return withPicture({{"GET", "/api/queue", kIn, answerQueue},
                      {"GET", "/api/cases/*", kIn, answerCase},
                      {"PUT", "/api/cases/*/sheet", kIn, answerSave},
                      {"POST", "/api/cases/*/viewing", kIn, answerViewing},
                      sealingRoute("/api/cases/*/submit", answerSubmit),
                      sealingRoute("/api/cases/*/amend", answerAmend),
                      {"POST", "/api/cases/*/remarks", kIn, answerRemark},
                      {"PUT", "/api/cases/*/remarks/*", kIn, answerEditRemark},
                      {"GET", "/api/organs/*", kIn, answerShelf}},
                     "/api/cases/*", pictureOf);
}

namespace {

using nlohmann::json;

constexpr std::int64_t kMaxIndices = 100;
constexpr std::int64_t kMaxSteps = 1'000'000;

const char* const kCampaign = "campaign ";

std::string keyOf(const CampaignId& campaignId, const std::string& label) {
  return modelRecording(campaignId.text(), label);
}

/// What this session watched of a model; empty if nothing.
WatchLog watchedOf(const Call& call, const CampaignId& campaignId, const std::string& label) {
  const auto found = call.session->modelsWatched.find(keyOf(campaignId, label));
  return found == call.session->modelsWatched.end() ? WatchLog() : found->second;
}

json modelJson(const Call& call, const EvaluationForm& form, const EvaluationFormModel& model,
               const ViewingRules& rules) {
  const WatchLog watched = watchedOf(call, form.campaignId, model.hiddenLabel);
  return {
      {"label", model.hiddenLabel},      {"sheet", sheetJson(evaluationSheet(model))},
      {"watched", watchedJson(watched)}, {"check", checkJson(checkEvaluation(form, model, watched, rules))},
      {"submitted", model.submitted},    {"recorded", model.recorded}};
}

json formsJson(Call& call) {
  const ViewingRules rules = evaluationRules(call.context);
  json forms = json::array();
  for (const EvaluationForm& form : evaluationForms(call.context)) {
    json rubric = rubricJson(evaluationRubric(form), call.wording);
    rubric["overall"] = nullptr;  // nine marks, no overall mark
    for (std::size_t i = 0; i < form.indexIds.size(); ++i) {
      const std::optional<IndexMeaning> meaning = indexMeaning(form.indexIds[i]);
      rubric["rows"][i]["description"] = meaning ? said(call, meaning->definition) : "";
    }
    json models = jsonList(
        form.models, [&](const EvaluationFormModel& model) { return modelJson(call, form, model, rules); });
    forms.push_back({{"form", call.session->handleFor(kCampaign + form.campaignId.text())},
                     {"title", form.title},
                     {"complete", form.complete()},
                     {"rubric", std::move(rubric)},
                     {"models", std::move(models)}});
  }
  return {{"forms", std::move(forms)},
          {"rules", {{"minimum_watched", rules.minimumWatched}, {"speeds", rules.speeds}}}};
}

/// Returns the model of an address, among those assigned to the actor.
std::pair<CampaignId, std::string> modelOf(Call& call) {
  const std::string what = call.session->objectOf(call.parts.front());
  for (const EvaluationForm& form : evaluationForms(call.context)) {
    const bool known = std::any_of(form.models.begin(), form.models.end(),
                                   [&](const auto& model) { return model.hiddenLabel == call.parts.back(); });
    if (what == kCampaign + form.campaignId.text() && known) {
      return {form.campaignId, call.parts.back()};
    }
  }
  throw Error(ErrorCode::kPermission, Text::tr("you do not take part in this evaluation"), "",
              Text::tr("Load the page again"));
}

HttpResponse answerForms(Call& call) {
  return jsonAnswer(formsJson(call));
}

json checkOfModel(Call& call, const CampaignId& campaignId, const std::string& label) {
  for (const EvaluationForm& form : evaluationForms(call.context)) {
    for (const EvaluationFormModel& model : form.models) {
      if (form.campaignId == campaignId && model.hiddenLabel == label) {
        return checkJson(
            checkEvaluation(form, model, watchedOf(call, campaignId, label), evaluationRules(call.context)));
      }
    }
  }
  return nullptr;
}

HttpResponse answerScore(Call& call) {
  const auto [campaignId, label] = modelOf(call);
  const auto index = static_cast<std::size_t>(call.body.whole("index", 1, kMaxIndices));
  saveEvaluationScore(call.context, campaignId, label, index - 1,
                      call.body.wholeOrNone("score_steps", -kMaxSteps, kMaxSteps));
  return jsonAnswer({{"revision", 0}, {"check", checkOfModel(call, campaignId, label)}});
}

HttpResponse answerSubmitModel(Call& call) {
  const auto [campaignId, label] = modelOf(call);
  return sealing(call, SignatureMeaning::kScored, [&, &campaign = campaignId, &model = label] {
    submitEvaluation(call.context, campaign, model, watchedOf(call, campaign, model));
    return jsonAnswer(formsJson(call));
  });
}

std::shared_ptr<const CasePicture> modelPicture(Call& call) {
  const auto [campaignId, label] = modelOf(call);
  return call.desk.pictures().of(keyOf(campaignId, label), [&, &campaign = campaignId, &model = label] {
    return casePicture(loadEvaluationRecording(call.context, campaign, model), assetsFolder(),
                       call.desk.shelf());
  });
}

HttpResponse answerModelViewing(Call& call) {
  const auto [campaignId, label] = modelOf(call);
  const std::string key = keyOf(campaignId, label);
  WatchLog& log =
      call.session->modelsWatched.try_emplace(key, WatchLog(modelPicture(call)->length_us)).first->second;
  log = watchedInBrowser(
      call.context, key, log,
      playable(playedOf(call.body), evaluationRules(call.context), Text::tr("model %1", label)));
  return jsonAnswer({{"watched", watchedJson(log)},
                     {"share", log.share()},
                     {"worked_us", log.worked_us()},
                     {"check", checkOfModel(call, campaignId, label)}});
}

}  // namespace

std::vector<Route> evaluationRoutes() {
  constexpr auto kIn = RouteAccess::kSignedIn;
  return withPicture({{"GET", "/api/evaluation", kIn, answerForms},
                      {"PUT", "/api/evaluation/*/*", kIn, answerScore},
                      {"POST", "/api/evaluation/*/*/viewing", kIn, answerModelViewing},
                      sealingRoute("/api/evaluation/*/*/submit", answerSubmitModel)},
                     "/api/evaluation/*/*", modelPicture);
}

}  // namespace torsio::web
