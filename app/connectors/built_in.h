// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

/// Connectors of this build (CMake: TORSIO_MAIL, TORSIO_XAPI, TORSIO_TRACKER, TORSIO_FOREIGN).
inline constexpr bool kMailBuiltIn = TORSIO_WITH_MAIL != 0;
inline constexpr bool kXapiBuiltIn = TORSIO_WITH_XAPI != 0;
inline constexpr bool kTrackerBuiltIn = TORSIO_WITH_TRACKER != 0;
inline constexpr bool kForeignBuiltIn = TORSIO_WITH_FOREIGN != 0;

}  // namespace torsio
