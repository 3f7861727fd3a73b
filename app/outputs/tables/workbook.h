// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/outputs/tables/export_table.h"
#include "app/services/base/progress.h"
#include "assessment/results/report_model.h"

namespace torsio {

/// The words of the reader, as UTF-8.
using ExportWording = std::function<std::string(const Text&)>;

/// What a workbook is made from.
struct WorkbookContents {
  Text title;
  Facts facts;                               ///< first sheet: what this is, when, from which record
  std::vector<const ExportTable*> tables;    ///< a sheet each
  std::vector<const ReportFigure*> figures;  ///< numbers and a chart that the spreadsheet draws, on one sheet
  std::vector<Text> methods;                 ///< a sheet of paragraphs; a section's title begins with "# "
};

/// Writes an Office Open XML workbook: frozen headings, filters, widths; numbers are numbers of 15 digits,
/// times are times of the spreadsheet (UTC), text is never a formula. A last sheet says what each column is
/// and where it comes from. Through a temporary file beside `file`, which the worker's memory does not hold.
/// Throws Error{kFileUnwritable}; then an older file of that name is untouched, as when `progress` throws to
/// give up. Any thread.
void writeWorkbook(const WorkbookContents& contents, const ExportWording& say,
                   const std::filesystem::path& file, const ProgressCallback& progress = {});

}  // namespace torsio
