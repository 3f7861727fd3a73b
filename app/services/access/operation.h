// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace torsio {

/// Operations that need permission. Table role_operation lists the roles that have them.
enum class Operation {
  kPractice,
  kTrialRecordOwn,
  kTrialViewOwn,
  kTrialViewAssigned,
  kTrialViewCoded,
  kMarkViewOwn,
  kMarkSubmit,
  kMarkViewCoded,
  kMarkRelease,
  kEvaluationSubmit,
  kEvaluationSetup,
  kPersonViewCoded,
  kPersonViewIdentity,
  kPersonEdit,
  kPersonExport,
  kPersonErase,
  kConsentRecord,
  kCurriculumEdit,
  kStudySetup,
  kStudyEnrol,
  kAllocationRun,
  kAllocationView,
  kAllocationReveal,
  kResultsCompute,
  kReportExportCoded,
  kReportExportNamed,
  kUserManage,
  kAuditView,
  kDatabaseBackup,
  kDatabaseRestore,
  kRetentionManage,
  kSettingsEdit,
};

/// Codes of table operation, in enumeration order (tested against the migrated database).
inline constexpr std::array<std::string_view, 32> kOperationCodes = {"practice",
                                                                     "trial.record_own",
                                                                     "trial.view_own",
                                                                     "trial.view_assigned",
                                                                     "trial.view_coded",
                                                                     "mark.view_own",
                                                                     "mark.submit",
                                                                     "mark.view_coded",
                                                                     "mark.release",
                                                                     "evaluation.submit",
                                                                     "evaluation.setup",
                                                                     "person.view_coded",
                                                                     "person.view_identity",
                                                                     "person.edit",
                                                                     "person.export",
                                                                     "person.erase",
                                                                     "consent.record",
                                                                     "curriculum.edit",
                                                                     "study.setup",
                                                                     "study.enrol",
                                                                     "allocation.run",
                                                                     "allocation.view",
                                                                     "allocation.reveal",
                                                                     "results.compute",
                                                                     "report.export_coded",
                                                                     "report.export_named",
                                                                     "user.manage",
                                                                     "audit.view",
                                                                     "database.backup",
                                                                     "database.restore",
                                                                     "retention.manage",
                                                                     "settings.edit"};

[[nodiscard]] constexpr std::string_view operationCode(Operation operation) noexcept {
  return kOperationCodes[static_cast<std::size_t>(operation)];
}

}  // namespace torsio
