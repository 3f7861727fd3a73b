// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace torsio {

/// Minimum and maximum over any range of a long series in logarithmic time, for redrawing a trace of 40
/// minutes (2.4 million samples) while scrubbing. Immutable; any thread.
class RangePyramid {
 public:
  struct Range {
    float low = 0.0F;
    float high = 0.0F;
  };

  RangePyramid() = default;
  /// `values` must be finite.
  explicit RangePyramid(std::vector<float> values);

  [[nodiscard]] std::size_t size() const noexcept { return values_.size(); }
  [[nodiscard]] float at(std::size_t index) const { return values_[index]; }
  /// Returns the range of the values first .. last - 1; at least one, inside the series.
  [[nodiscard]] Range range(std::size_t first, std::size_t last) const;
  /// Returns the range of all values; {0, 0} if there are none.
  [[nodiscard]] Range whole() const;

 private:
  std::vector<float> values_;
  std::vector<std::vector<Range>> levels_;  // level k: blocks of kBlock * 2^k values
};

}  // namespace torsio
