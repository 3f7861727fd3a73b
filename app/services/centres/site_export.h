// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "app/services/centres/site_package.h"

namespace torsio {

/// What a centre gives to whoever pools the trial.
struct SiteRequest {
  CohortId cohortId{};
  CampaignId campaignId{};  ///< empty: no evaluation of models
  std::filesystem::path out{};
  /// The centre's key, made if missing. Empty: "<record>.site-key" beside the record.
  std::filesystem::path key{};
  bool simulatedOnly = false;  ///< refuse a record with real people: nobody has signed in
};

struct SitePackage {
  SiteManifest manifest{};
  std::filesystem::path key{};
  bool keyMade = false;
  std::uintmax_t bytes = 0;
};

/// Writes a site package: what a cohort's protocol says, and every append-only row of its trainees who agree
/// to research, with its seal; without names, logins, remarks and other free text. Verifies the record first.
/// Audited. kReportExportCoded. Throws Error: kVerifyFailed if the record does not verify; kPermission for
/// `simulatedOnly` and for a key that others can read; kUsage on a server without `key`; kBadData if the
/// centre has no name or the cohort no plan; kFileUnwritable; DbError; what `progress` throws.
[[nodiscard]] SitePackage exportSite(SessionContext& session, const SiteRequest& request,
                                     const ProgressCallback& progress = {});

}  // namespace torsio
