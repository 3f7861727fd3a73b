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

/// A model to be evaluated.
struct NewModel {
  std::string code{};   ///< "PM"
  std::string label{};  ///< "proposed model"
  /// The recording that the raters watch under the hidden label; empty: they have met the model elsewhere.
  TrialId trialId{};
};

/// A nine-index evaluation to set up (paper section 5.3).
struct CampaignPlan {
  std::string name{};
  /// Scale, weights of classes and indices. RaterClass::id is the code of a stored rater class.
  EvaluationInstrument instrument{};
  std::vector<NewModel> models{};
  std::vector<RaterId> raterIds{};  ///< each counts in the class they have now
  std::optional<std::uint64_t>
      seed{};  ///< of hidden labels and orders; empty: drawn, and kept in the audit trail
  bool demonstration = false;
};
/// Throws Error{kBadParameter}: fewer than two models, one without a code or name, a code with a comma or
/// twice, recordings of some models only.
void requireComparableModels(const std::vector<NewModel>& models);
/// The paper's instrument, with the codes of the stored classes: intern, deputy_chief, chief.
[[nodiscard]] EvaluationInstrument paperEvaluationInstrument();

/// A recording that an evaluation may show: nobody's in training, and finished.
struct EvaluationRecording {
  TrialId trialId{};
  SceneId sceneId{};
  PatternId patternId{};
  TissueModel model = TissueModel::kTwist;
  std::int64_t startedUtc_us = 0;
};
/// Newest first, among the newest thousand recordings of the record. kEvaluationSetup.
[[nodiscard]] std::vector<EvaluationRecording> evaluationRecordings(SessionContext& session);

/// Stores the campaign: hidden labels (X, Y, Z ...) drawn at random, orders of the models counterbalanced
/// within each class (every order as often as any other, up to four models; beyond, rows of a Latin square).
/// Returns the id. Audited. kEvaluationSetup. Throws Error{kBadParameter}: weights that do not sum to 1,
/// fewer than two models, a weighted class without a rater, a rater whose class has no weight, recordings of
/// some models only, without their end, of a trainee, or twice of the same model; Error{kBadData}: no such
/// recording. With recordings of a simulated hand it is a demonstration.
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
/// Oldest first, with who has scored how much; no marks. kEvaluationSetup.
[[nodiscard]] std::vector<CampaignRow> campaigns(SessionContext& session);

}  // namespace torsio
