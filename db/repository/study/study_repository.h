// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/study/protocol_terms.h"
#include "db/connection/connection.h"

namespace torsio {

/// The centre that owns this record; one row.
struct StoredCentre {
  std::string id{};
  std::string name{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

struct StoredCohort {
  std::string id{};
  std::string name{};  ///< unique
  std::string description{};
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
  std::string curriculumVersionId{};  ///< filled when read; empty: follows none yet
};

/// An arm of the study (paper section 6: 40 min virtual; 20 + 20 min; 40 min real).
struct StoredGroup {
  std::string id{};
  std::string cohortId{};
  std::int64_t number = 0;  ///< 1, 2, 3
  std::string code{};       ///< "G1"
  std::string label{};      ///< "40 min virtual"
  std::string armId{};      ///< filled when read: what it goes through; empty: no curriculum yet
};

struct StoredEnrolment {
  std::string id{};
  std::string cohortId{};
  std::string traineeId{};
  std::string groupId{};           ///< empty before allocation
  std::int64_t numberInGroup = 0;  ///< 1 ..; 0 before allocation
  EnrolmentState state = EnrolmentState::kEnrolled;
  std::int64_t enrolledUtc_us = 0;
  bool demonstration = false;
  std::string traineeCode{};  ///< filled when read
  std::string groupCode{};    ///< filled when read; empty before allocation
};

/// How a cohort is divided, fixed before the first allocation.
struct StoredAllocationDesign {
  std::string id{};
  std::string cohortId{};
  std::string algorithm{};  ///< "complete", "permuted blocks", "minimisation" ...
  std::string algorithmVersion{};
  std::string parametersJson{};
  std::string generator{};       ///< "mt19937_64"
  std::string seedCommitment{};  ///< hash of the seed, published beforehand
  std::string seed{};            ///< kept in a table of its own; empty when read before it was revealed
  std::int64_t lockedUtc_us = 0;
  bool demonstration = false;
};

/// One person put into one group. Append-only and hash-chained: a mistake or an override is a new record.
struct StoredAllocation {
  std::string id{};
  std::string designId{};
  std::int64_t sequence = 0;  ///< 1, 2, 3 ... within the design
  std::string enrolmentId{};
  std::string groupId{};
  std::int64_t numberInGroup = 0;
  std::string covariatesJson = "{}";    ///< stratum as used
  std::string countsBeforeJson = "{}";  ///< people in each group before
  std::string scoresJson = "{}";        ///< minimisation: score of each group
  std::int64_t drawBefore = 0;          ///< draws of the generator so far
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

/// Time that was spent training or resting. Append-only.
struct StoredExposure {
  std::string id{};
  std::string enrolmentId{};
  std::string phaseId{};  ///< empty: outside any phase
  std::string kind{};     ///< "virtual", "real", "rest"
  std::int64_t startedUtc_us = 0;
  std::int64_t duration_us = 0;
  std::string recordedBy{};
  bool demonstration = false;
};

/// Something that did not go by the protocol. Append-only.
struct StoredDeviation {
  std::string id{};
  std::string cohortId{};
  std::string enrolmentId{};  ///< empty: the whole cohort
  std::string kind{};         ///< "device failed", "late", "swapped" ...
  std::string description{};
  std::int64_t happenedUtc_us = 0;
  std::string reportedBy{};
  std::int64_t reportedUtc_us = 0;
  bool demonstration = false;
};

/// A trial of a cohort that has no closing row: it is running, or was interrupted and not closed yet.
struct RunningTrial {
  std::string trialId{};
  std::string enrolmentId{};
  std::string station{};
  std::string phaseLabel{};
  std::int64_t startedUtc_us = 0;
};

/// Cohorts, groups, enrolments and the record of how people were allocated. One call, one transaction.
class StudyRepository {
 public:
  explicit StudyRepository(Connection& connection) : connection_(connection) {}

  void setCentre(const StoredCentre& centre);
  [[nodiscard]] std::optional<StoredCentre> centre() const;

  void addCohort(const StoredCohort& cohort, std::span<const StoredGroup> groups);
  [[nodiscard]] std::vector<StoredCohort> cohorts() const;
  /// Throws Error{kBadData} when there is no such cohort.
  [[nodiscard]] StoredCohort cohort(const std::string& cohortId) const;
  [[nodiscard]] std::vector<StoredGroup> groups(const std::string& cohortId) const;

  void enrol(std::span<const StoredEnrolment> enrolments);
  /// Ordered by group, number in the group, trainee code; those without a group come first.
  [[nodiscard]] std::vector<StoredEnrolment> enrolments(const std::string& cohortId) const;

  /// Moves an enrolment on. Throws DbError.
  void setEnrolmentState(const std::string& enrolmentId, EnrolmentState state);

  void lockDesign(const StoredAllocationDesign& design);
  void revealSeed(const std::string& designId, std::int64_t utc_us);
  /// The seed whether it was revealed or not: for drawing the next arm and for nothing else.
  [[nodiscard]] std::string sealedSeed(const std::string& designId) const;
  [[nodiscard]] std::vector<StoredAllocationDesign> designs(const std::string& cohortId) const;

  /// Appends the records, chains their hashes, and moves the enrolments. Returns them as stored. Throws Error
  /// (kBadData) when a sequence number does not follow the last one.
  std::vector<StoredAllocation> allocate(std::span<const StoredAllocation> records);
  [[nodiscard]] std::vector<StoredAllocation> allocations(const std::string& designId) const;
  /// The sequence number of the first record whose hash does not fit; empty: the chain is whole.
  [[nodiscard]] std::optional<std::int64_t> firstBrokenAllocation(const std::string& designId) const;

  void addExposures(std::span<const StoredExposure> exposures);
  /// Of one cohort, by enrolment and time.
  [[nodiscard]] std::vector<StoredExposure> exposures(const std::string& cohortId) const;

  /// Trials of all enrolments, ended or not, by their start.
  [[nodiscard]] std::vector<std::string> trialIds(const std::string& cohortId) const;
  /// Newest first.
  [[nodiscard]] std::vector<RunningTrial> runningTrials(const std::string& cohortId) const;

  void addDeviation(const StoredDeviation& deviation);
  /// Oldest first.
  [[nodiscard]] std::vector<StoredDeviation> deviations(const std::string& cohortId) const;

 private:
  Connection& connection_;
};

/// BLAKE2b-256 over the previous hash and every field but the two hashes.
[[nodiscard]] std::string allocationHash(const StoredAllocation& record);

}  // namespace torsio
