// SPDX-License-Identifier: GPL-3.0-or-later
// What stands against the answer on the first page, or limits it.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/received_training.h"
#include "assessment/results/record_sentences.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/same_marks.h"
#include "assessment/results/study_analysis.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr double kManyWithdrew = 0.2;
/// Rests and waits between runs take time, too; a record that has less than this of the noted time is
/// incomplete.
constexpr double kLeastRecordedShare = 0.1;
constexpr std::size_t kAlikePairsAtMost = 6;  // of trainees with the same marks, in one sentence

using Sentences = std::vector<ReportParagraph>;

/// By what they stand against, the most serious first.
struct Reservations {
  Sentences data{};      ///< doubts about the data
  Sentences rivals{};    ///< what else could explain a difference
  Sentences missing{};   ///< missing data
  Sentences analysis{};  ///< how the answer was reached
};

/// Adds whether the answer is not that of a planned analysis of covariance, and why.
void addMethod(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger, Sentences& out) {
  if (!in.hasAnalysisPlan() && study.primaryMethod() != PrimaryMethod::kNone) {
    out.emplace_back(Text(Text::tr(
        "No plan of the analysis is in the record: nothing shows that it was chosen before the data were "
        "seen.")));
  }
  if (study.mixed && study.endMissing == 0) {
    out.emplace_back(Text(
        Text::tr("Not every trainee was marked by the same raters at the end, so the answer is that of the "
                 "linear mixed model, in which raters may differ; the analysis of covariance is shown beside "
                 "it.")));
  } else if (study.mixed) {
    const ResultsAt at = resultsAtEnd(ledger);
    const ReportCell missing = at("marks_missing");
    const ReportCell all = at("marks_missing", kValues);
    out.push_back(
        {Text::tr("Of %2 marks %1 {is|are} missing, so the answer is that of the linear mixed model, which "
                  "uses every mark at the end of everybody who also has one before; the analysis of "
                  "covariance is shown beside it.",
                  missing.words(), all.words()),
         {missing, all}});
  }
  if (study.spreadsDiffer()) {
    const ResultsAt at = resultsAtEnd(ledger);
    const ReportCell least = at("smallest_spread", fixed(kPointDecimals));
    const ReportCell most = at("largest_spread", fixed(kPointDecimals));
    const ReportCell p = at("equal_spread_p", kEqualsP);
    const Text spread = Text::tr(
        "Scores vary more in some groups than in others (standard deviations about the adjusted means from "
        "%1 to %2 points, test of equal spread: %3)",
        least.words(), most.words(), p.words());
    out.push_back(
        {study.allowsForSpreads()
             ? Text::tr("%1. The standard errors of the answer allow for that (HC3).", spread)
         : study.mixed ? Text::tr("%1, which the linear mixed model does not allow for.", spread)
         : study.primaryMethod() == PrimaryMethod::kCentres
             ? Text::tr("%1, which the model with random centres does not allow for.", spread)
             : Text::tr("%1, which the answer does not allow for: somebody is alone in a group.", spread),
         {least, most, p}});
  }
  if (study.slopes) {
    const ResultsAt at = resultsAtEnd(ledger);
    const ReportCell p = at("ancova_equal_slopes_p", kEqualsP);
    out.push_back(
        {Text::tr(
             "The difference depends on the score before (test of equal slopes: %1): read the table with "
             "a slope for each group.",
             p.words()),
         {p}});
  }
}

/// Names raters whose severity cannot be told from what the training did.
void addRatersOfSomeGroups(const CohortInputs& in, const Ledger& ledger, Sentences& out) {
  if (const std::vector<std::string> codes = ratersOfSomeGroups(in); !codes.empty()) {
    out.push_back(ratersOfSomeGroupsSentence(in, codes, ledger));
  }
}

