// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/study/allocation.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <numeric>
#include <span>

#include "sim/core/digest.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::size_t kSaltDigits = 64;
constexpr const char* kOneList = "all";          // the block list when there are no strata
constexpr const char* kLeftovers = "leftovers";  // the list that fills the incomplete blocks of all strata

[[noreturn]] void refuseDesign(const Text& what, const Text& remedy) {
  refuseParameter(what, Text::tr("allocation design"), remedy);
}

template <class Numbers>
void appendNumbers(std::string& text, const Numbers& numbers) {
  for (const auto number : numbers) {
    text += ' ';
    text += std::to_string(number);
  }
}

std::vector<std::size_t> equalArms(std::size_t count, std::size_t arms) {
  std::vector<std::size_t> labels;
  for (std::size_t arm = 0; arm < arms; ++arm) {
    labels.insert(labels.end(), count / arms, arm);
  }
  return labels;
}

std::int64_t imbalanceOf(const std::vector<std::int64_t>& counts, Imbalance measure) {
  if (measure == Imbalance::kRange) {
    const auto [low, high] = std::minmax_element(counts.begin(), counts.end());
    return *high - *low;
  }
  // k sum x^2 - (sum x)^2 orders like the variance but stays an integer.
  std::int64_t sum = 0;
  std::int64_t squares = 0;
  for (const std::int64_t x : counts) {
    sum += x;
    squares += x * x;
  }
  return std::ssize(counts) * squares - sum * sum;
}

}  // namespace

bool usesFactors(AllocationMethod method) noexcept {
  return method == AllocationMethod::kStratifiedBlocks || method == AllocationMethod::kMinimisation;
}

bool usesBlocks(AllocationMethod method) noexcept {
  return method == AllocationMethod::kStratifiedBlocks || method == AllocationMethod::kPermutedBlocks;
}

void checkBlockSizes(const std::vector<std::size_t>& sizes, std::size_t arms) {
  if (sizes.empty()) {
    refuseDesign(Text::tr("no block size is given"), Text::tr("Give one or more block sizes."));
  }
  for (const std::size_t size : sizes) {
    if (size == 0 || size % arms != 0) {
      refuseDesign(Text::tr("block size %1 is not a multiple of the number of arms", size),
                   Text::tr("Give multiples of the number of arms."));
    }
  }
}

void validateDesign(const AllocationDesign& design) {
  const std::size_t arms = design.arms.size();
  if (arms < 2) {
    refuseDesign(Text::tr("there are fewer than two arms"), Text::tr("Name at least two arms."));
  }
  for (std::size_t arm = 1; arm < arms; ++arm) {
    const auto before = design.arms.begin() + static_cast<std::ptrdiff_t>(arm);
    if (std::find(design.arms.begin(), before, *before) != before) {
      refuseDesign(Text::tr("arm \"%1\" is named twice", *before), Text::tr("Name each arm once."));
    }
  }
  for (const AllocationFactor& factor : design.factors) {
    if (factor.levels.empty()) {
      refuseDesign(Text::tr("factor \"%1\" has no levels", factor.name), Text::tr("List its levels."));
    }
  }
  if (usesFactors(design.method) && design.factors.empty()) {
    refuseDesign(design.method == AllocationMethod::kMinimisation
                     ? Text::tr("minimisation needs a factor")
                     : Text::tr("stratified blocks need a factor"),
                 Text::tr("Name a factor with its levels."));
  }
  if (usesBlocks(design.method)) {
    checkBlockSizes(design.blockSizes, arms);
    const std::size_t smallest = *std::min_element(design.blockSizes.begin(), design.blockSizes.end());
    for (const std::size_t size : design.blockSizes) {
      if (!design.stratumTotals.empty() && size % smallest != 0) {
        refuseDesign(Text::tr("blocks of %1 and %2 cannot fill a stratum without a rest", smallest, size),
                     Text::tr("Give multiples of the smallest block."));
      }
    }
  }
  if (design.method == AllocationMethod::kCompletePermutation &&
      (design.participants == 0 || design.participants % arms != 0)) {
    refuseDesign(Text::tr("the number of participants is not a multiple of the number of arms"),
                 Text::tr("Choose permuted blocks, or enrol equal arms."));
  }
  if (design.method == AllocationMethod::kMinimisation &&
      (design.bestArm_tenths < 5 || design.bestArm_tenths > 9)) {
    refuseDesign(
        Text::tr("the probability of the best arm must lie between 0.5 and 0.9; 1 could be predicted"),
        Text::tr("Choose 0.8."));
  }
}

