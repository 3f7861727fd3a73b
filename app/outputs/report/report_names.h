// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/outputs/report/report_data.h"
#include "assessment/domain/ids.h"

namespace torsio {

class Connection;

/// Returns the cohort of this name, or the oldest for an empty name. Throws Error{kBadParameter} if there is
/// none.
[[nodiscard]] CohortId cohortNamed(Connection& connection, const std::string& name);

/// Returns the evaluation of this name; for an empty name the oldest with marks, or none. Throws
/// Error{kBadParameter} for an unknown name.
[[nodiscard]] CampaignId campaignNamed(Connection& connection, const std::string& name);

/// Names of what a report is about; empty: see reportNamed().
struct ReportNames {
  std::string cohort{};
  std::string campaign{};
  std::string frozen{};
};

/// Looks up the ids: by default the oldest cohort, the oldest evaluation with marks, and current data.
/// kReportExportCoded; for a frozen data set also kResultsCompute. Throws Error{kBadParameter} for an unknown
/// name.
[[nodiscard]] ReportRequest reportNamed(SessionContext& session, const ReportNames& names);

}  // namespace torsio
