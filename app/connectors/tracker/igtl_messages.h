// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/pose.h"

namespace torsio {

/// Port of OpenIGTLink (IANA).
inline constexpr std::uint16_t kIgtlPort = 18944;

/// Where an instrument is, as a tracker says it.
struct TrackedPose {
  std::string instrument{};               ///< of a TRANSFORM its device, of TDATA the name in its list
  Pose pose{};                            ///< instrument to the tracker's reference
  std::optional<std::int64_t> sent_us{};  ///< UTC by the sender's clock; empty: it gives no time
};

/// What came in of a stream of messages.
struct IgtlNews {
  std::vector<TrackedPose> poses{};     ///< in their order
  std::optional<std::string> status{};  ///< of the last STATUS message; empty text: all is well
  std::int64_t refused = 0;  ///< poses that cannot be used: check sum, size, no number, no rotation
  std::int64_t others = 0;   ///< messages of other kinds, passed over
};

/// Reads OpenIGTLink from a connection: TRANSFORM, TDATA and STATUS with header version 1 to 3; everything
/// else is passed over without being kept. Lengths are millimetres on the wire. One thread.
class IgtlReader {
 public:
  /// Takes the next bytes, however they are cut. Throws Error{kBadData} for what is no OpenIGTLink, and for a
  /// message of more than 64 MiB: where the next one begins is not known then, the connection must end.
  void take(std::span<const std::byte> bytes, IgtlNews& news);

 private:
  void beginBody();
  void readBody(IgtlNews& news) const;

  std::vector<std::byte> head_;
  std::vector<std::byte> body_;  // of a message that is read
  std::uint64_t left_ = 0;       // bytes of the present body that are still to come
  bool inBody_ = false;
  bool kept_ = false;  // the present body is of a kind that is read
};

/// Packs a pose as a TRANSFORM of `device`: matrix in millimetres. `utc_us`: when the instrument was there.
[[nodiscard]] std::vector<std::byte> igtlTransform(std::string_view device, const Pose& pose,
                                                   std::int64_t utc_us);
/// Packs a text (UTF-8, at most 65535 bytes, the rest is cut off) as a STRING of `device`.
[[nodiscard]] std::vector<std::byte> igtlString(std::string_view device, std::string_view text,
                                                std::int64_t utc_us);
/// Packs the request STT_TDATA: trackers that send TDATA begin when they are asked. A hundred
/// poses a second.
[[nodiscard]] std::vector<std::byte> igtlStartTracking();

}  // namespace torsio
