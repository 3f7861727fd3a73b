// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/tables/export_set.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "assessment/results/cohort_csv.h"

namespace torsio {

namespace {

using Row = CohortCsvRow;
using Cells = std::vector<ExportCell>;

ExportCell numberOf(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end ? ExportCell(value) : ExportCell();
}

ExportCell textOf(const std::string& text) {
  return text.empty() ? ExportCell() : ExportCell(text);
}

/// A row, each cell made where it stays.
template <typename... Values>
Cells rowOf(Values&&... values) {
  Cells cells;
  cells.reserve(sizeof...(values));
  (cells.emplace_back(std::forward<Values>(values)), ...);
  return cells;
}

/// What is no number.
ExportCell wordOf(const std::string& text) {
  return std::holds_alternative<double>(numberOf(text)) ? ExportCell() : textOf(text);
}

ExportColumn participant() {
  return {"participant", Text::tr("Trainee")};
}
ExportColumn groupColumn() {
  return {"group_name", Text::tr("Group")};
}
ExportColumn occasionColumn() {
  return {"occasion", Text::tr("Occasion")};
}
ExportColumn number(std::string name, Text title, std::string unit = {}) {
  return {std::move(name), std::move(title), ColumnKind::kNumber, std::move(unit)};
}

/// What varies from trial to trial; the name is the statistic of cohort.csv.
std::vector<ExportColumn> trialNumbers() {
  return {number("minutes", Text::tr("Time in the exercise"), "min"),
          number("twists", Text::tr("Twists")),
          number("twists_not_completed", Text::tr("Twists not completed")),
          number("twists_on_target", Text::tr("Twists released on target")),
          number("mean_absolute_error_deg", Text::tr("Mean absolute error of the angle"), "deg"),
          number("peak_torque_Nm", Text::tr("Peak torque"), "N m"),
          number("peak_force_N", Text::tr("Peak force on the tissue"), "N"),
          number("peak_device_force_N", Text::tr("Peak force of the device"), "N"),
          number("refused_samples", Text::tr("Samples that were refused")),
          number("force_cuts", Text::tr("Pauses without force"))};
}

std::string columnName(const std::string& statistic) {
  std::string name;
  for (const char c : statistic) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    name += upper ? static_cast<char>(c - 'A' + 'a') : plain ? c : '_';
  }
  return name;
}

/// Walks through the rows of cohort.csv and fills the tables.
class Sorter {
 public:
  Sorter(const CohortInputs& in, const std::vector<CohortCsvRow>& rows,
         const std::map<TrialId, std::int64_t>& started)
      : started_(started), rows_(rows) {
    for (std::size_t i = 0; i < in.occasions.size(); ++i) {
      occasions_[in.occasions[i].str()] = static_cast<double>(i + 1);
    }
    for (const CohortTrainee& trainee : in.trainees) {
      people_[trainee.code] = &trainee;
    }
  }

  ExportSet sorted() {
    ExportSet set;
    fillScores(set);
    fillTrials(set);
    fillCompetence(set);
    set.evaluation = statistics("evaluation", Text::tr("Evaluation"),
                                Text::tr("Evaluation of the tissue models by Eqs. 25 to 27"));
    set.agreement = statistics("agreement", Text::tr("Agreement"),
                               Text::tr("Agreement of the raters on the marks of the training study"));
    set.comparison = statistics("comparison", Text::tr("Comparison"),
                                Text::tr("Comparison of the groups on the scores of the training study"));
    fillDeviations(set);
    fillNumbers(set);
    return set;
  }

 private:
  [[nodiscard]] ExportCell occasionOf(const Row& row) const {
    const auto found = occasions_.find(row.occasion);
    return found == occasions_.end() ? ExportCell() : ExportCell(found->second);
  }

