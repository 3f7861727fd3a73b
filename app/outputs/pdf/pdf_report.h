// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "app/outputs/wording/wording.h"
#include "assessment/results/report_model.h"

namespace torsio {

/// Called after every page with the number drawn so far and the total. May throw to cancel.
using PdfProgress = std::function<void(std::size_t page, std::size_t pages)>;

/// Writes the report as a vector PDF (PDF/A-1b, A4, page x of y; tagged, with bookmarks of sections, figures
/// and tables) through a temporary file, translated with `wording`. `language`: language tag of the file.
/// Needs a QApplication (makeHeadlessGraphicsApplication() suffices). GUI thread. Throws
/// Error{kFileUnwritable}, or what `progress` throws; then an older file of that name is untouched and no
/// partial file remains.
void writePdfReport(const ReportModel& model, const std::filesystem::path& file,
                    const Wording& wording = englishWording, const PdfProgress& progress = {},
                    const std::string& language = "en");

}  // namespace torsio
