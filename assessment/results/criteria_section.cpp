// SPDX-License-Identifier: GPL-3.0-or-later
// Details of the overall marks: the scoring sheets as seen by raters, and the marks of each criterion.
#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "assessment/results/cohort_csv.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/result_writer.h"
#include "assessment/results/shown_inputs.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr const char* kCriterionMark = "criterion_mark";
constexpr const char* kCriterionMean = "criterion_mean";
constexpr int kMeanDecimals = 1;  // like the scores of the first page

struct Mean {
  double sum = 0.0;
  std::int64_t n = 0;
};

/// A trainee's means over the raters at one occasion on one sheet, one per criterion.
struct TraineeCriteria {
  std::size_t sheet = 0;
  std::size_t occasion = 0;
  std::size_t group = 0;
  std::string trainee;
  std::vector<Mean> criteria;
};

std::optional<double> valueOf(const Mean& mean, std::int64_t fewest) {
  if (mean.n < fewest) {
    return std::nullopt;
  }
  return mean.sum / static_cast<double>(mean.n);
}

/// Returns the minimum number of marks, or trainees, per mean for this reader.
std::int64_t fewestFor(const CohortInputs& in) {
  return in.singleMarks ? 1 : kMinMarks;
}

/// Sorted by sheet, occasion, group, trainee.
std::vector<TraineeCriteria> traineeCriteria(const CohortInputs& in) {
  std::map<std::tuple<std::size_t, std::size_t, std::size_t, std::string>, std::vector<Mean>> found;
  for (const CriterionMark& mark : in.criterionMarks) {
    std::vector<Mean>& means = found[{mark.sheet, mark.occasion, mark.group, mark.trainee}];
    means.resize(in.sheets.at(mark.sheet).criteria.size());
    if (mark.points) {
      means[mark.criterion].sum += *mark.points;
      ++means[mark.criterion].n;
    }
  }
  std::vector<TraineeCriteria> all;
  for (auto& [place, means] : found) {
    const auto& [sheet, occasion, group, trainee] = place;
    all.push_back({sheet, occasion, group, trainee, std::move(means)});
  }
  return all;
}

/// Sums the trainees' means for each group, occasion and sheet.
std::vector<TraineeCriteria> groupCriteria(const CohortInputs& in,
                                           const std::vector<TraineeCriteria>& trainees) {
  std::vector<TraineeCriteria> all;
  for (const TraineeCriteria& one : trainees) {
    if (all.empty() || std::tie(all.back().sheet, all.back().occasion, all.back().group) !=
                           std::tie(one.sheet, one.occasion, one.group)) {
      all.push_back({one.sheet, one.occasion, one.group, {}, std::vector<Mean>(one.criteria.size())});
    }
    for (std::size_t c = 0; c < one.criteria.size(); ++c) {
      if (const std::optional<double> mean = valueOf(one.criteria[c], fewestFor(in))) {
        all.back().criteria[c].sum += *mean;
        ++all.back().criteria[c].n;
      }
    }
  }
  return all;
}

Text titleOf(const ReportedSheet& sheet) {
  return Text::tr("%1, revision %2", sheet.name, sheet.revision);
}

/// Returns the key for the model "Twist training, revision 1: proficiency".
ResultKey criterionKey(const CohortInputs& in, std::size_t number, std::size_t criterion) {
  const ReportedSheet& sheet = in.sheets[number];
  return {.section = ResultSection::kCriterion,
          .model = sheet.name + ", revision " + std::to_string(sheet.revision) + ": " +
                   sheet.criteria[criterion].code,
          .record = std::to_string(number)};
}

ResultKey sheetKey(const CohortInputs& in, std::size_t number) {
  return {.section = ResultSection::kScoringSheet,
          .of = in.sheets[number].name,
          .index = "revision " + std::to_string(in.sheets[number].revision),
          .record = std::to_string(number)};
}

/// Returns the key for the mean of a group or trainee for a criterion.
ResultKey meanKey(const CohortInputs& in, const Ledger& ledger, const TraineeCriteria& one,
                  std::size_t criterion) {
  ResultKey key = criterionKey(in, one.sheet, criterion);
  key.statistic = kCriterionMean;
  key.of = one.trainee;
  key.group = ledger.group(one.group);
  key.occasion = ledger.occasion(one.occasion);
  return key;
}

