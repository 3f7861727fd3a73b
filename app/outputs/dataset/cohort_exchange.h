// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/outputs/dataset/dataset.h"
#include "app/outputs/dataset/gradebook.h"
#include "app/outputs/report/report_data.h"
#include "app/outputs/tables/export_set.h"
#include "app/outputs/tables/pseudonyms.h"
#include "app/outputs/tables/table_files.h"
#include "app/outputs/tables/workbook.h"
#include "assessment/results/analysed_cohort.h"

namespace torsio {

/// What to export of a cohort, and how its people appear.
struct ExchangeRequest {
  CohortId cohortId{};
  CampaignId campaignId{};     ///< empty: no evaluation
  FreezeId frozenId{};         ///< empty: current data
  bool pseudonymised = false;  ///< forced to true for actors who may not see names
  std::string key{};           ///< key of the pseudonyms; empty: a new one, so that exports cannot be linked
  bool withFreeText = false;   ///< if pseudonymised: include free text
  std::string reason{};        ///< for the audit trail
};

/// All data of a request, read before anything is written.
struct ExchangeData {
  ExchangeRequest request;
  CohortInputs inputs;
  ExportSet set;
  std::optional<PseudonymReport> pseudonyms;  ///< empty: data under the centre's codes
  std::map<TrialId, TrialId> recordings;      ///< record id by the recording's name in `inputs`
  AnalysedCohort analysed;                    ///< of `inputs`
  std::int64_t reportSavedUtc_us = 0;  ///< latest report with single people; 0: none, or data under codes
};

/// Exported files.
struct ExchangeFiles {
  std::vector<std::filesystem::path> files;
  std::uint64_t bytes = 0;
  std::string contentHash;    ///< BLAKE2b-256 of all files in order
  std::vector<Text> notes{};  ///< what did not go into them, a sentence each
};

/// Looks up ids by name; empty names: the oldest cohort, the oldest evaluation with marks.
/// kReportExportCoded. Throws Error{kBadParameter} for an unknown name.
void nameRequest(SessionContext& session, const std::string& cohort, const std::string& campaign,
                 ExchangeRequest& request);

/// Reads the data of a request. Contains no names; marks and means not to be shown yet are omitted as in the
/// report (assessment/results/shown_inputs.h). kReportExportCoded and kResultsCompute. Throws
/// Error{kBadParameter} for an unknown cohort or data set, or a key that is too short.
[[nodiscard]] ExchangeData exchangeData(SessionContext& session, const ExchangeRequest& request,
                                        TrialDigests& digests, const ProgressCallback& progress = {});

/// Describes the pseudonymisation in sentences; empty for data under codes.
[[nodiscard]] std::vector<Text> pseudonymSentences(const ExchangeData& data);

/// Writes `data` and audits who exported what, why, and the hash. kReportExportCoded. Throws
/// Error{kFileUnwritable}; then no partial file remains and nothing is audited. The same applies if
/// `progress` throws to cancel.
ExchangeFiles exportWorkbook(SessionContext& session, const ExchangeData& data, const ExportWording& say,
                             const std::filesystem::path& file, const ProgressCallback& progress = {});
ExchangeFiles exportTables(SessionContext& session, const ExchangeData& data, TableFormat format,
                           const std::filesystem::path& folder, const ProgressCallback& progress = {});

/// How to export a cohort as a data set.
struct DatasetRequest {
  DatasetAbout about;
  DatasetLayout layout = DatasetLayout::kFrictionless;
  std::int64_t rate_Hz = 100;  ///< of the trajectories; must divide the 1000 Hz of a recording
  bool whole = false;  ///< include what importDataset() needs; under codes, with single marks, not as BIDS
};

/// Writes a folder from which R computes the numbers again (writeReplication()). kReportExportCoded; audited.
ExchangeFiles exportReplication(SessionContext& session, const ExchangeData& data,
                                const std::filesystem::path& folder);
/// Exports like exportWorkbook(), but a data set (writeDataset()) with the trajectories of the cohort's
/// recordings. Throws Error{kBadParameter}, before anything is written, for a rate that does not divide 1000
/// Hz, an incomplete description, or a whole data set that is pseudonymised, BIDS or may not contain single
/// marks.
ExchangeFiles exportDataset(SessionContext& session, const ExchangeData& data, const DatasetRequest& request,
                            const std::filesystem::path& folder, const ProgressCallback& progress = {});

/// For which learning system scores are written.
struct GradebookRequest {
  GradebookForm form = GradebookForm::kMoodle;
  std::filesystem::path status{};  ///< ILIAS: the status file of the exercise that is filled in
  std::string occasion{};          ///< ILIAS: name of the occasion whose marks it takes; empty: the last
};

/// Writes a cohort's scores for a learning system, identified by staff or student number, mail address and
/// name, or by code if the centre stores none of them. Omits scores not to be shown yet. Identifies people as
/// the other system does: kReportExportNamed. Throws Error{kFileUnwritable}, {kBadData} if there are no
/// scores, {kBadParameter} for ILIAS without a status file or with an unknown occasion.
ExchangeFiles exportGradebook(SessionContext& session, const ExchangeRequest& request, TrialDigests& digests,
                              const GradebookRequest& wanted, const std::filesystem::path& file);

}  // namespace torsio
