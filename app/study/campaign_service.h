// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/access/session_context.h"
#include "assessment/people/person.h"
#include "assessment/rating/campaign.h"

namespace torsio {

/// A model to be evaluated.
struct NewModel {
  std::string code{};   ///< "PM"
  std::string label{};  ///< "proposed model"
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
/// The paper's instrument, with the codes of the stored classes: intern, deputy_chief, chief.
[[nodiscard]] EvaluationInstrument paperEvaluationInstrument();

/// Stores the campaign: hidden labels (X, Y, Z ...) drawn at random, orders of the models counterbalanced
/// within each class (every order as often as any other, up to four models; beyond, rows of a Latin square).
/// Returns the id. Audited. kEvaluationSetup. Throws Error{kBadParameter}: weights that do not sum to 1,
/// fewer than two models, a weighted class without a rater, a rater whose class has no weight.
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
