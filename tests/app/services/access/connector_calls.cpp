// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/foreign/dataset_import.h"
#include "app/connectors/foreign/foreign_import.h"
#include "app/connectors/mail/mail_settings.h"
#include "app/connectors/mail/mailing.h"
#include "app/connectors/xapi/learning_records.h"
#include "tests/app/services/access/permission_calls.h"

namespace torsio {

std::vector<ServiceCall> connectorCalls() {
  using O = Operation;
  using Path = const std::filesystem::path&;
  return {
      {O::kStudySetup, "sendReminders", [](SessionContext& w, Path) { (void)sendReminders(w, {}, {}); }},
      {O::kStudySetup, "mailSettings", [](SessionContext& w, Path) { (void)mailSettings(w); }},
      {O::kSettingsEdit, "setMailSettings", [](SessionContext& w, Path) { setMailSettings(w, {}); }},
      {O::kSettingsEdit, "lrsSettings", [](SessionContext& w, Path) { (void)lrsSettings(w); }},
      {O::kSettingsEdit, "setLrsSettings", [](SessionContext& w, Path) { setLrsSettings(w, {}); }},
      {O::kSettingsEdit, "learningRecords", [](SessionContext& w, Path) { (void)learningRecords(w); }},
      {O::kSettingsEdit, "retryLearningRecords",
       [](SessionContext& w, Path) { (void)retryLearningRecords(w); }},
      {O::kSettingsEdit, "dropLearningRecords",
       [](SessionContext& w, Path) { (void)dropLearningRecords(w); }},
      {O::kReportExportCoded, "sendLearningRecords",
       [](SessionContext& w, Path) { (void)sendLearningRecords(w); }},
      {O::kUserManage, "canMailInvitations", [](SessionContext& w, Path) { (void)canMailInvitations(w); }},
      {O::kUserManage, "sendInvitations", [](SessionContext& w, Path) { (void)sendInvitations(w, {}, {}); }},
      {O::kStudySetup, "importDataset",
       [](SessionContext& w, Path folder) { importDataset(w, folder / "no such set", {}, ""); }},
      {O::kStudySetup, "importForeign",
       [](SessionContext& w, Path folder) {
         importForeign(w, ForeignLayout::kCsv, folder / "no such map.json", "");
       }},
  };
}

}  // namespace torsio
