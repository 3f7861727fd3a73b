// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "assessment/scoring/instrument.h"
#include "db/connection/connection.h"
#include "db/repository/rating/assessment_run.h"

namespace torsio {

/// A model under test; raters see the hidden label only.
struct StoredModel {
  std::string code{};         ///< "PM", "FEM", "MSM"
  std::string label{};        ///< "proposed model"
  std::string hiddenLabel{};  ///< "X"
  std::int64_t position = 0;
};

/// A rater of a campaign, with the class that counted then.
struct StoredCampaignRater {
  std::string raterId{};
  std::string classCode{};
  std::string modelOrder{};  ///< "FEM,PM,MSM": the order in which this rater met the models
};

/// A nine-index evaluation (paper section 5.3). Fixed once stored. In `instrument`, RaterClass::id is the
/// code of a stored rater class; the order of classes and indices is kept.
struct StoredCampaign {
  std::string id{};
  std::string name{};  ///< unique
  EvaluationInstrument instrument{};
  std::vector<StoredModel> models{};
  std::vector<StoredCampaignRater> raters{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// One submitted mark: one rater, one model, one index. A correction is a new version with a reason.
struct StoredEvaluationMark {
  std::string id{};
  std::string raterId{};
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

/// Eqs. 25 and 26 for one index of one model, with what stands beside them. In points.
struct StoredEvaluationResult {
  std::string modelCode{};
  std::int64_t indexNumber = 0;
  double weightedMean = 0.0;  ///< M, Eq. 25
  double variance = 0.0;      ///< s^2, Eq. 26
  std::int64_t raterCount = 0;
  std::int64_t missingCount = 0;
  double lowest = 0.0;
  double highest = 0.0;
  double plainMean = 0.0;
  double populationVariance = 0.0;
  std::optional<double> sampleVariance{};
  std::optional<double> standardError{};
  std::vector<std::string> flags{};
};

/// Eq. 27 for one model.
struct StoredComposite {
  std::string modelCode{};
  double composite = 0.0;  ///< N
  std::optional<double> standardError{};
  std::vector<std::string> flags{};
};

struct StoredEvaluationRun {
  AssessmentRun run{};
  std::vector<StoredEvaluationResult> results{};
  std::vector<StoredComposite> composites{};
};

/// Campaigns, their marks and results. One call, one transaction.
class EvaluationRepository {
 public:
  /// `station`: for the audit trail.
  explicit EvaluationRepository(Connection& connection, std::string station = {})
      : connection_(connection), station_(std::move(station)) {}

  /// Throws Error (kBadParameter) when the instrument breaks its rules (weights that do not sum to 1).
  void addCampaign(const StoredCampaign& campaign);
  /// Id and name, oldest first.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> campaigns() const;
  [[nodiscard]] std::optional<StoredCampaign> campaign(const std::string& campaignId) const;

  /// Seals marks, each with an entry in the audit trail. Throws Error (kBadData) naming rater, model and
  /// index when a score lies outside the campaign's scale, DbError when a mark exists already or belongs to
  /// no rater, model or index of the campaign.
  void submit(const std::string& campaignId, std::span<const StoredEvaluationMark> marks);
  /// The newest version of every mark, ordered by model, class, rater code, index.
  [[nodiscard]] std::vector<StoredEvaluationMark> marks(const std::string& campaignId) const;
  /// Whether anybody has submitted a mark.
  [[nodiscard]] bool hasMarks(const std::string& campaignId) const;

  void storeRun(const std::string& campaignId, const StoredEvaluationRun& run);

 private:
  Connection& connection_;
  std::string station_;
};

}  // namespace torsio
