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

/// Pose of an instrument as sent by a tracker.
struct TrackedPose {
  std::string instrument{};               ///< device of a TRANSFORM or POSITION, or name in a TDATA list
  Pose pose{};                            ///< instrument to tracker reference
  std::optional<std::int64_t> sent_us{};  ///< UTC by the sender's clock; empty: not sent
  std::string lost{};  ///< why the sender says that this is no pose, "OUT_OF_VIEW"; empty: it is one
};

/// Messages read so far.
struct IgtlNews {
  std::vector<TrackedPose> poses{};     ///< in order
  std::optional<std::string> status{};  ///< of the last STATUS message; empty text: no problem
  std::int64_t refused = 0;             ///< unusable poses: checksum, size, NaN, not a rotation
  std::int64_t others = 0;              ///< ignored messages of other types
};

/// Parses an OpenIGTLink stream: TRANSFORM, POSITION, TDATA and STATUS with header versions 1 to 3; other
/// messages are skipped without buffering. From version 2 on, metadata tell whether a pose is one: PLUS and
/// Slicer send TransformStatus ("OK", "OUT_OF_VIEW" ...) and TransformValid. Lengths on the wire are in
/// millimetres. One thread.
class IgtlReader {
 public:
  /// Parses the next bytes; messages may be split anywhere. Throws Error{kBadData} if this is not OpenIGTLink
  /// or a message exceeds 64 MiB: the stream is then out of step and the connection must be closed.
  void take(std::span<const std::byte> bytes, IgtlNews& news);

 private:
  void beginBody();
  void readBody(IgtlNews& news) const;

  std::vector<std::byte> head_;
  std::vector<std::byte> body_;  // of the current message, if kept_
  std::uint64_t left_ = 0;       // bytes of the current body still to come
  bool inBody_ = false;
  bool kept_ = false;  // the current body is of a type that we read
};

/// A TRANSFORM message of `device`, in millimetres. `utc_us`: time of the pose.
[[nodiscard]] std::vector<std::byte> igtlTransform(std::string_view device, const Pose& pose,
                                                   std::int64_t utc_us);
/// A STRING message of `device` (UTF-8, truncated to 65535 bytes).
[[nodiscard]] std::vector<std::byte> igtlString(std::string_view device, std::string_view text,
                                                std::int64_t utc_us);
/// An STT_TDATA message, which asks a tracker to start sending TDATA, a hundred poses per second.
[[nodiscard]] std::vector<std::byte> igtlStartTracking();

}  // namespace torsio
