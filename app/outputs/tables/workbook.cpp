// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/tables/workbook.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <utility>
#include <xlsxwriter.h>

#include "app/outputs/tables/workbook_sheets.h"
#include "sim/core/error.h"
#include "sim/core/file_lock.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestCell = 32'767;  // characters per cell; its bytes are never fewer
constexpr std::size_t kLongestSheetName = 31;
constexpr std::uint8_t kA4 = 9;
constexpr double kNarrowest = 9.0;  // characters
constexpr double kWidest = 48.0;
constexpr double kUtcEpoch_days = 25'569.0;  // 1970-01-01 in spreadsheet days

/// Returns the width of a UTF-8 text in characters; Chinese ones count twice.
double widthOf(const std::string& text) {
  double width = 0.0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    width += byte < 0x80 ? 1.0 : byte >= 0xE0 ? 2.0 : byte >= 0xC0 ? 1.0 : 0.0;
  }
  return width;
}

/// Truncates a UTF-8 text to at most `bytes`, between two characters.
std::string shortened(const std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) {
    return text;
  }
  static const std::string kEllipsis = "\xE2\x80\xA6";
  std::size_t end = bytes - kEllipsis.size();
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) {
    --end;
  }
  return text.substr(0, end) + kEllipsis;
}

class Workbook {
 public:
  Workbook(const fs::path& temporary, const fs::path& folder, const ExportWording& say)
      : file_(temporary.string()), folder_(folder.string()), say_(say) {
    lxw_workbook_options options{};
    options.constant_memory = LXW_TRUE;
    options.tmpdir = folder_.empty() ? nullptr : folder_.data();
    book_ = workbook_new_opt(file_.c_str(), &options);
    if (book_ == nullptr) {
      requireWritten(LXW_ERROR_MEMORY_MALLOC_FAILED, file_);
    }
    formats_.heading = workbook_add_format(book_);
    format_set_bold(formats_.heading);
    format_set_text_wrap(formats_.heading);
    format_set_align(formats_.heading, LXW_ALIGN_VERTICAL_TOP);
    format_set_bottom(formats_.heading, LXW_BORDER_THIN);
    formats_.title = workbook_add_format(book_);
    format_set_bold(formats_.title);
    format_set_font_size(formats_.title, 14.0);
    formats_.wrapped = workbook_add_format(book_);
    format_set_text_wrap(formats_.wrapped);
    format_set_align(formats_.wrapped, LXW_ALIGN_VERTICAL_TOP);
    formats_.time = workbook_add_format(book_);
    formats_.figure = workbook_add_format(book_);
    format_set_num_format(formats_.figure, "0.0##");
    format_set_num_format(formats_.time, "yyyy-mm-dd hh:mm:ss.000");
  }
  ~Workbook() {
    if (book_ != nullptr) {
      lxw_workbook_free(book_);
    }
  }
  Workbook(const Workbook&) = delete;
  Workbook& operator=(const Workbook&) = delete;

  void addFacts(const Text& title, const Facts& facts) {
    SheetPen pen = sheet(say_(Text::tr("Overview")));
    pen.text(0, 0, say_(title), formats_.title);
    std::uint32_t row = 2;
    for (const auto& [label, value] : facts) {
      pen.text(row, 0, say_(label), formats_.wrapped);
      pen.text(row++, 1, say_(value), formats_.wrapped);
    }
    worksheet_set_column(pen.sheet(), 0, 0, 34.0, nullptr);
    worksheet_set_column(pen.sheet(), 1, 1, 90.0, nullptr);
  }