/// Names the groups whose scores before are unlike.
std::optional<ReportParagraph> unlikeBefore(const CohortInputs& in, const Ledger& ledger) {
  std::vector<Text> pairs;
  std::vector<std::shared_ptr<const ResultKey>> keys;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    for (std::size_t h = g + 1; h < in.groups.size(); ++h) {
      const ResultsAt at = resultsOfPair(ledger, g, h);
      const std::optional<double> by = at.number("difference_before_in_sd");
      if (by && std::abs(*by) >= kUnlikeBefore_sd) {
        const ReportCell cell = at("difference_before_in_sd", fixed(1));
        pairs.push_back(Text::verbatim("%1: %2", pairName(in, g, h), cell.words()));
        keys.push_back(cell.key);
      }
    }
  }
  if (pairs.empty()) {
    return std::nullopt;
  }
  ReportParagraph out = Text::tr(
      "The groups were unlike before the training, in standard deviations: %1. The answer is adjusted for it "
      "as far as a straight line can.",
      listed(pairs, Text::tr("%1; %2")));
  out.keys = std::move(keys);
  return out;
}

/// Names trainees whose marks are the same, or nearly so.
std::optional<Text> sameMarks(const CohortInputs& in, const StudyAnalysis& study) {
  const std::vector<AlikeTrainees> alike = traineesMarkedAlike(study.trainees, study.occasions);
  if (alike.empty()) {
    return std::nullopt;
  }
  if (in.identity == ReportIdentity::kAggregated) {
    return Text::tr(
        "%1 {pair of trainees has|pairs of trainees have} more identical marks than chance gives two of "
        "equal "
        "skill (same rater, same occasion): check whether somebody was entered twice.",
        alike.size());
  }
  std::vector<Text> pairs;
  for (std::size_t i = 0; i < std::min(kAlikePairsAtMost, alike.size()); ++i) {
    const AlikeTrainees& pair = alike[i];
    pairs.push_back(Text::tr("%1 and %2 in %3 of %4", pair.first, pair.second, pair.same, pair.shared));
  }
  if (alike.size() > kAlikePairsAtMost) {
    pairs.push_back(Text::tr("and %1 more {pair|pairs}", alike.size() - kAlikePairsAtMost));
  }
  return Text::tr(
      "These trainees have more identical marks than chance gives two of equal skill (same rater, same "
      "occasion): %1. Check whether somebody was entered twice.",
      listed(pairs, Text::tr("%1; %2")));
}

/// Formats how many of each group withdrew, "Group 1: 0; Group 2: 6".
Text withdrawnByGroup(const CohortInputs& in, const Ledger& ledger) {
  std::vector<Text> groups;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const ResultsAt at(ledger, {.section = ResultSection::kParticipants, .group = ledger.group(g)});
    groups.push_back(Text::verbatim("%1: %2", in.groups[g].name, at("withdrew").words()));
  }
  return listed(groups, Text::tr("%1; %2"));
}

double largestShareWithdrawn(const CohortInputs& in, const Ledger& ledger) {
  double largest = 0.0;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const ResultsAt at(ledger, {.section = ResultSection::kParticipants, .group = ledger.group(g)});
    const double size = at.number("allocated").value_or(0.0);
    largest = size > 0.0 ? std::max(largest, at.number("withdrew").value_or(0.0) / size) : largest;
  }
  return largest;
}

