// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsio::gui::testing {

/// The expected consequence of a fault, in every place.
enum class Course {
  kRefused,   ///< the device is not opened: no force, and the reason is shown
  kLost,      ///< no force 20 ms after the fault, and the device is lost
  kEnded,     ///< the library hangs: its process is gone after 100 ms, and the device is lost
  kForceOff,  ///< no force 20 ms after the fault, the device stays
  kNeverOn,   ///< the device stays, without any force
  kWorks,     ///< no noticeable effect; released in order
  kStuck,     ///< works, but its library hangs on release
};

/// A fault of a vendor's library.
struct FaultScenario {
  std::string name;
  std::string story;  ///< FAKEHD_... assignments separated by blanks; "@": 0.3 s after the first force
  Course course = Course::kLost;
  std::string words{};           ///< part of the device check's message
  std::string library{};         ///< "truncated", "other machine", "no library", "absent"; "": the fake
  bool slow = false;             ///< takes the timeout of an opening device (15 s)
  double restsWithin_ms = 20.0;  ///< after the fault, where it is immediately detectable
  bool impatient = false;        ///< the window is closed while the device is being opened
};

/// Returns all scenarios, in a fixed order.
[[nodiscard]] const std::vector<FaultScenario>& faultScenarios();

/// First argument that makes the test program one of these places.
inline constexpr const char* kBeAPlace = "--be-a-place";

/// Runs free practice ("practice") or a graded run ("graded") in a window with the fake library, in real
/// time, until the fake's story is over or `seconds` have passed; then closes the window. Prints a JSON
/// object: `words` shown, `longest_ms` for which the window was unresponsive, `closed_ms` that closing took.
/// Returns the exit code.
int beAPlace(const std::string& place, const std::string& library, double seconds);

}  // namespace torsio::gui::testing
