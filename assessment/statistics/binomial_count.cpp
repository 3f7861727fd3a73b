// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/binomial_count.h"

#include <algorithm>
#include <limits>

namespace torsio {

std::optional<std::int64_t> binomialCount(std::int64_t n, std::int64_t k) {
  constexpr std::int64_t kCountLimit = std::int64_t{1} << 53;
  std::int64_t value = 1;
  for (std::int64_t i = 1; i <= std::min(k, n - k); ++i) {
    const std::int64_t factor = n - i + 1;
    if (value > std::numeric_limits<std::int64_t>::max() / factor) {
      return std::nullopt;
    }
    value = value * factor / i;
    if (value > kCountLimit) {
      return std::nullopt;
    }
  }
  return value;
}

}  // namespace torsio
