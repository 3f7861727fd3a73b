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

/// Translates a text for the reader, as UTF-8.
using ExportWording = std::function<std::string(const Text&)>;

/// Contents of a workbook.
struct WorkbookContents {
  Text title;
  Facts facts;                               ///< first sheet: title, time and source record
  std::vector<const ExportTable*> tables;    ///< one sheet each
  std::vector<const ReportFigure*> figures;  ///< numbers and a native chart, on one sheet
  std::vector<Text> methods;                 ///< one sheet of paragraphs; section titles begin with "# "
};

/// Writes an Office Open XML workbook: frozen headings, filters, column widths; numbers have 15 digits, times
/// are spreadsheet times (UTC), text is never a formula. A sheet gives the address of each value of a figure
/// in cohort.csv, as `torsio report trace` takes it; the last one explains each column and its source.
/// Writes through a temporary file next to `file`, so memory use stays small. Throws Error{kFileUnwritable},
/// or what `progress` throws; an older file of that name is then untouched. Any thread.
void writeWorkbook(const WorkbookContents& contents, const ExportWording& say,
                   const std::filesystem::path& file, const ProgressCallback& progress = {});

}  // namespace torsio
