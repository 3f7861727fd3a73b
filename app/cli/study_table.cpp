// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/study_table.h"

#include <algorithm>
#include <utility>

namespace torsio::cli {

namespace {

template <class Items, class Same>
std::size_t place(Items& items, const Same& same, typename Items::value_type item) {
  const auto found = std::find_if(items.begin(), items.end(), same);
  if (found != items.end()) {
    return static_cast<std::size_t>(found - items.begin());
  }
  items.push_back(std::move(item));
  return items.size() - 1;
}

std::size_t placeName(std::vector<std::string>& names, const std::string& name) {
  return place(
      names, [&](const std::string& other) { return other == name; }, name);
}

std::string textOr(const CsvTable& table, std::size_t row, const char* column, const char* otherwise) {
  return table.has(column) ? table.text(row, column) : otherwise;
}

}  // namespace

Study readStudy(const CsvTable& table) {
  Study study;
  std::map<std::pair<std::string, std::string>, std::size_t> rowOf;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = table.text(row, "subject");
    const std::string occasion = textOr(table, row, "occasion", "only");
    const std::size_t group = placeName(study.groups, textOr(table, row, "group", "all"));
    placeName(study.occasions, occasion);
    const auto [first, isNew] = rowOf.emplace(std::pair{name, occasion}, row);
    if (!isNew) {
      table.refuse(
          row,
          "subject \"" + name + "\" has a second score" +
              (table.has("occasion") ? " at occasion \"" + occasion + "\"" : "") + ", first in " +
              table.where(first->second),
          Text::verbatim("Average marks over the raters first: one score for each subject and occasion"));
    }
    const std::size_t s = place(
        study.subjects, [&](const Subject& other) { return other.name == name; },
        Subject{name, group, row, {}});
    if (study.subjects[s].group != group) {
      table.refuse(row,
                   "subject \"" + name + "\" is in group \"" + study.groups[group] +
                       "\", but in another in " + table.where(study.subjects[s].row),
                   Text::verbatim("A subject belongs to one group"));
    }
    if (const auto score = table.numberIfGiven(row, "score")) {
      study.subjects[s].scores[occasion] = *score;
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
    } else {
      ++out.leftOut;
    }
  }
  return out;
}

}  // namespace torsio::cli
