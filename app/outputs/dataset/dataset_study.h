// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/outputs/dataset/cohort_exchange.h"
#include "app/services/study/landed_study.h"

namespace torsio {

class Connection;

/// File with the data that the tables lack.
inline constexpr const char* kDatasetStudyFile = "study.json";

/// Signature of that file by the station that wrote it, if it has a key.
inline constexpr const char* kDatasetSealFile = "study.seal.json";
/// Returns that signature, as JSON; empty without a key. Throws Error if the key cannot be used.
[[nodiscard]] std::string datasetSeal(const std::string& studyJson);

/// Returns what another record needs of a cohort beyond the data set's tables (study.json, format "torsio
/// study 1"): groups, people, raters with their classes, occasions, marks as far as they may be shown,
/// training times, deviations, what each recording counted for, its hash, what the study says about itself,
/// and where it was imported from. Under codes; throws ContractError for pseudonymised data.
[[nodiscard]] std::string datasetStudyJson(Connection& connection, const ExchangeData& data);

/// Reads the study and recordings of a data set folder for import. Throws Error: kFileMissing,
/// kFileUnreadable; kBadData for an invalid file, a recording that was changed, or a signature that
/// does not fit.
[[nodiscard]] LandedStudy readDatasetStudy(const std::filesystem::path& folder);

}  // namespace torsio
