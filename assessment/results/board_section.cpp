// SPDX-License-Identifier: GPL-3.0-or-later
// A one-minute summary for a board: the question, who took part, the answer with its uncertainty, who reached
// the standard, limitations, and signatures.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/received_training.h"
#include "assessment/results/record_sentences.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/study_analysis.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr double kSignificant = 0.05;
constexpr std::size_t kSignatures = 3;
constexpr std::size_t kNamedAtMost = 10;  // people in one cell
constexpr std::size_t kRoomyGroups = 3;   // more of them, or of sentences, fill the page
constexpr std::size_t kRoomyParagraphs = 6;
constexpr std::size_t kPairsAtMost = 3;  // not shown to differ, but still named

/// A difference of the primary comparison as the ledger has it.
struct AnsweredPair {
  Text name;
  ReportCell difference;
  ReportCell interval;
  ReportCell p;
  double value = 0.0;
  Interval between;
  double pHolm = 1.0;
};

/// Returns the pairs of the primary comparison that the reader may see.
std::vector<AnsweredPair> answeredPairs(const CohortInputs& in, const StudyAnalysis& study,
                                        const Ledger& ledger) {
  const PrimaryStatistics names = primaryStatistics(study.primaryMethod());
  std::vector<AnsweredPair> out;
  for (const PrimaryDifference& pair : primaryDifferences(study)) {
    const ResultsAt at = resultsOfPair(ledger, pair.first, pair.second);
    const Result* interval = at.find(names.interval);
    const std::optional<double> value = at.number(names.difference);
    const std::optional<double> p = at.number(names.p);
    if (interval == nullptr || !value || !p) {
      continue;
    }
    const auto& between = std::get<Interval>(interval->value);
    const int decimals = decimalsOf(between);
    out.push_back({pairName(in, pair.first, pair.second), at(names.difference, fixed(decimals)),
                   at(names.interval, intervalWith(decimals)), at(names.p, kEqualsP), *value, between, *p});
  }
  return out;
}

Text shown(const AnsweredPair& pair) {
  return Text::tr("%1: %2 points %3, %4", pair.name, pair.difference.words(), pair.interval.words(),
                  pair.p.words());
}

/// Adds the results that a pair's words state.
void addKeys(const AnsweredPair& pair, ReportParagraph& to) {
  for (const ReportCell* cell : {&pair.difference, &pair.interval, &pair.p}) {
    to.keys.push_back(cell->key);
  }
}

Text questionOf(const CohortInputs& in) {
  std::vector<Text> protocols;
  for (const CohortGroup& group : in.groups) {
    protocols.push_back(group.protocol.empty() ? group.name
                                               : Text::verbatim("%1 (%2)", group.name, group.protocol));
  }
  return Text::tr(
      "Question: do the scores at the end (%1) differ between trainees who trained in different ways: %2?",
      in.occasions.back(), listed(protocols));
}

ReportParagraph peopleOf(const Ledger& ledger) {
  const ResultsAt people(ledger, {.section = ResultSection::kParticipants});
  const ResultsAt marks(ledger, {.section = ResultSection::kTraining});
  const ReportCell trainees = people("trainees");
  const ReportCell groups = people("groups");
  const ReportCell compared = resultsAtEnd(ledger)("trainees_compared", {}, Text::verbatim("0"));
  const ReportCell withdrew = people("withdrew");
  const ReportCell raters = marks("raters");
  const ReportCell given = marks("marks");
  const ReportCell reported = people("deviations");
  return {
      Text::tr("People: %1 {trainee|trainees} in %2 {group|groups}, %3 of them compared at the end, %4 of "
               "them withdrew; %5 {physician|physicians} gave %6 {mark|marks}; %7 {deviation from the "
               "protocol was|deviations from the protocol were} reported.",
               trainees.words(), groups.words(), compared.words(), withdrew.words(), raters.words(),
               given.words(), reported.words()),
      {trainees, groups, compared, withdrew, raters, given, reported}};
}

