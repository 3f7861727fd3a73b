// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "app/services/study/scoring_plan.h"

namespace torsio {
namespace {

/// Three groups of ten at three stages.
std::vector<OrderedCase> paperCases() {
  std::vector<OrderedCase> cases;
  for (const char* stage : {"pre", "mid", "post"}) {
    for (const char* group : {"G1", "G2", "G3"}) {
      for (int i = 0; i < 10; ++i) {
        cases.push_back({cases.size(), std::string(stage) + " " + group});
      }
    }
  }
  return cases;
}

TEST(CaseOrder, IsADifferentPermutationForEachRater) {
  const std::vector<OrderedCase> cases = paperCases();

  std::vector<std::size_t> first = counterbalancedOrder(cases, 5, 0);
  const std::vector<std::size_t> second = counterbalancedOrder(cases, 5, 1);

  EXPECT_EQ(first, counterbalancedOrder(cases, 5, 0));
  EXPECT_NE(first, second);
  EXPECT_NE(first, counterbalancedOrder(cases, 6, 0));
  std::sort(first.begin(), first.end());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i], i);
  }
}

TEST(CaseOrder, SpreadsStagesAndGroupsEvenlyOverTheSession) {
  const std::vector<OrderedCase> cases = paperCases();

  const std::vector<std::size_t> order = counterbalancedOrder(cases, 5, 3);

  // Nine strata of ten: each successive nine cases contain each stratum once.
  for (std::size_t round = 0; round < 10; ++round) {
    std::map<std::string, int> seen;
    for (std::size_t i = 0; i < 9; ++i) {
      ++seen[cases[order[round * 9 + i]].stratum];
    }
    EXPECT_EQ(seen.size(), 9U) << round;
  }
}

TEST(CaseOrder, SpreadsSmallStrataToo) {
  std::vector<OrderedCase> cases;
  for (std::size_t i = 0; i < 20; ++i) {
    cases.push_back({i, i < 4 ? "few" : "many"});
  }

  const std::vector<std::size_t> order = counterbalancedOrder(cases, 1, 0);

  std::size_t inFirstHalf = 0;
  for (std::size_t i = 0; i < 10; ++i) {
    inFirstHalf += cases[order[i]].stratum == "few" ? 1 : 0;
  }
  EXPECT_EQ(inFirstHalf, 2U);
}

TEST(CaseLabels, AreUniqueAndNewAndTheirOrderRevealsNothing) {
  const std::vector<std::string> labels = caseLabels(90, {"7F"}, 11, 1);

  const std::set<std::string> unique(labels.begin(), labels.end());
  EXPECT_EQ(unique.size(), 90U);
  EXPECT_FALSE(unique.contains("7F"));
  EXPECT_FALSE(std::is_sorted(labels.begin(), labels.end()));
  EXPECT_NE(labels, caseLabels(90, {"7F"}, 11, 2));
  for (const std::string& label : labels) {
    EXPECT_EQ(label.size(), 2U);
    EXPECT_EQ(label.find_first_of("IO"), std::string::npos);
  }
}

TEST(CaseLabels, GrowWhenTheShortOnesAreUsedUp) {
  // 9 digits x 24 letters = 216 short labels.
  const std::vector<std::string> labels = caseLabels(300, {}, 11, 1);

  EXPECT_EQ(std::set<std::string>(labels.begin(), labels.end()).size(), 300U);
  const auto lateShort = std::count_if(labels.end() - 100, labels.end(),
                                       [](const std::string& label) { return label.size() == 2; });
  EXPECT_GT(lateShort, 40);  // expected 72: long ones do not gather at the end
}

}  // namespace
}  // namespace torsio
