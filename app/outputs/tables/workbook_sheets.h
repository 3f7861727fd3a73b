// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/outputs/tables/workbook.h"

struct lxw_workbook;
struct lxw_worksheet;
struct lxw_format;

// Parts of writeWorkbook(), one a source file.
namespace torsio {

/// How cells look, made once a workbook.
struct WorkbookFormats {
  lxw_format* heading = nullptr;
  lxw_format* title = nullptr;
  lxw_format* wrapped = nullptr;
  lxw_format* time = nullptr;
  lxw_format* figure = nullptr;  ///< numbers that are drawn
};

/// Refuses what the library did not write, by its code (0: it did): throws Error{kFileUnwritable} for `file`.
void requireWritten(int error, const std::string& file);

/// A place on a sheet, rows and columns from 0.
class SheetPen {
 public:
  SheetPen(lxw_worksheet* sheet, std::string file) : sheet_(sheet), file_(std::move(file)) {}

  /// Text is never taken for a formula. What is longer than a cell holds ends with an ellipsis.
  void text(std::uint32_t row, std::uint16_t column, const std::string& words, lxw_format* look = nullptr);
  /// Not finite: an empty cell.
  void number(std::uint32_t row, std::uint16_t column, double value, lxw_format* look = nullptr);
  void cell(std::uint32_t row, std::uint16_t column, const ExportCell& value, const WorkbookFormats& formats);

  [[nodiscard]] lxw_worksheet* sheet() const noexcept { return sheet_; }

 private:
  lxw_worksheet* sheet_;
  std::string file_;
};

/// Fills a sheet with the numbers of every figure, one beneath the other, and its chart beside them.
void writeFigures(lxw_workbook* workbook, const std::string& sheetName, SheetPen pen,
                  const std::vector<const ReportFigure*>& figures, const WorkbookFormats& formats,
                  const ExportWording& say);

}  // namespace torsio
