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
#include "assessment/results/report_sections.h"
#include "assessment/results/result_writer.h"
#include "assessment/results/shown_inputs.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr const char* kCriterionMark = "criterion_mark";
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

/// Returns the key for the mean of a group or trainee for a criterion.
ResultKey meanKey(const CohortInputs& in, const TraineeCriteria& one, std::size_t criterion) {
  ResultKey key = criterionKey(in, one.sheet, criterion);
  key.statistic = "criterion_mean";
  key.of = one.trainee;
  key.group = one.group;
  key.occasion = one.occasion;
  return key;
}

/// Formats "1: hesitates; 10: sure".
Text anchorsOf(const ReportedCriterion& criterion) {
  std::vector<Text> anchors;
  for (const ReportedAnchor& anchor : criterion.anchors) {
    anchors.push_back(Text::verbatim("%1: %2", formatExact(anchor.points), anchor.meaning));
  }
  return anchors.empty() ? Text::tr("none") : listed(anchors, Text::tr("%1; %2"));
}

ReportTable sheetTable(const CohortInputs& in, std::size_t number) {
  const ReportedSheet& sheet = in.sheets[number];
  ReportTable table =
      itemOf<ReportTable>(in, "table-sheet-" + std::to_string(number + 1),
                          Text::tr("Scoring sheet as the raters saw it: %1", titleOf(sheet)), Text());
  table.columns = {Text::tr("Criterion"), Text::tr("Scale"), Text::tr("Weight"),
                   Text::tr("What the marks mean (anchors)")};
  for (const ReportedCriterion& criterion : sheet.criteria) {
    table.rows.push_back({criterion.label,
                          Text::tr("%1 to %2", formatExact(criterion.lowest), formatExact(criterion.highest)),
                          formatExact(criterion.weight), anchorsOf(criterion)});
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

/// Adds the means of a group or trainee to a table's last row.
void addMeans(const CohortInputs& in, const TraineeCriteria& one, ReportTable& table) {
  for (std::size_t c = 0; c < one.criteria.size(); ++c) {
    const std::optional<double> value = valueOf(one.criteria[c], fewestFor(in));
    table.rows.back().push_back(value ? ReportCell(formatFixed(*value, kMeanDecimals), meanKey(in, one, c))
                                      : ReportCell(Text::tr("none")));
  }
}

ReportTable groupsTable(const CohortInputs& in, std::size_t number,
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
    std::int64_t most = 0;
    for (const Mean& mean : group.criteria) {
      most = std::max(most, mean.n);
    }
    table.rows.push_back({in.groups[group.group].name, in.occasions[group.occasion], std::to_string(most)});
    addMeans(in, group, table);
  }
  return table;
}

ReportTable traineesTable(const CohortInputs& in, std::size_t number,
                          const std::vector<TraineeCriteria>& trainees) {
  ReportTable table = itemOf<ReportTable>(in, "table-criteria-trainees-" + std::to_string(number + 1),
                                          Text::tr("Criteria by trainee: %1", titleOf(in.sheets[number])),
                                          Text::tr("mean over the raters"));
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
    std::int64_t most = 0;
    for (const Mean& mean : one->criteria) {
      most = std::max(most, mean.n);
    }
    table.rows.push_back({one->trainee, in.occasions[one->occasion], std::to_string(most)});
    addMeans(in, *one, table);
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

ReportSection criteriaSection(const CohortInputs& in) {
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
    section.tables.push_back(sheetTable(in, i));
    section.tables.push_back(groupsTable(in, i, groups));
    section.tables.push_back(traineesTable(in, i, trainees));
  }
  return section;
}

void addCriteriaResults(const CohortInputs& in, Ledger& ledger) {
  ResultWriter lines(ledger, {.section = ResultSection::kScoringSheet}, commonFlags(in));
  for (std::size_t i = 0; i < in.sheets.size(); ++i) {
    const ReportedSheet& sheet = in.sheets[i];
    lines.place.of = sheet.name;
    lines.place.index = "revision " + std::to_string(sheet.revision);
    lines.place.record = std::to_string(i);
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
        rows.place = meanKey(in, one, c);
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
    rows.place.group = mark.group;
    rows.place.index = mark.rater;
    rows.place.occasion = mark.occasion;
    rows.madeOf = partsOf({RecordRef{RecordKind::kMark, mark.mark}});
    rows.add(kCriterionMark, mark.points, mark.points ? 1 : 0);
  }
}

}  // namespace torsio
