// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/study/allocation.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "tests/assessment/reference_case.h"

namespace torsio {
namespace {

struct Vectors {
  test::ReferenceCase reference = test::referenceCase("allocation", "randomisation_vectors");
  std::uint64_t seed = reference.input.at("seed").get<std::uint64_t>();

  [[nodiscard]] std::vector<AllocationPerson> persons(bool sex, bool experience) const {
    std::vector<AllocationPerson> out;
    const auto sexes = reference.input.at("sex").get<std::string>();
    for (std::size_t i = 0; i < sexes.size(); ++i) {
      AllocationPerson person{std::to_string(100 + i), {}};
      if (sex) {
        person.levels.push_back(sexes[i] == 'M' ? 0 : 1);
      }
      if (experience) {
        person.levels.push_back(reference.input.at("experience_level")[i].get<std::size_t>());
      }
      out.push_back(person);
    }
    return out;
  }

  [[nodiscard]] std::vector<std::size_t> expected(const char* method) const {
    return reference.expected.at(method).get<std::vector<std::size_t>>();
  }
};

const AllocationFactor kSex{"sex", {"M", "F"}};
const AllocationFactor kExperience{"experience", {"none", "some", "much"}};

AllocationDesign design(AllocationMethod method) {
  AllocationDesign out;
  out.studyId = "T";
  out.method = method;
  out.arms = {"1", "2", "3"};
  return out;
}

std::vector<std::size_t> armsFromOne(const Allocation& allocation) {
  std::vector<std::size_t> arms;
  for (const AllocationRecord& record : allocation.records) {
    arms.push_back(record.arm + 1);
  }
  return arms;
}

TEST(Allocate, ReproducesTheReferenceOfTheCompletePermutation) {
  const Vectors vectors;
  const Allocation got =
      allocate(design(AllocationMethod::kCompletePermutation), vectors.seed, vectors.persons(false, false));
  EXPECT_EQ(armsFromOne(got), vectors.expected("complete_shuffle"));
  EXPECT_TRUE(replayAllocation(got).sound);
}

TEST(Allocate, ReproducesTheReferencesOfPermutedBlocks) {
  const Vectors vectors;
  AllocationDesign fixed = design(AllocationMethod::kPermutedBlocks);
  fixed.blockSizes = {6};
  AllocationDesign varying = fixed;
  varying.blockSizes = {3, 6};

  const Allocation six = allocate(fixed, vectors.seed, vectors.persons(false, false));
  const Allocation threeOrSix = allocate(varying, vectors.seed, vectors.persons(false, false));

  EXPECT_EQ(armsFromOne(six), vectors.expected("blocks6"));
  EXPECT_EQ(armsFromOne(threeOrSix), vectors.expected("blocks_3_or_6"));
  EXPECT_TRUE(replayAllocation(six).sound);
  EXPECT_TRUE(replayAllocation(threeOrSix).sound);
}

TEST(Allocate, ReproducesTheReferenceOfClosedStratifiedBlocks) {
  const Vectors vectors;
  AllocationDesign strata = design(AllocationMethod::kStratifiedBlocks);
  strata.blockSizes = {3};
  strata.factors = {kSex};

  const Allocation got = allocate(strata, vectors.seed, vectors.persons(true, false), false);

  EXPECT_EQ(armsFromOne(got), vectors.expected("stratified_sex_blocks3"));
  EXPECT_TRUE(replayAllocation(got).sound);
}

TEST(Allocate, AllocatesTheRemaindersOfAllStrataJointlySoThatTheArmsComeOutEven) {
  const Vectors vectors;
  AllocationDesign strata = design(AllocationMethod::kStratifiedBlocks);
  strata.blockSizes = {3};
  strata.factors = {kSex};
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Allocation got = allocate(strata, seed, vectors.persons(true, false));

    std::vector<std::vector<int>> counts(2, std::vector<int>(3, 0));
    for (const AllocationRecord& record : got.records) {
      ++counts[record.levels[0]][record.arm];
    }
    for (std::size_t arm = 0; arm < 3; ++arm) {
      EXPECT_EQ(counts[0][arm] + counts[1][arm], 10);
      EXPECT_GE(counts[0][arm], 5);  // 17 men: five complete blocks of three, two remaining
      EXPECT_LE(counts[0][arm], 6);
    }
    EXPECT_TRUE(replayAllocation(got).sound);
  }
}

TEST(Allocate, FillsStrataWithBlocksOfSeveralSizesAndKeepsTheArmsEven) {
  const Vectors vectors;
  AllocationDesign strata = design(AllocationMethod::kStratifiedBlocks);
  strata.blockSizes = {3, 6};
  strata.factors = {kSex};
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Allocation got = allocate(strata, seed, vectors.persons(true, false));

    std::vector<int> counts(3, 0);
    for (const AllocationRecord& record : got.records) {
      ++counts[record.arm];
    }
    EXPECT_EQ(counts, (std::vector<int>{10, 10, 10})) << seed;
    EXPECT_TRUE(replayAllocation(got).sound);
  }
  strata.blockSizes = {6, 9};  // nine persons could leave three that fit no block
  EXPECT_THROW((void)allocate(strata, 1, vectors.persons(true, false)), Error);
}

