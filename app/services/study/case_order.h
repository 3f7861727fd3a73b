// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace torsio {

/// A case as the order needs to know it: which stratum (stage and group) it belongs to.
struct OrderedCase {
  std::size_t index = 0;  ///< of the caller
  std::string stratum{};
};

/// An order for one rater in which the strata are spread evenly: it is made of rounds with at most one case
/// of each stratum, shuffled within the round. Same seed and rater, same order. `rater`: position in the
/// panel.
[[nodiscard]] std::vector<std::size_t> counterbalancedOrder(std::vector<OrderedCase> cases,
                                                            std::uint64_t seed, std::uint64_t rater);

/// `count` labels of the form "7F", at random and without repetition, none of them in `taken`. The letters I
/// and O are left out. Labels grow a digit when the short ones are used up.
[[nodiscard]] std::vector<std::string> caseLabels(std::size_t count, const std::set<std::string>& taken,
                                                  std::uint64_t seed, std::uint64_t stream);

}  // namespace torsio
