// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/scoring/cohort_inputs.h"
#include "assessment/domain/ids.h"
#include "sim/core/text.h"

namespace torsio {

/// Numbers of rows in a frozen data set.
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

/// A named state of a cohort's data: its rows with their hashes.
struct FrozenRow {
  FreezeId id{};
  CohortId cohortId{};
  std::string name{};
  std::string contentHash{};
  FrozenCounts counts{};
  std::int64_t createdUtc_us = 0;
  std::string createdBy{};  ///< sign-in name
  SheetCount sheets{};      ///< when it was frozen; of older ones not known: 0
  std::string whyIncomplete{};
  std::string askedBy{};  ///< sign-in name of the other person who asked for an interim state; empty: nobody
};

/// Counts the sheets of a cohort. kResultsCompute.
[[nodiscard]] SheetCount sheetCount(SessionContext& session, const CohortId& cohortId);

/// Returns whether freezeData() would do without another person's request, or has one. kResultsCompute.
[[nodiscard]] bool mayFreezeNow(SessionContext& session, const CohortId& cohortId);
/// Stores a named manifest of everything that a report of the cohort (and of `campaignIds`) is based on.
/// Copies and locks nothing: the hashes show later whether the data changed. Audited. kResultsCompute. Throws
/// Error{kBadParameter} for an empty or used name, an unknown cohort or campaign. If sheets are missing
/// (sheetCount()), this is an interim look at the study: Error{kBadData} if `whyIncomplete` is empty,
/// SecondPersonNeeded{kFreezeInterim, cohort} unless another person asked for it (simulated cohorts need
/// nobody).
FrozenRow freezeData(SessionContext& session, const CohortId& cohortId, const std::string& name,
                     const std::vector<CampaignId>& campaignIds = {}, const std::string& whyIncomplete = {});
/// Oldest first. kResultsCompute.
[[nodiscard]] std::vector<FrozenRow> frozenData(SessionContext& session, const CohortId& cohortId);

struct FrozenCheck {
  bool same = true;
  std::vector<Text> differences{};  ///< such as "mark 4f... was added", at most twenty
};
/// Compares a frozen state with the current data. kResultsCompute. Throws Error{kBadParameter} if it does not
/// exist.
[[nodiscard]] FrozenCheck compareWithFrozen(SessionContext& session, const FreezeId& frozenId);

}  // namespace torsio
