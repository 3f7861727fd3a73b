// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/report/report_export.h"

#include <nlohmann/json.hpp>

#include "app/outputs/pdf/pdf_report.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/cohort_report.h"
#include "assessment/results/validity_argument.h"
#include "db/connection/connection.h"
#include "sim/core/byte_order_mark.h"
#include "sim/core/contracts.h"
#include "sim/core/digest.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

/// Returns the format's name in the audit trail.
std::string_view formatCode(ReportFormat format) noexcept {
  switch (format) {
    case ReportFormat::kPdf:
      return "pdf";
    case ReportFormat::kCsv:
      return "csv";
    case ReportFormat::kValidity:
      return "validity";
  }
  return "";
}

}  // namespace

std::string_view identityCode(ReportIdentity identity) noexcept {
  switch (identity) {
    case ReportIdentity::kCoded:
      return "coded";
    case ReportIdentity::kNamed:
      return "named";
    case ReportIdentity::kAggregated:
      return "aggregated";
  }
  return "";
}

ReportExport exportReport(SessionContext& session, const ReportRequest& request, const CohortInputs& inputs,
                          ReportFormat format, const std::filesystem::path& file, const std::string& language,
                          const ReportPages& pages, const CsvStyle& look) {
  const bool named = request.identity == ReportIdentity::kNamed;
  session.require(named ? Operation::kReportExportNamed : Operation::kReportExportCoded);
  TORSIO_EXPECTS(inputs.identity == request.identity);
  if (format == ReportFormat::kPdf) {
    writePdfReport(cohortReport(inputs), file, wordingIn(language), pages, language);
  } else {
    const AnalysedCohort analysed = analysedCohort(inputs);
    const std::string table = format == ReportFormat::kCsv ? cohortCsvText(analysed.ledger)
                                                           : validityCsvText(validityArgument(analysed));
    writeFileAtomically(file, csvInStyle(std::string(kByteOrderMark) + table, look));
  }
  const std::string content = readFile(file);
  Digest digest;
  digest.update(content);
  ReportExport done{file, digest.hex(), content.size()};
  nlohmann::ordered_json what;
  what["format"] = formatCode(format);
  if (format == ReportFormat::kPdf) {
    what["language"] = language;
  }
  what["identity"] = identityCode(request.identity);
  what["campaign"] = request.campaignId;
  what["frozen"] = request.frozenId;
  what["trainees"] = inputs.trainees.size();
  what["bytes"] = done.bytes;
  what["hash"] = done.contentHash;
  AuditNote note{.action = named ? AuditAction::kReportExportNamed : AuditAction::kReportExportCoded,
                 .objectKind = AuditObject::kCohort};
  note.objectId = request.cohortId;
  note.newJson = what.dump();
  Transaction transaction(session.connection());
  session.note(note);
  transaction.commit();
  return done;
}

}  // namespace torsio
