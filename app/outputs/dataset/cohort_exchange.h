// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/outputs/dataset/dataset.h"
#include "app/outputs/report/report_data.h"
#include "app/outputs/tables/export_set.h"
#include "app/outputs/tables/pseudonyms.h"
#include "app/outputs/tables/table_files.h"
#include "app/outputs/tables/workbook.h"
#include "assessment/results/analysed_cohort.h"

namespace torsio {

/// What of a cohort leaves, and how its people appear in it.
struct ExchangeRequest {
  CohortId cohortId{};
  CampaignId campaignId{};     ///< empty: no evaluation of models
  FreezeId frozenId{};         ///< empty: the data as they are now
  bool pseudonymised = false;  ///< true in any case for whoever may not see names
  std::string key{};           ///< of the pseudonyms; empty: a new one, so that no two exports can be joined
  bool withFreeText = false;   ///< pseudonymised: also what somebody wrote
  std::string reason{};        ///< why, for the audit trail
};

/// Everything that a request gives, before anything is written.
struct ExchangeData {
  ExchangeRequest request;
  CohortInputs inputs;
  ExportSet set;
  std::optional<PseudonymReport> pseudonyms;  ///< empty: under the codes of the centre
  std::map<TrialId, TrialId> recordings;      ///< id in the record by the name of the recording in `inputs`
  AnalysedCohort analysed;                    ///< of `inputs`
};

/// What left the house.
struct ExchangeFiles {
  std::vector<std::filesystem::path> files;
  std::uint64_t bytes = 0;
  std::string contentHash;  ///< BLAKE2b-256 of all files in their order
};

/// Ids of what a person names; empty names: the oldest cohort, the oldest evaluation that has marks.
/// kReportExportCoded. Throws Error{kBadParameter}: there is none of that name.
void nameRequest(SessionContext& session, const std::string& cohort, const std::string& campaign,
                 ExchangeRequest& request);

/// Reads what is asked for. Nobody is named; marks and means that are not to be shown yet are left out as in
/// the report (assessment/results/shown_inputs.h). kReportExportCoded and kResultsCompute. Throws
/// Error{kBadParameter} for an unknown cohort, data set or a key that is too short.
[[nodiscard]] ExchangeData exchangeData(SessionContext& session, const ExchangeRequest& request,
                                        TrialDigests& digests, const ProgressCallback& progress = {});

/// What was done so that nobody is found, as sentences; empty for data under codes.
[[nodiscard]] std::vector<Text> pseudonymSentences(const ExchangeData& data);

/// Each writes `data` and keeps in the audit trail who took out what, why, and the hash. kReportExportCoded.
/// Throws Error{kFileUnwritable}; nothing half written is left, and nothing is noted. What `progress` throws
/// gives it up, with the same promise.
ExchangeFiles exportWorkbook(SessionContext& session, const ExchangeData& data, const ExportWording& say,
                             const std::filesystem::path& file, const ProgressCallback& progress = {});
ExchangeFiles exportTables(SessionContext& session, const ExchangeData& data, TableFormat format,
                           const std::filesystem::path& folder, const ProgressCallback& progress = {});

/// What of a cohort's data becomes a data set for others.
struct DatasetRequest {
  DatasetAbout about;
  DatasetLayout layout = DatasetLayout::kFrictionless;
  std::int64_t rate_Hz = 100;  ///< of the trajectories; divides the 1000 Hz of a recording
  bool whole = false;  ///< also what importDataset() needs; under codes, with single marks, not as BIDS
};

/// As above, of a whole data set (writeDataset) with the trajectories of the cohort's recordings. Throws
/// Error{kBadParameter} for a rate that does not divide 1000 Hz, a description that is not whole, or a whole
/// data set that is pseudonymised, of BIDS or may not hold single marks, before anything is written.
ExchangeFiles exportDataset(SessionContext& session, const ExchangeData& data, const DatasetRequest& request,
                            const std::filesystem::path& folder, const ProgressCallback& progress = {});

/// Writes the scores of a cohort as a learning system takes them (Moodle's CSV): a line a trainee, known by
/// staff or student number and mail address, or by code where the centre keeps neither; a column an occasion.
/// Whose scores are not to be shown yet is left out. Names people by what the other system knows them by:
/// kReportExportNamed. Throws Error{kFileUnwritable}, {kBadData} when nobody has a score.
ExchangeFiles exportGradebook(SessionContext& session, const ExchangeRequest& request, TrialDigests& digests,
                              const std::filesystem::path& file);

}  // namespace torsio
