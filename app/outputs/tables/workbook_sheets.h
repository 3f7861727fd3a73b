// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/outputs/tables/workbook.h"

struct lxw_workbook;
struct lxw_worksheet;
struct lxw_format;

// Parts of writeWorkbook(), one per source file.
namespace torsio {

/// Cell formats, created once per workbook.
struct WorkbookFormats {
  lxw_format* heading = nullptr;
  lxw_format* title = nullptr;
  lxw_format* wrapped = nullptr;
  lxw_format* time = nullptr;
  lxw_format* figure = nullptr;  ///< numbers of figures
};

/// Throws Error{kFileUnwritable} for `file` if the library's error code is not 0.
void requireWritten(int error, const std::string& file);

/// Writes cells of a sheet; rows and columns from 0.
class SheetPen {
 public:
  SheetPen(lxw_worksheet* sheet, std::string file) : sheet_(sheet), file_(std::move(file)) {}

  /// Writes text, never as a formula; text too long for a cell is truncated with an ellipsis.
  void text(std::uint32_t row, std::uint16_t column, const std::string& words, lxw_format* look = nullptr);
  /// Writes a number; an empty cell if not finite.
  void number(std::uint32_t row, std::uint16_t column, double value, lxw_format* look = nullptr);
  void cell(std::uint32_t row, std::uint16_t column, const ExportCell& value, const WorkbookFormats& formats);

  [[nodiscard]] lxw_worksheet* sheet() const noexcept { return sheet_; }

 private:
  lxw_worksheet* sheet_;
  std::string file_;
};

/// Fills a sheet with the numbers of all figures, one below the other, each with its chart next to it.
void writeFigures(lxw_workbook* workbook, const std::string& sheetName, SheetPen pen,
                  const std::vector<const ReportFigure*>& figures, const WorkbookFormats& formats,
                  const ExportWording& say);

}  // namespace torsio