  [[nodiscard]] ExportColumn occasionNumber() const {
    ExportColumn column = number("occasion_number", Text::tr("Number of the occasion"));
    for (const auto& [name, place] : occasions_) {
      column.labels.emplace_back(place, name);
    }
    std::sort(column.labels.begin(), column.labels.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    return column;
  }

  void fillScores(ExportSet& set) const {
    set.scores = {"scores",
                  Text::tr("Scores"),
                  Text::tr("Mean of the raters' marks of a trainee at an occasion"),
                  {participant(),
                   groupColumn(),
                   {"sex", Text::tr("Sex")},
                   {"training_level", Text::tr("Level of training")},
                   occasionNumber(),
                   occasionColumn(),
                   number("score", Text::tr("Score")),
                   number("marks", Text::tr("Marks behind it"))},
                  {}};
    set.marks = {"marks",
                 Text::tr("Marks"),
                 Text::tr("Newest version of each mark that a rater submitted"),
                 {participant(),
                  groupColumn(),
                  {"rater", Text::tr("Rater")},
                  occasionNumber(),
                  occasionColumn(),
                  number("mark", Text::tr("Mark"))},
                 {}};
    for (const Row& row : rows_) {
      if (row.section != "training") {
        continue;
      }
      if (row.statistic == "score") {
        const auto person = people_.find(row.item);
        const CohortTrainee* known = person == people_.end() ? nullptr : person->second;
        set.scores.rows.push_back(rowOf(row.item, textOf(row.group), textOf(known ? known->sex : ""),
                                        textOf(known ? known->level : ""), occasionOf(row),
                                        textOf(row.occasion), numberOf(row.value), numberOf(row.n)));
      } else if (row.statistic == "rater_mark") {
        set.marks.rows.push_back(rowOf(row.item, textOf(row.group), textOf(row.index), occasionOf(row),
                                       textOf(row.occasion), numberOf(row.value)));
      }
    }
  }

  void fillTrials(ExportSet& set) const {
    std::vector<ExportColumn> numbers = trialNumbers();
    std::map<std::string, std::size_t> place;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      place[numbers[i].name] = i;
    }
    for (const Row& row : rows_) {  // an untwisting has metrics of its own
      const bool text = row.statistic == "trial" || row.statistic == "content_hash";
      if (row.section == "trial" && !text && row.index.empty() && !place.contains(row.statistic)) {
        place[row.statistic] = numbers.size();
        numbers.push_back(number(columnName(row.statistic), row.statistic));
      }
    }
    const std::vector<ExportColumn> head = {participant(),
                                            groupColumn(),
                                            number("trial_number", Text::tr("Number of the run")),
                                            {"phase", Text::tr("Phase")},
                                            {"model", Text::tr("Tissue model")},
                                            {"interrupted", Text::tr("Interrupted")},
                                            {"started_utc", Text::tr("Started (UTC)"), ColumnKind::kTime},
                                            {"trial", Text::tr("Recording")},
                                            {"content_hash", Text::tr("Hash of the recording")}};
    set.trials = {"trials",
                  Text::tr("Recorded runs"),
                  Text::tr("Metrics of each recorded run, measured again from its samples"),
                  head,
                  {}};
    for (ExportColumn& column : numbers) {
      column.name = columnName(column.name);
      set.trials.columns.push_back(column);
    }
    set.twists = {"twists",
                  Text::tr("Learning curves"),
                  Text::tr("Absolute error of each completed twist when the jaw was opened, in its order"),
                  {participant(),
                   groupColumn(),
                   number("trial_number", Text::tr("Number of the run")),
                   {"phase", Text::tr("Phase")},
                   number("twist_number", Text::tr("Number of the twist")),
                   number("twist_error_deg", Text::tr("Error of the angle"), "deg")},
                  {}};
    std::map<std::string, double> counted;
    for (const Row& row : rows_) {
      if (row.section != "trial") {
        continue;
      }
      if (row.statistic == "minutes") {  // a trial begins
        Cells cells(set.trials.columns.size());
        cells[0] = row.item;
        cells[1] = textOf(row.group);
        cells[2] = ++counted[row.item];
        cells[3] = textOf(row.occasion);
        cells[4] = textOf(row.model);
        cells[5] = row.flags.find("interrupted") == std::string::npos ? "no" : "yes";
        set.trials.rows.push_back(std::move(cells));
      }
      Cells& trial = set.trials.rows.back();
      if (row.statistic == "trial") {
        trial[7] = textOf(row.value);
        const auto began = started_.find(TrialId(row.value));
        trial[6] = began == started_.end() ? ExportCell() : ExportCell(began->second);
      } else if (row.statistic == "content_hash") {
        trial[8] = textOf(row.value);
      } else if (!row.index.empty()) {
        set.twists.rows.push_back(rowOf(row.item, textOf(row.group), counted[row.item], textOf(row.occasion),
                                        numberOf(row.index), numberOf(row.value)));
      } else {
        trial[head.size() + place.at(row.statistic)] = numberOf(row.value);
      }
    }
  }

