// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/foreign/dataset_import.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "app/outputs/dataset/dataset_study.h"
#include "sim/core/digest.h"
#include "sim/core/file_io.h"

namespace torsio {

DatasetOutcome importDataset(SessionContext& session, const std::filesystem::path& folder,
                             const std::filesystem::path& assets, const std::string& reason,
                             const ProgressCallback& progress) {
  constexpr double kReadingDataset = 0.3;  // share of the total progress
  requireLanding(session);
  tellProgress(progress, Text::tr("Reading %1", folder.filename().string()), 0.0);
  LandedStudy study = readDatasetStudy(folder);
  study.assets = assets;
  DatasetOutcome outcome;
  outcome.trials = study.trials.size();
  outcome.marks = study.marks.size();
  Digest digest;
  digest.update(readFile(folder / kDatasetStudyFile));
  for (const LandedTrial& landed : study.trials) {
    digest.update(landed.trial.summary.contentHash);
  }
  outcome.contentHash = digest.hex();
  const nlohmann::ordered_json what{
      {"layout", "torsio"},           {"people", study.people.size()}, {"raters", study.raters.size()},
      {"recordings", outcome.trials}, {"marks", outcome.marks},        {"hash", outcome.contentHash}};
  outcome.landed =
      landStudy(session, std::move(study), {what.dump(), reason}, partOf(progress, kReadingDataset, 1.0));
  return outcome;
}

}  // namespace torsio