/// Names the pairs that do not differ: readers must not think that there were none.
Text othersOf(const std::vector<Text>& differing, const std::vector<Text>& others) {
  const Text answer = Text::tr(
      "Answer, adjusted for the score before, with the 95 % interval and the p value of each pair after "
      "Holm: "
      "%1.",
      listed(differing, Text::tr("%1; %2")));
  if (others.empty()) {
    return answer;
  }
  return Text::verbatim(
      "%1 %2", answer,
      others.size() <= kPairsAtMost
          ? Text::tr("Not shown to differ: %1.", listed(others, Text::tr("%1; %2")))
          : Text::tr("%1 other pairs were not shown to differ: see the figure.", others.size()));
}

/// Answers the question as far as the data allow.
ReportParagraph answerOf(const CohortInputs& in, const StudyAnalysis& study,
                         const std::vector<AnsweredPair>& pairs) {
  if (study.primaryMethod() == PrimaryMethod::kNone) {
    return in.groups.size() < 2
               ? Text::tr("Answer: none. There is only one group.")
               : Text::tr("Answer: none. The groups are not compared: %1.", Text(study.ancova.reason()));
  }
  if (pairs.empty()) {
    return Text(Text::tr("Answer: not shown, because it rests on too few people."));
  }
  std::vector<Text> differing;
  std::vector<Text> others;
  const AnsweredPair* widest = &pairs.front();
  for (const AnsweredPair& pair : pairs) {
    (pair.pHolm < kSignificant ? differing : others).push_back(shown(pair));
    if (std::abs(pair.value) > std::abs(widest->value)) {
      widest = &pair;
    }
  }
  ReportParagraph answer =
      !differing.empty()
          ? othersOf(differing, others)
          : Text::tr(
                "Answer: no difference between two groups was shown. The largest, adjusted for the score "
                "before, with the 95 % interval and the p value after Holm: %1. The interval of every "
                "pair includes zero.",
                shown(*widest));
  for (const AnsweredPair& pair : pairs) {
    if (!differing.empty() || &pair == widest) {
      addKeys(pair, answer);
    }
  }
  return answer;
}

/// States who belongs to which group by what, as far as the record knows.
Text allocationOf(const CohortInputs& in) {
  const CohortAllocation& drawn = in.allocation;
  if (drawn.method.empty() && in.sites.size() > 1) {
    return Text::tr(
        "Groups: how trainees came into them is recorded at their centres, not here. Ask the centres before "
        "a difference is called an effect of the training.");
  }
  if (drawn.method.empty()) {
    return Text::tr(
        "Groups: how trainees came into them is not in the record. Nothing shows that they were drawn at "
        "random, so a difference need not be an effect of the training.");
  }
  if (drawn.movedByHand > 0) {
    return Text::tr(
        "Groups: drawn at random (%1), but %2 {trainee was|trainees were} moved by hand after the draw: a "
        "difference need not be an effect of the training.",
        drawn.method, drawn.movedByHand);
  }
  if (drawn.replayDiffers) {
    return Text::tr(
        "Groups: the record says that they were drawn (%1), but the draw could not be repeated from its "
        "seed: a difference need not be an effect of the training.",
        drawn.method);
  }
  if (!drawn.replayed) {
    return Text::tr(
        "Groups: the record says that they were drawn at random (%1); the draw has not been repeated from "
        "its "
        "seed.",
        drawn.method);
  }
  return Text::tr("Groups: drawn at random (%1).", drawn.method);
}

/// Says who is compared in which group.
Text comparedIn(const CohortInputs& in, const StudyAnalysis& study) {
  const std::int64_t without = std::ssize(leftOutTrainees(study));
  if (without > 0) {
    return Text::tr(
        "%1 {trainee has|trainees have} no score at one of the two ends and {is|are} not compared; everybody "
        "else is compared in the group in which the record has them.",
        without);
  }
  return in.allocation.asDrawn()
             ? Text(Text::tr(
                   "Everybody is compared in the group to which they were allocated (intention to treat)."))
             : Text(Text::tr("Everybody is compared in the group in which the record has them."));
}

