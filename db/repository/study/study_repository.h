// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/allocation.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/protocol_terms.h"
#include "assessment/domain/study/study_statement.h"
#include "db/connection/connection.h"

namespace torsio {

/// Cohorts, groups, enrolments and allocation records. Each call is one transaction.
class StudyRepository {
 public:
  explicit StudyRepository(Connection& connection) : connection_(connection) {}

  void setCentre(const Centre& centre);
  [[nodiscard]] std::optional<Centre> centre() const;

  void addCohort(const Cohort& cohort, std::span<const StudyGroup> groups);
  [[nodiscard]] std::vector<Cohort> cohorts() const;
  /// Throws Error{kBadData} if the cohort does not exist.
  [[nodiscard]] Cohort cohort(const CohortId& cohortId) const;
  void renameCohort(const CohortId& cohortId, const std::string& name);
  /// `state`: not kDraft, which is only implied before the first allocation.
  void setCohortState(const CohortId& cohortId, CohortState state, const std::string& reason,
                      const std::string& changedBy, std::int64_t utc_us);
  /// Appends a version of a statement.
  void addStatement(const StudyStatement& statement);
  [[nodiscard]] StudyStatements statements(const CohortId& cohortId) const;
  void addImport(const StudyImport& import);
  /// Oldest first.
  [[nodiscard]] std::vector<StudyImport> imports(const CohortId& cohortId) const;
  /// Counts the recordings that came with an import.
  [[nodiscard]] std::int64_t importedTrials(const CohortId& cohortId) const;
  [[nodiscard]] std::vector<StudyGroup> groups(const CohortId& cohortId) const;

  void enrol(std::span<const Enrolment> enrolments);
  /// Ordered by group, number in the group, trainee code; unallocated ones come first.
  [[nodiscard]] std::vector<Enrolment> enrolments(const CohortId& cohortId) const;

  /// Changes the state of an enrolment. Throws DbError.
  void setEnrolmentState(const EnrolmentId& enrolmentId, EnrolmentState state);

  void lockDesign(const LockedDesign& design);
  void revealSeed(const DesignId& designId, std::int64_t utc_us);
  /// Returns the seed, revealed or not: only for drawing the next arm.
  [[nodiscard]] std::string sealedSeed(const DesignId& designId) const;
  /// Returns the salt of the commitment, revealed or not: only for checking it.
  [[nodiscard]] std::string sealedSalt(const DesignId& designId) const;
  [[nodiscard]] std::vector<LockedDesign> designs(const CohortId& cohortId) const;

  /// Appends records, chains their hashes, and updates the enrolments. Returns them as stored. Throws Error
  /// (kBadData) if sequence numbers are not consecutive.
  std::vector<AllocationEntry> allocate(std::span<const AllocationEntry> records);
  [[nodiscard]] std::vector<AllocationEntry> allocations(const DesignId& designId) const;
  /// Returns the sequence number of the first record with a wrong hash; empty: the chain is intact.
  [[nodiscard]] std::optional<std::int64_t> firstBrokenAllocation(const DesignId& designId) const;

  void addExposures(std::span<const Exposure> exposures);
  /// Exposures of a cohort, by enrolment and time.
  [[nodiscard]] std::vector<Exposure> exposures(const CohortId& cohortId) const;
  [[nodiscard]] std::vector<Exposure> exposuresOf(const EnrolmentId& enrolmentId) const;

  /// Trials of all enrolments, ended or not, by start.
  [[nodiscard]] std::vector<TrialId> trialIds(const CohortId& cohortId) const;
  /// Running trials of a cohort, newest first.
  [[nodiscard]] std::vector<RunningTrial> runningTrials(const CohortId& cohortId) const;

  /// Cohorts with a slot that overlaps [from, to), or a recording started then that has not ended.
  [[nodiscard]] std::vector<CohortId> cohortsAtWork(std::int64_t fromUtc_us, std::int64_t toUtc_us) const;

  void addDeviation(const ProtocolDeviation& deviation);
  /// Deviations of a cohort, oldest first.
  [[nodiscard]] std::vector<ProtocolDeviation> deviations(const CohortId& cohortId) const;

 private:
  Connection& connection_;
};

/// BLAKE2b-256 of the previous hash and every field except the two hashes.
[[nodiscard]] std::string allocationHash(const AllocationEntry& record);

}  // namespace torsio
