// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/base/csv_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <unordered_set>

#include "app/services/base/identifiers.h"
#include "sim/core/byte_order_mark.h"
#include "sim/core/contracts.h"
#include "sim/core/csv_cell.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

/// The columns of tables that name people and things.
constexpr std::array<std::string_view, 11> kIdentifiers = {"model", "subject", "group",    "occasion",
                                                           "rater", "target",  "task",     "judge",
                                                           "item",  "expert",  "recording"};
constexpr std::size_t kShown = 60;  // characters of an invalid value shown in messages

[[noreturn]] void refuseAt(const std::string& name, std::size_t line, const Text& what, const Text& remedy) {
  refuse(what, Text::tr("%1, line %2", name, line), remedy);
}

std::string inQuotes(std::string_view value) {
  std::string text(1, '"');
  text.append(value.substr(0, kShown)).append(value.size() > kShown ? "...\"" : "\"");
  return text;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Returns the position of the first byte that is not valid UTF-8 (overlong forms and surrogates are
/// invalid).
std::size_t firstNoUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) {
      return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0U;
    };
    const unsigned lead = byte(0);
    const std::size_t length = lead < 0x80 ? 1 : lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if (length == 0 || lead > 0xF4 || lead == 0) {
      return i;
    }
    for (std::size_t k = 1; k < length; ++k) {
      if ((byte(k) & 0xC0U) != 0x80U) {
        return i;
      }
    }
    if ((lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) > 0x9F) ||
        (lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) > 0x8F)) {
      return i;
    }
    i += length;
  }
  return std::string_view::npos;
}

/// Reads records; a quoted value may span lines.
class Reader {
 public:
  Reader(std::string_view text, const std::string& name, char separator)
      : text_(text), name_(name), separator_(separator), valueEnds_({separator, '\r', '\n'}) {}

  /// Returns false at the end. `line`: first line of the record.
  bool next(std::vector<std::string>& values, std::size_t& line) {
    while (at_ < text_.size() && endOfLine()) {
    }
    if (at_ >= text_.size()) {
      return false;
    }
    line = line_;
    values.clear();
    while (true) {
      values.push_back(value());
      if (at_ >= text_.size() || endOfLine()) {
        return true;
      }
      ++at_;  // the separator
    }
  }

 private:
  bool endOfLine() {
    if (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') {
      ++at_;
    }
    if (text_[at_] != '\n' && text_[at_] != '\r') {
      return false;
    }
    ++at_;
    ++line_;
    return true;
  }

  std::string value() {
    const std::size_t start = text_.find_first_not_of(blanks(), at_);
    if (start != std::string_view::npos && text_[start] == '"') {
      at_ = start + 1;
      return quotedValue();
    }
    const std::size_t end = std::min(text_.find_first_of(valueEnds_, at_), text_.size());
    const std::string_view raw = text_.substr(at_, end - at_);
    if (raw.find('"') != std::string_view::npos) {
      refuseAt(name_, line_,
               Text::tr("there is a quote inside the value %1", std::string(trimmed(raw).substr(0, kShown))),
               Text::tr("Put the whole value in quotes and double each quote in it"));
    }
    at_ = end;
    return std::string(trimmed(raw));
  }

  std::string quotedValue() {
    const std::size_t begun = line_;
    std::string value;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '"') {
        if (at_ + 1 >= text_.size() || text_[at_ + 1] != '"') {
          break;
        }
        ++at_;
      } else if (text_[at_] == '\n') {
        ++line_;
      }
      value.push_back(text_[at_]);
    }
    if (at_ >= text_.size()) {
      refuseAt(name_, begun, Text::tr("a quote does not close"), Text::tr("Close the quoted value"));
    }
    at_ = std::min(text_.find_first_not_of(blanks(), at_ + 1), text_.size());
    if (at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\n' && text_[at_] != '\r') {
      refuseAt(name_, line_, Text::tr("text follows the quoted value %1", inQuotes(value)),
               Text::tr("End the value at the closing quote"));
    }
    return value;
  }

  [[nodiscard]] std::string_view blanks() const { return separator_ == '\t' ? " " : " \t"; }

  std::string_view text_;
  const std::string& name_;
  char separator_;
  std::string valueEnds_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

