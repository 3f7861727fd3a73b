// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/alert_labels.h"

namespace torsio {

Text alertText(const DayAlert& alert, const std::string& since, const Text& occasion) {
  using Kind = DayAlert::Kind;
  switch (alert.kind) {
    case Kind::kTrialOpen:
      return Text::tr("%1 was recording at %2, which does not answer since %3. Go and look.", alert.subject,
                      alert.station, since);
    case Kind::kStationSilent:
      return Text::tr("%1 does not answer since %2.", alert.subject, since);
    case Kind::kDeviceUnfit:
      return Text::tr("%1: the device is not fit for graded runs: %2.", alert.subject, alert.reason);
    case Kind::kServoUneven:
      return Text::tr("%1, last run: %2. %3.", alert.subject, alert.reason, alert.remedy);
    case Kind::kSlotOverdue:
      return Text::tr("%1 was expected at %2, %3, and has not begun.", alert.subject, since, alert.station);
    case Kind::kRestTooLong:
      return Text::tr("%1 has rested longer than allowed.", alert.subject);
    case Kind::kSheetsMissing:
      return Text::tr("%1: sheets still missing: %2.", occasion, alert.count);
    case Kind::kNoGroup:
      return Text::tr("Trainees without a group: %1. Draw them under Allocation.", alert.count);
  }
  return {};
}

}  // namespace torsio
