// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsio::gui::testing {

/// What must come of a fault, wherever it happens.
enum class Course {
  kRefused,   ///< the device is not opened: no force, and the reason is said
  kLost,      ///< the motors have nothing 20 ms after the fault, and the device is lost
  kEnded,     ///< the library answers nobody: its process is gone after 100 ms, and the device is lost
  kForceOff,  ///< the motors have nothing 20 ms after the fault, the device stays
  kNeverOn,   ///< the device stays, without any force
  kWorks,     ///< nothing happens that a hand would feel; let go of in order
  kStuck,     ///< works, but its library does not let go at the end
};

/// One thing that a vendor's library may do.
struct FaultScenario {
  std::string name;
  std::string story;  ///< FAKEHD_... assignments, a space between; "@": 0.3 s after the first force
  Course course = Course::kLost;
  std::string words{};           ///< what the device check says, a part of it
  std::string library{};         ///< "truncated", "other machine", "no library", "absent"; "": the fake
  bool slow = false;             ///< takes the patience of an opening device (15 s)
  double restsWithin_ms = 20.0;  ///< after the fault, where it can be seen at once
  bool impatient = false;        ///< the window is closed while the device is being opened
};

/// All of them, in a fixed order.
[[nodiscard]] const std::vector<FaultScenario>& faultScenarios();

}  // namespace torsio::gui::testing