std::string designText(const AllocationDesign& design) {
  std::string text = kAllocationVersion;
  text += "; study ";
  text += design.studyId;
  text += "; ";
  text += storedText(design.method);
  text += "; arms";
  for (const std::string& arm : design.arms) {
    text += " [" + arm + "]";
  }
  text += "; participants ";
  text += std::to_string(design.participants);
  text += "; blocks";
  appendNumbers(text, design.blockSizes);
  for (const AllocationFactor& factor : design.factors) {
    text += "; factor [" + factor.name + "]:";
    for (const std::string& level : factor.levels) {
      text += " [" + level + "]";
    }
  }
  for (const auto& [stratum, total] : design.stratumTotals) {
    text += "; stratum [" + stratum + "] ";
    text += std::to_string(total);
  }
  text += "; best arm ";
  text += std::to_string(design.bestArm_tenths);
  text += "/10 by ";
  text += storedText(design.imbalance);
  text += "; ";
  text += kAllocationGenerator;
  return text;
}

std::string seedCommitment(const AllocationDesign& design, std::uint64_t seed, const std::string& salt) {
  Digest digest;
  digest.update(designText(design));
  digest.update(static_cast<std::int64_t>(seed));
  digest.update(salt);
  return digest.hex();
}

bool isSalt(const std::string& text) noexcept {
  return text.size() == kSaltDigits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string allocationHead(const Allocation& allocation) {
  std::vector<std::int64_t> counts(allocation.design.arms.size(), 0);
  for (const AllocationRecord& record : allocation.records) {
    ++counts.at(record.arm);
  }
  std::string numbers;
  appendNumbers(numbers, counts);
  const std::string records = std::to_string(allocation.records.size());
  Digest digest;
  for (const std::string& part :
       {allocation.salt, allocation.commitment, records, numbers,
        allocation.records.empty() ? std::string() : allocation.records.back().hash}) {
    digest.update(static_cast<std::int64_t>(part.size()));
    digest.update(part);
  }
  return "torsio-allocation 1 " + records + " " + digest.hex();
}

std::string recordHash(const AllocationRecord& record) {
  std::string numbers;
  appendNumbers(numbers, record.levels);
  numbers += " |";
  appendNumbers(numbers, record.countsBefore);
  numbers += " |";
  appendNumbers(numbers, record.scores);
  Digest digest;
  digest.update(record.previousHash);
  digest.update(static_cast<std::int64_t>(record.position));
  for (const std::string* field : std::initializer_list<const std::string*>{
           &record.person, &record.stratum, &numbers, &record.stamp.enrolledBy, &record.stamp.allocatedBy,
           &record.stamp.softwareVersion}) {
    digest.update(static_cast<std::int64_t>(field->size()));
    digest.update(*field);
  }
  digest.update(static_cast<std::int64_t>(record.drawsBefore));
  digest.update(static_cast<std::int64_t>(record.drawsAfter));
  digest.update(static_cast<std::int64_t>(record.arm));
  digest.update(record.stamp.utc_us);
  return digest.hex();
}

Allocator::Allocator(AllocationDesign design, std::uint64_t seed)
    : design_(std::move(design)), random_(seed) {
  validateDesign(design_);
  counts_.assign(design_.arms.size(), 0);
}

std::uint64_t Allocator::draw(std::uint64_t n) {
  ++draws_;
  return random_.bounded(n);
}

std::vector<std::size_t> Allocator::shuffled(std::vector<std::size_t> labels) {
  if (labels.size() > 1) {
    draws_ += labels.size() - 1;
  }
  random_.shuffle(std::span<std::size_t>(labels));
  std::reverse(labels.begin(), labels.end());  // handed out from the back
  return labels;
}

std::vector<std::size_t> Allocator::nextBlock(std::size_t room) {
  std::vector<std::size_t> sizes;
  std::copy_if(design_.blockSizes.begin(), design_.blockSizes.end(), std::back_inserter(sizes),
               [&](std::size_t size) { return size <= room; });
  const std::size_t size = sizes[sizes.size() == 1 ? 0 : draw(sizes.size())];
  return shuffled(equalArms(size, design_.arms.size()));
}

std::size_t Allocator::fromBlocks(const std::string& stratum, std::size_t room) {
  std::vector<std::size_t>& list = waiting_[stratum];
  if (list.empty()) {
    list = nextBlock(room);
  }
  const std::size_t arm = list.back();
  list.pop_back();
  return arm;
}

std::vector<std::size_t> Allocator::shuffledRest(std::size_t persons) {
  const std::size_t arms = design_.arms.size();
  std::vector<std::size_t> labels = equalArms(persons / arms * arms, arms);
  if (const std::size_t more = persons % arms; more > 0) {
    std::vector<std::size_t> chosen = shuffled(equalArms(arms, arms));
    labels.insert(labels.end(), chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(more));
  }
  return shuffled(std::move(labels));
}

std::size_t Allocator::fromStratum(const std::string& stratum) {
  if (design_.stratumTotals.empty()) {
    return fromBlocks(stratum);
  }
  const std::size_t block = *std::min_element(design_.blockSizes.begin(), design_.blockSizes.end());
  const auto total = design_.stratumTotals.find(stratum);
  const std::size_t known = total == design_.stratumTotals.end() ? 0 : total->second;
  const std::size_t inBlocks = known - known % block;
  const std::size_t served = served_[stratum]++;
  if (served < inBlocks) {
    return fromBlocks(stratum, inBlocks - served);
  }
  std::vector<std::size_t>& list = waiting_[kLeftovers];
  if (list.empty()) {
    std::size_t leftovers = 0;
    for (const auto& [name, persons] : design_.stratumTotals) {
      leftovers += persons % block;
    }
    list = shuffledRest(std::max<std::size_t>(1, leftovers));
  }
  const std::size_t arm = list.back();
  list.pop_back();
  return arm;
}

std::size_t Allocator::minimise(const AllocationPerson& person, std::vector<std::int64_t>& scores) {
  const std::size_t arms = design_.arms.size();
  scores.assign(arms, 0);
  for (std::size_t arm = 0; arm < arms; ++arm) {
    for (std::size_t f = 0; f < person.levels.size(); ++f) {
      std::vector<std::int64_t>& margin = margins_[{f, person.levels[f]}];
      margin.resize(arms, 0);
      ++margin[arm];
      scores[arm] += imbalanceOf(margin, design_.imbalance);
      --margin[arm];
    }
  }
  const std::int64_t least = *std::min_element(scores.begin(), scores.end());
  std::vector<std::size_t> best;
  std::vector<std::size_t> rest;
  for (std::size_t arm = 0; arm < arms; ++arm) {
    (scores[arm] == least ? best : rest).push_back(arm);
  }
  const bool takeBest = rest.empty() || draw(10) < static_cast<std::uint64_t>(design_.bestArm_tenths);
  const std::vector<std::size_t>& from = takeBest ? best : rest;
  const std::size_t arm = from.size() == 1 ? from[0] : from[draw(from.size())];
  for (std::size_t f = 0; f < person.levels.size(); ++f) {
    ++margins_[{f, person.levels[f]}][arm];
  }
  return arm;
}

std::string Allocator::stratumOf(const AllocationPerson& person) const {
  std::string stratum;
  for (std::size_t f = 0; f < design_.factors.size(); ++f) {
    if (!stratum.empty()) {
      stratum += " / ";
    }
    stratum += design_.factors[f].levels[person.levels[f]];
  }
  return stratum;
}

AllocationRecord Allocator::assign(const AllocationPerson& person, const AllocationStamp& stamp) {
  for (const AllocationRecord& record : records_) {
    if (record.person == person.code) {
      refuse(Text::tr("person %1 is already allocated", person.code), Text::tr("allocation"),
             Text::tr("Enrol each person once; analyse as allocated."));
    }
  }
  bool levelsKnown = person.levels.size() == design_.factors.size();
  for (std::size_t f = 0; levelsKnown && f < person.levels.size(); ++f) {
    levelsKnown = person.levels[f] < design_.factors[f].levels.size();
  }
  if (!levelsKnown) {
    refuse(Text::tr("a factor of person %1 has no valid level", person.code), Text::tr("allocation"),
           Text::tr("Record every factor before allocation."));
  }
  AllocationRecord record;
  record.position = records_.size();
  record.person = person.code;
  record.levels = person.levels;
  record.stratum = stratumOf(person);
  record.drawsBefore = draws_;
  record.countsBefore = counts_;
  switch (design_.method) {
    case AllocationMethod::kCompletePermutation:
      if (record.position >= design_.participants) {
        refuse(Text::tr("the allocation list is used up"), Text::tr("allocation"),
               Text::tr("Plan a new list; the old one stays as it is."));
      }
      if (record.position == 0) {
        waiting_[kOneList] = shuffled(equalArms(design_.participants, design_.arms.size()));
      }
      record.arm = fromBlocks(kOneList);
      break;
    case AllocationMethod::kPermutedBlocks:
      record.arm = fromBlocks(kOneList);
      break;
    case AllocationMethod::kStratifiedBlocks:
      record.arm = fromStratum(record.stratum);
      break;
    case AllocationMethod::kMinimisation:
      record.arm = minimise(person, record.scores);
      break;
  }
  record.drawsAfter = draws_;
  ++counts_[record.arm];
  record.stamp = stamp;
  record.previousHash = records_.empty() ? std::string() : records_.back().hash;
  record.hash = recordHash(record);
  records_.push_back(record);
  return record;
}

Allocation allocate(AllocationDesign design, std::uint64_t seed, const std::vector<AllocationPerson>& persons,
                    bool jointLeftovers, const std::string& salt) {
  if (design.method == AllocationMethod::kCompletePermutation) {
    design.participants = persons.size();
  }
  if (design.method == AllocationMethod::kStratifiedBlocks && jointLeftovers) {
    design.stratumTotals.clear();
    for (const AllocationPerson& person : persons) {
      std::string stratum;
      for (std::size_t f = 0; f < design.factors.size() && f < person.levels.size(); ++f) {
        if (!stratum.empty()) {
          stratum += " / ";
        }
        stratum += design.factors[f].levels.at(person.levels[f]);
      }
      ++design.stratumTotals[stratum];
    }
  }
  Allocator allocator(design, seed);
  for (const AllocationPerson& person : persons) {
    allocator.assign(person);
  }
  Allocation made{design, seed, salt, seedCommitment(design, seed, salt), allocator.records(), {}};
  made.head = allocationHead(made);
  return made;
}

ReplayFinding replayAllocation(const Allocation& allocation, const std::string& keptHead) {
  if (seedCommitment(allocation.design, allocation.seed, allocation.salt) != allocation.commitment) {
    return {false, std::nullopt, "seed and design do not match the published commitment"};
  }
  Allocator allocator(allocation.design, allocation.seed);
  std::string previous;
  for (std::size_t i = 0; i < allocation.records.size(); ++i) {
    const AllocationRecord& kept = allocation.records[i];
    if (kept.position != i || kept.previousHash != previous || recordHash(kept) != kept.hash) {
      return {false, i, "the chain of records is broken"};
    }
    previous = kept.hash;
    const AllocationRecord again = allocator.assign({kept.person, kept.levels}, kept.stamp);
    if (again.arm != kept.arm) {
      return {false, i, "the seed gives another arm"};
    }
    if (again.hash != kept.hash) {
      return {false, i, "the seed gives another record"};
    }
  }
  const std::string head = allocationHead(allocation);
  for (const std::string& kept : {allocation.head, keptHead}) {
    if (!kept.empty() && kept != head) {
      return {false, std::nullopt,
              "the head of the chain differs: records were cut off or added, or persons changed places"};
    }
  }
  return {};
}

}  // namespace torsio
