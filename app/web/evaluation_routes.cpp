// SPDX-License-Identifier: GPL-3.0-or-later
// The nine-index evaluation form of tissue models.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "app/services/base/assets.h"
#include "app/services/review/evaluation_form.h"
#include "app/web/case_json.h"
#include "app/web/router.h"
#include "app/web/sealing.h"
#include "app/web/web_desk.h"
#include "assessment/domain/people/signature.h"
#include "assessment/domain/rating/index_meaning.h"
#include "sim/core/error.h"

namespace torsio::web {

namespace {

using nlohmann::json;

constexpr std::int64_t kMaxIndices = 100;
constexpr std::int64_t kMaxSteps = 1'000'000;

const char* const kCampaign = "campaign ";

json modelJson(const EvaluationFormModel& model) {
  return {{"label", model.hiddenLabel},
          {"sheet", sheetJson(evaluationSheet(model))},
          {"submitted", model.submitted},
          {"recorded", model.recorded}};
}

json formsJson(Call& call) {
  json forms = json::array();
  for (const EvaluationForm& form : evaluationForms(call.context)) {
    json rubric = rubricJson(evaluationRubric(form), call.wording);
    rubric["overall"] = nullptr;  // nine marks, no overall mark
    for (std::size_t i = 0; i < form.indexIds.size(); ++i) {
      const std::optional<IndexMeaning> meaning = indexMeaning(form.indexIds[i]);
      rubric["rows"][i]["description"] = meaning ? call.wording(meaning->definition).toStdString() : "";
    }
    json models = json::array();
    for (const EvaluationFormModel& model : form.models) {
      models.push_back(modelJson(model));
    }
    forms.push_back({{"form", call.session->handleFor(kCampaign + form.campaignId.text())},
                     {"title", form.title},
                     {"complete", form.complete()},
                     {"rubric", std::move(rubric)},
                     {"models", std::move(models)}});
  }
  return {{"forms", std::move(forms)}};
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
  throw Error(ErrorCode::kPermission, Text::tr("this evaluation does not ask for you"), "",
              Text::tr("Load the page again"));
}

HttpResponse answerForms(Call& call) {
  return jsonAnswer(formsJson(call));
}

HttpResponse answerScore(Call& call) {
  const auto [campaignId, label] = modelOf(call);
  const auto index = static_cast<std::size_t>(call.body.whole("index", 1, kMaxIndices));
  saveEvaluationScore(call.context, campaignId, label, index - 1,
                      call.body.wholeOrNone("score_steps", -kMaxSteps, kMaxSteps));
  return jsonAnswer({{"revision", 0}});
}

HttpResponse answerSubmitModel(Call& call) {
  const auto [campaignId, label] = modelOf(call);
  return sealing(call, SignatureMeaning::kScored, [&, &campaign = campaignId, &model = label] {
    submitEvaluation(call.context, campaign, model);
    return jsonAnswer(formsJson(call));
  });
}

std::shared_ptr<const CasePicture> modelPicture(Call& call) {
  const auto [campaignId, label] = modelOf(call);
  return call.desk.pictures().of(kCampaign + campaignId.text() + " " + label,
                                 [&, &campaign = campaignId, &model = label] {
                                   return casePicture(loadEvaluationRecording(call.context, campaign, model),
                                                      assetsFolder(), call.desk.shelf());
                                 });
}

HttpResponse answerModelRecording(Call& call) {
  return binaryAnswer(call, modelPicture(call)->recording);
}

HttpResponse answerModelOrgan(Call& call) {
  return organAnswer(call, *modelPicture(call));
}

}  // namespace

std::vector<Route> evaluationRoutes() {
  constexpr auto kIn = RouteAccess::kSignedIn;
  return {{"GET", "/api/evaluation", kIn, answerForms},
          {"PUT", "/api/evaluation/*/*", kIn, answerScore},
          {"POST", "/api/evaluation/*/*/submit", kIn, answerSubmitModel},
          {"GET", "/api/evaluation/*/*/recording", kIn, answerModelRecording, true},
          {"GET", "/api/evaluation/*/*/organ", kIn, answerModelOrgan, true}};
}

}  // namespace torsio::web
