// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/case_order.h"

#include <algorithm>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "sim/core/random.h"

namespace torsio {

namespace {

constexpr std::uint64_t kCaseOrderStream = 1000;
constexpr std::string_view kLetters = "ABCDEFGHJKLMNPQRSTUVWXYZ";

}  // namespace

std::vector<std::size_t> counterbalancedOrder(std::vector<OrderedCase> cases, std::uint64_t seed,
                                              std::uint64_t rater) {
  Random random = Random::forStream(seed, kCaseOrderStream + rater);
  std::map<std::string, std::vector<std::size_t>> strata;
  for (const OrderedCase& one : cases) {
    strata[one.stratum].push_back(one.index);
  }
  std::size_t rounds = 0;
  for (auto& [name, members] : strata) {
    random.shuffle(std::span<std::size_t>(members));
    rounds = std::max(rounds, members.size());
  }
  std::vector<std::size_t> order;
  for (std::size_t round = 0; round < rounds; ++round) {
    std::vector<std::size_t> together;
    for (const auto& [name, members] : strata) {
      // Small strata are spread over all rounds rather than used up in the first ones.
      const std::size_t from = round * members.size() / rounds;
      const std::size_t to = (round + 1) * members.size() / rounds;
      for (std::size_t i = from; i < to; ++i) {
        together.push_back(members[i]);
      }
    }
    random.shuffle(std::span<std::size_t>(together));
    order.insert(order.end(), together.begin(), together.end());
  }
  return order;
}

std::vector<std::string> caseLabels(std::size_t count, const std::set<std::string>& taken, std::uint64_t seed,
                                    std::uint64_t stream) {
  Random random = Random::forStream(seed, stream);
  std::vector<std::string> labels;
  for (std::size_t first = 1; labels.size() < count; first *= 10) {
    std::vector<std::string> pool;
    for (std::size_t number = first; number < first * 10; ++number) {
      for (const char letter : kLetters) {
        std::string label = std::to_string(number) + letter;
        if (!taken.contains(label)) {
          pool.push_back(std::move(label));
        }
      }
    }
    random.shuffle(std::span<std::string>(pool));
    const std::size_t wanted = std::min(count - labels.size(), pool.size());
    labels.insert(labels.end(), pool.begin(), pool.begin() + static_cast<std::ptrdiff_t>(wanted));
  }
  // The longer labels must not gather at the end: their place would tell something.
  random.shuffle(std::span<std::string>(labels));
  return labels;
}

}  // namespace torsio
