// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/record_sentences.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr std::size_t kPrintedHash = 16;

ReportParagraph waysSentence(const MarkWays& ways, bool imported, const ResultsAt& at) {
  const std::int64_t all = ways.blinded + ways.live + ways.entered;
  const ReportCell marks = at("given_in_all");
  if (imported && ways.entered == all) {
    return {Text::tr("Nothing shows that raters were blinded: all marks of the training study (%1) were "
                     "imported.",
                     marks.words()),
            {marks}};
  }
  if (ways.blinded == all) {
    return {
        Text::tr("Raters were blinded: all marks of the training study (%1) were given on recordings under "
                 "a case label, without name, group or occasion.",
                 marks.words()),
        {marks}};
  }
  if (ways.live == all) {
    return {
        Text::tr("Raters were not blinded: all marks of the training study (%1) were given live at the real "
                 "arm, where the rater sees the trainee.",
                 marks.words()),
        {marks}};
  }
  if (ways.entered == all) {
    return {
        Text::tr("Nothing shows that raters were blinded: all marks of the training study (%1) were entered "
                 "without a scoring sheet.",
                 marks.words()),
        {marks}};
  }
  const ReportCell blinded = at("given_blinded");
  const ReportCell live = at("given_live");
  const ReportCell entered = at("entered_without_sheet");
  return {
      Text::tr("Raters were blinded in part: of %1 {mark|marks} of the training study %2 {was|were} given on "
               "recordings under a case label, %3 live at the real arm, where the rater sees the trainee, "
               "and %4 {was|were} entered without a scoring sheet.",
               marks.words(), blinded.words(), live.words(), entered.words()),
      {marks, blinded, live, entered}};
}

}  // namespace

ReportParagraph markWaysSentence(const CohortInputs& in, const Ledger& ledger) {
  return waysSentence(in.markWays, in.imported.has_value(), {ledger, wholeKey(kTrainingMarks)});
}

std::vector<ReportParagraph> blindingSentences(const CohortInputs& in, const Ledger& ledger) {
  std::vector<ReportParagraph> sentences;
  if (in.markWays.blinded + in.markWays.live + in.markWays.entered > 0) {
    sentences.push_back(markWaysSentence(in, ledger));
  }
  if (in.evaluations.empty()) {
    return sentences;
  }
  const ResultsAt at(ledger, wholeKey(kEvaluationMarks));
  const ReportCell models = at("models");
  const ReportCell hidden = at("models_hidden");
  const ReportCell both = at("raters_who_are_trainees");
  sentences.push_back(
      in.modelsHidden == std::ssize(in.evaluations)
          ? ReportParagraph(
                Text::tr("All models (%1) stood before their raters under hidden labels.", models.words()),
                {models})
          : ReportParagraph(Text::tr("%1 of %2 {model|models} stood before their raters under hidden labels.",
                                     hidden.words(), models.words()),
                            {hidden, models}));
  if (at.number("raters_who_are_trainees").value_or(0.0) > 0.0) {
    sentences.push_back(
        {Text::tr(
             "%1 {trainee of this cohort is a rater|trainees of this cohort are raters} of the models as "
             "well: their marks are not independent of their training.",
             both.words()),
         {both}});
  }
  return sentences;
}

int decimalsOf(const Interval& interval) {
  constexpr int kMaxDecimals = 4;
  constexpr double kSteps = 2.0;  // in units of the last decimal, between the ends
  const double fromZero = interval.lower * interval.upper > 0.0
                              ? std::min(std::abs(interval.lower), std::abs(interval.upper))
                              : 1.0;
  int decimals = kPointDecimals;
  const auto tooFew = [&] {
    const double step = std::pow(10.0, -decimals);
    return interval.upper - interval.lower < kSteps * step || fromZero < 0.5 * step;
  };
  while (decimals < kMaxDecimals && tooFew()) {
    ++decimals;
  }
  return decimals;
}