  void fillCompetence(ExportSet& set) const {
    set.competence = {"competence",
                      Text::tr("Competence"),
                      Text::tr("Verdict of the registered competence design, with both error rates"),
                      {participant(),
                       groupColumn(),
                       {"exercise", Text::tr("Exercise")},
                       {"level", Text::tr("Level reached")},
                       number("attempts", Text::tr("Attempts")),
                       number("failed", Text::tr("Failed attempts")),
                       {"able",
                        Text::tr("Competent"),
                        ColumnKind::kNumber,
                        {},
                        {{0.0, Text::tr("no")}, {1.0, Text::tr("yes")}}},
                       number("able_at_attempt", Text::tr("Competent at attempt")),
                       number("false_pass", Text::tr("Probability of a false pass")),
                       number("false_fail", Text::tr("Probability of a false fail")),
                       number("false_alarm", Text::tr("Probability of a false alarm")),
                       number("within_attempts", Text::tr("Attempts within which both hold")),
                       number("design_version", Text::tr("Version of the design"))},
                      {}};
    for (const Row& row : rows_) {
      if (row.section != "competence") {
        continue;
      }
      if (row.statistic == "level") {
        Cells cells(set.competence.columns.size());
        cells[0] = row.item;
        cells[1] = textOf(row.group);
        cells[2] = textOf(row.index);
        cells[3] = textOf(row.value);
        cells[4] = numberOf(row.n);
        set.competence.rows.push_back(std::move(cells));
        continue;
      }
      const auto column = std::find_if(set.competence.columns.begin(), set.competence.columns.end(),
                                       [&](const ExportColumn& one) { return one.name == row.statistic; });
      if (column != set.competence.columns.end()) {
        set.competence.rows.back()[static_cast<std::size_t>(column - set.competence.columns.begin())] =
            numberOf(row.value);
      }
    }
  }

  /// One line a number of a section.
  [[nodiscard]] ExportTable statistics(const std::string& section, const Text& title,
                                       const Text& source) const {
    ExportTable table{section,
                      title,
                      source,
                      {{"item", Text::tr("Trainee, rater or all")},
                       groupColumn(),
                       {"model", Text::tr("Tissue model")},
                       {"index_name", Text::tr("Index")},
                       occasionColumn(),
                       {"statistic", Text::tr("Statistic")},
                       number("value", Text::tr("Value")),
                       {"value_text", Text::tr("Value as text")},
                       number("n", Text::tr("Values used")),
                       {"flags", Text::tr("Flags")}},
                      {}};
    for (const Row& row : rows_) {
      if (row.section == section) {
        table.rows.push_back(rowOf(textOf(row.item), textOf(row.group), textOf(row.model), textOf(row.index),
                                   textOf(row.occasion), row.statistic, numberOf(row.value),
                                   wordOf(row.value), numberOf(row.n), textOf(row.flags)));
      }
    }
    return table;
  }

  void fillDeviations(ExportSet& set) const {
    set.deviations = {"deviations",
                      Text::tr("Protocol deviations"),
                      Text::tr("What did not go by the protocol, as it was noted"),
                      {participant(),
                       {"happened_utc", Text::tr("Happened (UTC)")},
                       {"kind", Text::tr("Kind")},
                       {"description", Text::tr("Description")}},
                      {}};
    for (const Row& row : rows_) {
      if (row.section == "deviation") {
        set.deviations.rows.push_back(
            {textOf(row.item), textOf(row.occasion), row.statistic, textOf(row.value)});
      }
    }
  }

  void fillNumbers(ExportSet& set) const {
    set.numbers = {"numbers",
                   Text::tr("All numbers"),
                   Text::tr("Every line of cohort.csv; a spreadsheet keeps 15 digits, the text all of them"),
                   {{"section", Text::tr("Section")},
                    {"item", Text::tr("Trainee, rater or all")},
                    groupColumn(),
                    {"model", Text::tr("Tissue model")},
                    {"index_name", Text::tr("Index")},
                    occasionColumn(),
                    {"statistic", Text::tr("Statistic")},
                    number("value", Text::tr("Value")),
                    {"value_text", Text::tr("Value as text")},
                    number("n", Text::tr("Values used")),
                    {"flags", Text::tr("Flags")}},
                   {}};
    for (const Row& row : rows_) {
      set.numbers.rows.push_back(rowOf(textOf(row.section), textOf(row.item), textOf(row.group),
                                       textOf(row.model), textOf(row.index), textOf(row.occasion),
                                       row.statistic, numberOf(row.value), textOf(row.value), numberOf(row.n),
                                       textOf(row.flags)));
    }
  }

  std::map<std::string, double> occasions_;
  std::map<std::string, const CohortTrainee*> people_;
  const std::map<TrialId, std::int64_t>& started_;
  const std::vector<Row>& rows_;
};

}  // namespace

ExportSet exportSet(const CohortInputs& inputs, const std::vector<CohortCsvRow>& rows,
                    const std::map<TrialId, std::int64_t>& startedUtc_us) {
  return Sorter(inputs, rows, startedUtc_us).sorted();
}

std::vector<const ExportTable*> tablesOf(const ExportSet& set) {
  return {&set.scores, &set.marks,      &set.evaluation, &set.agreement,  &set.comparison,
          &set.twists, &set.competence, &set.trials,     &set.deviations, &set.numbers};
}

}  // namespace torsio
