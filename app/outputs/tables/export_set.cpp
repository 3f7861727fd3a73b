// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/tables/export_set.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

#include "assessment/catalogue/quantity.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"

namespace torsio {

namespace {

using Cells = std::vector<ExportCell>;

ExportCell textOf(const std::string& text) {
  return text.empty() ? ExportCell() : ExportCell(text);
}

/// Returns a cell that belongs to a result.
ExportCell cellOf(ExportCell cell, const Result& result) {
  cell.key = std::make_shared<const ResultKey>(result.key);
  return cell;
}

ExportCell numberOf(const Result* result) {
  const std::optional<double> value = result == nullptr ? std::nullopt : numberIn(result->value);
  return value ? cellOf(*value, *result) : ExportCell();
}

/// Returns the text of a cell that is not a number.
ExportCell wordOf(const Result& result) {
  const auto* word = std::get_if<Text>(&result.value);
  return word == nullptr ? ExportCell() : textOf(word->str());
}

ExportCell countOf(std::int64_t count) {
  return static_cast<double>(count);
}

/// Returns the number of values behind a result.
ExportCell valuesOf(const Result& result) {
  return cellOf(countOf(result.n), result);
}

ExportColumn participant() {
  return {"participant", Text::tr("Trainee")};
}
ExportCell timeOf(std::int64_t utc_us) {
  return utc_us > 0 ? ExportCell(utc_us) : ExportCell();
}
ExportCell numberOfGroup(std::size_t group) {
  return countOf(static_cast<std::int64_t>(group) + 1);
}
ExportCell wayOf(MarkWay way) {
  switch (way) {
    case MarkWay::kBlinded:
      return "blinded";
    case MarkWay::kLive:
      return "live";
    case MarkWay::kEntered:
      return "entered";
  }
  return {};
}

ExportColumn number(std::string name, Text title, std::string unit = {}) {
  return {std::move(name), std::move(title), ColumnKind::kNumber, std::move(unit)};
}
ExportColumn yesNo(std::string name, Text title) {
  ExportColumn column = number(std::move(name), std::move(title));
  column.labels = {{0.0, Text::tr("no")}, {1.0, Text::tr("yes")}};
  return column;
}

ExportColumn quantityColumn(std::string name, Quantity quantity) {
  const QuantityRow& row = rowOf(quantity);
  const bool plain = row.unit == "1" || row.unit == "count";
  return number(std::move(name), row.name, plain ? std::string() : std::string(row.unit));
}

/// Returns the columns that vary between runs, named like the statistics in lower case.
std::vector<ExportColumn> trialNumbers() {
  return {number("minutes", Text::tr("Time in the exercise"), "min"),
          quantityColumn("twists", Quantity::kCompletedTwists),
          number("twists_not_completed", Text::tr("Twists not completed")),
          quantityColumn("twists_on_target", Quantity::kTargetsReached),
          number("mean_absolute_error_deg", Text::tr("Mean absolute error of the angle"), "deg"),
          quantityColumn("peak_torque_Nm", Quantity::kPeakTorque),
          quantityColumn("peak_force_N", Quantity::kPeakForce),
          quantityColumn("peak_device_force_N", Quantity::kDeviceForce),
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

/// Builds the tables of a cohort.
class Tables {
 public:
  Tables(const AnalysedCohort& cohort, const std::map<TrialId, std::int64_t>& started)
      : in_(cohort.shown), ledger_(cohort.ledger), started_(started) {}

  ExportSet made() const {
    ExportSet set;
    set.groups = groups();
    set.participants = participants();
    set.scores = scores();
    set.marks = marks();
    set.trials = trials();
    set.twists = twists();
    set.competence = competence();
    set.evaluation = statistics(ResultSection::kEvaluation, Text::tr("Evaluation"),
                                Text::tr("Evaluation of the tissue models by Eqs. 25 to 27"));
    set.agreement = statistics(ResultSection::kAgreement, Text::tr("Agreement"),
                               Text::tr("Agreement of the raters on the marks of the training study"));
    set.comparison = statistics(ResultSection::kComparison, Text::tr("Comparison"),
                                Text::tr("Comparison of the groups on the scores of the training study"));
    set.deviations = deviations();
    set.numbers = numbers();
    return set;
  }

 private:
  [[nodiscard]] ExportColumn groupColumn() const {
    ExportColumn column{"group_name", Text::tr("Group")};
    for (const CohortGroup& group : in_.groups) {
      column.order.push_back(group.name);
    }
    return column;
  }
  [[nodiscard]] ExportColumn occasionColumn() const {
    ExportColumn column{"occasion", Text::tr("Occasion")};
    column.order = in_.occasions;
    return column;
  }
  [[nodiscard]] ExportColumn occasionNumber() const {
    ExportColumn column = number("occasion_number", Text::tr("Number of the occasion"));
    for (std::size_t t = 0; t < in_.occasions.size(); ++t) {
      column.labels.emplace_back(static_cast<double>(t + 1), in_.occasions[t]);
    }
    return column;
  }
  /// Returns a number column whose labels describe the groups.
  [[nodiscard]] ExportColumn groupNumber() const {
    ExportColumn column = number("group_number", Text::tr("Number of the group"));
    for (std::size_t g = 0; g < in_.groups.size(); ++g) {
      const CohortGroup& group = in_.groups[g];
      column.labels.emplace_back(
          static_cast<double>(g + 1),
          group.protocol.empty() ? group.name : Text::verbatim("%1: %2", group.name, group.protocol));
    }
    return column;
  }
  [[nodiscard]] ExportCell groupOf(std::size_t group) const {
    return textOf(in_.groups.at(group).name.str());
  }

  [[nodiscard]] ExportTable groups() const {
    ExportTable table{"groups",
                      Text::tr("Groups"),
                      Text::tr("The groups of the cohort and what their arms of the curriculum plan"),
                      {groupNumber(),
                       groupColumn(),
                       {"code", Text::tr("Code")},
                       {"protocol", Text::tr("Protocol")},
                       {"arm", Text::tr("Arm of the curriculum")},
                       number("planned_virtual_min", Text::tr("Planned on the simulator"), "min"),
                       number("planned_real_min", Text::tr("Planned at the real arm"), "min"),
                       number("trainees", Text::tr("Trainees"))},
                      {}};
    for (std::size_t g = 0; g < in_.groups.size(); ++g) {
      const CohortGroup& group = in_.groups[g];
      const ResultsAt at(ledger_, {.section = ResultSection::kParticipants, .group = ledger_.group(g)});
      table.rows.push_back({numberOfGroup(g), groupOf(g), textOf(group.code), textOf(group.protocol.str()),
                            textOf(group.arm), numberOf(at.find("planned_virtual_min")),
                            numberOf(at.find("planned_real_min")), numberOf(at.find("allocated"))});
    }
    return table;
  }

  [[nodiscard]] ExportTable participants() const {
    ExportTable table{"participants",
                      Text::tr("Participants"),
                      Text::tr("Trainees as they were enrolled, and the times that were noted for them"),
                      {participant(),
                       groupNumber(),
                       groupColumn(),
                       {"sex", Text::tr("Sex")},
                       {"training_level", Text::tr("Level of training")},
                       {"enrolled_utc", Text::tr("Enrolled (UTC)"), ColumnKind::kTime},
                       yesNo("withdrew", Text::tr("Withdrew")),
                       {"withdrew_utc", Text::tr("Withdrew (UTC)"), ColumnKind::kTime},
                       number("virtual_min", Text::tr("Trained on the simulator"), "min"),
                       number("real_min", Text::tr("Trained at the real arm"), "min"),
                       number("rest_min", Text::tr("Rested"), "min"),
                       {"received", Text::tr("Training against the plan of the group")},
                       {"origin", Text::tr("Origin: recorded, simulated or imported")}},
                      {}};
    const ExportCell origin = textOf(std::string(in_.demonstration ? "simulated" : "recorded") +
                                     (in_.imported ? ", imported" : ""));
    for (const CohortTrainee& one : in_.trainees) {
      const ResultsAt at(ledger_, traineeKey(ledger_, one));
      table.rows.push_back({one.code, numberOfGroup(one.group), groupOf(one.group), textOf(one.sex),
                            textOf(one.level), timeOf(one.enrolledUtc_us), numberOf(at.find("withdrew")),
                            timeOf(one.withdrewUtc_us), numberOf(at.find("noted_virtual_min")),
                            numberOf(at.find("noted_real_min")), numberOf(at.find("noted_rest_min")),
                            at.find("received") == nullptr ? ExportCell() : wordOf(*at.find("received")),
                            origin});
    }
    return table;
  }

  [[nodiscard]] ExportTable scores() const {
    ExportTable table{"scores",
                      Text::tr("Scores"),
                      Text::tr("Mean of the raters' marks of a trainee at an occasion"),
                      {participant(),
                       groupColumn(),
                       {"sex", Text::tr("Sex")},
                       {"training_level", Text::tr("Level of training")},
                       occasionNumber(),
                       occasionColumn(),
                       number("score", Text::tr("Score")),
                       number("marks", Text::tr("Marks behind it")),
                       groupNumber()},
                      {}};
    std::map<std::string, const CohortTrainee*> people;
    for (const CohortTrainee& trainee : in_.trainees) {
      people[trainee.code] = &trainee;
    }
    for (const TraineeScore& one : in_.scores) {
      const Result* score = ledger_.find({.statistic = "score",
                                          .of = one.trainee,
                                          .group = ledger_.group(one.group),
                                          .occasion = ledger_.occasion(one.occasion)});
      if (score == nullptr) {
        continue;
      }
      const auto person = people.find(one.trainee);
      const bool known = person != people.end();
      table.rows.push_back({one.trainee, groupOf(one.group), textOf(known ? person->second->sex : ""),
                            textOf(known ? person->second->level : ""),
                            countOf(static_cast<std::int64_t>(one.occasion) + 1),
                            textOf(in_.occasions[one.occasion].str()), numberOf(score), valuesOf(*score),
                            numberOfGroup(one.group)});
    }
    return table;
  }

  /// Returns the marks, and a row without a mark for each that a rater who scored at the occasion did not
  /// give a trainee.
  [[nodiscard]] ExportTable marks() const {
    ExportTable table{
        "marks",
        Text::tr("Marks"),
        Text::tr("Newest version of each mark that a rater submitted; a line without a mark where "
                 "a rater of that occasion gave none"),
        {participant(),
         groupColumn(),
         {"rater", Text::tr("Rater")},
         occasionNumber(),
         occasionColumn(),
         number("mark", Text::tr("Mark")),
         groupNumber(),
         {"rater_class", Text::tr("Class of the rater")},
         {"given", Text::tr("How it was given")},
         number("version", Text::tr("Version of the mark")),
         {"submitted_utc", Text::tr("Submitted (UTC)"), ColumnKind::kTime}},
        {}};
    std::map<std::string, std::string> classOf;
    std::map<std::pair<std::size_t, std::string>, std::set<std::string>> marked;  // by occasion and rater
    const auto add = [&](const std::string& trainee, std::size_t group, const std::string& rater,
                         std::size_t occasion, Cells rest) {
      Cells row{trainee, groupOf(group), rater, countOf(static_cast<std::int64_t>(occasion) + 1),
                textOf(in_.occasions[occasion].str())};
      row.insert(row.end(), rest.begin(), rest.end());
      table.rows.push_back(std::move(row));
    };
    for (const TrainingMark& mark : in_.trainingMarks) {
      const Result* result = ledger_.find({.statistic = "rater_mark",
                                           .of = mark.trainee,
                                           .group = ledger_.group(mark.group),
                                           .index = mark.rater,
                                           .occasion = ledger_.occasion(mark.occasion)});
      if (result != nullptr) {
        classOf[mark.rater] = mark.raterClass;
        marked[{mark.occasion, mark.rater}].insert(mark.trainee);
        add(mark.trainee, mark.group, mark.rater, mark.occasion,
            {numberOf(result), numberOfGroup(mark.group), textOf(mark.raterClass), wayOf(mark.way),
             cellOf(countOf(mark.version), *result), timeOf(mark.submittedUtc_us)});
      }
    }
    for (const auto& [at, trainees] : marked) {
      for (const CohortTrainee& one : in_.trainees) {
        if (!trainees.contains(one.code)) {
          add(one.code, one.group, at.second, at.first,
              {{}, numberOfGroup(one.group), textOf(classOf[at.second]), "missing", {}, {}});
        }
      }
    }
    return table;
  }

  [[nodiscard]] ResultKey runKey(const TrialSummaryRow& trial, std::string statistic) const {
    ResultKey key = trialKey(ledger_, trial);
    key.statistic = std::move(statistic);
    return key;
  }

  [[nodiscard]] ExportTable trials() const {
    ExportTable table{"trials",
                      Text::tr("Recorded runs"),
                      Text::tr("Metrics of each recorded run, measured again from its samples"),
                      {participant(),
                       groupColumn(),
                       number("trial_number", Text::tr("Number of the run")),
                       {"phase", Text::tr("Phase")},
                       {"model", Text::tr("Tissue model")},
                       {"interrupted", Text::tr("Interrupted")},
                       {"outcome", Text::tr("Outcome")},
                       {"started_utc", Text::tr("Started (UTC)"), ColumnKind::kTime},
                       {"trial", Text::tr("Recording")},
                       {"content_hash", Text::tr("Hash of the recording")}},
                      {}};
    std::vector<ExportColumn> numbers = trialNumbers();
    for (const TrialSummaryRow& trial : in_.trials) {
      for (const auto& measured : trial.detorsion) {
        const auto& id = measured.first;
        if (std::none_of(numbers.begin(), numbers.end(), [&](const auto& one) { return one.name == id; })) {
          const std::optional<Quantity> known = quantityOf(id);
          numbers.push_back(known ? quantityColumn(id, *known) : number(id, Text(id)));
        }
      }
    }
    std::map<std::string, std::int64_t> counted;
    for (const TrialSummaryRow& trial : in_.trials) {
      if (ledger_.find(runKey(trial, "minutes")) == nullptr) {
        continue;
      }
      const auto began = started_.find(trial.trialId);
      Cells row{trial.trainee,
                groupOf(trial.group),
                countOf(++counted[trial.trainee]),
                textOf(trial.phase.str()),
                textOf(trial.model),
                trial.interrupted ? "yes" : "no",
                wordOf(*ledger_.find(runKey(trial, "outcome"))),
                began == started_.end() ? ExportCell() : ExportCell(began->second),
                textOf(trial.trialId.text()),
                textOf(trial.contentHash)};
      for (const ExportColumn& column : numbers) {
        row.push_back(numberOf(ledger_.find(runKey(trial, column.name))));
      }
      table.rows.push_back(std::move(row));
    }
    for (ExportColumn& column : numbers) {
      column.name = columnName(column.name);
      table.columns.push_back(std::move(column));
    }
    return table;
  }

  [[nodiscard]] ExportTable twists() const {
    ExportTable table{
        "twists",
        Text::tr("Learning curves"),
        Text::tr("Absolute error of each completed twist when the jaw was opened, in its order"),
        {participant(),
         groupColumn(),
         number("trial_number", Text::tr("Number of the run")),
         {"phase", Text::tr("Phase")},
         number("twist_number", Text::tr("Number of the twist")),
         number("twist_error_deg", Text::tr("Error of the angle"), "deg"),
         groupNumber()},
        {}};
    std::map<std::string, std::int64_t> counted;
    for (const TrialSummaryRow& trial : in_.trials) {
      const std::int64_t run = ++counted[trial.trainee];
      ResultKey key = runKey(trial, "twist_error_deg");
      for (key.number = 1; const Result* twist = ledger_.find(key); ++key.number) {
        table.rows.push_back({trial.trainee, groupOf(trial.group), countOf(run), textOf(trial.phase.str()),
                              countOf(key.number), numberOf(twist), numberOfGroup(trial.group)});
      }
    }
    return table;
  }

  [[nodiscard]] ExportTable competence() const {
    std::vector<ExportColumn> numbers = {
        number("failed", Text::tr("Failed runs")),
        yesNo("able", Text::tr("Competent")),
        number("able_at_attempt", Text::tr("Competent at run")),
        number("false_pass", Text::tr("Probability of a false pass within the runs made")),
        number("false_fail", Text::tr("Probability of a false fail within the runs made")),
        number("false_alarm", Text::tr("Probability of a false alarm within the runs made"))};
    for (const bool planned : {false, true}) {
      for (std::size_t rate = 0; rate < kStatedFailureRates.size(); ++rate) {
        const std::string share = formatFixed(100.0 * kStatedFailureRates[rate], 0);
        numbers.push_back(number(
            declaredStatistic(rate, planned),
            planned
                ? Text::tr("Probability of being declared competent within the runs planned, failing %1 %",
                           share)
                : Text::tr("Probability of being declared competent within the runs made, failing %1 %",
                           share)));
      }
    }
    numbers.push_back(number("planned_attempts", Text::tr("Runs planned")));
    numbers.push_back(number("fewest_attempts", Text::tr("Fewest runs that can show competence")));
    numbers.push_back(number("design_version", Text::tr("Version of the design")));
    ExportTable table{"competence",
                      Text::tr("Competence"),
                      Text::tr("Verdict of the registered competence design, with both error rates"),
                      {participant(),
                       groupColumn(),
                       {"exercise", Text::tr("Exercise")},
                       {"level", Text::tr("Level reached")},
                       number("attempts", Text::tr("Runs"))},
                      {}};
    table.columns.insert(table.columns.end(), numbers.begin(), numbers.end());
    for (const Result* level :
         ledger_.select({.section = ResultSection::kCompetence, .statistic = "level", .of = kEach})) {
      ResultKey key = level->key;
      Cells row{key.of, textOf(key.group), textOf(key.index), wordOf(*level), valuesOf(*level)};
      for (const ExportColumn& column : numbers) {
        key.statistic = column.name;
        row.push_back(numberOf(ledger_.find(key)));
      }
      table.rows.push_back(std::move(row));
    }
    return table;
  }

  /// Returns the columns of a row of cohort.csv, from its subject to its flags.
  [[nodiscard]] std::vector<ExportColumn> lineColumns() const {
    return {{"item", Text::tr("Trainee, rater or all")},
            {"group_name", Text::tr("Group")},  // or a pair of groups
            {"model", Text::tr("Tissue model")},
            {"index_name", Text::tr("Index")},
            occasionColumn(),
            {"statistic", Text::tr("Statistic")},
            number("value", Text::tr("Value")),
            {"value_text", Text::tr("Value as text")},
            number("n", Text::tr("Values used")),
            {"flags", Text::tr("Flags")}};
  }
  [[nodiscard]] Cells lineOf(const Result& result, ExportCell text) const {
    Cells row;
    const std::array<std::string, 7> cells = keyCells(result.key);
    std::transform(std::next(cells.begin()), cells.end(), std::back_inserter(row), textOf);
    row.push_back(numberOf(&result));
    row.push_back(std::move(text));
    row.push_back(valuesOf(result));
    row.push_back(textOf(result.flags));
    return row;
  }

  /// Returns one row per result of a section.
  [[nodiscard]] ExportTable statistics(ResultSection section, const Text& title, const Text& source) const {
    ExportTable table{std::string(sectionName(section)), title, source, lineColumns(), {}};
    ledger_.eachLine([&](const Result& result) {
      if (result.key.section == section) {
        table.rows.push_back(lineOf(result, wordOf(result)));
      }
    });
    return table;
  }

  [[nodiscard]] ExportTable numbers() const {
    ExportTable table{
        "numbers",
        Text::tr("All numbers"),
        Text::tr("Every line of cohort.csv; a spreadsheet keeps 15 digits, the text all of them"),
        lineColumns(),
        {}};
    table.columns.insert(table.columns.begin(), {"section", Text::tr("Section")});
    ledger_.eachLine([&](const Result& result) {
      Cells row = lineOf(result, textOf(resultText(result.value)));
      row.insert(row.begin(), std::string(sectionName(result.key.section)));
      table.rows.push_back(std::move(row));
    });
    return table;
  }

  [[nodiscard]] ExportTable deviations() const {
    ExportTable table{"deviations",
                      Text::tr("Protocol deviations"),
                      Text::tr("What did not go by the protocol, as it was noted"),
                      {participant(),
                       {"happened_utc", Text::tr("Happened (UTC)")},
                       {"kind", Text::tr("Kind")},
                       {"description", Text::tr("Description")}},
                      {}};
    for (const Result& result : ledger_.every()) {
      if (result.key.section == ResultSection::kDeviation) {
        table.rows.push_back({result.key.of.empty() ? "all" : result.key.of, result.key.when,
                              result.key.statistic, wordOf(result)});
      }
    }
    return table;
  }

  const CohortInputs& in_;
  const Ledger& ledger_;
  const std::map<TrialId, std::int64_t>& started_;
};

}  // namespace

ExportSet exportSet(const AnalysedCohort& cohort, const std::map<TrialId, std::int64_t>& startedUtc_us) {
  return Tables(cohort, startedUtc_us).made();
}

std::vector<const ExportTable*> tablesOf(const ExportSet& set) {
  return {&set.scores,     &set.marks,  &set.participants, &set.groups, &set.evaluation, &set.agreement,
          &set.comparison, &set.twists, &set.competence,   &set.trials, &set.deviations, &set.numbers};
}

}  // namespace torsio