/// Formats "1: hesitates; 10: sure".
Text anchorsOf(const ReportedCriterion& criterion) {
  std::vector<Text> anchors;
  for (const ReportedAnchor& anchor : criterion.anchors) {
    anchors.push_back(Text::verbatim("%1: %2", formatExact(anchor.points), anchor.meaning));
  }
  return listed(anchors, Text::tr("%1; %2"));
}

ReportTable sheetTable(const CohortInputs& in, const Ledger& ledger, std::size_t number) {
  const ReportedSheet& sheet = in.sheets[number];
  ReportTable table =
      itemOf<ReportTable>(in, "table-sheet-" + std::to_string(number + 1),
                          Text::tr("Scoring sheet as the raters saw it: %1", titleOf(sheet)), Text());
  table.annex = true;
  table.columns = {Text::tr("Criterion"), Text::tr("Scale"), Text::tr("Weight"),
                   Text::tr("What the marks mean (anchors)")};
  for (const ReportedCriterion& criterion : sheet.criteria) {
    ResultKey key = sheetKey(in, number);
    key.model = criterion.code;
    const ResultsAt at(ledger, key);
    const ReportCell lowest = at("lowest", kExactly);
    table.rows.push_back({criterion.label,
                          {Text::tr("%1 to %2", lowest.words(), at("highest", kExactly).words()), lowest.key},
                          at("weight", kExactly),
                          criterion.anchors.empty()
                              ? ReportCell(Text::tr("none"))
                              : ReportCell(anchorsOf(criterion),
                                           at("anchor_" + formatExact(criterion.anchors[0].points)).key)});
  }
  table.provenance.formulaVersion.clear();
  return table;
}

std::vector<Text> columnsOf(const ReportedSheet& sheet, std::vector<Text> first) {
  for (const ReportedCriterion& criterion : sheet.criteria) {
    first.emplace_back(criterion.label);
  }
  return first;
}

/// Adds a row with the means of a group or trainee, and the number of values of that with the most.
void addMeans(const CohortInputs& in, const Ledger& ledger, const TraineeCriteria& one, const Text& who,
              ReportTable& table) {
  const auto most = std::max_element(one.criteria.begin(), one.criteria.end(),
                                     [](const Mean& a, const Mean& b) { return a.n < b.n; });
  std::vector<ReportCell> row{who, in.occasions[one.occasion]};
  if (most != one.criteria.end()) {
    const auto c = static_cast<std::size_t>(most - one.criteria.begin());
    row.push_back(ResultsAt(ledger, meanKey(in, ledger, one, c))(kCriterionMean, kValues));
  } else {
    row.emplace_back(std::to_string(0));
  }
  for (std::size_t c = 0; c < one.criteria.size(); ++c) {
    row.push_back(ResultsAt(ledger, meanKey(in, ledger, one, c))(kCriterionMean, fixed(kMeanDecimals),
                                                                 Text::tr("none")));
  }
  table.rows.push_back(std::move(row));
}

ReportTable groupsTable(const CohortInputs& in, const Ledger& ledger, std::size_t number,
                        const std::vector<TraineeCriteria>& groups) {
  ReportTable table = itemOf<ReportTable>(in, "table-criteria-" + std::to_string(number + 1),
                                          Text::tr("Criteria by group: %1", titleOf(in.sheets[number])),
                                          Text::tr("mean over trainees of the mean of their raters"));
  table.columns =
      columnsOf(in.sheets[number], {Text::tr("Group"), Text::tr("Occasion"), Text::tr("Trainees")});
  for (const TraineeCriteria& group : groups) {
    if (group.sheet != number) {
      continue;
    }
    addMeans(in, ledger, group, in.groups[group.group].name, table);
  }
  return table;
}