/// Adds how many withdrew if they are many, also in one group alone.
void addWithdrawn(const CohortInputs& in, const Ledger& ledger, Sentences& out) {
  const ResultsAt people(ledger, {.section = ResultSection::kParticipants});
  const double everybody = people.number("trainees").value_or(0.0);
  const double withdrew = people.number("withdrew").value_or(0.0);
  const ReportCell gone = people("withdrew");
  const ReportCell all = people("trainees");
  if (withdrew == 0.0) {
    return;
  }
  if (withdrew == everybody) {
    out.push_back({Text(Text::tr("Everybody withdrew. The answer rests on the marks of people who left the "
                                 "study: ask whether they may be used.")),
                   {gone, all}});
  } else if (withdrew >= kManyWithdrew * everybody || largestShareWithdrawn(in, ledger) >= kManyWithdrew) {
    ReportParagraph sentence{
        Text::tr("%1 of %2 trainees withdrew (%3). Where their marks are missing, the answer holds only for "
                 "people like those who stayed.",
                 gone.words(), all.words(), withdrawnByGroup(in, ledger)),
        {gone, all}};
    for (std::size_t g = 0; g < in.groups.size(); ++g) {
      sentence.keys.push_back(
          ResultsAt(ledger, {.section = ResultSection::kParticipants, .group = ledger.group(g)})("withdrew")
              .key);
    }
    out.push_back(std::move(sentence));
  }
  for (std::size_t g = 0; g < in.groups.size() && withdrew < everybody; ++g) {
    const ResultsAt group(ledger, {.section = ResultSection::kParticipants, .group = ledger.group(g)});
    const double size = group.number("allocated").value_or(0.0);
    if (size > 0.0 && group.number("withdrew").value_or(0.0) == size) {
      const ReportCell own = group("withdrew");
      out.push_back(
          {Text::tr("Everybody in %1 withdrew: its results rest on the marks of people who left the "
                    "study.",
                    in.groups[g].name),
           {own}});
    }
  }
}

/// Adds that minutes were noted for a group without any recorded run.
void addNotedWithoutRuns(const Text& group, const Ledger& ledger, std::size_t g, Sentences& out) {
  const ResultsAt times(ledger, {.section = ResultSection::kPractice, .group = ledger.group(g)});
  if (times.number("mean_noted_virtual_min").value_or(0.0) > 0.0) {
    const ReportCell noted = times("mean_noted_virtual_min", fixed(0));
    const ReportCell runs =
        ResultsAt(ledger, {.section = ResultSection::kParticipants, .group = ledger.group(g)})("runs");
    out.push_back(
        {Text::tr("For %1, %2 minutes on the simulator are noted per trainee on average, but no run is "
                  "recorded.",
                  group, noted.words()),
         {noted, runs}});
  }
}

/// Adds that the recorded runs of a group make up hardly any of the minutes that were noted.
void addNotedBeyondRuns(const Text& group, const Ledger& ledger, std::size_t g, Sentences& out) {
  const ResultsAt times(ledger, {.section = ResultSection::kPractice, .group = ledger.group(g)});
  const double noted_min = times.number("mean_noted_virtual_min").value_or(0.0);
  if (times.number("mean_recorded_virtual_min").value_or(noted_min) < kLeastRecordedShare * noted_min) {
    const ReportCell noted = times("mean_noted_virtual_min", fixed(0));
    const ReportCell recorded = times("mean_recorded_virtual_min", fixed(1));
    out.push_back(
        {Text::tr("For %1, %2 minutes on the simulator are noted per trainee on average, but the recorded "
                  "runs last only %3 {minute|minutes}: most of the training is not in the record.",
                  group, noted.words(), recorded.words()),
         {noted, recorded}});
  }
}

/// Adds where recorded runs contradict the minutes that somebody noted, or the plan.
void addContradictions(const CohortInputs& in, const Ledger& ledger, Sentences& out) {
  if (!knowsPlanAndTimes(in)) {
    return;
  }
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const ResultsAt at(ledger, {.section = ResultSection::kParticipants, .group = ledger.group(g)});
    const ReportCell runs = at("runs");
    const bool ran = at.number("runs").value_or(0.0) > 0.0;
    if (ran && at.number("planned_virtual_min") == 0.0) {
      out.push_back(
          {Text::tr("%1 was not to train on the simulator, but %2 {run is|runs are} recorded for it.",
                    in.groups[g].name, runs.words()),
           {runs}});
    } else if (!ran && !in.trials.empty()) {
      addNotedWithoutRuns(in.groups[g].name, ledger, g, out);
    } else if (ran && !in.demonstration) {  // whose runs are shortened
      addNotedBeyondRuns(in.groups[g].name, ledger, g, out);
    }
  }
}

