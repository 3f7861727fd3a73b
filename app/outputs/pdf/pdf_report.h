// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "app/outputs/wording/wording.h"
#include "assessment/results/report_model.h"

namespace torsio {

/// Told after every page: pages drawn so far and in all. May throw to give up.
using PdfProgress = std::function<void(std::size_t page, std::size_t pages)>;

/// Writes the whole report as a vector PDF (PDF/A-1b, A4, page x of y; tagged, with bookmarks of sections,
/// figures and tables) in the words of `wording`, through a temporary file. `language`: that of the words,
/// for the file. Needs a QApplication (makeHeadlessGraphicsApplication suffices). GUI thread. Throws
/// Error{kFileUnwritable}, or what `progress` throws; then an older file of that name is untouched and no
/// half file is left.
void writePdfReport(const ReportModel& model, const std::filesystem::path& file,
                    const Wording& wording = englishWording, const PdfProgress& progress = {},
                    const std::string& language = "en");

}  // namespace torsio
