// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>
#include <vector>

#include "assessment/results/record_sentences.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

Text policyText(MissingPolicy policy) {
  switch (policy) {
    case MissingPolicy::kRefuse:
      return Text::tr("none allowed");
    case MissingPolicy::kAvailableCase:
      return Text::tr("each index uses the marks at hand (available case)");
    case MissingPolicy::kListWise:
      return Text::tr("raters with a missing mark are left out (list-wise)");
    case MissingPolicy::kRenormalise:
      return Text::tr(
          "marks at hand; weights of classes without marks are divided among the others (renormalised)");
  }
  return {};
}

/// Returns the names of rater classes with no weight in M.
std::vector<Text> classesOfNoWeight(const CohortInputs& in) {
  std::vector<Text> names;
  for (const RaterClass& one : in.instrument.classes) {
    if (one.weight_milli == 0) {
      names.emplace_back(one.name);
    }
  }
  return names;
}

std::vector<Text> evaluationSentences(const CohortInputs& in) {
  std::vector<Text> out;
  out.push_back(Text::tr(
      "M (Eq. 25) is the sum over rater classes of the class weight times the class mean. s2 (Eq. 26) is "
      "the "
      "mean squared distance of all raters' marks from M, with divisor n; it is not the usual variance, "
      "because its centre is the weighted mean. N (Eq. 27) is the sum over indices of the index weight "
      "times "
      "M."));
  if (const std::vector<Text> idle = classesOfNoWeight(in); !idle.empty()) {
    out.push_back(
        in.evaluationPolicy.zeroWeightClassesInVariance
            ? Text::tr("A class of weight 0 enters s2 but not M: %1.", listed(idle))
            : Text::tr("A class of weight 0 enters neither M nor s2: %1. Its marks are among the raters' own "
                       "scores and in the order of the models.",
                       listed(idle)));
  }
  out.push_back(Text::tr("Missing marks: %1.", policyText(in.evaluationPolicy.missing)));
  out.push_back(Text::tr(
      "The text under Eq. 26 of the paper speaks of the chief physicians' scores, but its sum runs over "
      "all "
      "raters; so does it here, and the chief physicians are shown alone where the figure says "
      "so."));
  return out;
}

Text comparisonSentence(const StudyAnalysis& study) {
  if (!study.mixed && !study.ancova) {
    return Text::tr("Groups are not compared: %1.", study.ancova.reason());
  }
  if (!study.mixed) {
    return Text::tr(
        "Groups are compared by an analysis of covariance: the score at the end, adjusted for the score "
        "before, one pooled slope; the trainee is the unit.");
  }
  return Text::tr(
      "Groups are compared by a linear mixed model, as %1: the marks at the end, adjusted for the mean mark "
      "before, trainees and raters as random effects, restricted maximum likelihood, degrees of freedom "
      "after Satterthwaite. The analysis of covariance is shown beside it.",
      study.endMissing > 0 ? Text::tr("marks are missing")
                           : Text::tr("not every trainee was marked by the same raters at the end"));
}

}  // namespace

ReportSection methodsSection(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  ReportSection section{"methods", Text::tr("Methods and limits")};
  if (!in.evaluations.empty()) {
    const std::vector<Text> sentences = evaluationSentences(in);
    section.paragraphs.assign(sentences.begin(), sentences.end());
  }
  if (!in.evaluations.empty() && !in.scores.empty()) {
    const ResultsAt models(ledger, wholeKey(kEvaluationMarks));
    const ResultsAt training(ledger, wholeKey(kTrainingMarks));
    const ReportCell lowest = models("scale_lowest", fixed(0));
    const ReportCell highest = models("scale_highest", fixed(0));
    const ReportCell lowestMark = training("scale_lowest", fixed(0));
    const ReportCell highestMark = training("scale_highest", fixed(0));
    section.paragraphs.push_back(
        {Text::tr(
             "The paper gives the scale of the model evaluation as 0 to 10 and that of the training study "
             "as 1 to 10; here they run from %1 to %2 and from %3 to %4.",
             lowest.words(), highest.words(), lowestMark.words(), highestMark.words()),
         {lowest, highest, lowestMark, highestMark}});
  }
  if (!in.scores.empty()) {
    section.paragraphs.push_back(
        Text::tr("The variance of the training evaluation is not defined in the paper. The figure shows the "
                 "variance of "
                 "the trainee scores with divisor n; the table lists the other readings."));
  }
  for (ReportParagraph& sentence : blindingSentences(in, ledger)) {
    section.paragraphs.push_back(std::move(sentence));
  }
  if (!in.trainingMarks.empty()) {
    section.paragraphs.push_back(comparisonSentence(study));
    section.paragraphs.push_back(Text::tr(
        "Effect sizes are Hedges g with intervals from the noncentral t distribution. Agreement of raters is "
        "the dependability within the groups, which in a single group is the intraclass correlation for "
        "absolute agreement (Shrout and Fleiss). Severity is a rater's mean distance from the other "
        "raters."));
  }
  if (!in.competence.empty()) {
    section.paragraphs.push_back(Text::tr(
        "Who counts as competent is judged by LC-CUSUM, by the designs and with the error rates of the "
        "section Competence."));
  }
  if (in.demonstration) {
    section.paragraphs.push_back(Text::tr(
        "All people and marks in this report are simulated. No conclusion about training, trainees or models "
        "may be drawn from it."));
  }
  return section;
}

}  // namespace torsio
