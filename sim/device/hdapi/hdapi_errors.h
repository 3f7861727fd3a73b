// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "sim/core/text.h"
#include "sim/device/hdapi/hdapi_abi.h"

namespace torsio {

/// What an error of the vendor's library means for us, from harmless to the end of the connection.
enum class HdapiErrorClass : std::uint8_t {
  kNone,
  kCall,     ///< a wrong or unsupported call: counted, nothing else
  kFrame,    ///< no frame could be opened or closed: this tick sends nothing
  kForce,    ///< the device's protection tripped (force, impulse, velocity): engage anew
  kWarm,     ///< motors warm: no force until they have cooled
  kLicence,  ///< the library refuses to work without a licence
  kFatal,    ///< device, communication, timer or scheduler: the servo loop cannot go on
};

[[nodiscard]] HdapiErrorClass hdapiErrorClass(hd::ErrorCode code) noexcept;

/// Says an error code in plain words: "the connection to the device broke off".
[[nodiscard]] Text hdapiErrorText(hd::ErrorCode code);

/// Most errors that are taken in one tick, so that the library cannot hold up a tick.
inline constexpr std::size_t kMaxErrorsAtOnce = 16;

/// The errors that one emptying of the stack brought, in the order in which they happened.
struct HdapiErrors {
  std::array<hd::ErrorInfo, kMaxErrorsAtOnce> entries{};
  std::size_t count = 0;
  HdapiErrorClass worst = HdapiErrorClass::kNone;

  [[nodiscard]] bool any(HdapiErrorClass wanted) const noexcept;
  /// Returns the code of the first entry of the worst class; kSuccess when there is none.
  [[nodiscard]] hd::ErrorCode worstCode() const noexcept;
};

/// Empties the library's error stack, which gives the most recent error first and is shared by all threads:
/// only the thread that owns the session at that time may call this. No allocation.
[[nodiscard]] HdapiErrors drainHdapiErrors(const hd::Api& api) noexcept;

}  // namespace torsio
