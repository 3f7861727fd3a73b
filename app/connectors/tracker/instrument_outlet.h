// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <thread>

#include "sim/core/live_types.h"
#include "sim/core/text.h"

namespace torsio {

/// Names under which the instrument goes out.
inline constexpr const char* kOutletInstrument = "TorsioInstrument";
inline constexpr const char* kOutletEvents = "TorsioEvent";

/// How it stands with those who watch.
struct OutletView {
  Text trouble{};             ///< why nobody can connect; empty: they can
  std::int64_t watchers = 0;  ///< connected now
  std::int64_t sent = 0;      ///< poses, over all watchers
  std::int64_t left = 0;      ///< poses that a watcher was too slow for
};

/// Offers the simulator's instrument to other programs (Slicer) by OpenIGTLink: a TRANSFORM for each pose
/// that is shown, in millimetres and RAS (right, front, head), and a STRING for each step of the exercise:
/// "touches", "grips", "lets go at 91.8 deg", "free". Nothing says who trains. A thread of its own: who
/// watches too slowly misses poses, and who does not read at all is let go. GUI thread, or that of a command.
class InstrumentOutlet {
 public:
  /// Listens at `address` of this computer.
  InstrumentOutlet(const std::string& address, std::uint16_t port);
  /// Waits half a second at most.
  ~InstrumentOutlet();
  InstrumentOutlet(const InstrumentOutlet&) = delete;
  InstrumentOutlet& operator=(const InstrumentOutlet&) = delete;

  /// Sends the instrument, and what has happened since the last call.
  void show(const LiveState& state);
  [[nodiscard]] OutletView view() const;
  /// Whether it was made to listen there.
  [[nodiscard]] bool isAt(const std::string& address, std::uint16_t port) const;

 private:
  struct State;
  static void run(const std::shared_ptr<State>& state);

  std::shared_ptr<State> state_;
  ExercisePhase phase_ = ExercisePhase::kTracking;
  double held_rad_ = 0.0;  // newest angle of the grip
  std::thread thread_;
};

/// Returns what this station offers, as it remembers (rememberedTracker): one for the whole program, made
/// when first asked for, anew when something else is remembered, and gone with the last who holds it; null:
/// nothing is offered. GUI thread.
[[nodiscard]] std::shared_ptr<InstrumentOutlet> outletOfThisStation();

}  // namespace torsio
