// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/standard_tables.h"

#include <map>
#include <utility>

#include "app/services/base/name_places.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Throws on a second row with the same name, which would be the same person.
class NamesOnce {
 public:
  NamesOnce(const CsvTable& table, const std::string& column) : table_(table), column_(column) {}

  void take(std::size_t row) {
    const auto [first, isNew] = rowOf_.emplace(table_.text(row, column_), row);
    if (!isNew) {
      table_.refuse(row,
                    Text::tr("%1 \"%2\" is listed twice, first in %3", column_, first->first,
                             table_.where(first->second)),
                    Text::tr("Keep one row for each %1", column_));
    }
  }

 private:
  const CsvTable& table_;
  std::string column_;
  std::map<std::string, std::size_t> rowOf_;
};

}  // namespace

JudgedItems readJudgedItems(const CsvTable& table) {
  NamePlaces judges;
  NamePlaces items;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> rowOf;  // judge, item
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& judge = table.text(row, "judge");
    const std::string& item = table.text(row, "item");
    const auto [first, isNew] = rowOf.emplace(std::pair{judges(judge), items(item)}, row);
    if (!isNew) {
      table.refuse(row,
                   Text::tr("judge \"%1\" judges item \"%2\" a second time, first in %3", judge, item,
                            table.where(first->second)),
                   Text::tr("Keep one percentage for each judge and item"));
    }
  }
  JudgedItems out{judges.names(), items.names(), NumberTable(judges.names().size(), items.names().size())};
  for (std::size_t judge = 0; judge < out.judges.size(); ++judge) {
    for (std::size_t item = 0; item < out.items.size(); ++item) {
      const auto found = rowOf.find({judge, item});
      if (found == rowOf.end()) {
        refuse(Text::tr("judge \"%1\" has no percentage for item \"%2\"", out.judges[judge], out.items[item]),
               table.name(), Text::tr("Every judge judges every item"));
      }
      const double value = table.number(found->second, "percent");
      if (value < 0.0 || value > 100.0) {
        table.refuse(found->second,
                     Text::tr("the percentage %1 is outside 0 to 100", table.cell(found->second, "percent")),
                     Text::tr("Give the chance of a borderline trainee in percent"));
      }
      out.percent.at(judge, item) = value;
    }
  }
  return out;
}

RatedScores readRatedScores(const CsvTable& table) {
  RatedScores out;
  NamesOnce subjects(table, "subject");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    subjects.take(row);
    out.ratings.push_back(table.number(row, "global"));
    out.scores.push_back(table.number(row, "score"));
  }
  return out;
}

ContrastedScores readContrastedScores(const CsvTable& table) {
  ContrastedScores out;
  NamesOnce subjects(table, "subject");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    subjects.take(row);
    const std::string& group = table.text(row, "group");
    if (group != "novice" && group != "master") {
      table.refuse(row, Text::tr("\"%1\" is not a group of this method", group),
                   Text::tr("Write novice or master"));
    }
    (group == "novice" ? out.novices : out.masters).push_back(table.number(row, "score"));
  }
  return out;
}

std::vector<double> readExpertValues(const CsvTable& table) {
  std::vector<double> out;
  NamesOnce experts(table, "expert");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    experts.take(row);
    out.push_back(table.number(row, "value"));
  }
  return out;
}

}  // namespace torsio