/// States the training that the groups were to receive and did receive.
ReportParagraph trainingOf(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  if (in.doses.empty()) {
    return Text(Text::tr(
        "Training: no training time is in the record. Nothing shows that the groups trained as their "
        "names say."));
  }
  if (!knowsPlanAndTimes(in)) {
    return Text(
        Text::tr("Training: the record has times, but no plan for every group to compare them with."));
  }
  ReportParagraph out;
  std::map<Received, std::int64_t> counts;
  std::int64_t asPlanned = 0;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const ResultsAt at(ledger, {.section = ResultSection::kParticipants, .group = ledger.group(g)});
    for (const Received received : kEveryReceived) {
      const auto count = static_cast<std::int64_t>(at.number(receivedStatistic(received)).value_or(0.0));
      (received == Received::kAsPlanned ? asPlanned : counts[received]) += count;
      if (count > 0) {
        out.keys.push_back(at(receivedStatistic(received)).key);
      }
    }
  }
  std::vector<Text> kinds;
  std::int64_t otherwise = 0;
  for (const auto& [received, count] : counts) {
    otherwise += count;
    if (count > 0) {
      kinds.push_back(Text::tr("%1: %2", labelOf(received), count));
    }
  }
  if (otherwise == 0) {
    static_cast<Text&>(out) = Text::tr(
        "Training: by the times noted, all %1 {trainee|trainees} received what was planned for their group, "
        "within %2 %.",
        asPlanned, std::lround(100.0 * kWithinShare));
    return out;
  }
  const Text who = Text::tr(
      "Training: by the times noted, %1 of %2 {trainee|trainees} did not receive what was planned for their "
      "group (%3). %4",
      otherwise, asPlanned + otherwise, listed(kinds), comparedIn(in, study));
  if (!study.perProtocol) {
    static_cast<Text&>(out) =
        Text::tr("%1 Those who were trained as planned cannot be compared by themselves: %2.", who,
                 study.perProtocol.reason());
    return out;
  }
  std::vector<Text> pairs;
  for (const AdjustedDifference& pair : study.perProtocol->pairs) {
    const ResultsAt at = resultsOfPair(ledger, pair.first, pair.second);
    const ReportCell interval = at("per_protocol_difference_holm_95", intervalWith(kPointDecimals));
    const ReportCell value = at("per_protocol_difference", fixed(kPointDecimals));
    pairs.push_back(
        Text::tr("%1: %2 %3", pairName(in, pair.first, pair.second), value.words(), interval.words()));
    out.keys.insert(out.keys.end(), {value.key, interval.key});
  }
  static_cast<Text&>(out) = Text::tr(
      "%1 Only those who were trained as planned (per protocol, analysis of covariance), in points "
      "with 95 % intervals after Holm: %2.",
      who, listed(pairs, Text::tr("%1; %2")));
  return out;
}

std::optional<ReportFigure> answerFigure(const CohortInputs& in, const StudyAnalysis& study,
                                         const Ledger& ledger, const std::vector<AnsweredPair>& pairs) {
  if (pairs.empty()) {
    return std::nullopt;
  }
  ReportFigure figure = itemOf<ReportFigure>(
      in, "figure-answer", Text::tr("The answer: differences between the groups with 95 % intervals"),
      primaryMethodText(study));
  figure.kind = FigureKind::kForest;
  figure.valuesInLabels = true;
  figure.yLabel = Text::tr("difference (points)");
  FigureSeries series{.name = Text::tr("difference [95 %]")};
  for (const AnsweredPair& pair : pairs) {  // points, like the axis: a chart truncates long labels
    figure.categories.push_back(
        Text::tr("%1: %2 %3", pair.name, pair.difference.words(), pair.interval.words()));
    series.y.emplace_back(pair.value);
    series.low.push_back(pair.between.lower);
    series.high.push_back(pair.between.upper);
    series.keys.push_back(pair.difference.key);
  }
  figure.series = {series};
  figure.references = {{0.0, Text::tr("no difference")}};
  const ResultsAt end = resultsAtEnd(ledger);
  figure.provenance.n = end.count(study.mixed ? "mixed_model_marks" : "trainees_compared");
  figure.provenance.missing = end.count("marks_missing");
  figure.notes = {Text::tr(
      "Intervals are adjusted for the number of pairs, as the p values are (Holm): one excludes zero "
      "exactly where p is below 0.05.")};
  return figure;
}