  void addTable(const ExportTable& table) {
    SheetPen pen = sheet(say_(table.title));
    const auto last = static_cast<std::uint16_t>(table.columns.size() - 1);
    for (std::uint16_t c = 0; c <= last; ++c) {
      const ExportColumn& column = table.columns[c];
      const std::string head = say_(column.title) + (column.unit.empty() ? "" : ", " + column.unit);
      double width = std::max(kNarrowest, std::min(22.0, widthOf(head)));
      if (column.kind == ColumnKind::kTime) {
        width = 24.0;
      }
      for (const auto& row : table.rows) {
        if (const auto* words = std::get_if<std::string>(&row[c])) {
          width = std::max(width, std::min(kWidest, widthOf(*words) + 1.0));
        }
      }
      worksheet_set_column(pen.sheet(), c, c, width, nullptr);
      pen.text(0, c, head, formats_.heading);
    }
    std::uint32_t at = 1;
    for (const auto& row : table.rows) {
      for (std::uint16_t c = 0; c <= last; ++c) {
        pen.cell(at, c, row[c], formats_);
      }
      ++at;
    }
    worksheet_repeat_rows(pen.sheet(), 0, 0);
    worksheet_freeze_panes(pen.sheet(), 1, 1);
    worksheet_autofilter(pen.sheet(), 0, 0, std::max<std::uint32_t>(1, at - 1), last);
  }

  void addFigures(const std::vector<const ReportFigure*>& figures) {
    const std::string name = say_(Text::tr("Figures"));
    SheetPen pen = sheet(name);
    writeFigures(book_, names_.back(), pen, figures, formats_, say_);
  }

  /// Adds one row per value of a figure that is a result: its number, and its address.
  void addFigureAddresses(const std::vector<const ReportFigure*>& figures) {
    SheetPen pen = heading(say_(Text::tr("Addresses of figures")),
                           {Text::tr("Figure"), Text::tr("Series"), Text::tr("Place"), Text::tr("Value"),
                            Text::tr("Address for torsio report trace")});
    std::uint32_t at = 1;
    const auto add = [&](const ReportFigure& figure, const FigureSeries& series, const std::string& place,
                         double value, const ResultKey& key) {
      pen.text(at, 0, say_(figure.title));
      pen.text(at, 1, say_(series.name));
      pen.text(at, 2, place);
      pen.number(at, 3, value, formats_.figure);
      pen.text(at++, 4, keyAddress(key));
    };
    for (const ReportFigure* figure : figures) {
      for (const FigureSeries& series : figure->series) {
        if (series.box && series.boxKey != nullptr) {
          add(*figure, series, say_(Text::tr("median")), series.box->median, *series.boxKey);
        }
        for (std::size_t i = 0; i < std::min(series.y.size(), series.keys.size()); ++i) {
          if (series.y[i] && series.keys[i] != nullptr) {
            const bool category = i < figure->categories.size() && series.x.empty();
            add(*figure, series,
                category              ? say_(figure->categories[i])
                : i < series.x.size() ? cellText(ExportCell(series.x[i]))
                                      : std::string(),
                *series.y[i], *series.keys[i]);
          }
        }
      }
    }
    finish(pen, at);
  }

  void addMethods(const std::vector<Text>& paragraphs) {
    SheetPen pen = sheet(say_(Text::tr("Methods")));
    worksheet_set_column(pen.sheet(), 0, 0, 120.0, nullptr);
    std::uint32_t row = 0;
    for (const Text& paragraph : paragraphs) {
      pen.text(row++, 0, say_(paragraph), formats_.wrapped);
    }
  }

  void addSources(const std::vector<const ExportTable*>& tables) {
    SheetPen pen = heading(say_(Text::tr("Sources")),
                           {Text::tr("Sheet"), Text::tr("Column"), Text::tr("Name for programs"),
                            Text::tr("Unit"), Text::tr("Where it comes from")});
    std::uint32_t row = 1;
    for (const ExportTable* table : tables) {
      for (const ExportColumn& column : table->columns) {
        pen.text(row, 0, say_(table->title));
        pen.text(row, 1, say_(column.title));
        pen.text(row, 2, table->name + "." + column.name);
        pen.text(row, 3, column.unit);
        pen.text(row++, 4, say_(table->source), formats_.wrapped);
      }
    }
    finish(pen, row);
  }

  void close() { requireWritten(workbook_close(std::exchange(book_, nullptr)), file_); }

