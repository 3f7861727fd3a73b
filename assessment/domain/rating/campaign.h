// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"

namespace torsio {

/// A model under evaluation; raters see only the hidden label.
struct CampaignModel {
  std::string code{};         ///< "PM", "FEM", "MSM"
  std::string label{};        ///< "proposed model"
  std::string hiddenLabel{};  ///< "X"
  std::int64_t position = 0;
  /// Recording made with the model, which the raters watch; empty: they know the model from elsewhere.
  TrialId trialId{};
};

/// A rater of a campaign with the seniority class valid at that time.
struct CampaignRater {
  RaterId raterId{};
  std::string classCode{};
  std::string modelOrder{};  ///< "FEM,PM,MSM": the order in which this rater met the models
};

/// A nine-index evaluation (paper section 5.3). Immutable once stored. In `instrument`, RaterClass::id is the
/// code of a stored seniority class; the order of classes and indices is preserved.
struct Campaign {
  CampaignId id{};
  std::string name{};  ///< unique
  EvaluationInstrument instrument{};
  std::vector<CampaignModel> models{};
  std::vector<CampaignRater> raters{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// One submitted mark of one rater for one model and index. A correction is a new version with a reason.
struct EvaluationMark {
  EvaluationMarkId id{};
  RaterId raterId{};
  std::string modelCode{};
  std::int64_t indexNumber = 0;  ///< 1 .. number of indices
  std::int64_t version = 1;
  std::int64_t score_steps = 0;
  std::string amendReason{};
  std::int64_t submittedUtc_us = 0;
  bool demonstration = false;
  std::string raterCode{};  ///< filled when read
  std::string classCode{};  ///< filled when read
};

/// One mark of an unfinished evaluation form.
struct EvaluationDraftMark {
  std::string modelCode{};
  std::int64_t indexNumber = 0;
  std::int64_t score_steps = 0;
};

}  // namespace torsio