/// Formats how many are competent, "2 of 10: T-03, T-07".
ReportCell ableOf(const CohortInputs& in, const Ledger& ledger, std::size_t group,
                  const std::vector<Text>& able) {
  const ResultsAt at(ledger, {.section = ResultSection::kCompetence, .group = ledger.group(group)});
  const ResultsAt people(ledger, {.section = ResultSection::kParticipants, .group = ledger.group(group)});
  ReportCell cell =
      at("able_at_every_exercise", {},
         people.number("runs").value_or(0.0) > 0.0 ? Text::tr("no run judged") : Text::tr("no recorded run"));
  if (cell.key == nullptr) {
    return cell;
  }
  const Text count = Text::tr("%1 of %2", cell.words(), at("able_at_every_exercise", kValues).words());
  static_cast<Text&>(cell) = able.empty() || in.identity == ReportIdentity::kAggregated ? count
                             : able.size() > kNamedAtMost ? Text::tr("%1, see the section Competence", count)
                                                          : Text::tr("%1: %2", count, listed(able));
  return cell;
}

/// Formats the minutes of a group, "38 (40); 0 (0)".
ReportCell minutesOf(const Ledger& ledger, std::size_t g) {
  const ResultsAt plan(ledger, {.section = ResultSection::kParticipants, .group = ledger.group(g)});
  const ResultsAt times(ledger, {.section = ResultSection::kPractice, .group = ledger.group(g)});
  const Text none = Text::tr("not recorded");
  const auto one = [&](const char* received, const char* planned) {
    return Text::verbatim("%1 (%2)", times(received, fixed(0), none).words(),
                          plan(planned, fixed(0), none).words());
  };
  ReportCell cell = times("mean_noted_virtual_min", fixed(0), none);
  if (cell.key != nullptr) {
    static_cast<Text&>(cell) = Text::verbatim("%1; %2", one("mean_noted_virtual_min", "planned_virtual_min"),
                                              one("mean_noted_real_min", "planned_real_min"));
  }
  return cell;
}

/// Describes what competent means on the first page, and how often it is wrong after the runs made.
ReportParagraph standardNote(const Ledger& ledger) {
  const ResultsAt at(ledger, {.section = ResultSection::kCompetence});
  const Text rule = Text::tr(
      "Competent: at every exercise that the curriculum requires; one that was not tried counts against it. "
      "The rules are in the section Competence.");
  const ReportCell fewest = at("fewest_runs_needed");
  const ReportCell most = at("most_runs_made");
  if (at.number("most_runs_made").value_or(0.0) < at.number("fewest_runs_needed").value_or(0.0)) {
    return {
        at.number("most_runs_made").value_or(0.0) == 0.0
            ? Text::tr("%1 Nobody can have been shown competent: no run was recorded.", rule)
            : Text::tr(
                  "%1 Nobody can have been shown competent yet: at least %2 {run|runs} at an exercise are "
                  "needed, and nobody made more than %3.",
                  rule, fewest.words(), most.words()),
        {fewest, most}};
  }
  const ReportCell pass = at("false_pass_at_most", percent(1));
  const ReportCell fail = at("false_fail_at_most", percent(1));
  const ReportCell tooFew = at("verdicts_on_too_few_runs");
  const ReportCell all = at("verdicts_on_too_few_runs", kValues);
  return {
      Text::tr("%1 After the runs made, at most %2 of trainees who are inadequate at an exercise are judged "
               "competent at it, and at most %3 of those who are adequate at every exercise are not judged "
               "competent at one or more. %4 of %5 {verdict rests|verdicts rest} on too few runs to show "
               "anybody competent.",
               rule, pass.words(), fail.words(), tooFew.words(), all.words()),
      {pass, fail, tooFew, all}};
}

