// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/evaluation_form.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "app/services/access/signing.h"
#include "app/services/base/assets.h"
#include "app/services/recording/kept_digests.h"
#include "app/services/recording/recorded_run.h"
#include "app/services/review/case_sheet.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/campaign.h"
#include "assessment/domain/rating/instrument.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/base/id_source.h"
#include "db/repository/rating/desk_repository.h"
#include "db/repository/rating/evaluation_repository.h"
#include "sim/core/error.h"
#include "sim/core/tissue_model.h"
#include "sim/scene/scene.h"

namespace torsio {

namespace {

/// Returns the campaign's models in a rater's order; models that it lacks come last.
std::vector<CampaignModel> inOwnOrder(const Campaign& campaign, const std::string& order) {
  std::vector<CampaignModel> models;
  std::string rest = order;
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string code = rest.substr(0, comma);
    rest.erase(0, comma + 1);
    for (const CampaignModel& model : campaign.models) {
      if (model.code == code) {
        models.push_back(model);
      }
    }
  }
  for (const CampaignModel& model : campaign.models) {
    const bool there = std::any_of(models.begin(), models.end(),
                                   [&](const CampaignModel& one) { return one.code == model.code; });
    if (!there) {
      models.push_back(model);
    }
  }
  return models;
}

const CampaignRater* asked(const Campaign& campaign, const RaterId& raterId) {
  for (const CampaignRater& rater : campaign.raters) {
    if (rater.raterId == raterId) {
      return &rater;
    }
  }
  return nullptr;
}

/// The actor's form with the model codes behind its hidden labels.
struct OpenForm {
  EvaluationForm form;
  std::vector<CampaignModel> models;
  bool demonstration = false;
};

/// Returns the model for a hidden label of a demonstration; empty if a recording is required instead.
std::optional<TissueModel> computedModel(const CampaignModel& model, bool demonstration) {
  constexpr std::array<std::pair<std::string_view, TissueModel>, 3> kModels{
      {{"PM", TissueModel::kTwist},
       {"FEM", TissueModel::kFiniteElements},
       {"MSM", TissueModel::kMassSpring}}};
  const auto* found = std::find_if(kModels.begin(), kModels.end(),
                                   [&](const auto& known) { return known.first == model.code; });
  return demonstration && found != kModels.end() ? std::optional(found->second) : std::nullopt;
}

/// Computes an expert's run of a model, under a hidden label.
BlindedRecording computedRun(TissueModel model, const std::string& hiddenLabel, const std::string& salt) {
  SceneRequest request;
  request.assets = assetsFolder();
  request.tissue = model;
  const Scene scene = loadScene(request);
  BlindedRecording recording;
  recording.label = hiddenLabel;
  recording.trial = expertRun(scene, scene.pattern.targetAngle_rad);
  recording.digest = blindedDigest(recording.trial.summary.contentHash, salt);
  recording.task = {recording.trial.header.targetAngle_rad,
                    ExerciseRules().ofPattern(scene.id, scene.pattern.id)};
  recording.trial.header = blinded(recording.trial.header, hiddenLabel);
  recording.trial.summary.contentHash.clear();
  return recording;
}

OpenForm formOf(Connection& connection, const Campaign& campaign, const CampaignRater& rater) {
  OpenForm open{{campaign.id, campaign.name, campaign.instrument.scale, {}, {}, {}},
                inOwnOrder(campaign, rater.modelOrder),
                campaign.demonstration};
  for (const EvaluationIndex& index : campaign.instrument.indices) {
    open.form.indices.push_back(index.name);
    open.form.indexIds.push_back(index.id);
  }
  const std::size_t count = open.form.indices.size();
  const auto draft = DeskRepository(connection).evaluationDraft(campaign.id, rater.raterId);
  const auto marks = EvaluationRepository(connection).marks(campaign.id);
  for (const CampaignModel& model : open.models) {
    EvaluationFormModel shown{model.hiddenLabel, std::vector<std::optional<std::int64_t>>(count), false,
                              !model.trialId.empty() || computedModel(model, campaign.demonstration)};
    for (const EvaluationDraftMark& mark : draft) {
      if (mark.modelCode == model.code) {
        shown.scores.at(static_cast<std::size_t>(mark.indexNumber - 1)) = mark.score_steps;
      }
    }
    for (const EvaluationMark& mark : marks) {
      if (mark.modelCode != model.code || mark.raterId != rater.raterId) {
        continue;
      }
      shown.submitted = true;
      shown.scores.at(static_cast<std::size_t>(mark.indexNumber - 1)) = mark.score_steps;
    }
    open.form.models.push_back(std::move(shown));
  }
  return open;
}

OpenForm ownForm(SessionContext& session, const CampaignId& campaignId) {
  session.require(Operation::kEvaluationSubmit);
  const auto campaign = EvaluationRepository(session.connection()).campaign(campaignId);
  const std::string& person = session.actor().personId;
  const CampaignRater* rater = campaign && !person.empty() ? asked(*campaign, person) : nullptr;
  if (rater == nullptr) {
    throw Error(ErrorCode::kPermission, Text::tr("you are not a rater of this evaluation"),
                Text::tr("the evaluation"), Text::tr("Ask an administrator"));
  }
  return formOf(session.connection(), *campaign, *rater);
}

/// Returns the position of a model that is not submitted yet.
std::size_t openModel(const OpenForm& open, const std::string& hiddenLabel) {
  for (std::size_t i = 0; i < open.form.models.size(); ++i) {
    if (open.form.models[i].hiddenLabel != hiddenLabel) {
      continue;
    }
    if (!open.form.models[i].submitted) {
      return i;
    }
    refuse(Text::tr("these marks were submitted already"), Text::tr("model %1", hiddenLabel),
           Text::tr("Continue with the next model"));
  }
  refuse(Text::tr("there is no such model"), Text::tr("model %1", hiddenLabel),
         Text::tr("Open the form again"));
}

std::vector<RubricAnchor> meaningAnchors(const std::string& indexId, const ScoreScale& scale) {
  const std::optional<IndexMeaning> meaning = indexMeaning(indexId);
  if (!meaning) {
    return {};
  }
  return {{scale.lo, meaning->lowest.str()},
          {(scale.lo + scale.hi) / 2, meaning->middle.str()},
          {scale.hi, meaning->highest.str()}};
}

}  // namespace

