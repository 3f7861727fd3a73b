// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/foreign/foreign_import.h"
#include "app/connectors/mail/mailing.h"
#include "app/connectors/xapi/learning_records.h"
#include "tests/app/services/access/permission_calls.h"

namespace torsio {

std::vector<ServiceCall> connectorCalls() {
  using O = Operation;
  using W = SessionContext&;
  using Path = const std::filesystem::path&;
  return {
      {O::kStudySetup, "sendReminders", [](W w, Path) { (void)sendReminders(w, {}, {}); }},
      {O::kStudySetup, "mailSettings", [](W w, Path) { (void)mailSettings(w); }},
      {O::kSettingsEdit, "setMailSettings", [](W w, Path) { setMailSettings(w, {}); }},
      {O::kSettingsEdit, "lrsSettings", [](W w, Path) { (void)lrsSettings(w); }},
      {O::kSettingsEdit, "setLrsSettings", [](W w, Path) { setLrsSettings(w, {}); }},
      {O::kSettingsEdit, "learningRecords", [](W w, Path) { (void)learningRecords(w); }},
      {O::kSettingsEdit, "retryLearningRecords", [](W w, Path) { (void)retryLearningRecords(w); }},
      {O::kSettingsEdit, "dropLearningRecords", [](W w, Path) { (void)dropLearningRecords(w); }},
      {O::kReportExportCoded, "sendLearningRecords", [](W w, Path) { (void)sendLearningRecords(w); }},
      {O::kUserManage, "canMailInvitations", [](W w, Path) { (void)canMailInvitations(w); }},
      {O::kUserManage, "sendInvitations", [](W w, Path) { (void)sendInvitations(w, {}, {}); }},
      {O::kUserManage, "canMailAdministrators", [](W w, Path) { (void)canMailAdministrators(w); }},
      {O::kUserManage, "mailAdministrators", [](W w, Path) { (void)mailAdministrators(w, {}, {}, {}); }},
      {O::kStudySetup, "importDataset",
       [](W w, Path folder) { importDataset(w, folder / "no such set", {}, ""); }},
      {O::kStudySetup, "importForeign",
       [](W w, Path folder) { importForeign(w, ForeignLayout::kCsv, folder / "no such map.json", ""); }},
  };
}

}  // namespace torsio
