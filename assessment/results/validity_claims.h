// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/results/validity_argument.h"

// The claims of the validity argument. Private to assessment/results.
namespace torsio {

/// What the ledger says about a claim.
struct ValidityEvidence {
  const Result* number = nullptr;    ///< never null
  const Result* interval = nullptr;  ///< null: none
};

/// Finds the results that a claim is about; none: nothing was collected.
using FindEvidence = std::vector<ValidityEvidence> (*)(const AnalysedCohort& analysed);

/// How the number of a claim is to be read.
enum class EvidenceKind : std::uint8_t {
  kEstimate,  ///< has an interval
  kCount,     ///< a count, or a rate of the plan
  kShare,     ///< a count, of its n
};

/// A row of the table of claims, the one home of claims, thresholds and their sources.
struct ValidityClaim {
  std::string_view id;
  Inference inference;
  EvidenceSource source;
  std::string_view claim;
  std::optional<ValidityThreshold> threshold{};
  bool byMargin = false;         ///< the cohort's margin is the threshold, if it has one
  std::string_view toCollect{};  ///< what would have to be collected
  EvidenceKind kind = EvidenceKind::kEstimate;
  bool fromMarks = true;        ///< its results are of marks, which are withheld until every sheet is in
  FindEvidence find = nullptr;  ///< null: the record has no place for it
  /// Returns a remark on the numbers, or why they decide nothing (`undecided`); null: none.
  std::string (*remark)(const AnalysedCohort& analysed, bool& undecided) = nullptr;
};

[[nodiscard]] std::span<const ValidityClaim> validityClaims() noexcept;

}  // namespace torsio
