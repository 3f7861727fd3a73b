// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

/// A trainee of a trial of several centres.
struct SiteTrainee {
  std::size_t group = 0;
  std::size_t site = 0;
  double before = 0.0;
  double after = 0.0;
  std::size_t level = 0;  ///< of a further factor: device, station
};

/// Returns the groups, sites or levels that occur, ascending.
[[nodiscard]] std::vector<std::size_t> present(const std::vector<SiteTrainee>& trainees,
                                               std::size_t SiteTrainee::*member);

/// Returns why groups cannot be compared within sites at all, if so.
[[nodiscard]] std::optional<Text> sitesNotComparable(const std::vector<SiteTrainee>& trainees);

}  // namespace torsio