/// Returns per group the scores at the end, and how many were shown competent on the simulator.
ReportTable standardTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table =
      itemOf<ReportTable>(in, "table-standard", Text::tr("Scores at the end, and who reached the standard"),
                          Text::tr("mean of the trainee scores; LC-CUSUM"));
  table.columns = {Text::tr("Group"),
                   Text::tr("Trainees"),
                   Text::tr("Mean minutes received (planned): simulator; real arm"),
                   Text::tr("Recorded runs"),
                   Text::tr("Mean score (lowest to highest)"),
                   Text::tr("Competent on the simulator")};
  // Verdicts of the section Competence; none are computed here.
  std::map<std::string, bool> ableAtAll;
  for (const CohortCompetence& one : in.competence) {
    const auto known = ableAtAll.try_emplace(one.trainee, true).first;
    known->second = known->second && (one.able || !one.required);
  }
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    std::vector<Text> able;
    for (const CohortTrainee& trainee : in.trainees) {
      const auto verdict = ableAtAll.find(trainee.code);
      if (trainee.group == g && verdict != ableAtAll.end() && verdict->second) {
        able.emplace_back(trainee.code);
      }
    }
    const ResultsAt end(ledger, {.group = ledger.group(g), .occasion = ledger.lastOccasion()});
    ReportCell score = end("mean", fixed(kPointDecimals), Text::tr("none"));
    const ResultsAt group(ledger, {.section = ResultSection::kParticipants, .group = ledger.group(g)});
    if (score.key != nullptr) {
      static_cast<Text&>(score) =
          Text::tr("%1 (%2 to %3)", score.words(), end("min", fixed(kPointDecimals)).words(),
                   end("max", fixed(kPointDecimals)).words());
      const std::int64_t scored = end.find("mean")->n;
      if (static_cast<double>(scored) < group.number("allocated").value_or(0.0)) {
        static_cast<Text&>(score) = Text::tr("%1, %2 {trainee|trainees} scored", score.words(), scored);
      }
    }
    table.rows.push_back({in.groups[g].name, group("allocated"), minutesOf(ledger, g), group("runs"), score,
                          ableOf(in, ledger, g, able)});
  }
  table.provenance.n = ResultsAt(ledger, {.section = ResultSection::kParticipants}).count("trainees");
  if (!ableAtAll.empty()) {
    table.notes = {standardNote(ledger)};
  }
  return table;
}

/// `roomy`: with a line for each signature.
ReportTable signatureTable(bool roomy) {
  ReportTable table;
  table.id = "table-signatures";
  table.title = Text::tr("Signatures");
  table.columns = {Text::tr("Name"), Text::tr("Role"), Text::tr("Date"), Text::tr("Signature")};
  for (std::size_t i = 0; i < kSignatures; ++i) {
    const Text above = roomy ? Text::verbatim("\n") : Text();
    table.rows.push_back({Text::verbatim("%1____________________", above),
                          Text::verbatim("%1______________", above), Text::verbatim("%1____________", above),
                          Text::verbatim("%1________________________", above)});
  }
  return table;
}

}  // namespace

ReportSection boardSection(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  ReportSection section{"summary", Text::tr("At a glance")};
  section.onFirstPage = true;
  const std::vector<AnsweredPair> pairs = answeredPairs(in, study, ledger);
  section.paragraphs = {questionOf(in), peopleOf(ledger), allocationOf(in), trainingOf(in, study, ledger),
                        answerOf(in, study, pairs)};
  for (ReportParagraph& reservation : reservations(in, study, ledger)) {
    section.paragraphs.push_back(std::move(reservation));
  }
  section.paragraphs.push_back(detectableSentence(study, ledger));
  if (std::optional<ReportFigure> figure = answerFigure(in, study, ledger, pairs)) {
    section.figures.push_back(std::move(*figure));
  }
  const bool roomy = in.groups.size() <= kRoomyGroups && section.paragraphs.size() <= kRoomyParagraphs;
  section.tables = {standardTable(in, ledger), signatureTable(roomy)};
  return section;
}

}  // namespace torsio
