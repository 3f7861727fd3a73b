// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

/// The part of the vendor's haptic interface (libHD, versions 3.0 to 3.5) that the driver uses, declared by
/// ourselves: the vendor's headers are never included. Names are the vendor's without their prefix "HD_";
/// what a call does is said where it is used.
namespace torsio::hd {

using Int = std::int32_t;
using Enum = std::uint32_t;
using ErrorCode = std::uint32_t;
using Handle = std::uint32_t;
using Boolean = std::uint8_t;
using UShort = std::uint16_t;
using ULong = unsigned long;  ///< 8 bytes on Linux, 4 on Windows, as in the vendor's interface
using SchedulerHandle = ULong;
using CallbackCode = std::uint32_t;

/// One entry of the error stack, returned by value: a smaller struct would corrupt the stack on Windows.
struct ErrorInfo {
  ErrorCode error = 0;
  std::int32_t internalError = 0;
  Handle device = 0;
};
static_assert(sizeof(ErrorInfo) == 12 && std::is_trivially_copyable_v<ErrorInfo>);

#if defined(_WIN32)
#define TORSIO_HD_CALL __stdcall
#else
#define TORSIO_HD_CALL
#endif

using SchedulerCallback = CallbackCode(TORSIO_HD_CALL*)(void* userData);

inline constexpr Handle kInvalidHandle = 0xFFFFFFFFU;

inline constexpr Enum kVersion = 0x2500;
inline constexpr Enum kDeviceModelType = 0x2501;
inline constexpr Enum kDeviceDriverVersion = 0x2502;
inline constexpr Enum kDeviceVendor = 0x2503;
inline constexpr Enum kDeviceSerialNumber = 0x2504;
inline constexpr Enum kDeviceFirmwareVersion = 0x2505;

inline constexpr Enum kCurrentButtons = 0x2000;
inline constexpr Enum kCurrentInkwellSwitch = 0x2002;
inline constexpr Enum kCurrentPosition = 0x2050;
inline constexpr Enum kCurrentTransform = 0x2052;
inline constexpr Enum kCurrentJointAngles = 0x2100;
inline constexpr Enum kCurrentGimbalAngles = 0x2150;

inline constexpr Enum kMaxWorkspaceDimensions = 0x2550;
inline constexpr Enum kUsableWorkspaceDimensions = 0x2551;
inline constexpr Enum kInputDof = 0x2553;
inline constexpr Enum kOutputDof = 0x2554;
inline constexpr Enum kCalibrationStyle = 0x2555;

inline constexpr Enum kUpdateRate = 0x2600;
inline constexpr Enum kInstantaneousUpdateRate = 0x2601;
inline constexpr Enum kNominalMaxStiffness = 0x2602;
inline constexpr Enum kNominalMaxForce = 0x2603;
inline constexpr Enum kNominalMaxContinuousForce = 0x2604;
inline constexpr Enum kMotorTemperature = 0x2605;
inline constexpr Enum kSoftwareVelocityLimit = 0x2606;
inline constexpr Enum kSoftwareForceImpulseLimit = 0x2607;

inline constexpr Enum kCurrentForce = 0x2700;

inline constexpr Enum kForceOutput = 0x4000;
inline constexpr Enum kMaxForceClamping = 0x4001;
inline constexpr Enum kForceRamping = 0x4002;
inline constexpr Enum kSoftwareForceLimit = 0x4003;
inline constexpr Enum kOneFrameLimit = 0x4004;

inline constexpr Enum kCalibrationOk = 0x5000;
inline constexpr Enum kCalibrationNeedsUpdate = 0x5001;
inline constexpr Enum kCalibrationNeedsManualInput = 0x5002;
inline constexpr Enum kCalibrationEncoderReset = 1;
inline constexpr Enum kCalibrationAuto = 2;
inline constexpr Enum kCalibrationInkwell = 4;

inline constexpr CallbackCode kCallbackDone = 0;
inline constexpr CallbackCode kCallbackContinue = 1;
inline constexpr UShort kMinPriority = 0;
inline constexpr UShort kMaxPriority = 65535;
inline constexpr UShort kDefaultPriority = 32767;

inline constexpr ErrorCode kSuccess = 0x0000;
inline constexpr ErrorCode kInvalidEnum = 0x0100;
inline constexpr ErrorCode kInvalidValue = 0x0101;
inline constexpr ErrorCode kInvalidOperation = 0x0102;
inline constexpr ErrorCode kInvalidInputType = 0x0103;
inline constexpr ErrorCode kBadHandle = 0x0104;
inline constexpr ErrorCode kWarmMotors = 0x0200;
inline constexpr ErrorCode kExceededMaxForce = 0x0201;
inline constexpr ErrorCode kExceededMaxForceImpulse = 0x0202;
inline constexpr ErrorCode kExceededMaxVelocity = 0x0203;
inline constexpr ErrorCode kForceError = 0x0204;
inline constexpr ErrorCode kDeviceFault = 0x0300;
inline constexpr ErrorCode kDeviceAlreadyInitiated = 0x0301;
inline constexpr ErrorCode kCommError = 0x0302;
inline constexpr ErrorCode kCommConfigError = 0x0303;
inline constexpr ErrorCode kTimerError = 0x0304;
inline constexpr ErrorCode kIllegalBegin = 0x0400;
inline constexpr ErrorCode kIllegalEnd = 0x0401;
inline constexpr ErrorCode kFrameError = 0x0402;
inline constexpr ErrorCode kInvalidPriority = 0x0500;
inline constexpr ErrorCode kSchedulerFull = 0x0501;
inline constexpr ErrorCode kInvalidLicense = 0x0600;

/// Lists the functions of the loaded library as X(result, name, parameters). All of TORSIO_HD_MANDATORY
/// must be there; of TORSIO_HD_OPTIONAL any may be null.
#define TORSIO_HD_MANDATORY(X)                                                                              \
  X(Handle, hdInitDevice, (const char* configName))                                                         \
  X(void, hdDisableDevice, (Handle device))                                                                 \
  X(void, hdMakeCurrentDevice, (Handle device))                                                             \
  X(Handle, hdGetCurrentDevice, ())                                                                         \
  X(void, hdBeginFrame, (Handle device))                                                                    \
  X(void, hdEndFrame, (Handle device))                                                                      \
  X(ErrorInfo, hdGetError, ())                                                                              \
  X(const char*, hdGetErrorString, (ErrorCode code))                                                        \
  X(void, hdEnable, (Enum capability))                                                                      \
  X(void, hdDisable, (Enum capability))                                                                     \
  X(Boolean, hdIsEnabled, (Enum capability))                                                                \
  X(void, hdGetIntegerv, (Enum name, Int * values))                                                         \
  X(void, hdGetDoublev, (Enum name, double* values))                                                        \
  X(void, hdGetBooleanv, (Enum name, Boolean * values))                                                     \
  X(const char*, hdGetString, (Enum name))                                                                  \
  X(void, hdSetDoublev, (Enum name, const double* values))                                                  \
  X(Enum, hdCheckCalibration, ())                                                                           \
  X(void, hdUpdateCalibration, (Enum style))                                                                \
  X(void, hdStartScheduler, ())                                                                             \
  X(void, hdStopScheduler, ())                                                                              \
  X(SchedulerHandle, hdScheduleAsynchronous, (SchedulerCallback callback, void* userData, UShort priority)) \
  X(void, hdUnschedule, (SchedulerHandle callback))

#define TORSIO_HD_OPTIONAL(X)               \
  X(void, hdSetSchedulerRate, (ULong rate)) \
  X(void, hdScheduleSynchronous, (SchedulerCallback callback, void* userData, UShort priority))

/// Table of function pointers; optional ones may be null.
struct Api {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a declaration, parentheses would change it
#define TORSIO_HD_DECLARE(result, name, parameters) result(TORSIO_HD_CALL* name) parameters = nullptr;
  TORSIO_HD_MANDATORY(TORSIO_HD_DECLARE)
  TORSIO_HD_OPTIONAL(TORSIO_HD_DECLARE)
#undef TORSIO_HD_DECLARE
};

}  // namespace torsio::hd
