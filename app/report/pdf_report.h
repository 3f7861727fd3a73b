// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "assessment/report/report_model.h"

namespace torsio {

/// Writes the whole report as a vector PDF (A4, fonts embedded, page x of y), through a temporary file.
/// Needs a QApplication (makeHeadlessGraphicsApplication suffices). GUI thread.
/// Throws Error{kFileUnwritable}; then an older file of that name is untouched.
void writePdfReport(const ReportModel& model, const std::filesystem::path& file);

}  // namespace torsio
