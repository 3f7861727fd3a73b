// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/outputs/tables/export_table.h"
#include "app/services/base/progress.h"
#include "sim/record/trial.h"

namespace torsio {

enum class DatasetLayout {
  kFrictionless,  ///< Frictionless data package, version 1: datapackage.json beside the tables
  kRoCrate,       ///< the same, and ro-crate-metadata.json of RO-Crate 1.1
  kBids,          ///< BIDS 1.9 with Motion-BIDS recordings; the data package lies in derivatives/torsio
};

/// "frictionless", "ro-crate". Throws Error{kUsage} for another word.
[[nodiscard]] DatasetLayout datasetLayout(const std::string& word);

/// What a publisher of data has to say about them.
struct DatasetAbout {
  std::string title;
  std::string description{};
  std::string licence{};   ///< SPDX identifier, "CC-BY-4.0"
  std::string citation{};  ///< how users cite it; empty: they are not asked to
  std::string creator{};   ///< person or centre that publishes; empty: not named
  std::int64_t madeUtc_us = 0;
};

/// Throws Error{kBadParameter} for a title or licence that is missing, a licence that is no SPDX identifier.
void requireWhole(const DatasetAbout& about);

/// A recording as it leaves: under which names, and how it is read. `load` is called once, by the writer.
struct DatasetRecording {
  std::string name;  ///< of a file: letters, digits, '-' and '_'
  std::string trainee;
  std::function<Trial()> load;
};

/// What a data set consists of besides its tables.
struct DatasetContents {
  DatasetAbout about;
  std::vector<const ExportTable*> tables;
  std::vector<DatasetRecording> recordings;
  std::int64_t every = 10;       ///< one line of a trajectory for so many samples of a recording
  std::string curriculumJson{};  ///< empty: the cohort follows none
  std::string softwareVersion;
  ProgressCallback progress{};  ///< told before each recording; may throw to give up
  std::string studyJson{};      ///< dataset_study.h; not empty: recordings are written as they are, too
};

/// Tells that a recording is written now.
inline void tellRecording(const DatasetContents& contents, std::size_t number) {
  tellProgress(contents.progress,
               Text::tr("Writing recording %1 of %2", number + 1, contents.recordings.size()),
               static_cast<double>(number) / static_cast<double>(contents.recordings.size()));
}

/// Writes into `folder`, which must be missing or empty: data/*.csv (the tables, and `recordings`: organ,
/// pattern, hashes, device, rate of each), trajectories/*.csv, parameters/*.json (models of tissue),
/// metrics.json (definition cards), curriculum.json, README.md and the descriptor of `layout`; with a study
/// also study.json and recordings/*.torsio, from which importDataset() makes it again. Returns the
/// files in their order. Throws Error{kFileUnwritable}, {kBadParameter} (requireWhole); what was written
/// before an error is taken away again.
std::vector<std::filesystem::path> writeDataset(const DatasetContents& contents, DatasetLayout layout,
                                                const std::filesystem::path& folder);

}  // namespace torsio
