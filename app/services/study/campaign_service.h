// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/campaign.h"
#include "sim/core/tissue_model.h"

namespace torsio {

/// A model to evaluate.
struct NewModel {
  std::string code{};   ///< "PM"
  std::string label{};  ///< "proposed model"
  /// Recording shown to raters under the hidden label; empty: the raters know the model from elsewhere.
  TrialId trialId{};
};

/// Settings of a nine-index evaluation (paper section 5.3).
struct CampaignPlan {
  std::string name{};
  /// Scale, weights of classes and indices. RaterClass::id is the code of a stored rater class.
  EvaluationInstrument instrument{};
  std::vector<NewModel> models{};
  std::vector<RaterId> raterIds{};      ///< each counts in their current class
  std::optional<std::uint64_t> seed{};  ///< of hidden labels and orders; empty: drawn, and audited
  bool demonstration = false;
};
/// Throws Error{kBadParameter} for fewer than two models, a model without code or name, a code with a comma
/// or a duplicate one, recordings of some models only.
void requireComparableModels(const std::vector<NewModel>& models);
/// Returns the paper's instrument with the codes of the stored classes: intern, deputy_chief, chief.
[[nodiscard]] EvaluationInstrument paperEvaluationInstrument();

/// A recording that can be evaluated: finished, without a trainee.
struct EvaluationRecording {
  TrialId trialId{};
  SceneId sceneId{};
  PatternId patternId{};
  TissueModel model = TissueModel::kTwist;
  std::int64_t startedUtc_us = 0;
};
/// Latest first, among the latest thousand recordings. kEvaluationSetup.
[[nodiscard]] std::vector<EvaluationRecording> evaluationRecordings(SessionContext& session);

/// Stores the campaign: random hidden labels (X, Y, Z ...), orders of the models counterbalanced within each
/// class (all orders equally often for up to four models; otherwise rows of a Latin square). Returns the id.
/// Audited. kEvaluationSetup. Throws Error{kBadParameter} for weights that do not sum to 1, fewer than two
/// models, a weighted class without raters, a rater whose class has no weight, recordings of some models
/// only, unfinished ones, those of a trainee, or two of the same model; Error{kBadData} for an unknown
/// recording. Recordings of a simulated hand make it a demonstration.
CampaignId addCampaign(SessionContext& session, const CampaignPlan& plan);

struct CampaignRow {
  Campaign campaign{};
  std::size_t marksExpected = 0;
  std::size_t marksSubmitted = 0;
  struct Rater {
    RaterId id{};
    std::string code{};
    std::string classCode{};
    std::size_t submitted = 0;
    std::size_t expected = 0;
  };
  std::vector<Rater> raters{};
};
/// Oldest first, with the raters' progress but no marks. kEvaluationSetup.
[[nodiscard]] std::vector<CampaignRow> campaigns(SessionContext& session);

}  // namespace torsio