ReportParagraph detectableSentence(const StudyAnalysis& study, const Ledger& ledger) {
  std::optional<std::pair<double, ReportCell>> least;
  std::optional<std::pair<double, ReportCell>> most;
  for (const PrimaryDifference& pair : primaryDifferences(study)) {
    const ResultsAt at = resultsOfPair(ledger, pair.first, pair.second);
    const std::optional<double> value = at.number("detectable_difference");
    if (!value) {
      continue;
    }
    const ReportCell cell = at("detectable_difference", fixed(decimalsOf({0.0, *value})));
    least = !least || *value < least->first ? std::pair(*value, cell) : least;
    most = !most || *value > most->first ? std::pair(*value, cell) : most;
  }
  if (!least) {
    return Text(Text::tr("What this does not show: marks on a training arm say nothing about patients."));
  }
  const Text rest = Text::tr(
      "A difference that was not shown is not evidence of equality, and marks on a training arm say nothing "
      "about patients.");
  const Text size = least->second == most->second
                        ? least->second.words()
                        : Text::tr("%1 to %2", least->second.words(), most->second.words());
  return {
      Text::tr(
          "What this does not show: with the spread found here, this comparison detects a difference of "
          "%1 points between two groups with a power of %2 (two-sided test at 5 %, shared among the pairs "
          "as in Holm's first step), and misses smaller ones more often. %3",
          size, formatFixed(kWantedPower, 2), rest),
      {least->second, most->second}};
}

Text importSentence(const CohortOrigin& origin) {
  const Text from = Text::tr(
      "from %1 (%2, hash %3) by %4 on %5",
      origin.source.empty() ? Text(Text::tr("a file without a name")) : Text(origin.source), origin.layout,
      origin.contentHash.substr(0, kPrintedHash), origin.importedBy, formatUtc(origin.importedUtc_us));
  const Text vouched =
      origin.signedBy.empty()
          ? Text::tr("%1, not signed, so nothing proves that its marks are real", from)
          : Text::tr("%1, signed with the key %2", from, origin.signedBy.substr(0, kPrintedHash));
  if (origin.earlier.empty()) {
    return vouched;
  }
  std::vector<Text> steps(origin.earlier.begin(), origin.earlier.end());
  return Text::tr("%1; imported there from %2", vouched, listed(steps));
}

std::vector<Text> originSentences(const CohortInputs& in) {
  std::vector<Text> out;
  if (in.demonstration) {
    out.push_back(
        Text::tr("Simulated: people, movements and marks. Nothing in it is a result about real people."));
  }
  if (in.imported) {
    out.push_back(Text::tr("Imported %1.", importSentence(*in.imported)));
  }
  return out;
}

ReportParagraph commitmentSentence(const CohortAllocation& drawn, const Ledger& ledger) {
  const ResultsAt at(ledger, {.section = ResultSection::kParticipants});
  if (drawn.commitment.empty()) {
    return Text::tr("No commitment to the seed is in the record.");
  }
  if (drawn.lockedUtc_us == 0) {
    return Text::tr("Commitment to the seed: %1; when it was made is not in the record.", drawn.commitment);
  }
  const std::string locked = formatUtc(drawn.lockedUtc_us);
  if (drawn.allocatedBeforeLock > 0) {
    const ReportCell allocated = at("allocated_before_commitment");
    return {Text::tr("Commitment to the seed: %1, made %2, after %3 {trainee|trainees} had been allocated.",
                     drawn.commitment, locked, allocated.words()),
            {allocated}};
  }
  if (drawn.enrolledBeforeLock > 0) {
    const ReportCell enrolled = at("enrolled_before_commitment");
    return {Text::tr("Commitment to the seed: %1, made %2, before anybody was allocated and after %3 "
                     "{trainee|trainees} had been enrolled.",
                     drawn.commitment, locked, enrolled.words()),
            {enrolled}};
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

ReportParagraph marksSentence(const CohortInputs& in, const Ledger& ledger) {
  const ResultsAt at(ledger, wholeKey(kTrainingMarks));
  const ReportCell raters = at("raters");
  const ReportCell marks = at("raters", kValues);
  const ReportCell occasions = at("occasions");
  const ReportCell lowest = at("scale_lowest", fixed(0));
  const ReportCell highest = at("scale_highest", fixed(0));
  if (in.trainingMarks.empty() || allMarksGiven(in)) {
    return {
        Text::tr("%1 {physician|physicians} scored every trainee at %2 {occasion|occasions} on a scale from "
                 "%3 to %4. A trainee's score is the plain mean of these marks.",
                 raters.words(), occasions.words(), lowest.words(), highest.words()),
        {raters, occasions, lowest, highest}};
  }
  return {
      Text::tr("%1 {physician|physicians} gave %2 {mark|marks} at %3 {occasion|occasions} on a scale from %4 "
               "to %5; not every physician scored every trainee at every occasion. A trainee's score is the "
               "plain mean of the marks at hand.",
               raters.words(), marks.words(), occasions.words(), lowest.words(), highest.words()),
      {raters, marks, occasions, lowest, highest}};
}

}  // namespace torsio
