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
#include "sim/core/text.h"

namespace torsio {

/// Settings for allocating a cohort.
struct AllocationPlan {
  CohortId cohortId{};
  AllocationMethod method = AllocationMethod::kCompletePermutation;
  std::vector<std::string> factors{};     ///< stored BalanceFactors: strata, or margins of minimisation
  std::vector<std::size_t> blockSizes{};  ///< multiples of the number of groups
  std::int64_t bestArm_tenths = 8;        ///< minimisation only
  Imbalance imbalance = Imbalance::kRange;
  /// Everybody is enrolled already: the last blocks of all strata are combined so that the groups have equal
  /// sizes.
  bool everybodyEnrolled = true;
  std::optional<std::uint64_t> seed{};  ///< empty (normally): from the machine's random numbers
};

/// Expected balance of the groups, simulated with throw-away seeds: the real one is drawn later, so that
/// nobody can choose among outcomes.
struct BalancePreview {
  std::vector<std::string> groups{};  ///< codes
  struct Level {
    std::string factor{};
    std::string level{};
    std::size_t people = 0;
    std::vector<double> expected{};   ///< mean number of people per group
    std::size_t worstDifference = 0;  ///< largest minus smallest group, worst simulation
    double meanDifference = 0.0;
  };
  std::vector<Level> levels{};  ///< every level of every factor, whether in the plan or not
  std::size_t people = 0;
  std::size_t worstSizeDifference = 0;
  std::size_t tries = 0;
  std::vector<std::string> missing{};  ///< codes of people with unrecorded factors
};
/// kAllocationRun. Throws Error{kBadParameter} for a plan that is invalid for its method.
[[nodiscard]] BalancePreview previewBalance(SessionContext& session, const AllocationPlan& plan);

/// A locked design as seen by the administrator.
struct AllocationDesignRow {
  LockedDesign stored{};  ///< seed empty until revealed
  AllocationDesign design{};
  std::size_t records = 0;
  std::size_t overrides = 0;
};

/// Locks the design, draws and seals the seed. Returns the design with its commitment, which may be
/// published. Replaces an earlier design for people not yet allocated; after the first allocation, only with
/// a reason. Audited. kAllocationRun.
AllocationDesignRow lockAllocation(SessionContext& session, const AllocationPlan& plan,
                                   const std::string& supersedeReason = {});
/// Oldest first; the last one is in use. kAllocationView.
[[nodiscard]] std::vector<AllocationDesignRow> allocationDesigns(SessionContext& session,
                                                                 const CohortId& cohortId);
/// Content of one envelope.
struct SealedCard {
  std::int64_t sequence = 0;
  std::string traineeCode{};
  std::string groupCode{};
  std::string groupLabel{};
};
/// Returns the cards of the latest design in order of the draw, for printing. Audited. kAllocationRun. Throws
/// Error{kBadData} if nobody is allocated yet.
[[nodiscard]] std::vector<SealedCard> takeOutCards(SessionContext& session, const CohortId& cohortId);

/// Returns the allocations in order, including overrides. kAllocationView.
[[nodiscard]] std::vector<AllocationEntry> allocations(SessionContext& session, const DesignId& designId);

/// Allocates everybody who is enrolled without a group, by code; all or nothing. Returns how many.
/// kAllocationRun.
std::size_t allocateAll(SessionContext& session, const CohortId& cohortId);
/// Moves a person to another group, as a new record with its reason in addition to the drawn one. Audited.
/// kAllocationRun.
AllocationEntry overrideAllocation(SessionContext& session, const CohortId& cohortId,
                                   const EnrolmentId& enrolmentId, const GroupId& groupId,
                                   const std::string& reason);
/// Reveals the seed, so that anybody can replay the allocation. Returns it. Audited. kAllocationReveal.
/// Refused while an enrolled person has no group, unless a reason is given.
std::string revealSeed(SessionContext& session, const DesignId& designId, const std::string& reason = {});

/// Replays the whole allocation from the seed and compares commitment, chain and every record.
/// kAllocationView.
[[nodiscard]] AllocationCheck checkAllocation(SessionContext& session, const DesignId& designId);

}  // namespace torsio
