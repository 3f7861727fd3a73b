// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/allocation_entry.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/protocol_terms.h"
#include "db/connection/connection.h"

namespace torsio {

/// Cohorts, groups, enrolments and the record of how people were allocated. One call, one transaction.
class StudyRepository {
 public:
  explicit StudyRepository(Connection& connection) : connection_(connection) {}

  void setCentre(const Centre& centre);
  [[nodiscard]] std::optional<Centre> centre() const;

  void addCohort(const Cohort& cohort, std::span<const StudyGroup> groups);
  [[nodiscard]] std::vector<Cohort> cohorts() const;
  /// Throws Error{kBadData} when there is no such cohort.
  [[nodiscard]] Cohort cohort(const CohortId& cohortId) const;
  void renameCohort(const CohortId& cohortId, const std::string& name);
  /// `state`: not kDraft, which a cohort is only until its people are allocated.
  void setCohortState(const CohortId& cohortId, CohortState state, const std::string& reason,
                      const std::string& changedBy, std::int64_t utc_us);
  [[nodiscard]] std::vector<StudyGroup> groups(const CohortId& cohortId) const;

  void enrol(std::span<const Enrolment> enrolments);
  /// Ordered by group, number in the group, trainee code; those without a group come first.
  [[nodiscard]] std::vector<Enrolment> enrolments(const CohortId& cohortId) const;

  /// Moves an enrolment on. Throws DbError.
  void setEnrolmentState(const EnrolmentId& enrolmentId, EnrolmentState state);

  void lockDesign(const LockedDesign& design);
  void revealSeed(const DesignId& designId, std::int64_t utc_us);
  /// The seed whether it was revealed or not: for drawing the next arm and for nothing else.
  [[nodiscard]] std::string sealedSeed(const DesignId& designId) const;
  /// The salt of the commitment, revealed or not: for checking it.
  [[nodiscard]] std::string sealedSalt(const DesignId& designId) const;
  [[nodiscard]] std::vector<LockedDesign> designs(const CohortId& cohortId) const;

  /// Appends the records, chains their hashes, and moves the enrolments. Returns them as stored. Throws Error
  /// (kBadData) when a sequence number does not follow the last one.
  std::vector<AllocationEntry> allocate(std::span<const AllocationEntry> records);
  [[nodiscard]] std::vector<AllocationEntry> allocations(const DesignId& designId) const;
  /// The sequence number of the first record whose hash does not fit; empty: the chain is whole.
  [[nodiscard]] std::optional<std::int64_t> firstBrokenAllocation(const DesignId& designId) const;

  void addExposures(std::span<const Exposure> exposures);
  /// Of one cohort, by enrolment and time.
  [[nodiscard]] std::vector<Exposure> exposures(const CohortId& cohortId) const;

  /// Trials of all enrolments, ended or not, by their start.
  [[nodiscard]] std::vector<TrialId> trialIds(const CohortId& cohortId) const;
  /// Newest first.
  [[nodiscard]] std::vector<RunningTrial> runningTrials(const CohortId& cohortId) const;

  /// Cohorts in which a slot touches [from, to), or a recording that began then has not ended.
  [[nodiscard]] std::vector<CohortId> cohortsAtWork(std::int64_t fromUtc_us, std::int64_t toUtc_us) const;

  void addDeviation(const ProtocolDeviation& deviation);
  /// Oldest first.
  [[nodiscard]] std::vector<ProtocolDeviation> deviations(const CohortId& cohortId) const;

 private:
  Connection& connection_;
};

/// BLAKE2b-256 over the previous hash and every field but the two hashes.
[[nodiscard]] std::string allocationHash(const AllocationEntry& record);

}  // namespace torsio
