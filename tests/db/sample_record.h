// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/schema_tables.h"
#include "sim/record/trial.h"
#include "tests/db/test_database.h"

namespace torsio {

inline constexpr std::int64_t kSampleTime_us = 1'763'712'000'000'000;  // 2025-11-21 08:00 UTC

/// A small centre: three rater classes, `trainees` trainees and two chiefs, one cohort of two groups with all
/// trainees enrolled. Ids from a fixed seed.
struct SampleRecord {
  SampleRecord(Connection& connection, int traineeCount);

  SeededIdSource ids{20251121};
  std::vector<Trainee> trainees;
  std::vector<Rater> chiefs;
  Cohort cohort;
  std::vector<StudyGroup> groups;
  std::vector<Enrolment> enrolments;
};

/// A test of a centre with one trainee.
class SampleTest : public DatabaseTest {
 protected:
  /// Made at the first call.
  SampleRecord& sample() { return sample_ ? *sample_ : sample_.emplace(connection(), 1); }

 private:
  std::optional<SampleRecord> sample_;
};

/// A header in which every field differs from its default.
[[nodiscard]] TrialHeader sampleHeader(const TrialId& trialId, const std::string& traineeCode);
/// Chunk `index` with `samples` samples and `size` bytes that depend on the index.
[[nodiscard]] TrialChunk sampleChunk(std::int64_t index, std::size_t size = 15000);
/// A complete trial of one small chunk, with its digests.
[[nodiscard]] Trial sampleTrial();

/// Fills every table of the schema with at least one row: people, trials and marks as the program makes them,
/// so that the audit trail verifies; the rest with generated values that satisfy the column rules. Real rows
/// once, simulated rows once; names and codes begin with `prefix`. New tables are filled automatically; a
/// column with a rule of its own needs an entry below.
struct FullRecord {
  FullRecord(Connection& connection, const std::string& prefix, bool demonstration);

  TraineeId traineeId;
  RaterId raterId;
  TrialId trialId;
};

/// Prints a digest in failure messages.
void PrintTo(const TableDigest& digest, std::ostream* out);

inline constexpr int kManyTrainees = 10'000;
inline constexpr int kManyMarks = 100'000;

/// Fills a record as large as any centre's: 200 cohorts of 50 trainees, each marked by both chiefs of
/// `sample` in five versions. Returns the id of the last cohort.
std::string fillLargeRecord(Connection& connection, SampleRecord& sample);

}  // namespace torsio
