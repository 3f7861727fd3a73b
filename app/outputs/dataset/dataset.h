// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/outputs/tables/export_table.h"
#include "app/services/base/progress.h"
#include "sim/record/trial.h"

namespace torsio {

enum class DatasetLayout {
  kFrictionless,  ///< Frictionless data package, version 1: datapackage.json next to the tables
  kRoCrate,       ///< the same plus ro-crate-metadata.json of RO-Crate 1.1
  kParquet,       ///< the data package with Parquet files in place of CSV
  kBids,          ///< BIDS 1.9 with Motion-BIDS recordings; the data package is in derivatives/torsio
  kLerobot,       ///< LeRobot 3.0: frames of all recordings in Parquet; the data package is in torsio/
};

/// Parses "frictionless", "ro-crate", "parquet", "bids" or "lerobot". Throws Error{kUsage} for another word.
[[nodiscard]] DatasetLayout datasetLayout(const std::string& word);

/// Description of a data set by its publisher.
struct DatasetAbout {
  std::string title;
  std::string description{};
  std::string licence{};   ///< SPDX identifier such as "CC-BY-4.0"
  std::string citation{};  ///< how to cite it; empty: no request
  std::string creator{};   ///< publishing person or centre; empty: not named
  std::int64_t madeUtc_us = 0;
};

/// Throws Error{kBadParameter} for a missing title or licence, or a licence that is not an SPDX identifier.
void requireWhole(const DatasetAbout& about);

/// A recording to export: its names and how to read it. The writer calls `load` once.
struct DatasetRecording {
  std::string name;  ///< of the file: letters, digits, '-' and '_'
  std::string trainee;
  std::function<Trial()> load;
};

/// Contents of a data set besides its tables.
struct DatasetContents {
  DatasetAbout about;
  std::vector<const ExportTable*> tables;
  std::vector<DatasetRecording> recordings;
  std::int64_t every = 10;       ///< samples per trajectory row
  std::string curriculumJson{};  ///< empty: the cohort has none
  std::string softwareVersion;
  std::vector<std::pair<std::string, std::string>> participants{};  ///< every trainee with the group's name
  std::vector<std::string> origin{};  ///< sentences: simulated, imported from where
  ProgressCallback progress{};        ///< called before each recording; may throw to cancel
  std::string studyJson{};            ///< dataset_study.h; if not empty, complete recordings are written too
  std::string studySeal{};            ///< signature of it; empty: none
};

/// Reports that a recording is about to be written.
inline void tellRecording(const DatasetContents& contents, std::size_t number) {
  tellProgress(contents.progress,
               Text::tr("Writing recording %1 of %2", number + 1, contents.recordings.size()),
               static_cast<double>(number) / static_cast<double>(contents.recordings.size()));
}

/// Writes into `folder`, which must be missing or empty: data/*.csv or .parquet (the tables, and
/// `recordings`: organ, pattern, hashes, device and rate of each), trajectories in the same format,
/// parameters/*.json (tissue models), metrics.json (definition cards), curriculum.json, README.md and the
/// descriptor of `layout`; with a study also study.json and recordings/*.torsio for importDataset(). Returns
/// the files in order. Throws Error{kFileUnwritable}, {kBadParameter} (requireWhole()); removes what it wrote
/// if it fails.
std::vector<std::filesystem::path> writeDataset(const DatasetContents& contents, DatasetLayout layout,
                                                const std::filesystem::path& folder);

}  // namespace torsio
