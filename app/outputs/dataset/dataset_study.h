// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/outputs/dataset/cohort_exchange.h"
#include "app/services/study/landed_study.h"

namespace torsio {

class Connection;

/// Where a data set keeps what its tables do not say.
inline constexpr const char* kDatasetStudyFile = "study.json";

/// What of a cohort the tables of a data set do not say and another record needs (study.json, format "torsio
/// study 1"): groups, people, raters with their classes, occasions, marks as far as they may be shown, times
/// of training, deviations, and for what each recording counted. Under codes; throws ContractError for
/// pseudonymised data.
[[nodiscard]] std::string datasetStudyJson(Connection& connection, const ExchangeData& data);

/// The study of a data set folder with its recordings, ready to be landed. Throws Error: kFileMissing,
/// kFileUnreadable; kBadData for a file that breaks its rules, a recording that was changed.
[[nodiscard]] LandedStudy readDatasetStudy(const std::filesystem::path& folder);

}  // namespace torsio
