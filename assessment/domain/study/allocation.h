// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"
#include "sim/core/random.h"

namespace torsio {

inline constexpr const char* kAllocationVersion = "allocation-1";
inline constexpr const char* kAllocationGenerator =
    "mt19937_64, bounded by rejection, Fisher-Yates from the back";

enum class AllocationMethod : std::uint8_t {
  kCompletePermutation,  ///< all persons known at the start (the paper's case): one shuffle of equal arms
  kPermutedBlocks,    ///< sequential enrolment: shuffled blocks, sizes drawn at random when several are given
  kStratifiedBlocks,  ///< a block list for each combination of factor levels
  kMinimisation,      ///< Pocock and Simon 1975: the arm that leaves the margins most even, with chance
};

inline constexpr std::array<Term<AllocationMethod>, 4> kAllocationMethods{{
    {AllocationMethod::kCompletePermutation, "complete permutation",
     Text::tr("Simple randomisation into equal groups (as in the paper)")},
    {AllocationMethod::kPermutedBlocks, "permuted blocks", Text::tr("Shuffled blocks, one after another")},
    {AllocationMethod::kStratifiedBlocks, "stratified blocks", Text::tr("Shuffled blocks within strata")},
    {AllocationMethod::kMinimisation, "minimisation", Text::tr("Minimisation (Pocock and Simon)")},
}};
[[nodiscard]] constexpr const auto& termsOf(AllocationMethod) noexcept {
  return kAllocationMethods;
}

/// True if a method balances by factors: strata, or margins of minimisation.
[[nodiscard]] bool usesFactors(AllocationMethod method) noexcept;
/// True if a method draws blocks and therefore needs block sizes.
[[nodiscard]] bool usesBlocks(AllocationMethod method) noexcept;

enum class Imbalance : std::uint8_t { kRange, kVariance };
inline constexpr std::array<Term<Imbalance>, 2> kImbalances{{
    {Imbalance::kRange, "range", Text::verbatim("range")},
    {Imbalance::kVariance, "variance", Text::verbatim("variance")},
}};
[[nodiscard]] constexpr const auto& termsOf(Imbalance) noexcept {
  return kImbalances;
}

/// The attributes of a trainee by which groups can be balanced.
enum class BalanceFactor : std::uint8_t { kSex, kLevel, kExperience, kHandedness };
inline constexpr std::array<Term<BalanceFactor>, 4> kBalanceFactors{{
    {BalanceFactor::kSex, "sex", Text::tr("sex")},
    {BalanceFactor::kLevel, "level", Text::tr("level of education")},
    {BalanceFactor::kExperience, "experience", Text::tr("experience")},
    {BalanceFactor::kHandedness, "handedness", Text::tr("handedness")},
}};
[[nodiscard]] constexpr const auto& termsOf(BalanceFactor) noexcept {
  return kBalanceFactors;
}

/// An attribute of a person known before allocation: sex, experience.
struct AllocationFactor {
  std::string name;
  std::vector<std::string> levels;
};

struct AllocationDesign {
  std::string studyId;
  AllocationMethod method = AllocationMethod::kCompletePermutation;
  std::vector<std::string> arms;
  std::size_t participants = 0;           ///< kCompletePermutation only
  std::vector<std::size_t> blockSizes;    ///< multiples of the number of arms
  std::vector<AllocationFactor> factors;  ///< strata, or the margins of minimisation
  std::int64_t bestArm_tenths = 8;        ///< kMinimisation: probability of the best arm in tenths, 5 to 9
  Imbalance imbalance = Imbalance::kRange;
  /// For kStratifiedBlocks: number of persons in each stratum, if all are known. Blocks then fill each
  /// stratum up to a multiple of the smallest block; the remainders of all strata share one permutation, so
  /// that the arms come out even. Empty: complete blocks only.
  std::map<std::string, std::size_t> stratumTotals;
};

/// Checks block sizes. Throws Error{kBadParameter} if there are none or one is not a multiple of `arms`.
void checkBlockSizes(const std::vector<std::size_t>& sizes, std::size_t arms);

/// Checks a design. Throws Error{kBadParameter}: fewer than two arms, a duplicate arm, block sizes that are
/// not multiples of the number of arms (with known strata, of the smallest block), a factor without levels, a
/// probability of 1, a permutation of nobody.
void validateDesign(const AllocationDesign& design);

/// Serialises everything that determines the allocation, except the seed, as one line of text.
[[nodiscard]] std::string designText(const AllocationDesign& design);

/// Computes the commitment that is published before the first person is enrolled: BLAKE2b-256 of study,
/// design, seed and salt. Anybody given seed and salt at the end can verify that they were not chosen
/// afterwards. The salt (256 random bits as 64 hexadecimal digits) keeps the seed from being guessed. `salt`
/// empty: a commitment from before salts were introduced.
[[nodiscard]] std::string seedCommitment(const AllocationDesign& design, std::uint64_t seed,
                                         const std::string& salt = {});

/// True if a text has the form of a salt: 64 lower-case hexadecimal digits.
[[nodiscard]] bool isSalt(const std::string& text) noexcept;

struct AllocationPerson {
  std::string code;                 ///< pseudonym
  std::vector<std::size_t> levels;  ///< one per factor
};

/// Context of one allocation as given by the caller: who, when, with what version. Part of the record and its
/// hash.
struct AllocationStamp {
  std::int64_t utc_us = 0;
  std::string enrolledBy;
  std::string allocatedBy;
  std::string softwareVersion;
};

/// One allocation, append-only. `hash` covers every other field, so a changed or removed record breaks the
/// chain.
struct AllocationRecord {
  std::size_t position = 0;  ///< 0, 1, 2 ... in the order of enrolment
  std::string person;
  std::vector<std::size_t> levels;
  std::string stratum;
  std::uint64_t drawsBefore = 0;  ///< numbers drawn from the generator so far
  std::uint64_t drawsAfter = 0;
  std::vector<std::int64_t> countsBefore;  ///< persons in each arm
  std::vector<std::int64_t> scores;        ///< kMinimisation: imbalance if the person joined that arm
  std::size_t arm = 0;
  AllocationStamp stamp;
  std::string previousHash;
  std::string hash;
};

[[nodiscard]] std::string recordHash(const AllocationRecord& record);

/// Assigns study arms one by one. The sequence depends only on design, seed, and the order and factor levels
/// of the persons; it cannot be predicted from outside. Not thread-safe.
class Allocator {
 public:
  /// Throws Error{kBadParameter} if the design is invalid.
  Allocator(AllocationDesign design, std::uint64_t seed);

