// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "assessment/domain/ids.h"

namespace torsio {

/// The allocation design of a cohort, fixed before the first allocation.
struct LockedDesign {
  DesignId id{};
  CohortId cohortId{};
  std::string algorithm{};  ///< "complete", "permuted blocks", "minimisation" ...
  std::string algorithmVersion{};
  std::string parametersJson{};
  std::string generator{};       ///< "mt19937_64"
  std::string seedCommitment{};  ///< published before the first allocation
  std::string seed{};            ///< in a table of its own; empty until revealed
  std::string salt{};            ///< of the commitment; sealed and revealed with the seed
  std::int64_t lockedUtc_us = 0;
  bool demonstration = false;
};

/// One person allocated to one group. Append-only and hash-chained: a correction or override is a new record.
struct AllocationEntry {
  AllocationId id{};
  DesignId designId{};
  std::int64_t sequence = 0;  ///< 1, 2, 3 ... within the design
  EnrolmentId enrolmentId{};
  GroupId groupId{};
  std::int64_t numberInGroup = 0;
  std::string covariatesJson = "{}";    ///< stratum as used
  std::string countsBeforeJson = "{}";  ///< people in each group before
  std::string scoresJson = "{}";        ///< minimisation: score of each group
  std::int64_t drawBefore = 0;          ///< numbers drawn from the generator so far
  std::int64_t drawAfter = 0;
  std::string enrolledBy{};
  std::string allocatedBy{};
  std::string softwareVersion{};
  std::string overrideReason{};  ///< empty: as drawn
  std::int64_t allocatedUtc_us = 0;
  bool demonstration = false;
  std::string previousHash{};  ///< filled by allocate(); empty in the first record of a design
  std::string recordHash{};    ///< filled by allocate()
};

}  // namespace torsio
