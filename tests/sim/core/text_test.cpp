// SPDX-License-Identifier: GPL-3.0-or-later

#include "sim/core/text.h"

#include <map>
#include <sstream>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/domain/ids.h"
#include "sim/core/error.h"
#include "sim/core/text_packing.h"

namespace torsio {

namespace {

TEST(Text, PutsItsArgumentsInTheirPlaces) {
  const Text text =
      Text::verbatim("row %2 of %1 has %3 values", std::string("roster.csv"), 7, Text::verbatim("no"));

  EXPECT_EQ(text.str(), "row 7 of roster.csv has no values");
  EXPECT_EQ(text.pattern(), "row %2 of %1 has %3 values");
}

TEST(Text, TakesTextsAsArguments) {
  const Text place = Text::verbatim("module %1", Text::verbatim("V2"));
  const Text text = Text::verbatim("%1, mastery %2", place, Text::verbatim("peak_force"));

  EXPECT_EQ(text.str(), "module V2, mastery peak_force");
  EXPECT_EQ(text.arguments().front().pattern(), "module %1");
}

TEST(Text, ChoosesSingularOrPluralByTheNumber) {
  const auto said = [](int trainees, int groups) {
    return Text::verbatim("%1 {trainee was|trainees were} put into %2 {group|groups}", trainees, groups)
        .str();
  };

  EXPECT_EQ(said(1, 1), "1 trainee was put into 1 group");
  EXPECT_EQ(said(0, 1), "0 trainees were put into 1 group");
  EXPECT_EQ(said(11, 3), "11 trainees were put into 3 groups");
  // What is no pair stays, and so does what an argument says.
  EXPECT_EQ(Text::verbatim("%1 {a} of {b", 2).str(), "2 {a} of {b");
  EXPECT_EQ(Text::verbatim("{a|b} %1", Text::verbatim("{c|d}")).str(), "{a|b} {c|d}");
}

TEST(Text, NeverReadsAnArgumentAsAPattern) {
  EXPECT_EQ(Text::verbatim("%1 and %2", Text::verbatim("100 %2"), Text::verbatim("b")).str(), "100 %2 and b");
}

TEST(Text, LeavesAPlainSentenceAlone) {
  const Text text = Text::verbatim("only 40 % of %1");

  EXPECT_EQ(text.str(), "only 40 % of %1");
  EXPECT_TRUE(Text().empty());
}

TEST(Text, EqualsATextOfTheSameWords) {
  EXPECT_EQ(Text::verbatim("trial %1", 4), Text::verbatim("trial 4"));
  EXPECT_FALSE(Text::verbatim("trial %1", 4) == Text::verbatim("trial %1", 5));
  std::ostringstream out;
  out << Text::verbatim("trial %1", 4);
  EXPECT_EQ(out.str(), "trial 4");
}

// A literal that nobody marked is no text, wherever a text is wanted.
static_assert(!std::is_constructible_v<Text, const char (&)[4]>);
static_assert(!std::is_constructible_v<Text, const char*>);
static_assert(!std::is_constructible_v<Phrase, const char (&)[4]>);
static_assert(!std::is_constructible_v<Error, ErrorCode, const char (&)[4], Text, Text>);
static_assert(!std::is_constructible_v<Error, ErrorCode, Text, const char (&)[4], Text>);
static_assert(!std::is_constructible_v<Error, ErrorCode, Text, Text, const char (&)[4]>);
static_assert(std::is_constructible_v<Error, ErrorCode, Phrase, std::string, const char (&)[1]>);

TEST(Text, IsRestoredFromItsPatternAndArguments) {
  const Text text = Text::verbatim("case %1", std::string("7F"));

  const Text again = Text::restored(text.pattern(), text.arguments());

  EXPECT_EQ(again.pattern(), "case %1");
  EXPECT_EQ(again.str(), "case 7F");
}

TEST(Error, HasAnEnglishMessageAndKeepsItsPatterns) {
  const Error error(ErrorCode::kBadData, Text::verbatim("row %1 is not answered", Text::verbatim("C2")),
                    Text::verbatim("case %1", Text::verbatim("7F")), Text::verbatim("Fill it in"));

  EXPECT_STREQ(error.what(), "case 7F: row C2 is not answered. Fill it in");
  EXPECT_EQ(error.happened(), "row C2 is not answered");
  EXPECT_EQ(error.happenedText().pattern(), "row %1 is not answered");
  EXPECT_EQ(error.whereText().arguments().front().str(), "7F");
}

// A list of pieces lies as deep as it is long: what follows it is read where it stands.
TEST(TextPacking, GivesBackWhatFollowsALongListOrText) {
  for (const std::size_t items : {1U, 5U, 7U, 24U, 25U, 60U}) {
    std::vector<Text> pieces;
    for (std::size_t n = 0; n < items; ++n) {
      pieces.push_back(Text::verbatim("%1 ml (%2)", n, std::string("1,2,3")));
    }
    const Text told = Text::verbatim("the largest of several pieces was taken: %1", listed(pieces));
    TextPacker packer;
    packer.text(told);
    packer.number(0.25);
    packer.text(std::string(10'000, 'x'));
    packer.list(std::vector<std::string>(100, "y"));
    packer.number(0.5);

    TextUnpacker unpacker(packer.bytes());
    Text text;
    std::string longest;
    std::vector<std::string> list;
    unpacker.text(text);
    EXPECT_EQ(text.str(), told.str()) << items;
    EXPECT_EQ(unpacker.number(), 0.25) << items;
    unpacker.text(longest);
    EXPECT_GT(longest.size(), 8'000U);
    unpacker.list(list);
    EXPECT_EQ(list.size(), 64U);
    EXPECT_EQ(unpacker.number(), 0.5) << items;
  }
}

}  // namespace

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
