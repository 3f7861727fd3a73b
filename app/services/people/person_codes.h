// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

namespace torsio {

/// Prefixes of pseudonyms.
inline constexpr const char* kTraineePrefix = "T";
inline constexpr const char* kRaterPrefix = "R";

/// Gives out pseudonyms "T-01", "T-02" ... above every number that was ever used with the prefix: a code is
/// never given twice.
class PersonCodes {
 public:
  explicit PersonCodes(std::set<std::string> used) : used_(std::move(used)) {}
  [[nodiscard]] std::string next(const std::string& prefix);

 private:
  std::set<std::string> used_;
};

}  // namespace torsio
