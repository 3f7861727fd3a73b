// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/device_choice.h"

#include <chrono>
#include <thread>

#include "assessment/report/number_format.h"
#include "sim/base/error.h"

namespace torsio {

void pause_s(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

void requireTime(double seconds, double longest, Phrase what) {
  if (seconds > 0.0 && seconds <= longest) {
    return;
  }
  throw Error(ErrorCode::kBadParameter,
              Text::tr("%1 must lie above 0 s and not above %2 s, got %3", what, formatFixed(longest, 0),
                       formatFixed(seconds, 2)),
              Text::tr("device"), Text::tr("Give another number of seconds"));
}

StylusRequest stylusRequest(const DeviceChoice& choice, const std::function<bool()>& cancelled,
                            bool onlyLibrary) {
  StylusRequest request;
  request.library = choice.library;
  request.options.deviceName = choice.name;
  request.onlyLibrary = onlyLibrary;
  request.inThisProcess = choice.inThisProcess;
  request.cancelled = cancelled;
  return request;
}

}  // namespace torsio