RubricRevision evaluationRubric(const EvaluationForm& form) {
  RubricRevision rubric;
  rubric.overall = form.scale;
  for (std::size_t i = 0; i < form.indices.size(); ++i) {
    rubric.rows.push_back(
        {std::to_string(i + 1), form.indices[i], form.scale, meaningAnchors(form.indexIds[i], form.scale)});
  }
  return rubric;
}

Sheet evaluationSheet(const EvaluationFormModel& model) {
  Sheet sheet;
  for (std::size_t i = 0; i < model.scores.size(); ++i) {
    sheet.rows.push_back({std::to_string(i + 1), model.scores[i], {}});
  }
  return sheet;
}

bool EvaluationForm::complete() const noexcept {
  return std::all_of(models.begin(), models.end(),
                     [](const EvaluationFormModel& model) { return model.submitted; });
}

std::vector<EvaluationForm> evaluationForms(SessionContext& session) {
  session.require(Operation::kEvaluationSubmit);
  std::vector<EvaluationForm> forms;
  const std::string& person = session.actor().personId;
  if (person.empty()) {
    return forms;
  }
  EvaluationRepository repository(session.connection());
  for (const auto& [id, name] : repository.campaigns()) {
    const auto campaign = repository.campaign(id);
    const CampaignRater* rater = campaign ? asked(*campaign, person) : nullptr;
    if (rater != nullptr) {
      forms.push_back(formOf(session.connection(), *campaign, *rater).form);
    }
  }
  return forms;
}

BlindedRecording loadEvaluationRecording(SessionContext& session, const CampaignId& campaignId,
                                         const std::string& hiddenLabel) {
  const OpenForm open = ownForm(session, campaignId);
  const std::string salt = campaignId.text() + session.actor().personId.text();
  for (const CampaignModel& model : open.models) {
    if (model.hiddenLabel != hiddenLabel) {
      continue;
    }
    if (!model.trialId.empty()) {
      return blindedRecordingOf(session.connection(), model.trialId, hiddenLabel, salt);
    }
    if (const std::optional<TissueModel> known = computedModel(model, open.demonstration)) {
      return computedRun(*known, hiddenLabel, salt);
    }
  }
  refuse(Text::tr("there is no recording of this model"), Text::tr("model %1", hiddenLabel),
         Text::tr("Score what you have met"));
}

