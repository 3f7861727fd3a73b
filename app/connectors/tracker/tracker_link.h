// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/connectors/tracker/igtl_messages.h"
#include "sim/core/live_types.h"
#include "sim/core/pose.h"
#include "sim/core/spsc_ring.h"
#include "sim/core/text.h"

namespace torsio {

/// Address of a tracker.
struct TrackerPlace {
  std::string address = "127.0.0.1";  ///< of the tracker, or of this computer if it `listens`
  std::uint16_t port = kIgtlPort;
  bool listens = false;      ///< wait for the tracker to connect, instead of connecting to it
  std::string instrument{};  ///< its name at the tracker; empty: the first one seen
  friend bool operator==(const TrackerPlace&, const TrackerPlace&) = default;
};

enum class TrackerStage : std::uint8_t {
  kSeeking,   ///< no connection
  kWaiting,   ///< connected, no pose of the instrument yet
  kTracking,  ///< poses arrive
  kSilent,    ///< poses have stopped
};

/// Counts of the instrument's poses.
struct TrackerCounts {
  std::int64_t received = 0;
  std::int64_t missing = 0;  ///< by the sender's times; 0 if it gives none
  std::int64_t late = 0;     ///< by more than kLatePose_us
  std::int64_t refused = 0;  ///< damaged, NaN, not a rotation, or a duplicate time
};

/// State of a tracker.
struct TrackerView {
  TrackerStage stage = TrackerStage::kSeeking;
  Text trouble{};                          ///< why there is no connection, or the tracker's own complaint
  std::string instrument{};                ///< being followed
  std::vector<std::string> instruments{};  ///< seen so far, at most twenty
  Pose pose{};                             ///< latest, in the tracker's frame
  double rate_per_s = 0.0;
  bool stamped = false;  ///< the tracker sends times
  std::optional<std::int64_t> period_us{};
  TrackerCounts counts{};
};

/// An OpenIGTLink tracker, served by a thread: connects to it or waits for it, and reconnects. No function
/// blocks, even if the other side hangs, disappears, or floods us with garbage. A connection that is silent
/// for half a minute is closed.
class TrackerLink {
 public:
  explicit TrackerLink(const TrackerPlace& place);
  /// Waits at most half a second.
  ~TrackerLink();
  TrackerLink(const TrackerLink&) = delete;
  TrackerLink& operator=(const TrackerLink&) = delete;

  [[nodiscard]] const TrackerPlace& place() const noexcept { return place_; }
  [[nodiscard]] TrackerView view() const;
  /// From now on, writes poses into `ring` (null: nowhere), with time counted from now. A sample has time,
  /// position and rotation; a late pose is flagged kDeviceStale, and missing ones skip tick numbers.
  void record(std::shared_ptr<SpscRing<Sample>> ring);
  /// Number of late poses in the current ring.
  [[nodiscard]] std::int64_t lateRecorded() const;

 private:
  struct State;
  static void run(const std::shared_ptr<State>& state);

  TrackerPlace place_;
  std::shared_ptr<State> state_;
  std::thread thread_;
};

}  // namespace torsio
