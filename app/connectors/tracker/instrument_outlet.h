// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <thread>

#include "sim/core/live_types.h"
#include "sim/core/text.h"

namespace torsio {

/// Device names of the messages.
inline constexpr const char* kOutletInstrument = "TorsioInstrument";
inline constexpr const char* kOutletEvents = "TorsioEvent";

/// State of the outlet.
struct OutletView {
  Text trouble{};             ///< why nobody can connect; empty: connections are accepted
  std::int64_t watchers = 0;  ///< currently connected
  std::int64_t sent = 0;      ///< poses, summed over watchers
  std::int64_t left = 0;      ///< poses dropped because a watcher was too slow
};

/// Streams the simulator's instrument to other programs (Slicer) by OpenIGTLink: a TRANSFORM for each pose
/// shown, in millimetres and RAS (right, front, head), and a STRING for each step of the exercise: "touches",
/// "grips", "lets go at 91.8 deg", "free". It never says who is training. Served by a thread: slow watchers
/// miss poses, and those that do not read are disconnected. Call from the GUI thread or a command's.
class InstrumentOutlet {
 public:
  /// Listens at an address of this computer.
  InstrumentOutlet(const std::string& address, std::uint16_t port);
  /// Waits at most half a second.
  ~InstrumentOutlet();
  InstrumentOutlet(const InstrumentOutlet&) = delete;
  InstrumentOutlet& operator=(const InstrumentOutlet&) = delete;

  /// Sends the pose, and the steps of the exercise since the last call.
  void show(const LiveState& state);
  [[nodiscard]] OutletView view() const;
  /// Whether it listens there.
  [[nodiscard]] bool isAt(const std::string& address, std::uint16_t port) const;

 private:
  struct State;
  static void run(const std::shared_ptr<State>& state);

  std::shared_ptr<State> state_;
  ExercisePhase phase_ = ExercisePhase::kTracking;
  double held_rad_ = 0.0;  // latest angle of the grip
  std::thread thread_;
};

/// The outlet that this station is set to offer (rememberedTracker), shared by the whole program as long as
/// somebody holds it; created on demand, and again if the settings change. Null: none is offered. GUI thread.
[[nodiscard]] std::shared_ptr<InstrumentOutlet> outletOfThisStation();

}  // namespace torsio
