// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "app/outputs/report/report_data.h"
#include "app/services/base/csv_style.h"

namespace torsio {

enum class ReportFormat { kPdf, kCsv, kValidity };  ///< kValidity: the validity argument as a table

/// Exported report.
struct ReportExport {
  std::filesystem::path file{};
  std::string contentHash{};  ///< BLAKE2b-256 of the file
  std::uint64_t bytes = 0;
};

/// Called after every page; may throw to cancel, then no file remains.
using ReportPages = std::function<void(std::size_t page, std::size_t pages)>;

/// Writes the report (PDF, in one of reportLanguages() of app/outputs/wording/wording.h: GUI thread, needs a
/// QApplication), its table of numbers or its validity argument (UTF-8 with byte order mark, in the requested
/// format) and audits who exported what: cohort, data set, form of identity, format, language, size and hash
/// of the file; no names. Coded and aggregated: kReportExportCoded; named: kReportExportNamed. `inputs` are
/// those of `request`. Throws Error{kFileUnwritable}; an older file of that name is then untouched.
ReportExport exportReport(SessionContext& session, const ReportRequest& request, const CohortInputs& inputs,
                          ReportFormat format, const std::filesystem::path& file,
                          const std::string& language = "en", const ReportPages& pages = {},
                          const CsvStyle& look = {});

/// Returns "coded", "named" or "aggregated".
[[nodiscard]] std::string_view identityCode(ReportIdentity identity) noexcept;

}  // namespace torsio
