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

/// Where a tracker is found.
struct TrackerPlace {
  std::string address = "127.0.0.1";  ///< of the tracker; of this computer where it is waited for
  std::uint16_t port = kIgtlPort;
  bool listens = false;      ///< the tracker calls; else it is called
  std::string instrument{};  ///< its name as the tracker says it; empty: the first that comes
  friend bool operator==(const TrackerPlace&, const TrackerPlace&) = default;
};

enum class TrackerStage : std::uint8_t {
  kSeeking,   ///< no connection
  kWaiting,   ///< connected; no pose of the instrument yet
  kTracking,  ///< poses come
  kSilent,    ///< none has come for a while
};

/// What poses of the instrument came to.
struct TrackerCounts {
  std::int64_t received = 0;
  std::int64_t missing = 0;  ///< by the sender's times; 0 where it gives none
  std::int64_t late = 0;     ///< by more than kLatePose_us
  std::int64_t refused = 0;  ///< of no use: damaged, no number, no rotation, a time that was there already
};

/// How it stands with a tracker.
struct TrackerView {
  TrackerStage stage = TrackerStage::kSeeking;
  Text trouble{};                          ///< why there is no connection, or what the tracker complains of
  std::string instrument{};                ///< that is followed
  std::vector<std::string> instruments{};  ///< seen so far, twenty at most
  Pose pose{};                             ///< the newest, in the frame of the tracker
  double rate_per_s = 0.0;
  bool stamped = false;  ///< the tracker says when each pose was
  std::optional<std::int64_t> period_us{};
  TrackerCounts counts{};
};

/// A tracker by OpenIGTLink, in a thread of its own: calls it or waits for its call, and does so again when
/// the connection ends. Whatever the other side does - hangs, goes away, sends rubbish or without end - no
/// function of this class waits for it. Of a connection in which nothing comes for half a minute it lets go.
class TrackerLink {
 public:
  explicit TrackerLink(const TrackerPlace& place);
  /// Waits half a second at most.
  ~TrackerLink();
  TrackerLink(const TrackerLink&) = delete;
  TrackerLink& operator=(const TrackerLink&) = delete;

  [[nodiscard]] const TrackerPlace& place() const noexcept { return place_; }
  [[nodiscard]] TrackerView view() const;
  /// From now on poses go into `ring`, the time counted from now; null: nowhere. Of a pose the sample holds
  /// time, place and rotation; one that was late is marked kDeviceStale, and what is missing has its numbers
  /// left out of the ticks.
  void record(std::shared_ptr<SpscRing<Sample>> ring);
  /// Returns how many poses that went into the present ring were late.
  [[nodiscard]] std::int64_t lateRecorded() const;

 private:
  struct State;
  static void run(const std::shared_ptr<State>& state);

  TrackerPlace place_;
  std::shared_ptr<State> state_;
  std::thread thread_;
};

}  // namespace torsio
