// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/record_sentences.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "assessment/results/number_format.h"
#include "assessment/results/report_sections.h"
#include "assessment/statistics/power.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr double kLargeEffect = 0.8;
constexpr double kDefaultPower = 0.8;

Text waysSentence(const MarkWays& ways) {
  const std::int64_t all = ways.blinded + ways.live + ways.entered;
  if (ways.blinded == all) {
    return Text::tr(
        "Raters were blinded: all marks of the training study (%1) were given on recordings under a case "
        "label, without name, group or occasion.",
        all);
  }
  if (ways.live == all) {
    return Text::tr(
        "Raters were not blinded: all marks of the training study (%1) were given live at the real arm, "
        "where the rater sees the trainee.",
        all);
  }
  if (ways.entered == all) {
    return Text::tr(
        "Nothing shows that raters were blinded: all marks of the training study (%1) were entered without a "
        "sheet of the desk.",
        all);
  }
  return Text::tr(
      "Raters were blinded in part: of %1 {mark|marks} of the training study %2 {was|were} given on "
      "recordings under a case label, %3 live at the real arm, where the rater sees the trainee, and %4 "
      "{was|were} entered without a sheet of the desk.",
      all, ways.blinded, ways.live, ways.entered);
}

}  // namespace

std::vector<Text> blindingSentences(const CohortInputs& in) {
  std::vector<Text> sentences;
  if (in.markWays.blinded + in.markWays.live + in.markWays.entered > 0) {
    sentences.push_back(waysSentence(in.markWays));
  }
  if (in.evaluations.empty()) {
    return sentences;
  }
  const auto models = static_cast<std::int64_t>(in.evaluations.size());
  sentences.push_back(in.modelsHidden == models
                          ? Text::tr("All models (%1) stood before their raters under hidden labels.", models)
                          : Text::tr("%1 of %2 {model|models} stood before their raters under hidden labels.",
                                     in.modelsHidden, models));
  const std::set<std::string> raters = evaluationRaters(in);
  const auto both = std::count_if(in.trainees.begin(), in.trainees.end(), [&](const CohortTrainee& trainee) {
    return raters.contains(trainee.code);
  });
  if (both > 0) {
    sentences.push_back(
        Text::tr("%1 {trainee of this cohort is a rater|trainees of this cohort are raters} of the models as "
                 "well: their marks are not independent of their training.",
                 both));
  }
  return sentences;
}

namespace {

/// Returns the trainees per group with a score at the end; without any scores, those allocated.
std::vector<std::size_t> groupSizes(const CohortInputs& in) {
  std::vector<std::set<std::string>> members(in.groups.size());
  for (const TraineeScore& score : in.scores) {
    if (score.occasion + 1 == in.occasions.size()) {
      members[score.group].insert(score.trainee);
    }
  }
  if (std::all_of(members.begin(), members.end(), [](const auto& group) { return group.empty(); })) {
    for (const CohortTrainee& trainee : in.trainees) {
      members[trainee.group].insert(trainee.code);
    }
  }
  std::vector<std::size_t> sizes;
  for (const auto& group : members) {
    sizes.push_back(group.size());
  }
  return sizes;
}

/// Returns the size of the smallest group of at least two, if there are two such groups.
std::optional<std::size_t> smallestCompared(const std::vector<std::size_t>& sizes) {
  std::vector<std::size_t> compared;
  for (const std::size_t size : sizes) {
    if (size > 1) {
      compared.push_back(size);
    }
  }
  return compared.size() < 2 ? std::nullopt
                             : std::optional(*std::min_element(compared.begin(), compared.end()));
}

}  // namespace

