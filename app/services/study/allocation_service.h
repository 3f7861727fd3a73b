// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/scoring/stored_allocation.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/allocation.h"
#include "assessment/domain/study/allocation_entry.h"
#include "sim/core/text.h"

namespace torsio {

/// How the allocator wants to divide a cohort.
struct AllocationPlan {
  CohortId cohortId{};
  AllocationMethod method = AllocationMethod::kCompletePermutation;
  std::vector<std::string> factors{};     ///< of allocationFactorNames(): strata, or margins of minimisation
  std::vector<std::size_t> blockSizes{};  ///< multiples of the number of groups
  std::int64_t bestArm_tenths = 8;        ///< minimisation
  Imbalance imbalance = Imbalance::kRange;
  /// Everybody is enrolled already: the strata's last blocks are joined so that the groups come out even.
  bool everybodyEnrolled = true;
  std::optional<std::uint64_t> seed{};  ///< empty (the rule): drawn from the machine's random numbers
};
/// What people can be balanced by: "sex", "level", "experience", "handedness".
[[nodiscard]] const std::vector<std::string>& allocationFactorNames();

/// How even the groups would come out, tried with throw-away seeds: the real one is drawn later, so that
/// nobody can choose among outcomes.
struct BalancePreview {
  std::vector<std::string> groups{};  ///< codes
  struct Level {
    std::string factor{};
    std::string level{};
    std::size_t people = 0;
    std::vector<double> expected{};   ///< mean number of people in each group
    std::size_t worstDifference = 0;  ///< largest minus smallest group, worst of the tries
    double meanDifference = 0.0;
  };
  std::vector<Level> levels{};  ///< every level of every factor, of the plan or not
  std::size_t people = 0;
  std::size_t worstSizeDifference = 0;
  std::size_t tries = 0;
  std::vector<std::string> missing{};  ///< codes of people whose factors are not all recorded
};
/// kAllocationRun. Throws Error{kBadParameter} for a plan that breaks the rules of its method.
[[nodiscard]] BalancePreview previewBalance(SessionContext& session, const AllocationPlan& plan);

/// A locked design as the administrator sees it.
struct AllocationDesignRow {
  LockedDesign stored{};  ///< seed empty until it was revealed
  AllocationDesign design{};
  std::size_t records = 0;
  std::size_t overrides = 0;
};

/// Fixes the design, draws and seals the seed. Returns the design with its commitment, which may be
/// published. Supersedes an earlier design for whoever is not allocated yet; once somebody is, only with a
/// reason. Audited. kAllocationRun.
AllocationDesignRow lockAllocation(SessionContext& session, const AllocationPlan& plan,
                                   const std::string& supersedeReason = {});
/// Oldest first; the last one counts. kAllocationView.
[[nodiscard]] std::vector<AllocationDesignRow> allocationDesigns(SessionContext& session,
                                                                 const CohortId& cohortId);
/// What goes into one envelope.
struct SealedCard {
  std::int64_t sequence = 0;
  std::string traineeCode{};
  std::string groupCode{};
  std::string groupLabel{};
};
/// The cards of the newest design, in the order of the draw, to be printed and put into envelopes. That they
/// were taken out is audited. kAllocationRun. Throws Error{kBadData} when nobody is allocated yet.
[[nodiscard]] std::vector<SealedCard> takeOutCards(SessionContext& session, const CohortId& cohortId);

/// Allocations in order, overrides too. kAllocationView.
[[nodiscard]] std::vector<AllocationEntry> allocations(SessionContext& session, const DesignId& designId);

/// Everybody who is enrolled and has no group, by code: all or none. Returns how many. The same.
std::size_t allocateAll(SessionContext& session, const CohortId& cohortId);
/// Moves somebody to another group, as a new record with its reason beside the drawn one. Audited.
/// kAllocationRun.
AllocationEntry overrideAllocation(SessionContext& session, const CohortId& cohortId,
                                   const EnrolmentId& enrolmentId, const GroupId& groupId,
                                   const std::string& reason);
/// Opens the seal: from now on anybody can repeat the draw. Returns the seed. Audited. kAllocationReveal.
/// Refused while an enrolled person has no group, unless a reason is given.
std::string revealSeed(SessionContext& session, const DesignId& designId, const std::string& reason = {});

/// Repeats the whole draw from the seed and compares commitment, chain and every record. kAllocationView.
[[nodiscard]] AllocationCheck checkAllocation(SessionContext& session, const DesignId& designId);

}  // namespace torsio
