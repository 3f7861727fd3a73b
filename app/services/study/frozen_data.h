// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "sim/core/text.h"

namespace torsio {

/// What a named data set holds, counted.
struct FrozenCounts {
  std::size_t enrolments = 0;
  std::size_t allocations = 0;
  std::size_t exposures = 0;
  std::size_t deviations = 0;
  std::size_t marks = 0;
  std::size_t trials = 0;
  std::size_t campaigns = 0;
  std::size_t evaluationMarks = 0;
};

/// A named state of a cohort's data: which rows, with their hashes.
struct FrozenRow {
  FreezeId id{};
  CohortId cohortId{};
  std::string name{};
  std::string contentHash{};
  FrozenCounts counts{};
  std::int64_t createdUtc_us = 0;
  std::string createdBy{};  ///< sign-in name
};

/// Stores the manifest of everything that a report of the cohort (and of `campaignIds`) is made of, under a
/// name. Nothing is copied or locked: the hash says later whether it is still the same. Audited.
/// kResultsCompute. Throws Error{kBadParameter} for an empty or used name, an unknown cohort or campaign.
FrozenRow freezeData(SessionContext& session, const CohortId& cohortId, const std::string& name,
                     const std::vector<CampaignId>& campaignIds = {});
/// Oldest first. kResultsCompute.
[[nodiscard]] std::vector<FrozenRow> frozenData(SessionContext& session, const CohortId& cohortId);

struct FrozenCheck {
  bool same = true;
  std::vector<Text> differences{};  ///< "mark 4f... was added", in words, at most twenty
};
/// Compares a frozen state with what is there now. kResultsCompute. Throws Error{kBadParameter} when there is
/// none.
[[nodiscard]] FrozenCheck compareWithFrozen(SessionContext& session, const FreezeId& frozenId);

}  // namespace torsio
