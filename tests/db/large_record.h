// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "db/connection/connection.h"
#include "tests/db/sample_record.h"

namespace torsio {

inline constexpr int kManyTrainees = 10'000;
inline constexpr int kManyMarks = 100'000;

/// Fills a record as large as any centre's: 200 cohorts of 50 trainees, each marked by both chiefs of
/// `sample` in five versions. Returns the id of the last cohort.
std::string fillLargeRecord(Connection& connection, SampleRecord& sample);

}  // namespace torsio