/// Adds what the data lack.
void addData(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger, Reservations& out) {
  if (in.freeze && !in.freeze->unchanged) {
    out.data.emplace_back(
        Text::tr("The record has changed since it was frozen as \"%1\": these results are computed from the "
                 "record as it is now, not from the frozen data.",
                 in.freeze->name));
  }
  if (in.freeze && in.freeze->interim()) {
    out.data.emplace_back(Text::tr(
        "Interim: these data were frozen when %1 of %2 sheets were in (%3). %4 Looking at results "
        "before the end of a study makes false findings more likely.",
        in.freeze->sheetsSubmitted, in.freeze->sheetsAsked, in.freeze->whyIncomplete,
        in.freeze->askedBy.empty()
            ? Text::tr("One person alone decided to look.")
            : Text::tr("%1 asked for this look, and %2 agreed.", in.freeze->askedBy, in.freeze->frozenBy)));
  }
  if (in.imported) {
    out.data.emplace_back(Text::tr(
        "This study was imported: %1. How its marks (%2) were given, its recordings (%3) made and its "
        "groups drawn is not in this record.",
        importSentence(*in.imported), in.imported->marks, in.imported->recordings));
  }
  if (in.sites.size() > 1) {
    out.rivals.push_back(sitesSentence(in, study, ledger));
  }
  const bool said = in.imported && in.markWays.blinded + in.markWays.live == 0;  // that nothing is known
  if (in.markWays.live + in.markWays.entered > 0 && !said) {
    out.rivals.push_back(markWaysSentence(in, ledger));
  }
  if (in.notAllocated > 0) {
    const ReportCell more = ResultsAt(ledger, {.section = ResultSection::kParticipants})("not_allocated");
    out.missing.push_back(
        {Text::tr(
             "%1 {trainee was|trainees were} enrolled but {is|are} in no group and in no comparison. The "
             "record does not say why.",
             more.words()),
         {more}});
  }
  addWithdrawn(in, ledger, out.missing);
  addContradictions(in, ledger, out.data);
  const bool compared = study.primaryMethod() != PrimaryMethod::kNone;
  if (const std::vector<Text> groups = groupsNotCompared(in, study); !groups.empty()) {
    out.missing.emplace_back(
        Text::tr("Not compared, as nobody has a score at both occasions: %1.", listed(groups)));
  }
  std::vector<Text> single;
  for (std::size_t g = 0; g < study.ends.after.size(); ++g) {
    if (study.ends.after[g].size() == 1 && compared) {
      single.push_back(in.groups[g].name);
    }
  }
  if (!single.empty()) {
    out.rivals.emplace_back(
        Text::tr("A single trainee has a score at both occasions in: %1. Its differences rest on one person; "
                 "how much trainees of a group vary is taken from the other groups.",
                 listed(single)));
  }
  if (std::optional<ReportParagraph> unlike = unlikeBefore(in, ledger)) {
    out.rivals.push_back(std::move(*unlike));
  }
  if (std::optional<Text> same = sameMarks(in, study)) {
    out.data.emplace_back(std::move(*same));
  }
  const ResultsAt at = resultsAtEnd(ledger);
  if (at.number("pairs_left_open").value_or(0.0) > 0.0 && compared) {
    const ReportCell open = at("pairs_left_open");
    const ReportCell pairs = at("pairs_left_open", kValues);
    out.missing.push_back(
        {Text::tr("The missing marks could, at worst, leave open which group is better in %1 of %2 "
                  "{comparison|comparisons}.",
                  open.words(), pairs.words()),
         {open, pairs}});
  }
}

}  // namespace

std::vector<ReportParagraph> reservations(const CohortInputs& in, const StudyAnalysis& study,
                                          const Ledger& ledger) {
  Reservations found;
  addRatersOfSomeGroups(in, ledger, found.rivals);
  addData(in, study, ledger, found);
  addMethod(in, study, ledger, found.analysis);
  Sentences out;
  for (Sentences* kind : {&found.data, &found.rivals, &found.missing, &found.analysis}) {
    for (ReportParagraph& sentence : *kind) {
      sentence.reservation = true;
      out.push_back(std::move(sentence));
    }
  }
  return out;
}

}  // namespace torsio
