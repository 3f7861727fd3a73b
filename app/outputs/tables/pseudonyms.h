// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "assessment/results/cohort_report.h"

namespace torsio {

/// Pseudonyms derived from a key: the same person and key give the same name, which cannot be traced back
/// without the key.
class Pseudonyms {
 public:
  /// `key`: at least 32 unguessable bytes; use a new one for files that must not be linkable. Throws
  /// Error{kBadParameter} for a shorter one.
  explicit Pseudonyms(std::string key);
  /// Returns a key of 244 bits from the system's random numbers.
  [[nodiscard]] static std::string freshKey();

  /// Returns "P-" or another `kind` and ten hexadecimal digits.
  [[nodiscard]] std::string of(std::string_view kind, std::string_view code) const;
  /// Returns the shift of all times of a person: whole days up to half a year in either direction, never
  /// zero. Intervals are preserved.
  [[nodiscard]] std::int64_t shift_us(std::string_view code) const;

 private:
  std::string key_;
};

/// What pseudonymisation changed.
struct PseudonymReport {
  std::int64_t people = 0;
  std::int64_t smallestBefore = 0;  ///< size of the smallest group with equal group, sex and level
  std::int64_t smallestAfter = 0;   ///< the same after hiding: k
  std::int64_t levelsHidden = 0;    ///< people whose level of training was hidden
  std::int64_t sexesHidden = 0;
  std::int64_t textsLeftOut = 0;
  std::int64_t deviationsUnlinked = 0;  ///< deviations without their person
};

/// Returns the inputs for readers outside the centre: opaque names for trainees and raters, sorted by them;
/// opaque names for recordings; each person's times shifted, including those in `startedUtc_us` (by
/// recording). Removes the person from deviations if fewer than kSmallestCell people have the same number of
/// them; sex and level if fewer than kSmallestCell share them within their group; centre, recording hashes
/// and allocation seed; and, unless `withFreeText`, free text (including names of cohort and data set). The
/// person who froze the data gets an opaque name. `report`: what was changed. Numbers change in their last
/// digits at most, because sums run in another order.
[[nodiscard]] CohortInputs pseudonymised(CohortInputs inputs, std::map<TrialId, std::int64_t>& startedUtc_us,
                                         const Pseudonyms& names, bool withFreeText, PseudonymReport& report);

}  // namespace torsio
