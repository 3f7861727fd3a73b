// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/station_pages.h"

#include <QCoreApplication>

#include "app/gui/base/shell_context.h"
#include "app/gui/trainee/briefing_page.h"
#include "app/gui/trainee/consent_page.h"
#include "app/gui/trainee/debrief_page.h"
#include "app/gui/trainee/device_check_page.h"
#include "app/gui/trainee/next_step_page.h"
#include "app/gui/trainee/remarks_page.h"
#include "app/gui/trainee/run_page.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/transcript_page.h"
#include "app/gui/trainee/trend_page.h"

namespace torsio::gui {

namespace {

template <typename P>
PageEntry entry(PageId id) {
  return {id, [](ShellContext& shell) -> Page* { return new P(shell); }};
}

/// Returns the entry of a page that uses the station's desk.
template <typename P>
PageEntry entry(PageId id, const std::shared_ptr<StationDesk>& desk) {
  return {id, [desk](ShellContext& shell) -> Page* {
            desk->announce(shell.line());
            return new P(shell, *desk);
          }};
}

}  // namespace

std::vector<PageEntry> stationPages(const std::shared_ptr<StationDesk>& desk) {
  return {entry<NextStepPage>(PageId::kNextStep, desk),
          entry<DebriefPage>(PageId::kDebrief, desk),
          entry<TrendPage>(PageId::kTrend),
          entry<RemarksPage>(PageId::kRemarks),
          entry<TranscriptPage>(PageId::kTranscript),
          entry<DeviceCheckPage>(PageId::kDeviceCheck, desk),
          entry<ConsentPage>(PageId::kConsent),
          entry<BriefingPage>(PageId::kBriefing, desk),
          entry<RunPage>(PageId::kRun, desk)};
}

}  // namespace torsio::gui