TEST(Allocate, NeverLeavesAnArmTwoAhead) {
  AllocationDesign strata = design(AllocationMethod::kStratifiedBlocks);
  strata.factors = {kSex, kExperience};
  for (const std::vector<std::size_t>& sizes :
       {std::vector<std::size_t>{3}, std::vector<std::size_t>{3, 6}}) {
    strata.blockSizes = sizes;
    for (std::size_t persons = 4; persons <= 31; persons += 3) {
      for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        std::vector<AllocationPerson> all;
        for (std::size_t i = 0; i < persons; ++i) {
          all.push_back({"p" + std::to_string(i), {i % 2, (i * i + i / 3) % 3}});
        }
        const Allocation got = allocate(strata, seed, all);
        std::vector<int> counts(3, 0);
        for (const AllocationRecord& record : got.records) {
          ++counts[record.arm];
        }
        const auto [low, high] = std::minmax_element(counts.begin(), counts.end());
        EXPECT_LE(*high - *low, 1) << persons << " persons, seed " << seed;
        EXPECT_TRUE(replayAllocation(got).sound);
      }
    }
  }
}

TEST(Allocate, RejectsADuplicateArm) {
  AllocationDesign twice = design(AllocationMethod::kPermutedBlocks);
  twice.arms = {"simulator", "arm", "simulator"};
  twice.blockSizes = {3};

  EXPECT_THROW(validateDesign(twice), Error);
}

TEST(Allocate, ReproducesTheReferenceOfMinimisationWithItsScores) {
  const Vectors vectors;
  AllocationDesign margins = design(AllocationMethod::kMinimisation);
  margins.factors = {kSex, kExperience};

  const Allocation got = allocate(margins, vectors.seed, vectors.persons(true, true));

  EXPECT_EQ(armsFromOne(got), vectors.expected("minimisation"));
  const nlohmann::json& scores = vectors.reference.expected.at("minimisation_scores_first6_and_last");
  for (std::size_t i = 0; i < 7; ++i) {
    const AllocationRecord& record = got.records[i < 6 ? i : 29];
    for (std::size_t arm = 0; arm < 3; ++arm) {
      EXPECT_EQ(record.scores[arm], scores[3 * i + arm].get<std::int64_t>()) << i;
    }
  }
  std::vector<std::vector<std::int64_t>> table(3, std::vector<std::int64_t>(5, 0));
  for (const AllocationRecord& record : got.records) {
    ++table[record.arm][record.levels[0]];
    ++table[record.arm][2 + record.levels[1]];
  }
  EXPECT_EQ(
      table,
      (vectors.reference.expected.at("minimisation_margins").get<std::vector<std::vector<std::int64_t>>>()));
  EXPECT_TRUE(replayAllocation(got).sound);
}

TEST(ReplayAllocation, DetectsAChangedArmAnotherSeedAndARemovedRecord) {
  const Vectors vectors;
  const Allocation kept =
      allocate(design(AllocationMethod::kCompletePermutation), vectors.seed, vectors.persons(false, false));
  Allocation changed = kept;
  changed.records[4].arm = (changed.records[4].arm + 1) % 3;
  Allocation forged = changed;  // rewriting a record and its hash still cannot change the seed
  for (std::size_t i = 4; i < forged.records.size(); ++i) {
    forged.records[i].previousHash = forged.records[i - 1].hash;
    forged.records[i].hash = recordHash(forged.records[i]);
  }
  Allocation reseeded = kept;
  reseeded.seed += 1;
  Allocation shortened = kept;
  shortened.records.erase(shortened.records.begin() + 3);

  EXPECT_EQ(replayAllocation(changed).firstWrongPosition, 4U);
  EXPECT_EQ(replayAllocation(forged).firstWrongPosition, 4U);
  EXPECT_FALSE(replayAllocation(reseeded).sound);
  EXPECT_EQ(replayAllocation(shortened).firstWrongPosition, 3U);
}

