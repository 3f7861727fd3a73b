// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/campaign.h"
#include "assessment/domain/rating/instrument.h"
#include "db/connection/connection.h"
#include "db/repository/rating/assessment_run.h"

namespace torsio {

/// Eqs. 25 and 26 for one index of one model, with accompanying statistics. In points.
struct EvaluationResultRow {
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
struct CompositeRow {
  std::string modelCode{};
  double composite = 0.0;  ///< N
  std::optional<double> standardError{};
  std::vector<std::string> flags{};
};

struct EvaluationRunRows {
  AssessmentRun run{};
  std::vector<EvaluationResultRow> results{};
  std::vector<CompositeRow> composites{};
};

/// Campaigns, their marks and results. Each call is one transaction.
class EvaluationRepository {
 public:
  /// `station`: for the audit trail.
  explicit EvaluationRepository(Connection& connection, std::string station = {})
      : connection_(connection), station_(std::move(station)) {}

  /// Throws Error (kBadParameter) for an invalid instrument (weights that do not sum to 1).
  void addCampaign(const Campaign& campaign);
  /// Id and name, oldest first.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> campaigns() const;
  [[nodiscard]] std::optional<Campaign> campaign(const CampaignId& campaignId) const;

  /// Seals marks, each with an entry in the audit trail. Throws Error (kBadData) naming rater, model and
  /// index if a
  /// score is off the campaign's scale, DbError if a mark already exists or names no rater, model or index of
  /// the
  /// campaign.
  void submit(const CampaignId& campaignId, std::span<const EvaluationMark> marks);
  /// The newest version of every mark, ordered by model, class, rater code, index.
  [[nodiscard]] std::vector<EvaluationMark> marks(const CampaignId& campaignId) const;
  /// True if anybody has submitted a mark.
  [[nodiscard]] bool hasMarks(const CampaignId& campaignId) const;

  void storeRun(const CampaignId& campaignId, const EvaluationRunRows& run);

 private:
  Connection& connection_;
  std::string station_;
};

}  // namespace torsio
