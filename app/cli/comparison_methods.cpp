// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/comparison_methods.h"

#include <utility>

#include "app/services/base/name_places.h"

namespace torsio::cli {

namespace {

std::string textOr(const CsvTable& table, std::size_t row, const char* column, const char* otherwise) {
  return table.has(column) ? table.text(row, column) : otherwise;
}

/// Throws for a duplicate score.
void refuseSecond(const CsvTable& table, std::size_t row, std::size_t firstRow) {
  const bool rated = table.has("rater");
  std::string what = "subject \"" + table.text(row, "subject") + "\" has a second score";
  if (table.has("occasion")) {
    what += " at occasion \"" + table.text(row, "occasion") + "\"";
  }
  if (rated) {
    what += " by rater \"" + table.text(row, "rater") + "\"";
  }
  table.refuse(row, what + ", first in " + table.where(firstRow),
               rated
                   ? Text::verbatim("Keep one score for each subject, occasion and rater")
                   : Text::verbatim("Give one score for each subject and occasion, or the raters in a column "
                                    "\"rater\""));
}

}  // namespace

Study readStudy(const CsvTable& table) {
  const bool rated = table.has("rater");
  NamePlaces groups;
  NamePlaces occasions;
  NamePlaces raters;
  NamePlaces subjects;
  Study study;
  std::map<std::pair<std::size_t, std::string>, std::map<std::size_t, std::size_t>>
      rowOf;  // inner key: rater
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = table.text(row, "subject");
    const std::string occasion = textOr(table, row, "occasion", "only");
    const std::size_t group = groups(textOr(table, row, "group", "all"));
    occasions(occasion);
    const std::size_t rater = rated ? raters(table.text(row, "rater")) : 0;
    const std::size_t s = subjects(name);
    if (s == study.subjects.size()) {
      study.subjects.push_back({.name = name, .group = group, .row = row});
    }
    const auto [first, isNew] = rowOf[{s, occasion}].emplace(rater, row);
    if (!isNew) {
      refuseSecond(table, row, first->second);
    }
    if (study.subjects[s].group != group) {
      table.refuse(row,
                   "subject \"" + name + "\" is in group \"" + groups.names()[group] +
                       "\", but in another in " + table.where(study.subjects[s].row),
                   Text::verbatim("A subject belongs to one group"));
    }
  }
  study.groups = groups.names();
  study.occasions = occasions.names();
  study.raters = raters.names();
  for (const auto& [at, rows] : rowOf) {
    std::vector<std::optional<double>> marks(rated ? study.raters.size() : 1);
    for (const auto& [rater, row] : rows) {
      marks[rater] = table.numberIfGiven(row, "score");
    }
    Subject& subject = study.subjects[at.first];
    if (const std::optional<double> score = meanMark(marks)) {
      subject.scores[at.second] = *score;
    }
    if (rated) {
      subject.marks[at.second] = std::move(marks);
    }
  }
  return study;
}

Groups scoresAt(const Study& study, const std::string& occasion) {
  Groups groups(study.groups.size());
  for (const Subject& subject : study.subjects) {
    if (const auto score = subject.scores.find(occasion); score != subject.scores.end()) {
      groups[subject.group].push_back(score->second);
    }
  }
  return groups;
}

CompleteSubjects completeSubjects(const Study& study, std::size_t group,
                                  const std::vector<std::string>& occasions) {
  CompleteSubjects out;
  for (const Subject& subject : study.subjects) {
    if (subject.group != group) {
      continue;
    }
    std::vector<double> row;
    for (const std::string& occasion : occasions) {
      if (const auto score = subject.scores.find(occasion); score != subject.scores.end()) {
        row.push_back(score->second);
      }
    }
    if (row.size() == occasions.size()) {
      out.scores.push_back(std::move(row));
      out.names.push_back(subject.name);
    } else {
      out.leftOut.push_back(subject.name);
    }
  }
  return out;
}

std::vector<MarkedTrainee> markedSubjects(const Study& study, const std::string& before,
                                          const std::string& after) {
  const std::vector<std::optional<double>> none(study.raters.size());
  const auto at = [&](const Subject& subject, const std::string& occasion) {
    const auto found = subject.marks.find(occasion);
    return found == subject.marks.end() ? none : found->second;
  };
  std::vector<MarkedTrainee> out;
  out.reserve(study.subjects.size());
  for (const Subject& subject : study.subjects) {
    out.push_back({subject.group, at(subject, before), at(subject, after)});
  }
  return out;
}

}  // namespace torsio::cli
