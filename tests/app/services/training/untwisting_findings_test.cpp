// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/untwisting_findings.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "sim/core/angle.h"

namespace torsio {
namespace {

DetorsionStory storyWith(std::initializer_list<std::pair<Quantity, double>> measures) {
  DetorsionStory story;
  story.mishapsKnown = true;
  for (const auto& [quantity, value] : measures) {
    story.metrics.set(quantity, value);
  }
  return story;
}

std::string toldOf(const DetorsionStory& story) {
  std::string all;
  for (const UntwistingFinding& finding : findingsOf(story)) {
    all += finding.text().str() + "\n";
  }
  return all;
}

bool isSaid(const DetorsionStory& story, const std::string& words) {
  return toldOf(story).find(words) != std::string::npos;
}

TEST(UntwistingFindings, DescribeTheMeasuresInSentences) {
  const DetorsionStory story = storyWith({{Quantity::kFirstDirection, 0.0}, {Quantity::kDose, 1.2}});

  EXPECT_EQ(toldOf(story),
            "The first turn went the wrong way.\n"
            "Blood flow did not return in this run.\n"
            "The ischaemic dose reached 1.20: from 1 the tissue is lost.\n");
}

TEST(UntwistingFindings, FormatTimesInMinutesAndSeconds) {
  const DetorsionStory story = storyWith({{Quantity::kTimeToFlow, 65.12}, {Quantity::kOverloadTime, 5.1}});

  // 65.12 s of the hand are 65 minutes of the tissue.
  EXPECT_TRUE(isSaid(story, "Blood flow returned after 1:05.1; 1:05 h for the tissue.")) << toldOf(story);
  EXPECT_TRUE(isSaid(story, "For 0:05.1, jaw pressure")) << toldOf(story);
  EXPECT_EQ(findingsOf(story).front().at_s, 65.12);
}

TEST(UntwistingFindings, DoNotReportThatFlowReturnedIfItNeverStopped) {
  const DetorsionStory story = storyWith({{Quantity::kTimeToFlow, 0.0}});

  EXPECT_TRUE(isSaid(story, "Blood flow was sufficient from the start."));
  EXPECT_FALSE(isSaid(story, "returned"));
}

TEST(UntwistingFindings, OmitInvisibleTurns) {
  EXPECT_FALSE(isSaid(storyWith({{Quantity::kWrongWay, 0.01}, {Quantity::kSlipBack, 0.01}}), "\u00b0"));
  const DetorsionStory seen =
      storyWith({{Quantity::kWrongWay, radians(30.0)}, {Quantity::kSlipBack, radians(12.0)}});
  EXPECT_TRUE(isSaid(seen, "The organ was twisted 30\u00b0 further than at the start."));
  EXPECT_TRUE(isSaid(seen, "12\u00b0 were lost again between grips"));
}

TEST(UntwistingFindings, CountMishapsAndSayIfTheyAreUnknown) {
  DetorsionStory known = storyWith({});
  known.events = {
      {1.0, DetorsionMoment::kBruise}, {2.0, DetorsionMoment::kTear}, {3.0, DetorsionMoment::kBruise}};
  DetorsionStory unknown;

  EXPECT_TRUE(isSaid(known, "Bruises from the jaw: 2."));
  EXPECT_TRUE(isSaid(known, "Tears in the wall: 1."));
  EXPECT_FALSE(isSaid(known, "Slips of"));
  EXPECT_FALSE(isSaid(known, "not marked"));
  EXPECT_TRUE(isSaid(unknown, "not marked: the organ of this run is not on this machine"));
  const std::vector<UntwistingFinding> found = findingsOf(known);
  const auto tears = std::find_if(found.begin(), found.end(), [](const UntwistingFinding& finding) {
    return finding.kind == UntwistingFinding::Kind::kTears;
  });
  EXPECT_EQ(tears->at_s, 2.0);
}

}  // namespace
}  // namespace torsio
