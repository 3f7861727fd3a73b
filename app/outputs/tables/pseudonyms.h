// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "assessment/results/cohort_report.h"

namespace torsio {

/// Names for people outside the centre, from a key: the same person has the same name under the same key, and
/// without the key nobody can tell which.
class Pseudonyms {
 public:
  /// `key`: at least 32 bytes nobody can guess; a new one for each set of files that shall not be joined.
  /// Throws Error{kBadParameter} for a shorter one.
  explicit Pseudonyms(std::string key);
  /// A key of 244 bits from the random numbers of the system.
  [[nodiscard]] static std::string freshKey();

  /// "P-" or another `kind`, and ten hexadecimal digits.
  [[nodiscard]] std::string of(std::string_view kind, std::string_view code) const;
  /// Whole days within half a year to either side, never none, by which every time of a person is moved:
  /// intervals stay.
  [[nodiscard]] std::int64_t shift_us(std::string_view code) const;

 private:
  std::string key_;
};

/// What was done so that nobody is found.
struct PseudonymReport {
  std::int64_t people = 0;
  std::int64_t smallestBefore = 0;  ///< people who share group, sex and level with the rarest of them
  std::int64_t smallestAfter = 0;   ///< the same, of what is written: k
  std::int64_t levelsHidden = 0;    ///< people whose level of training was left out
  std::int64_t sexesHidden = 0;
  std::int64_t textsLeftOut = 0;
  std::int64_t deviationsUnlinked = 0;  ///< deviations that stand there without their person
};

/// Returns the inputs as somebody outside may have them: opaque names for trainees and raters, in the order
/// of those names; recordings by opaque names, too; times of each person moved, those of `startedUtc_us` (by
/// recording) as well; deviations of whoever has as many as fewer than kSmallestCell others without their
/// person; sex and level left out where fewer than kSmallestCell share them within their group;
/// the centre, hashes of recordings, the seed of the draw and, but for `withFreeText`, what somebody wrote
/// (names of cohort and data set, too) are left out; who froze the data has an opaque name.
/// `report`: what was done. Numbers change in their last digits at most, because sums run in another order.
[[nodiscard]] CohortInputs pseudonymised(CohortInputs inputs, std::map<TrialId, std::int64_t>& startedUtc_us,
                                         const Pseudonyms& names, bool withFreeText, PseudonymReport& report);

}  // namespace torsio