void saveEvaluationScore(SessionContext& session, const CampaignId& campaignId,
                         const std::string& hiddenLabel, std::size_t index,
                         std::optional<std::int64_t> score_steps) {
  const OpenForm open = ownForm(session, campaignId);
  const std::size_t model = openModel(open, hiddenLabel);
  const ScoreScale& scale = open.form.scale;
  const bool outside = score_steps && !isOnScale(*score_steps, scale);
  if (outside || index >= open.form.indices.size()) {
    refuse(Text::tr("the mark is outside the scale"), Text::tr("model %1", hiddenLabel),
           Text::tr("Correct the mark"));
  }
  DeskRepository(session.connection())
      .saveEvaluationDraft(campaignId, session.actor().personId, open.models[model].code,
                           static_cast<std::int64_t>(index + 1), score_steps, session.now_us());
}

ViewingRules evaluationRules(SessionContext& session) {
  session.require(Operation::kEvaluationSubmit);
  return centreViewingRules(session.connection());
}

SheetCheck checkEvaluation(const EvaluationForm& form, const EvaluationFormModel& model,
                           const WatchLog& watched, const ViewingRules& rules) {
  std::vector<SheetLine> lines;
  for (std::size_t i = 0; i < model.scores.size(); ++i) {
    lines.push_back({std::to_string(i + 1), form.scale, {model.scores[i], {}}});
  }
  std::optional<RecordingWatched> seen;
  if (model.recorded) {
    const double share = watched.length_us() == 0 ? 0.0 : watched.share();  // 0: not opened yet
    seen = RecordingWatched{share, watched.slowest(), watched.fastest()};
  }
  return checkSheetLines(lines, seen, rules);
}

namespace {

void sealMarks(SessionContext& session, const CampaignId& campaignId, const std::string& modelCode,
               const std::vector<EvaluationMark>& marks, const nlohmann::json& note) {
  Transaction transaction(session.connection());
  EvaluationRepository(session.connection(), session.station()).submit(campaignId, marks);
  for (const EvaluationMark& mark : marks) {
    sign(session, {.kind = SignedKind::kEvaluationMark,
                   .objectId = mark.id,
                   .meaning = SignatureMeaning::kScored,
                   .demonstration = mark.demonstration});
  }
  DeskRepository(session.connection()).removeEvaluationDraft(campaignId, session.actor().personId, modelCode);
  session.note(AuditAction::kEvaluationForm, AuditObject::kEvaluationCampaign, campaignId, note);
  transaction.commit();
}

}  // namespace

void submitEvaluation(SessionContext& session, const CampaignId& campaignId, const std::string& hiddenLabel,
                      const WatchLog& watched) {
  const OpenForm open = ownForm(session, campaignId);
  const std::size_t model = openModel(open, hiddenLabel);
  const SheetCheck check =
      checkEvaluation(open.form, open.form.models[model], watched, evaluationRules(session));
  const std::vector<std::optional<std::int64_t>>& scores = open.form.models[model].scores;
  std::vector<EvaluationMark> marks;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (!scores[i]) {
      refuse(Text::tr("%1 has no mark yet", open.form.indices[i]), Text::tr("model %1", hiddenLabel),
             Text::tr("Fill it in"));
    }
    EvaluationMark mark;
    mark.id = session.ids().newUuid();
    mark.raterId = session.actor().personId;
    mark.modelCode = open.models[model].code;
    mark.indexNumber = static_cast<std::int64_t>(i + 1);
    mark.score_steps = *scores[i];
    mark.submittedUtc_us = session.now_us();
    mark.demonstration = open.demonstration;
    marks.push_back(std::move(mark));
  }
  requireWatched(check, Text::tr("model %1", hiddenLabel));
  try {
    sealMarks(session, campaignId, open.models[model].code, marks,
              open.form.models[model].recorded ? viewingNote(watched) : nlohmann::json());
  } catch (const DbError&) {
    (void)openModel(ownForm(session, campaignId), hiddenLabel);  // says so if another page was first
    throw;
  }
  endSigning(session);
}

}  // namespace torsio
