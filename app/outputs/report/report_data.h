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
  bool hasMarks = false;  ///< somebody has scored in it
};
/// Oldest first. kResultsCompute.
[[nodiscard]] std::vector<ReportableCampaign> reportableCampaigns(SessionContext& session);

/// What a report is asked for.
struct ReportRequest {
  CohortId cohortId{};
  CampaignId campaignId{};  ///< empty: no evaluation of models
  FreezeId frozenId{};      ///< empty: the data as they are now
  ReportIdentity identity = ReportIdentity::kCoded;
};

/// Everything that the report says, read from the record; with a frozen data set also whether the record is
/// still the same. kResultsCompute; for named trainees kPersonViewIdentity too. Single marks are included for
/// whoever has kMarkViewCoded; for others in a coded report of a frozen data set that is still the same and
/// waits for no rater. Throws Error{kBadParameter} for an unknown cohort or data set.
[[nodiscard]] CohortInputs reportInputs(SessionContext& session, const ReportRequest& request,
                                        TrialDigests& digests, const ProgressCallback& progress = {});

}  // namespace torsio