 private:
  /// Adds a sheet that describes others: four narrow columns and a wide one.
  SheetPen heading(const std::string& name, const std::array<Phrase, 5>& columns) {
    SheetPen pen = sheet(name);
    std::uint16_t c = 0;
    for (const Phrase& head : columns) {
      worksheet_set_column(pen.sheet(), c, c, c == 4 ? 70.0 : 26.0, nullptr);
      pen.text(0, c++, say_(head), formats_.heading);
    }
    return pen;
  }
  /// `rows`: including the headings.
  static void finish(const SheetPen& pen, std::uint32_t rows) {
    worksheet_freeze_panes(pen.sheet(), 1, 0);
    worksheet_autofilter(pen.sheet(), 0, 0, std::max<std::uint32_t>(1, rows - 1), 4);
  }

  /// Adds a sheet with a valid, unique name.
  SheetPen sheet(const std::string& wish) {
    std::string name;
    for (const char c : wish) {
      name += std::string_view("[]:*?/\\'").find(c) == std::string_view::npos ? c : ' ';
    }
    name = shortened(name, kLongestSheetName);
    for (int n = 2; std::find(names_.begin(), names_.end(), name) != names_.end(); ++n) {
      name = shortened(wish, kLongestSheetName - 4) + " " + std::to_string(n);
    }
    lxw_worksheet* made = workbook_add_worksheet(book_, name.c_str());
    if (made == nullptr) {
      requireWritten(LXW_ERROR_PARAMETER_VALIDATION, file_);
    }
    names_.push_back(name);
    worksheet_set_landscape(made);
    worksheet_set_paper(made, kA4);
    worksheet_fit_to_pages(made, 1, 0);
    return SheetPen(made, file_);
  }

  std::string file_;
  std::string folder_;
  const ExportWording& say_;
  lxw_workbook* book_ = nullptr;
  WorkbookFormats formats_;
  std::vector<std::string> names_;
};

}  // namespace

void requireWritten(int error, const std::string& file) {
  if (error != LXW_NO_ERROR) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("the workbook cannot be written"),
                Text(file + ": " + lxw_strerror(static_cast<lxw_error>(error))),
                Text::tr("Check the free space and the permissions of the folder"));
  }
}

void SheetPen::text(std::uint32_t row, std::uint16_t column, const std::string& words, lxw_format* look) {
  if (!words.empty()) {
    requireWritten(worksheet_write_string(sheet_, row, column, shortened(words, kLongestCell).c_str(), look),
                   file_);
  }
}

void SheetPen::number(std::uint32_t row, std::uint16_t column, double value, lxw_format* look) {
  if (std::isfinite(value)) {
    requireWritten(worksheet_write_number(sheet_, row, column, sheetNumber(value), look), file_);
  }
}

void SheetPen::cell(std::uint32_t row, std::uint16_t column, const ExportCell& value,
                    const WorkbookFormats& formats) {
  if (const auto* words = std::get_if<std::string>(&value)) {
    text(row, column, *words);
  } else if (const auto* amount = std::get_if<double>(&value)) {
    number(row, column, *amount);
  } else if (const auto* utc_us = std::get_if<std::int64_t>(&value)) {
    number(row, column, kUtcEpoch_days + static_cast<double>(*utc_us) / kDay_us, formats.time);
  }
}

void writeWorkbook(const WorkbookContents& contents, const ExportWording& say, const fs::path& file,
                   const ProgressCallback& progress) {
  PartFile part(file);
  {
    Workbook book(part.path(), file.parent_path(), say);
    book.addFacts(contents.title, contents.facts);
    for (std::size_t i = 0; i < contents.tables.size(); ++i) {
      const ExportTable& table = *contents.tables[i];
      tellProgress(progress, Text::tr("Writing %1", table.title),
                   static_cast<double>(i) / static_cast<double>(contents.tables.size()));
      if (!table.rows.empty()) {
        book.addTable(table);
      }
    }
    if (!contents.figures.empty()) {
      book.addFigures(contents.figures);
      book.addFigureAddresses(contents.figures);
    }
    book.addMethods(contents.methods);
    book.addSources(contents.tables);
    book.close();
  }
  part.finish();
}

}  // namespace torsio
