// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/random.h"

namespace torsio {

inline constexpr const char* kAllocationVersion = "allocation-1";
inline constexpr const char* kAllocationGenerator =
    "mt19937_64, bounded by rejection, Fisher-Yates from the back";

enum class AllocationMethod {
  kCompletePermutation,  ///< all persons known at the start (the paper's case): one shuffle of equal arms
  kPermutedBlocks,    ///< sequential enrolment: shuffled blocks, sizes drawn at random when several are given
  kStratifiedBlocks,  ///< a block list for each combination of factor levels
  kMinimisation,      ///< Pocock and Simon 1975: the arm that leaves the margins most even, with chance
};

/// Says whether a method balances by factors: strata, or margins of minimisation.
[[nodiscard]] bool usesFactors(AllocationMethod method) noexcept;
/// Says whether a method draws block by block and so needs block sizes.
[[nodiscard]] bool usesBlocks(AllocationMethod method) noexcept;

enum class Imbalance { kRange, kVariance };

/// Something known of a person before allocation: sex, experience.
struct AllocationFactor {
  std::string name;
  std::vector<std::string> levels;
};

struct AllocationDesign {
  std::string studyId;
  AllocationMethod method = AllocationMethod::kCompletePermutation;
  std::vector<std::string> arms;
  std::size_t participants = 0;           ///< kCompletePermutation
  std::vector<std::size_t> blockSizes;    ///< multiples of the number of arms
  std::vector<AllocationFactor> factors;  ///< strata, or the margins of minimisation
  std::int64_t bestArm_tenths = 8;        ///< kMinimisation: probability of the best arm in tenths, 5 to 9
  Imbalance imbalance = Imbalance::kRange;
  /// With kStratifiedBlocks: persons in each stratum, when all are known. Blocks then fill a stratum up to
  /// less than the smallest one, of which the others are multiples; the rests of all strata share one
  /// permutation, so that the arms come out even. Empty: closed blocks.
  std::map<std::string, std::size_t> stratumTotals;
};

/// Throws Error{kBadParameter}: no block sizes, or one that is no multiple of the arms.
void checkBlockSizes(const std::vector<std::size_t>& sizes, std::size_t arms);

/// Checks a design. Throws Error{kBadParameter}: fewer than two arms, one named twice, block sizes that are
/// no multiple of the arms or, with known strata, of the smallest, a factor without levels, a probability of
/// 1, a permutation for nobody.
void validateDesign(const AllocationDesign& design);

/// Writes everything that decides the allocation except the seed as one line of text.
[[nodiscard]] std::string designText(const AllocationDesign& design);

/// Computes the commitment that is published before the first person is enrolled: BLAKE2b-256 over study,
/// design, seed and salt. Whoever is given seed and salt at the end can check that they were not chosen
/// afterwards; without the salt, 256 random bits as 64 hexadecimal digits, no seed can be guessed from it.
/// `salt` empty: a commitment made before there were salts.
[[nodiscard]] std::string seedCommitment(const AllocationDesign& design, std::uint64_t seed,
                                         const std::string& salt = {});

/// Whether a text is a salt: 64 hexadecimal digits in lower case.
[[nodiscard]] bool isSalt(const std::string& text) noexcept;

struct AllocationPerson {
  std::string code;                 ///< pseudonym
  std::vector<std::size_t> levels;  ///< one a factor
};

/// Who, when and with what, as given by the caller; enters the record and its hash.
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
  std::uint64_t drawsBefore = 0;  ///< numbers asked from the generator
  std::uint64_t drawsAfter = 0;
  std::vector<std::int64_t> countsBefore;  ///< persons in each arm
  std::vector<std::int64_t> scores;        ///< kMinimisation: imbalance if the person went there
  std::size_t arm = 0;
  AllocationStamp stamp;
  std::string previousHash;
  std::string hash;
};

[[nodiscard]] std::string recordHash(const AllocationRecord& record);

/// Assigns study arms one by one. The sequence depends on design, seed, and the order and factor levels of
/// the persons; later assignments cannot be read from outside. One thread.
class Allocator {
 public:
  /// Makes an allocator. Throws Error{kBadParameter} for a design that breaks its rules.
  Allocator(AllocationDesign design, std::uint64_t seed);

  /// Assigns a person. Throws Error{kBadData} when the person is already allocated, has no level for a
  /// factor, or the list is used up.
  AllocationRecord assign(const AllocationPerson& person, const AllocationStamp& stamp = {});

  [[nodiscard]] const AllocationDesign& design() const noexcept { return design_; }
  [[nodiscard]] const std::vector<AllocationRecord>& records() const noexcept { return records_; }

 private:
  static constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

  [[nodiscard]] std::uint64_t draw(std::uint64_t n);
  [[nodiscard]] std::vector<std::size_t> shuffled(std::vector<std::size_t> labels);
  // Labels for `persons` of whom no arm gets two more than another.
  [[nodiscard]] std::vector<std::size_t> shuffledRest(std::size_t persons);
  // `room`: persons that the block may hold at most; at least the smallest size.
  [[nodiscard]] std::vector<std::size_t> nextBlock(std::size_t room);
  [[nodiscard]] std::size_t fromBlocks(const std::string& stratum, std::size_t room = kNoLimit);
  [[nodiscard]] std::size_t fromStratum(const std::string& stratum);
  [[nodiscard]] std::size_t minimise(const AllocationPerson& person, std::vector<std::int64_t>& scores);
  [[nodiscard]] std::string stratumOf(const AllocationPerson& person) const;

  AllocationDesign design_;
  Random random_;
  std::uint64_t draws_ = 0;
  std::map<std::string, std::vector<std::size_t>> waiting_;  // arms not yet handed out, next one last
  std::map<std::string, std::size_t> served_;
  std::vector<std::int64_t> counts_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::int64_t>> margins_;  // factor, level -> arms
  std::vector<AllocationRecord> records_;
};

/// A whole study: design, seed and what came of it.
struct Allocation {
  AllocationDesign design;
  std::uint64_t seed = 0;
  std::string salt{};  ///< sealed with the seed
  std::string commitment;
  std::vector<AllocationRecord> records;
  std::string head{};  ///< as it was kept; empty: none was
};

/// Returns the head of the chain as one line to be kept elsewhere: "torsio-allocation 1 RECORDS HASH", where
/// the hash covers salt, commitment, how many records and persons in each arm there are, and the last record.
/// Records that were cut off or added, and a chain that was written anew with other persons, give another
/// one.
[[nodiscard]] std::string allocationHead(const Allocation& allocation);

/// Allocates all persons in order; fills in the numbers that are known when everybody is (participants,
/// stratum totals when `jointLeftovers`), commitment and head.
[[nodiscard]] Allocation allocate(AllocationDesign design, std::uint64_t seed,
                                  const std::vector<AllocationPerson>& persons, bool jointLeftovers = true,
                                  const std::string& salt = {});

/// What a replay from the seed found. `sound` when every arm, every draw count, the commitment, the chain and
/// its head agree.
struct ReplayFinding {
  bool sound = true;
  std::optional<std::size_t> firstWrongPosition;
  std::string reason;
};

/// Repeats the allocation from seed and recorded factor levels and compares. `keptHead`: a head that was kept
/// elsewhere, which nobody who rewrites the whole allocation can change; empty: the one of the allocation.
[[nodiscard]] ReplayFinding replayAllocation(const Allocation& allocation, const std::string& keptHead = {});

}  // namespace torsio
