// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/services/recording/trial_digests.h"
#include "assessment/domain/ids.h"

namespace torsio {

/// A campaign that can be reported.
struct ReportableCampaign {
  CampaignId id{};
  std::string name{};
  bool hasMarks = false;  ///< it has marks
};
/// Oldest first. kResultsCompute.
[[nodiscard]] std::vector<ReportableCampaign> reportableCampaigns(SessionContext& session);

/// Contents of a report.
struct ReportRequest {
  CohortId cohortId{};
  CampaignId campaignId{};  ///< empty: no evaluation
  FreezeId frozenId{};      ///< empty: current data
  ReportIdentity identity = ReportIdentity::kCoded;
};

/// Reads everything that the report says; for a frozen data set also whether the record still matches.
/// kResultsCompute; for named trainees also kPersonViewIdentity. Includes single marks for actors with
/// kMarkViewCoded; for others, in a coded report of a frozen data set that still matches and has no pending
/// raters. Throws Error{kBadParameter} for an unknown cohort or data set.
[[nodiscard]] CohortInputs reportInputs(SessionContext& session, const ReportRequest& request,
                                        TrialDigests& digests, const ProgressCallback& progress = {});

}  // namespace torsio
