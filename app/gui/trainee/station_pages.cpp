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
#include "app/gui/trainee/transcript_page.h"
#include "app/gui/trainee/trend_page.h"

namespace torsio::gui {

namespace {

template <typename P>
PageEntry entry(const char* id, const char* icon, const char* title, std::vector<Operation> needs) {
  return {.id = QLatin1String(id),
          .icon = QLatin1String(icon),
          .title = [title] { return QCoreApplication::translate("StationPages", title); },
          .needs = std::move(needs),
          .make = [](ShellContext& shell) -> Page* { return new P(shell); }};
}

}  // namespace

std::vector<PageEntry> stationPages() {
  const std::vector<Operation> see{Operation::kTrialViewOwn};
  const std::vector<Operation> record{Operation::kTrialRecordOwn};
  return {
      entry<NextStepPage>("station.next", "play", QT_TRANSLATE_NOOP("StationPages", "My next step"), record),
      entry<DebriefPage>("station.debrief", "compare", QT_TRANSLATE_NOOP("StationPages", "Debrief"), see),
      entry<TrendPage>("station.trend", "stress", QT_TRANSLATE_NOOP("StationPages", "Trend"), see),
      entry<RemarksPage>("station.remarks", "info", QT_TRANSLATE_NOOP("StationPages", "Remarks"), see),
      entry<TranscriptPage>("station.transcript", "copy", QT_TRANSLATE_NOOP("StationPages", "Transcript"),
                            see),
      entry<DeviceCheckPage>("station.device", "device", QT_TRANSLATE_NOOP("StationPages", "Device check"),
                             record),
      entry<ConsentPage>("station.consent", "", QT_TRANSLATE_NOOP("StationPages", "Consent"), record),
      entry<BriefingPage>("station.briefing", "", QT_TRANSLATE_NOOP("StationPages", "Briefing"), record),
      entry<RunPage>("station.run", "", QT_TRANSLATE_NOOP("StationPages", "Run"), record),
  };
}

}  // namespace torsio::gui
