// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/access/first_run.h"
#include "app/services/base/progress.h"
#include "assessment/domain/ids.h"
#include "assessment/scoring/demonstration_marks.h"

namespace torsio {

class Connection;
class IdSource;
struct CurriculumVersion;

/// One simulated trainee of the demonstration.
struct DemonstrationTrainee {
  std::string code;  ///< "T-07"
  EnrolmentId enrolmentId;
  std::size_t group = 0;   ///< 0, 1, 2
  std::size_t number = 0;  ///< 1..10 within the group
};

/// People and study of the paper's section 6, as stored.
struct DemonstrationStudy {
  CohortId cohortId;
  CampaignId campaignId;
  std::vector<std::string> groupLabels;        ///< "40 min virtual" ...
  std::vector<DemonstrationTrainee> trainees;  ///< sorted by group, then number
  DemonstrationPeople people;                  ///< codes, for the rule that simulates marks
  std::string seedCommitment;
  std::int64_t allocationSeed = 0;
};

/// Stores 30 trainees in three groups by seeded allocation, ten chief physicians who mark them, 20/10/10
/// raters of three tissue models and the campaign. Every row has the demonstration flag.
[[nodiscard]] DemonstrationStudy storeDemonstrationPeople(Connection& connection, IdSource& ids,
                                                          std::uint64_t seed, std::int64_t utc_us);

/// Simulates and submits all marks by the stated rules: 900 training marks, each for its request (live, on
/// the real arm, when the trainee was called), and 1,080 evaluation marks.
void submitDemonstrationMarks(Connection& connection, const DemonstrationStudy& study,
                              const CurriculumVersion& curriculum, IdSource& ids, std::uint64_t seed,
                              std::int64_t utc_us);

/// Stores the demonstration cohort with content for a trainee and a physician, and creates an account for
/// each of the two. `assets`: folder with the organs. Runs in the caller's transaction; throws what
/// `progress` and the repositories throw.
std::vector<StartAccount> addDemonstration(SessionContext& session, const std::filesystem::path& assets,
                                           const ProgressCallback& progress);

}  // namespace torsio
