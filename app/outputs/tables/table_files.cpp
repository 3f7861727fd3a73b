// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/tables/table_files.h"

#include <array>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/services/base/csv_table.h"
#include "assessment/results/number_format.h"
#include "sim/core/byte_order_mark.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, TableFormat>, 3> kFormats = {
    {{"csv", TableFormat::kCsv}, {"r", TableFormat::kR}, {"spss", TableFormat::kSpss}}};

/// Files written to one folder; unless kept, the new ones are removed again.
class NewFiles {
 public:
  explicit NewFiles(fs::path folder) : folder_(std::move(folder)), hadFolder_(fs::exists(folder_)) {
    ensureFolder(folder_);
  }
  NewFiles(const NewFiles&) = delete;
  NewFiles& operator=(const NewFiles&) = delete;
  ~NewFiles() {
    if (kept_) {
      return;
    }
    std::error_code ignored;
    for (const fs::path& file : fresh_) {
      fs::remove(file, ignored);
    }
    if (!hadFolder_) {
      fs::remove(folder_, ignored);  // removes only an empty one
    }
  }
  const fs::path& add(const std::string& name) {
    files_.push_back(folder_ / name);
    if (!fs::exists(files_.back())) {
      fresh_.push_back(files_.back());
    }
    return files_.back();
  }
  std::vector<fs::path> keep() {
    kept_ = true;
    return std::move(files_);
  }

 private:
  fs::path folder_;
  bool hadFolder_;
  bool kept_ = false;
  std::vector<fs::path> files_;
  std::vector<fs::path> fresh_;
};

std::string typeWord(ColumnKind kind) {
  switch (kind) {
    case ColumnKind::kText:
      return "text";
    case ColumnKind::kNumber:
      return "number";
    case ColumnKind::kTime:
      return "time";
  }
  return "";
}

/// "1 = Group 1: 40 min virtual; 2 = ..."; empty: numbers stand for themselves.
std::string labelsText(const ExportColumn& column) {
  std::string text;
  for (const auto& [value, label] : column.labels) {
    text += (text.empty() ? "" : "; ") + formatExact(value) + " = " + label.str();
  }
  return text;
}

/// Quotes a string for R.
std::string quoted(const std::string& words) {
  std::string text = "\"";
  for (const char c : words) {
    text += c == '"' || c == '\\' ? std::string("\\") + c
            : c == '\n'           ? std::string("\\n")
                                  : std::string(1, c);
  }
  return text + "\"";
}

/// Converts a column of labelled numbers to a factor; the numbers stay its codes.
std::string factorLine(const std::string& column, const ExportColumn& from) {
  std::string values;
  std::string labels;
  for (const auto& [value, label] : from.labels) {
    values += (values.empty() ? "" : ", ") + formatExact(value);
    labels += (labels.empty() ? "" : ", ") + quoted(label.str());
  }
  return column + " <- factor(" + column + ", levels = c(" + values + "), labels = c(" + labels + "))\n";
}

/// Converts a column of words to a factor whose levels have their order, not that of the alphabet.
std::string orderLine(const std::string& column, const ExportColumn& from) {
  std::string levels;
  for (const Text& level : from.order) {
    levels += (levels.empty() ? "" : ", ") + quoted(level.str());
  }
  return column + " <- factor(" + column + ", levels = c(" + levels + "))\n";
}

std::string codebookText(const std::vector<const ExportTable*>& tables) {
  std::string text(kByteOrderMark);
  text += csvLine({"table", "column", "meaning", "unit", "type", "values", "source"});
  for (const ExportTable* table : tables) {
    for (const ExportColumn& column : table->columns) {
      text += csvLine({table->name, column.name, column.title.str(), column.unit, typeWord(column.kind),
                       labelsText(column), table->source.str()});
    }
  }
  return text;
}

/// Uses base R only; read.csv() keeps names and full precision.
std::string readerScript(const std::vector<const ExportTable*>& tables) {
  std::string text =
      "# Reads the tables of this script's folder, from wherever it is run or sourced, in a UTF-8 locale.\n"
      "folder <- local({\n"
      "  sourced <- Filter(Negate(is.null), lapply(sys.frames(), function(frame) frame$ofile))\n"
      "  run <- sub(\"^--file=\", \"\", grep(\"^--file=\", commandArgs(FALSE), value = TRUE))\n"
      "  file <- c(rev(sourced), run)\n"
      "  if (length(file) == 0) \".\" else dirname(file[[1]])\n"
      "})\n";
  for (const ExportTable* table : tables) {
    std::string classes;
    std::string after;
    for (const ExportColumn& column : table->columns) {
      classes += (classes.empty() ? "" : ", ") + column.name + " = \"" +
                 (column.kind == ColumnKind::kNumber ? "numeric" : "character") + "\"";
      if (column.kind == ColumnKind::kTime) {
        after += table->name + "$" + column.name + " <- as.POSIXct(" + table->name + "$" + column.name +
                 ", format = \"%Y-%m-%dT%H:%M:%OSZ\", tz = \"UTC\")\n";
      }
      if (!column.labels.empty()) {
        after += factorLine(table->name + "$" + column.name, column);
      }
      if (!column.order.empty()) {
        after += orderLine(table->name + "$" + column.name, column);
      }
    }
    text +=
        table->name + " <- read.csv(file.path(folder, \"" + table->name +
        ".csv\"), fileEncoding = \"UTF-8-BOM\", check.names = FALSE, na.strings = \"\",\n  colClasses = c(" +
        classes + "))\n" + after;
  }
  return text;
}

}  // namespace

std::string tableText(const ExportTable& table) {
  std::string text;
  std::vector<std::string> cells;
  for (const ExportColumn& column : table.columns) {
    cells.push_back(column.name);
  }
  text += csvLine(cells);
  for (const auto& row : table.rows) {
    cells.clear();
    for (const ExportCell& cell : row) {
      cells.push_back(cellText(cell));
    }
    text += csvLine(cells);
  }
  return text;
}

TableFormat tableFormat(const std::string& word) {
  for (const auto& [name, format] : kFormats) {
    if (name == word) {
      return format;
    }
  }
  throw Error(ErrorCode::kUsage, Text::tr("there is no such format of tables"), word,
              Text::tr("Use csv, r or spss"));
}

std::vector<fs::path> writeTables(const std::vector<const ExportTable*>& tables, TableFormat format,
                                  const fs::path& folder, const ProgressCallback& progress) {
  NewFiles made(folder);
  const auto write = [&](const std::string& name, const std::string& text) {
    writeFileAtomically(made.add(name), text);
  };
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const ExportTable& table = *tables[i];
    tellProgress(progress, Text::tr("Writing %1", table.title),
                 static_cast<double>(i) / static_cast<double>(tables.size()));
    if (format == TableFormat::kSpss) {
      writeSpssFile(table, made.add(table.name + ".sav"));
    } else {
      write(table.name + ".csv", std::string(kByteOrderMark) + tableText(table));
    }
  }
  if (format == TableFormat::kR) {
    write("read_tables.R", readerScript(tables));
  }
  write("codebook.csv", codebookText(tables));
  return made.keep();
}

}  // namespace torsio
