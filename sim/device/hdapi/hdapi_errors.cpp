// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/hdapi/hdapi_errors.h"

#include <algorithm>

namespace torsio {

HdapiErrorClass hdapiErrorClass(hd::ErrorCode code) noexcept {
  switch (code) {
    case hd::kSuccess:
      return HdapiErrorClass::kNone;
    case hd::kWarmMotors:
      return HdapiErrorClass::kWarm;
    case hd::kExceededMaxForce:
    case hd::kExceededMaxForceImpulse:
    case hd::kExceededMaxVelocity:
    case hd::kForceError:
      return HdapiErrorClass::kForce;
    case hd::kIllegalBegin:
    case hd::kIllegalEnd:
    case hd::kFrameError:
      return HdapiErrorClass::kFrame;
    case hd::kDeviceFault:
    case hd::kCommError:
    case hd::kCommConfigError:
    case hd::kTimerError:
    case hd::kInvalidPriority:
    case hd::kSchedulerFull:
      return HdapiErrorClass::kFatal;
    case hd::kInvalidLicense:
      return HdapiErrorClass::kLicence;
    default:
      return HdapiErrorClass::kCall;
  }
}

Text hdapiErrorText(hd::ErrorCode code) {
  switch (code) {
    case hd::kWarmMotors:
      return Text::tr("the motors are warm");
    case hd::kExceededMaxForce:
      return Text::tr("the device's force limit was exceeded");
    case hd::kExceededMaxForceImpulse:
      return Text::tr("the force changed faster than the device allows");
    case hd::kExceededMaxVelocity:
      return Text::tr("the stylus moved faster than the device allows");
    case hd::kForceError:
      return Text::tr("the library refused a force");
    case hd::kDeviceFault:
      return Text::tr("the device does not answer");
    case hd::kDeviceAlreadyInitiated:
      return Text::tr("the device is in use already");
    case hd::kCommError:
      return Text::tr("the connection to the device broke off");
    case hd::kCommConfigError:
      return Text::tr("the connection to the device is set up wrongly");
    case hd::kTimerError:
      return Text::tr("the library's servo timer does not work");
    case hd::kInvalidPriority:
    case hd::kSchedulerFull:
      return Text::tr("the library's servo loop accepts no further task");
    case hd::kIllegalBegin:
    case hd::kIllegalEnd:
    case hd::kFrameError:
      return Text::tr("a servo frame could not be opened or closed");
    case hd::kInvalidLicense:
      return Text::tr("the library has no valid licence");
    default:
      return Text::tr("the library refused a call");
  }
}

bool HdapiErrors::any(HdapiErrorClass wanted) const noexcept {
  return std::any_of(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(count),
                     [wanted](const hd::ErrorInfo& e) { return hdapiErrorClass(e.error) == wanted; });
}

hd::ErrorCode HdapiErrors::worstCode() const noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    if (hdapiErrorClass(entries[i].error) == worst) {
      return entries[i].error;
    }
  }
  return hd::kSuccess;
}

HdapiErrors drainHdapiErrors(const hd::Api& api) noexcept {
  HdapiErrors errors;
  while (errors.count < kMaxErrorsAtOnce) {
    const hd::ErrorInfo info = api.hdGetError();
    if (info.error == hd::kSuccess) {
      break;
    }
    errors.entries[errors.count++] = info;
    errors.worst = std::max(errors.worst, hdapiErrorClass(info.error));
  }
  std::reverse(errors.entries.begin(), errors.entries.begin() + static_cast<std::ptrdiff_t>(errors.count));
  return errors;
}

}  // namespace torsio