std::string listed(std::initializer_list<std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) {
    text.append(text.empty() ? "" : ",").append(name);
  }
  return text;
}

/// Returns whether the text consists of digits with one comma: 7,5.
bool hasDecimalComma(std::string_view text) {
  const std::size_t comma = text.find(',');
  return comma != std::string_view::npos && text.find(',', comma + 1) == std::string_view::npos &&
         text.find_first_not_of("0123456789,+-eE") == std::string_view::npos;
}

bool isDigits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Skips a byte order mark and throws if the text is not UTF-8.
std::string_view checkedText(std::string_view text, const std::string& name) {
  text = withoutByteOrderMark(text);
  if (const std::size_t bad = firstNoUtf8(text); bad != std::string_view::npos) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bad), '\n');
    refuseAt(name, static_cast<std::size_t>(line), Text::tr("the text is not UTF-8"),
             Text::tr("Save the table as UTF-8 CSV"));
  }
  return text;
}

}  // namespace

char guessSeparator(std::string_view text) {
  constexpr std::string_view kCandidates = ",;\t";
  std::array<std::size_t, kCandidates.size()> counts{};
  bool quoted = false;
  for (const char c : text.substr(0, text.find('\n'))) {
    if (c == '"') {
      quoted = !quoted;
    }
    const std::size_t candidate = quoted ? std::string_view::npos : kCandidates.find(c);
    if (candidate != std::string_view::npos) {
      ++counts[candidate];
    }
  }
  return kCandidates[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) -
                                              counts.begin())];
}

std::vector<CsvRecord> csvRecords(std::string_view text, const std::string& name, char separator) {
  std::vector<CsvRecord> records;
  Reader reader(checkedText(text, name), name, separator);
  CsvRecord record;
  while (reader.next(record.values, record.line)) {
    records.push_back(record);
  }
  return records;
}

CsvTable CsvTable::read(const std::filesystem::path& file, std::initializer_list<std::string_view> required,
                        std::initializer_list<std::string_view> optional) {
  return parse(readFile(file), file.string(), required, optional);
}

CsvTable CsvTable::parse(std::string_view text, const std::string& name,
                         std::initializer_list<std::string_view> required,
                         std::initializer_list<std::string_view> optional) {
  CsvTable table;
  table.name_ = name;
  Reader reader(checkedText(text, name), table.name_, ',');
  Row row;
  if (!reader.next(row.values, row.line)) {
    torsio::refuse(Text::tr("the table is empty"), name,
                   Text::tr("Begin with the header %1", listed(required)));
  }
  table.takeHeader(row.values, row.line, required, optional);
  while (reader.next(row.values, row.line)) {
    table.takeRow(row);
  }
  if (table.rows_.empty()) {
    torsio::refuse(Text::tr("the table has a header but no rows"), name, Text::tr("Add one row a value"));
  }
  table.checkIdentifiers();
  return table;
}

void CsvTable::checkIdentifiers() {
  for (const std::string_view column : kIdentifiers) {
    if (!has(column) || std::find(ignored_.begin(), ignored_.end(), column) != ignored_.end()) {
      continue;
    }
    const std::string kind(column);
    const std::size_t at = position(column);
    Identifiers identifiers(kind);
    std::unordered_set<std::string_view> seen;
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      const std::string& name = rows_[row].values[at];
      if (name.empty() || !seen.insert(name).second) {
        continue;
      }
      identifiers.take(name, where(row));
      if (isSpreadsheetNumber(name)) {
        damaged_.push_back(Text::tr("%1: %2 \"%3\" looks like a number that a spreadsheet has shortened",
                                    where(row), kind, name));
      }
    }
  }
}

