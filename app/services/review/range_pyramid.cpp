// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/range_pyramid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr std::size_t kBlock = 32;

RangePyramid::Range nothing() {
  return {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
}

RangePyramid::Range joined(const RangePyramid::Range& a, const RangePyramid::Range& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace

RangePyramid::RangePyramid(std::vector<float> values) : values_(std::move(values)) {
  std::vector<Range> level;
  for (std::size_t begin = 0; begin < values_.size(); begin += kBlock) {
    Range range = nothing();
    for (std::size_t i = begin; i < std::min(begin + kBlock, values_.size()); ++i) {
      TORSIO_EXPECTS(std::isfinite(values_[i]));
      range = joined(range, {values_[i], values_[i]});
    }
    level.push_back(range);
  }
  while (level.size() > 1) {
    std::vector<Range> above;
    for (std::size_t i = 0; i < level.size(); i += 2) {
      above.push_back(i + 1 < level.size() ? joined(level[i], level[i + 1]) : level[i]);
    }
    levels_.push_back(std::move(level));
    level = std::move(above);
  }
  if (!level.empty()) {
    levels_.push_back(std::move(level));
  }
}

RangePyramid::Range RangePyramid::range(std::size_t first, std::size_t last) const {
  TORSIO_EXPECTS(first < last && last <= values_.size());
  Range found = nothing();
  const auto single = [&](std::size_t i) { found = joined(found, {values_[i], values_[i]}); };
  while (first < last && first % kBlock != 0) {
    single(first++);
  }
  while (last > first && last % kBlock != 0) {
    single(--last);
  }
  std::size_t begin = first / kBlock;
  std::size_t end = last / kBlock;
  for (std::size_t k = 0; begin < end; ++k, begin /= 2, end /= 2) {
    if (begin % 2 == 1) {
      found = joined(found, levels_[k][begin++]);
    }
    if (end % 2 == 1 && begin < end) {
      found = joined(found, levels_[k][--end]);
    }
  }
  return found;
}

RangePyramid::Range RangePyramid::whole() const {
  return values_.empty() ? Range{} : levels_.back().front();
}

}  // namespace torsio
