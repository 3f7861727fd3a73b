// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/ids.h"

#include <map>
#include <string>
#include <type_traits>
#include <unordered_set>

#include <gtest/gtest.h>

#include "sim/core/text.h"

namespace torsio {
namespace {

template <typename A, typename B>
concept Equated = requires(const A& a, const B& b) {
  a == b;
};
template <typename A, typename B>
concept Ordered = requires(const A& a, const B& b) {
  a < b;
};

/// Whether an id of kind B can stand nowhere for one of kind A.
template <typename A, typename B>
constexpr bool kApart = !std::is_constructible_v<A, B> && !std::is_convertible_v<B, A> &&
                        !std::is_assignable_v<A&, B> && !Equated<A, B> && !Ordered<A, B>;

static_assert(kApart<TrialId, PersonId> && kApart<PersonId, TrialId>);
static_assert(kApart<EnrolmentId, TrialId> && kApart<EnrolmentId, PersonId> && kApart<UserId, PersonId>);
static_assert(kApart<CurriculumId, CurriculumVersionId> && kApart<RubricId, RubricRevisionId>);
static_assert(kApart<ModuleId, PhaseId> && kApart<AssignmentId, MarkId> && kApart<MarkId, EvaluationMarkId>);
static_assert(kApart<SceneId, PatternId> && kApart<CohortId, CampaignId> && kApart<GroupId, ArmId>);

// The check itself tells kinds that are one from kinds that are two.
static_assert(!kApart<TrialId, TrialId> && !kApart<TrialId, std::string> && !kApart<TrialId, const char*>);
// Trainees and raters are people: their tables refer to person.
static_assert(std::is_same_v<TraineeId, PersonId> && std::is_same_v<RaterId, PersonId>);

void takesText(const std::string& text, std::string& seen) {
  seen = text;
}

TEST(Ids, BecomeTextsAndTextsBecomeIdsWithoutAWord) {
  const TrialId trialId = "t-1";
  std::string seen;

  takesText(trialId, seen);
  const TrialId again = seen;

  EXPECT_EQ(seen, "t-1");
  EXPECT_EQ(again, trialId);
  EXPECT_EQ(again, "t-1");
  EXPECT_EQ("trial " + trialId + "!", "trial t-1!");
  EXPECT_EQ(Text::verbatim("trial %1", trialId).str(), "trial t-1");
  EXPECT_TRUE(TrialId().empty());
}

TEST(Ids, AreOrderedAndHashedAsTheirTexts) {
  const std::map<TrialId, int> ordered{{"b", 2}, {"a", 1}};
  const std::unordered_set<TrialId> hashed{"a", "b", "a"};

  EXPECT_EQ(ordered.begin()->first, "a");
  EXPECT_EQ(hashed.size(), 2U);
  EXPECT_EQ(std::hash<TrialId>{}("a"), std::hash<std::string>{}("a"));
}

}  // namespace
}  // namespace torsio