void CsvTable::takeHeader(std::vector<std::string> header, std::size_t line,
                          std::initializer_list<std::string_view> required,
                          std::initializer_list<std::string_view> optional) {
  const std::string remedy = "Begin with the header " + listed(required) + ", in any order";
  if (header.size() == 1 && required.size() > 1 && header[0].find_first_of(";\t") != std::string::npos) {
    refuseAt(name_, line, Text::tr("the columns are not separated by commas: %1", inQuotes(header[0])),
             Text::tr("Save the table with commas and decimal points"));
  }
  for (auto name = header.begin(); name != header.end(); ++name) {
    if (std::find(header.begin(), name, *name) != name) {
      refuseAt(name_, line, Text::tr("the header names the column %1 twice", inQuotes(*name)), remedy);
    }
  }
  for (const std::string_view name : required) {
    if (std::find(header.begin(), header.end(), name) == header.end()) {
      refuseAt(name_, line, Text::tr("the header has no column %1", inQuotes(name)), remedy);
    }
  }
  for (const std::string& name : header) {
    const bool known = std::find(required.begin(), required.end(), name) != required.end() ||
                       std::find(optional.begin(), optional.end(), name) != optional.end();
    if (!known) {
      ignored_.push_back(name);
    }
  }
  header_ = std::move(header);
}

void CsvTable::takeRow(Row row) {
  if (row.values.size() != header_.size()) {
    std::string what = "the line has " + std::to_string(row.values.size()) + " values, the header " +
                       std::to_string(header_.size());
    for (std::size_t i = 0; i + 1 < row.values.size() && row.values.size() > header_.size(); ++i) {
      if (!isDigits(row.values[i]) || !isDigits(row.values[i + 1])) {
        continue;
      }
      what += "; is " + inQuotes(row.values[i] + "," + row.values[i + 1]) + " a decimal comma?";
      break;
    }
    refuseAt(name_, row.line, what, Text::tr("Give one value a column and write decimals with a point"));
  }
  rows_.push_back(std::move(row));
}

bool CsvTable::has(std::string_view column) const noexcept {
  return std::find(header_.begin(), header_.end(), column) != header_.end();
}

std::size_t CsvTable::position(std::string_view column) const {
  const auto found = std::find(header_.begin(), header_.end(), column);
  TORSIO_EXPECTS(found != header_.end());
  return static_cast<std::size_t>(found - header_.begin());
}

std::string CsvTable::where(std::size_t row) const {
  return name_ + ", line " + std::to_string(rows_.at(row).line);
}

const std::string& CsvTable::cell(std::size_t row, std::string_view column) const {
  return rows_.at(row).values[position(column)];
}

const std::string& CsvTable::text(std::size_t row, std::string_view column) const {
  const std::string& value = cell(row, column);
  if (value.empty()) {
    refuse(row, Text::tr("the column \"%1\" is empty", std::string(column)),
           Text::tr("Fill it in or remove the line"));
  }
  return value;
}

double CsvTable::number(std::size_t row, std::string_view column) const {
  const std::string& shown = text(row, column);
  const Text rule = Text::tr("Write a decimal number with a point, such as 7.5");
  const std::string named = std::string(column) + " " + inQuotes(shown);
  std::string_view digits = shown;
  if (digits.front() == '+') {
    digits.remove_prefix(1);
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) {
    refuse(row, Text::tr("%1 is too large or too small", named), rule);
  }
  if (hasDecimalComma(shown)) {
    refuse(row, Text::tr("%1 has a decimal comma", named), rule);
  }
  if (error != std::errc() || end != digits.data() + digits.size() || digits.front() == '+') {
    refuse(row, Text::tr("%1 is not a number", named), rule);
  }
  if (!std::isfinite(value)) {
    refuse(row, Text::tr("%1 is not a finite number", named), rule);
  }
  return value;
}

std::optional<double> CsvTable::numberIfGiven(std::size_t row, std::string_view column) const {
  if (cell(row, column).empty()) {
    return std::nullopt;
  }
  return number(row, column);
}

std::int64_t CsvTable::whole(std::size_t row, std::string_view column, std::int64_t low,
                             std::int64_t high) const {
  const double value = number(row, column);
  if (value != std::floor(value) || value < static_cast<double>(low) || value > static_cast<double>(high)) {
    refuse(row,
           Text::tr("%1 %2 is not a whole number from %3 to %4", std::string(column),
                    inQuotes(cell(row, column)), low, high),
           Text::tr("Correct the value"));
  }
  return static_cast<std::int64_t>(value);
}

void CsvTable::refuse(std::size_t row, const Text& what, const Text& remedy) const {
  refuseAt(name_, rows_.at(row).line, what, remedy);
}

std::string csvLine(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) {
      line += ',';
    }
    appendCsvCell(line, cell);
  }
  line += "\r\n";
  return line;
}

}  // namespace torsio