Text powerSentence(const CohortInputs& in) {
  const std::vector<std::size_t> groups = groupSizes(in);
  if (groups.size() < 2) {
    return {};
  }
  std::vector<Text> sizes;
  for (const std::size_t size : groups) {
    sizes.emplace_back(std::to_string(size));
  }
  const std::optional<std::size_t> smallest = smallestCompared(groups);
  if (!smallest) {
    return Text::tr("The groups have %1 trainees: without two groups of two or more no power can be stated.",
                    listed(sizes));
  }
  const auto n = static_cast<double>(*smallest);
  return Text::tr(
      "The groups have %1 trainees. Two groups of %2 have a power of %3 in a two-sided t test at 5 % for a "
      "difference of 0.8 standard deviations, and detect one of %4 with a power of 0.80. A difference that "
      "is not significant is not evidence of equality.",
      listed(sizes), *smallest, formatFixed(powerTwoSampleT(n, kLargeEffect), 2),
      formatFixed(detectableTwoSampleT(n, kDefaultPower), 2));
}

Text detectableSentence(const CohortInputs& in) {
  const std::optional<std::size_t> smallest = smallestCompared(groupSizes(in));
  if (!smallest) {
    return Text::tr("a difference that was not shown is not evidence of equality.");
  }
  return Text::tr(
      "two groups of %1 detect a difference of %2 standard deviations with a power of 0.80 (two-sided t test "
      "at 5 %) and miss smaller ones more often; a difference that was not shown is not evidence of "
      "equality.",
      *smallest, formatFixed(detectableTwoSampleT(static_cast<double>(*smallest), kDefaultPower), 2));
}

Text commitmentSentence(const CohortAllocation& drawn) {
  if (drawn.commitment.empty()) {
    return Text::tr("No commitment to the seed is in the record.");
  }
  if (drawn.lockedUtc_us == 0) {
    return Text::tr("Commitment to the seed: %1; when it was made is not in the record.", drawn.commitment);
  }
  const std::string locked = formatUtc(drawn.lockedUtc_us);
  if (drawn.allocatedBeforeLock > 0) {
    return Text::tr("Commitment to the seed: %1, made %2, after %3 {trainee|trainees} had been allocated.",
                    drawn.commitment, locked, drawn.allocatedBeforeLock);
  }
  if (drawn.enrolledBeforeLock > 0) {
    return Text::tr(
        "Commitment to the seed: %1, made %2, before anybody was allocated and after %3 {trainee|trainees} "
        "had been enrolled.",
        drawn.commitment, locked, drawn.enrolledBeforeLock);
  }
  return Text::tr("Commitment to the seed: %1, made %2, before the first enrolment.", drawn.commitment,
                  locked);
}

Text replaySentence(const CohortAllocation& drawn) {
  if (drawn.replayed) {
    return Text::tr("The sequence was repeated from the seed and every arm was found the same.");
  }
  return drawn.replayDiffers ? Text::tr("The sequence was repeated from the seed and was NOT found the same.")
                             : Text::tr("The sequence has not been repeated from the seed.");
}

bool allMarksGiven(const CohortInputs& in) {
  std::set<std::string> trainees;
  std::set<std::string> raters;
  for (const CohortTrainee& trainee : in.trainees) {
    trainees.insert(trainee.code);
  }
  for (const TrainingMark& mark : in.trainingMarks) {
    trainees.insert(mark.trainee);
    raters.insert(mark.rater);
  }
  return in.trainingMarks.size() == trainees.size() * raters.size() * in.occasions.size();
}

Text marksSentence(const CohortInputs& in) {
  const std::string lo = formatFixed(pointsFromSteps(in.trainingScale.lo, in.trainingScale), 0);
  const std::string hi = formatFixed(pointsFromSteps(in.trainingScale.hi, in.trainingScale), 0);
  if (in.trainingMarks.empty() || allMarksGiven(in)) {
    return Text::tr(
        "%1 {physician|physicians} scored every trainee at %2 {occasion|occasions} on a scale from %3 to %4. "
        "A trainee's score is the plain mean of these marks.",
        in.trainingRaters, in.occasions.size(), lo, hi);
  }
  return Text::tr(
      "%1 {physician|physicians} gave %2 {mark|marks} at %3 {occasion|occasions} on a scale from %4 to %5; "
      "not every physician scored every trainee at every occasion. A trainee's score is the plain mean of "
      "the marks at hand.",
      in.trainingRaters, in.trainingMarks.size(), in.occasions.size(), lo, hi);
}

}  // namespace torsio