  /// Assigns a person to an arm. Throws Error{kBadData} if the person is already allocated, lacks a level of
  /// a factor, or the list is exhausted.
  AllocationRecord assign(const AllocationPerson& person, const AllocationStamp& stamp = {});

  [[nodiscard]] const AllocationDesign& design() const noexcept { return design_; }
  [[nodiscard]] const std::vector<AllocationRecord>& records() const noexcept { return records_; }

 private:
  static constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

  [[nodiscard]] std::uint64_t draw(std::uint64_t n);
  [[nodiscard]] std::vector<std::size_t> shuffled(std::vector<std::size_t> labels);
  // Shuffled arms for `persons`, their counts differing by at most one.
  [[nodiscard]] std::vector<std::size_t> shuffledRest(std::size_t persons);
  // `room`: maximum size of the block; at least the smallest block size.
  [[nodiscard]] std::vector<std::size_t> nextBlock(std::size_t room);
  [[nodiscard]] std::size_t fromBlocks(const std::string& stratum, std::size_t room = kNoLimit);
  [[nodiscard]] std::size_t fromStratum(const std::string& stratum);
  [[nodiscard]] std::size_t minimise(const AllocationPerson& person, std::vector<std::int64_t>& scores);
  [[nodiscard]] std::string stratumOf(const AllocationPerson& person) const;

  AllocationDesign design_;
  Random random_;
  std::uint64_t draws_ = 0;
  std::map<std::string, std::vector<std::size_t>> waiting_;  // arms not yet assigned, next one last
  std::map<std::string, std::size_t> served_;
  std::vector<std::int64_t> counts_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::int64_t>> margins_;  // factor, level -> arms
  std::vector<AllocationRecord> records_;
};

/// A complete allocation: design, seed and records.
struct Allocation {
  AllocationDesign design;
  std::uint64_t seed = 0;
  std::string salt{};  ///< sealed with the seed
  std::string commitment;
  std::vector<AllocationRecord> records;
  std::string head{};  ///< stored head of the chain; empty: none was stored
};

/// Returns the head of the chain as one line to be kept elsewhere: "torsio-allocation 1 RECORDS HASH". The
/// hash covers salt, commitment, number of records, persons in each arm, and the last record, so truncating,
/// extending or rewriting the chain changes it.
[[nodiscard]] std::string allocationHead(const Allocation& allocation);

/// Allocates all persons in order; fills in participants, stratum totals (with `jointLeftovers`), commitment
/// and head.
[[nodiscard]] Allocation allocate(AllocationDesign design, std::uint64_t seed,
                                  const std::vector<AllocationPerson>& persons, bool jointLeftovers = true,
                                  const std::string& salt = {});

/// Result of a replay from the seed. `sound` if every arm and draw count, the commitment, the chain and its
/// head agree.
struct ReplayFinding {
  bool sound = true;
  std::optional<std::size_t> firstWrongPosition;
  std::string reason;
};

/// Repeats the allocation from the seed and the recorded factor levels, and compares. `keptHead`: a head
/// stored elsewhere, out of reach of whoever rewrites the allocation; empty: the allocation's own.
[[nodiscard]] ReplayFinding replayAllocation(const Allocation& allocation, const std::string& keptHead = {});

/// The allocation design of a cohort, fixed before the first allocation.
struct LockedDesign {
  DesignId id{};
  CohortId cohortId{};
  std::string algorithm{};  ///< "complete", "permuted blocks", "minimisation" ...
  std::string algorithmVersion{};
  std::string parametersJson{};
  std::string generator{};       ///< "mt19937_64"
  std::string seedCommitment{};  ///< published before the first allocation
  std::string seed{};            ///< in a table of its own; empty until revealed
  std::string salt{};            ///< of the commitment; sealed and revealed with the seed
  std::int64_t lockedUtc_us = 0;
  bool demonstration = false;
};

/// One person allocated to one group. Append-only and hash-chained: a correction or override is a new record.
struct AllocationEntry {
  AllocationId id{};
  DesignId designId{};
  std::int64_t sequence = 0;  ///< 1, 2, 3 ... within the design
  EnrolmentId enrolmentId{};
  GroupId groupId{};
  std::int64_t numberInGroup = 0;
  std::string covariatesJson = "{}";    ///< stratum as used
  std::string countsBeforeJson = "{}";  ///< people in each group before
  std::string scoresJson = "{}";        ///< minimisation: score of each group
  std::int64_t drawBefore = 0;          ///< numbers drawn from the generator so far
  std::int64_t drawAfter = 0;
  std::string enrolledBy{};
  std::string allocatedBy{};
  std::string softwareVersion{};
  std::string overrideReason{};  ///< empty: as drawn
  std::int64_t allocatedUtc_us = 0;
  bool demonstration = false;
  std::string previousHash{};  ///< filled by allocate(); empty in the first record of a design
  std::string recordHash{};    ///< filled by allocate()
};

}  // namespace torsio
