// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/page.h"

#include <array>
#include <cstddef>

#include <QCoreApplication>
#include <QEvent>
#include <QStringList>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"

namespace torsio::gui {

namespace {

using enum Operation;

/// In the order of the enumeration.
constexpr std::array kPages{
    PageFacts{PageId::kNextStep, "station.next", "play", QT_TRANSLATE_NOOP("Pages", "My next step"),
              kTrialRecordOwn},
    PageFacts{PageId::kDebrief, "station.debrief", "debrief", QT_TRANSLATE_NOOP("Pages", "Debrief"),
              kTrialViewOwn},
    PageFacts{PageId::kTrend, "station.trend", "trend", QT_TRANSLATE_NOOP("Pages", "Trend"), kTrialViewOwn},
    PageFacts{PageId::kRemarks, "station.remarks", "info", QT_TRANSLATE_NOOP("Pages", "Remarks"),
              kTrialViewOwn},
    PageFacts{PageId::kTranscript, "station.transcript", "copy", QT_TRANSLATE_NOOP("Pages", "Transcript"),
              kTrialViewOwn},
    PageFacts{PageId::kDeviceCheck, "station.device", "device-check",
              QT_TRANSLATE_NOOP("Pages", "Device check"), kTrialRecordOwn},
    PageFacts{PageId::kConsent, "station.consent", "", QT_TRANSLATE_NOOP("Pages", "Consent"),
              kTrialRecordOwn},
    PageFacts{PageId::kBriefing, "station.briefing", "", QT_TRANSLATE_NOOP("Pages", "Briefing"),
              kTrialRecordOwn},
    PageFacts{PageId::kRun, "station.run", "", QT_TRANSLATE_NOOP("Pages", "Run"), kTrialRecordOwn},
    PageFacts{PageId::kPractice, "practice", "practice", QT_TRANSLATE_NOOP("Pages", "Free practice"),
              kPractice, std::nullopt, false},
    PageFacts{PageId::kCompare, "compare", "compare", QT_TRANSLATE_NOOP("Pages", "Compare models"), kPractice,
              std::nullopt, false},
    PageFacts{PageId::kQueue, "review.queue", "open", QT_TRANSLATE_NOOP("Pages", "Queue"), kMarkSubmit},
    PageFacts{PageId::kRaterCalibration, "review.calibration", "calibration",
              QT_TRANSLATE_NOOP("Pages", "Rater calibration"), kMarkSubmit, kTrialViewAssigned},
    PageFacts{PageId::kLiveSheet, "review.live", "record", QT_TRANSLATE_NOOP("Pages", "Live sheet"),
              kMarkSubmit},
    PageFacts{PageId::kDiscrepancyReview, "review.discrepancies", "discrepancy",
              QT_TRANSLATE_NOOP("Pages", "Discrepancy review"), kMarkSubmit},
    PageFacts{PageId::kSeverity, "review.severity", "severity", QT_TRANSLATE_NOOP("Pages", "My severity"),
              kMarkSubmit},
    PageFacts{PageId::kEvaluation, "review.evaluation", "check", QT_TRANSLATE_NOOP("Pages", "Evaluation"),
              kMarkSubmit, kEvaluationSubmit},
    PageFacts{PageId::kCase, "review.case", "", QT_TRANSLATE_NOOP("Pages", "Case"), kMarkSubmit,
              kTrialViewAssigned},
    PageFacts{PageId::kTodaysSessions, "administrator.today", "board",
              QT_TRANSLATE_NOOP("Pages", "Today's sessions"), kStudySetup},
    PageFacts{PageId::kRoster, "administrator.roster", "people", QT_TRANSLATE_NOOP("Pages", "Roster"),
              kPersonViewCoded},
    PageFacts{PageId::kCurricula, "administrator.curricula", "curriculum",
              QT_TRANSLATE_NOOP("Pages", "Curricula"), kCurriculumEdit},
    PageFacts{PageId::kCohorts, "administrator.cohorts", "cohort", QT_TRANSLATE_NOOP("Pages", "Cohorts"),
              kPersonViewCoded},
    PageFacts{PageId::kAllocation, "administrator.allocation", "allocation",
              QT_TRANSLATE_NOOP("Pages", "Allocation"), kAllocationView},
    PageFacts{PageId::kScoring, "administrator.scoring", "matrix", QT_TRANSLATE_NOOP("Pages", "Scoring"),
              kStudySetup},
    PageFacts{PageId::kCampaigns, "administrator.campaigns", "campaign",
              QT_TRANSLATE_NOOP("Pages", "Evaluation"), kEvaluationSetup},
    PageFacts{PageId::kResults, "administrator.results", "chart", QT_TRANSLATE_NOOP("Pages", "Results"),
              kResultsCompute},
    PageFacts{PageId::kReports, "administrator.reports", "report", QT_TRANSLATE_NOOP("Pages", "Reports"),
              kResultsCompute},
    PageFacts{PageId::kUsers, "administrator.users", "user", QT_TRANSLATE_NOOP("Pages", "Users"),
              kUserManage},
    PageFacts{PageId::kAudit, "administrator.audit", "audit", QT_TRANSLATE_NOOP("Pages", "Audit trail"),
              kAuditView},
    PageFacts{PageId::kHeads, "administrator.heads", "",
              QT_TRANSLATE_NOOP("Pages", "Checkpoints of the audit trail"), kAuditView},
    PageFacts{PageId::kMaintenance, "administrator.maintenance", "maintenance",
              QT_TRANSLATE_NOOP("Pages", "Maintenance"), kDatabaseBackup},
    PageFacts{PageId::kRestore, "administrator.restore", "", QT_TRANSLATE_NOOP("Pages", "Restore"),
              kDatabaseRestore},
    PageFacts{PageId::kMove, "administrator.move", "", QT_TRANSLATE_NOOP("Pages", "Move"), kDatabaseRestore},
    PageFacts{PageId::kDevices, "administrator.devices", "device", QT_TRANSLATE_NOOP("Pages", "Devices"),
              kSettingsEdit},
};

constexpr bool inOrder() {
  for (std::size_t i = 0; i < kPages.size(); ++i) {
    if (static_cast<std::size_t>(kPages[i].id) != i) {
      return false;
    }
  }
  return true;
}
static_assert(inOrder());

}  // namespace

const PageFacts& factsOf(PageId id) noexcept {
  return kPages[static_cast<std::size_t>(id)];
}

QString pageTitle(PageId id) {
  return QCoreApplication::translate("Pages", factsOf(id).title);
}

QString pageText(PageId id) {
  return QString::fromLatin1(factsOf(id).text);
}

Page::Page(ShellContext& shell, QWidget* parent) : QWidget(parent), shell_(shell) {
  QStringList roles;
  for (const std::string& role : shell.session().actor().roles) {
    roles << toQString(role);
  }
  setProperty("role", roles.join(QLatin1Char('+')));
}

void Page::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
  }
  QWidget::changeEvent(event);
}

}  // namespace torsio::gui
