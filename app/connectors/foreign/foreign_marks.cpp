// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/foreign/foreign_marks.h"

#include <algorithm>
#include <sstream>

#include "app/connectors/foreign/parquet_table.h"
#include "app/services/base/csv_table.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

/// The recording whose file has this stem.
const ForeignRecording* recordingOfStem(const ForeignMap& map, const std::string& stem) {
  const auto found = std::find_if(
      map.recordings.begin(), map.recordings.end(),
      [&](const ForeignRecording& one) { return one.name == stem || one.file.stem().string() == stem; });
  return found == map.recordings.end() ? nullptr : &*found;
}

constexpr std::size_t kMaxMarkBytes = 64U << 20U;

/// The columns of a Parquet file as the text of a table.
CsvTable markTable(const std::filesystem::path& file) {
  const std::vector<std::string> columns{"recording", "rater", "score"};
  ParquetTable table(file, file.filename().string(), columns);
  std::string text = csvLine(columns);
  for (std::vector<std::string> cells; table.next(cells);) {
    text += csvLine(cells);
    if (text.size() > kMaxMarkBytes) {
      refuse(Text::tr("the table of marks has more than 64 MiB"), file.filename().string(),
             Text::tr("Choose the file with the columns recording, rater and score"));
    }
  }
  return CsvTable::parse(text, file.filename().string(), {"recording", "rater", "score"});
}

}  // namespace

std::vector<ForeignMark> jigsawsMarks(const std::filesystem::path& file, const std::string& rater,
                                      const ForeignMap& map) {
  std::istringstream lines(readFile(file));
  std::vector<ForeignMark> marks;
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string name;
    std::string skill;
    std::string total;
    words >> name >> skill >> total;
    const ForeignRecording* recording = name.empty() ? nullptr : recordingOfStem(map, name);
    if (recording == nullptr) {
      continue;
    }
    const std::string where = file.filename().string() + ", line " + std::to_string(number);
    if (total.empty()) {
      refuse(Text::tr("the line ends before the score"), where,
             Text::tr("It needs the recording's name, a skill and the total"));
    }
    marks.push_back({recording->name, rater, stepsFromText(total, map.scale, where)});
  }
  if (marks.empty()) {
    refuse(Text::tr("there is no mark of any recording of the map"), file.filename().string(),
           Text::tr("Check the names of the recordings"));
  }
  return marks;
}

std::vector<ForeignMark> tabledMarks(const std::filesystem::path& file, const ForeignMap& map) {
  const CsvTable table =
      isParquet(file) ? markTable(file) : CsvTable::read(file, {"recording", "rater", "score"});
  std::vector<ForeignMark> marks;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = table.text(row, "recording");
    const std::string& rater = table.text(row, "rater");
    const ForeignRecording* recording = recordingOfStem(map, name);
    if (recording == nullptr) {
      table.refuse(row, Text::tr("the map lists no recording '%1'", name), Text::tr("Enter it in the map"));
    }
    const bool known = std::any_of(map.raters.begin(), map.raters.end(),
                                   [&](const ForeignRater& one) { return one.name == rater; });
    if (!known) {
      table.refuse(row, Text::tr("the map lists no rater '%1'", rater), Text::tr("Enter them in the map"));
    }
    marks.push_back(
        {recording->name, rater, stepsFromText(table.text(row, "score"), map.scale, table.where(row))});
  }
  return marks;
}

}  // namespace torsio