TEST(Allocator, RejectsInvalidDesignsAndPersons) {
  AllocationDesign blocks = design(AllocationMethod::kPermutedBlocks);
  blocks.blockSizes = {4};
  EXPECT_THROW(Allocator(blocks, 1), Error);
  AllocationDesign certain = design(AllocationMethod::kMinimisation);
  certain.factors = {kSex};
  certain.bestArm_tenths = 10;
  EXPECT_THROW(Allocator(certain, 1), Error);
  AllocationDesign oneArm = design(AllocationMethod::kPermutedBlocks);
  oneArm.arms = {"1"};
  EXPECT_THROW(Allocator(oneArm, 1), Error);
  blocks.blockSizes = {3};
  Allocator allocator(blocks, 1);
  (void)allocator.assign({"p1", {}});
  EXPECT_THROW((void)allocator.assign({"p1", {}}), Error);
  EXPECT_THROW((void)allocator.assign({"p2", {0}}), Error);
}

TEST(AllocationMethods, TellWhetherTheyUseFactorsAndBlocks) {
  EXPECT_FALSE(usesFactors(AllocationMethod::kCompletePermutation));
  EXPECT_FALSE(usesFactors(AllocationMethod::kPermutedBlocks));
  EXPECT_TRUE(usesFactors(AllocationMethod::kStratifiedBlocks));
  EXPECT_TRUE(usesFactors(AllocationMethod::kMinimisation));
  EXPECT_FALSE(usesBlocks(AllocationMethod::kCompletePermutation));
  EXPECT_TRUE(usesBlocks(AllocationMethod::kPermutedBlocks));
  EXPECT_TRUE(usesBlocks(AllocationMethod::kStratifiedBlocks));
  EXPECT_FALSE(usesBlocks(AllocationMethod::kMinimisation));
}

TEST(Allocator, RejectsAMethodWithoutTheFactorsOrBlocksThatItUses) {
  AllocationDesign strata = design(AllocationMethod::kStratifiedBlocks);
  strata.factors = {kSex};
  EXPECT_THROW(Allocator(strata, 1), Error);  // no block size
  strata.blockSizes = {3};
  EXPECT_NO_THROW(Allocator(strata, 1));
  strata.factors.clear();
  EXPECT_THROW(Allocator(strata, 1), Error);
}

TEST(ReplayAllocation, DetectsTruncationAndSwappedPersonsByTheHeadOfTheChain) {
  const Vectors vectors;
  const Allocation kept = allocate(design(AllocationMethod::kCompletePermutation), vectors.seed,
                                   vectors.persons(false, false), true, std::string(64, 'a'));
  ASSERT_TRUE(replayAllocation(kept).sound);
  EXPECT_TRUE(replayAllocation(kept, kept.head).sound);
  Allocation cut = kept;
  cut.records.pop_back();
  EXPECT_FALSE(replayAllocation(cut).sound);

  // The whole file is rewritten with two persons swapped: only a head stored elsewhere reveals it.
  std::vector<AllocationPerson> persons = vectors.persons(false, false);
  std::size_t other = 1;
  while (kept.records[other].arm == kept.records[0].arm) {
    ++other;
  }
  std::swap(persons[0], persons[other]);
  const Allocation swapped = allocate(kept.design, kept.seed, persons, true, kept.salt);
  EXPECT_EQ(swapped.commitment, kept.commitment);
  EXPECT_TRUE(replayAllocation(swapped).sound);
  EXPECT_FALSE(replayAllocation(swapped, kept.head).sound);
  Allocation forged = swapped;
  forged.head = kept.head;
  EXPECT_FALSE(replayAllocation(forged).sound);
}

TEST(SeedCommitment, OfASmallSeedCannotBeGuessedWithoutTheSalt) {
  AllocationDesign one = design(AllocationMethod::kPermutedBlocks);
  one.blockSizes = {3};
  const std::string salt(64, '7');
  const std::string commitment = seedCommitment(one, 5, salt);
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    EXPECT_NE(seedCommitment(one, seed), commitment);
    EXPECT_EQ(seedCommitment(one, seed, salt) == commitment, seed == 5);
  }
  EXPECT_TRUE(isSalt(salt));
  EXPECT_FALSE(isSalt(std::string(63, '7')));
  EXPECT_FALSE(isSalt(std::string(64, 'G')));
}

TEST(SeedCommitment, DependsOnSeedAndDesign) {
  AllocationDesign one = design(AllocationMethod::kPermutedBlocks);
  one.blockSizes = {3};
  AllocationDesign other = one;
  other.blockSizes = {6};
  const std::set<std::string> all = {seedCommitment(one, 1), seedCommitment(one, 2),
                                     seedCommitment(other, 1)};
  EXPECT_EQ(all.size(), 3U);
  EXPECT_EQ(all.begin()->size(), 64U);
}

}  // namespace
}  // namespace torsio