ReportTable traineesTable(const CohortInputs& in, const Ledger& ledger, std::size_t number,
                          const std::vector<TraineeCriteria>& trainees) {
  ReportTable table = itemOf<ReportTable>(in, "table-criteria-trainees-" + std::to_string(number + 1),
                                          Text::tr("Criteria by trainee: %1", titleOf(in.sheets[number])),
                                          Text::tr("mean over the raters"));
  table.annex = true;
  table.individual = true;
  table.columns =
      columnsOf(in.sheets[number], {Text::tr("Trainee"), Text::tr("Occasion"), Text::tr("Raters")});
  std::vector<const TraineeCriteria*> sorted;
  for (const TraineeCriteria& one : trainees) {
    if (one.sheet == number) {
      sorted.push_back(&one);
    }
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const TraineeCriteria* a, const TraineeCriteria* b) {
    return std::tie(a->group, a->trainee, a->occasion) < std::tie(b->group, b->trainee, b->occasion);
  });
  for (const TraineeCriteria* one : sorted) {
    addMeans(in, ledger, *one, one->trainee, table);
  }
  table.notes = {
      in.singleMarks
          ? Text::tr("What each rater gave for each criterion is in the table of numbers (CSV), section "
                     "\"criterion\".")
          : Text::tr("Means of fewer than %1 marks are left out: a single mark could be read from them.",
                     kMinMarks)};
  return table;
}

}  // namespace

ReportSection criteriaSection(const CohortInputs& in, const Ledger& ledger) {
  ReportSection section{"criteria", Text::tr("Criteria of the scoring sheet")};
  const bool whole = std::all_of(in.criterionMarks.begin(), in.criterionMarks.end(),
                                 [](const CriterionMark& mark) { return mark.points.has_value(); });
  section.paragraphs = {
      whole
          ? Text::tr("Raters gave a mark for each criterion and an overall mark. Scores, comparison and "
                     "agreement are those of the overall mark; the criteria show what it rests on and enter "
                     "no test.")
          : Text::tr("Raters gave an overall mark and one for each criterion that they could assess. Scores, "
                     "comparison and agreement are those of the overall mark; the criteria show what it "
                     "rests on and enter no test.")};
  const std::vector<TraineeCriteria> trainees = traineeCriteria(in);
  const std::vector<TraineeCriteria> groups = groupCriteria(in, trainees);
  for (std::size_t i = 0; i < in.sheets.size(); ++i) {
    section.tables.push_back(sheetTable(in, ledger, i));
    section.tables.push_back(groupsTable(in, ledger, i, groups));
    section.tables.push_back(traineesTable(in, ledger, i, trainees));
  }
  return section;
}

void addCriteriaResults(const CohortInputs& in, Ledger& ledger) {
  ResultWriter lines(ledger, {.section = ResultSection::kScoringSheet}, commonFlags(in));
  for (std::size_t i = 0; i < in.sheets.size(); ++i) {
    const ReportedSheet& sheet = in.sheets[i];
    lines.place = sheetKey(in, i);
    lines.madeOf = partsOf({RecordRef{RecordKind::kRubricRevision, sheet.id}});
    for (const ReportedCriterion& criterion : sheet.criteria) {
      lines.place.model = criterion.code;
      lines.put("label", Text(criterion.label), 1);
      lines.add("weight", criterion.weight, 1);
      lines.add("lowest", criterion.lowest, 1);
      lines.add("highest", criterion.highest, 1);
      for (const ReportedAnchor& anchor : criterion.anchors) {
        lines.put("anchor_" + formatExact(anchor.points), Text(anchor.meaning), 1);
      }
    }
  }
  ResultWriter rows(ledger, {.section = ResultSection::kCriterion}, commonFlags(in));
  const std::vector<TraineeCriteria> trainees = traineeCriteria(in);
  const auto addMeans = [&](const std::vector<TraineeCriteria>& all) {
    for (const TraineeCriteria& one : all) {
      for (std::size_t c = 0; c < one.criteria.size(); ++c) {
        rows.place = meanKey(in, ledger, one, c);
        ResultPattern part = rows.place;
        part.statistic = one.trainee.empty() ? rows.place.statistic : kCriterionMark;
        part.of = one.trainee.empty() ? kEach : one.trainee;
        rows.madeOf = partsOf({part});
        rows.add(rows.place.statistic, valueOf(one.criteria[c], fewestFor(in)), one.criteria[c].n);
      }
    }
  };
  addMeans(groupCriteria(in, trainees));
  addMeans(trainees);
  for (const CriterionMark& mark : in.criterionMarks) {
    rows.place = criterionKey(in, mark.sheet, mark.criterion);
    rows.place.of = mark.trainee;
    rows.place.group = ledger.group(mark.group);
    rows.place.index = mark.rater;
    rows.place.occasion = ledger.occasion(mark.occasion);
    rows.madeOf = partsOf({RecordRef{RecordKind::kMark, mark.mark}});
    rows.add(kCriterionMark, mark.points, mark.points ? 1 : 0);
  }
}

}  // namespace torsio
