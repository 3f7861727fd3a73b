// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/base/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace torsio {

namespace {

constexpr std::size_t kLettersForOneSlip = 3;

/// Letters to insert, remove, replace or exchange with their neighbour until both are equal.
std::size_t slipsBetween(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before;
  std::vector<std::size_t> last(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<std::size_t> row(b.size() + 1, i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before = std::exchange(last, std::move(row));
  }
  return last.back();
}

}  // namespace

std::string nearestOf(const std::vector<std::string>& names, const std::string& word) {
  std::string nearest;
  std::size_t fewest = std::max<std::size_t>(1, word.size() / kLettersForOneSlip) + 1;
  for (const std::string& name : names) {
    if (const std::size_t slips = slipsBetween(name, word); slips < fewest) {
      fewest = slips;
      nearest = name;
    }
  }
  return nearest;
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) {
    all.append(all.empty() ? "" : ", ").append(word);
  }
  return all;
}

}  // namespace torsio
