// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/tracker/igtl_messages.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <igtl_header.h>
#include <igtl_position.h>
#include <igtl_string.h>
#include <igtl_tdata.h>
#include <igtl_transform.h>
#include <igtl_util.h>
#include <map>
#include <set>
#include <utility>

#include "sim/core/error.h"
#include "sim/core/plain_text.h"
#include "sim/core/pose.h"

namespace torsio {

namespace {

constexpr std::uint64_t kMaxMessage_bytes = 64ULL << 20U;  // a camera image, skipped
constexpr std::uint64_t kMaxRead_bytes = 64ULL << 10U;     // 900 instruments
constexpr int kNewestHeader = 3;
constexpr double kMillimetre_m = 1e-3;
constexpr double kFarthest_m = 200.0;
constexpr std::uint16_t kStatusFine = 1;
constexpr std::uint16_t kUtf8 = 106;  // MIBenum
constexpr std::size_t kExtendedHead = 12;
constexpr double kFraction = 0x1p-32;
constexpr double kUnitTolerance = 0.01;  // of the length of a quaternion

/// Text of a sender as a line for people.
std::string nameIn(const char* text, std::size_t longest) {
  return plainLine({text, std::find(text, text + longest, '\0')});
}

igtl_header headOf(std::span<const std::byte> bytes) {
  igtl_header head;
  std::memcpy(&head, bytes.data(), sizeof head);
  igtl_header_convert_byte_order(&head);
  return head;
}

std::string kindOf(const igtl_header& head) {
  return nameIn(head.name, sizeof head.name);
}

bool isRead(const std::string& kind) {
  return kind == "TRANSFORM" || kind == "POSITION" || kind == "TDATA" || kind == "STATUS";
}

/// A type name has capitals, digits and underscores.
bool isKind(const std::string& kind) {
  return !kind.empty() && std::all_of(kind.begin(), kind.end(), [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

std::optional<std::int64_t> timeOf(const igtl_header& head) {
  if (head.timestamp == 0) {
    return std::nullopt;
  }
  const auto seconds = static_cast<std::int64_t>(head.timestamp >> 32U);
  const double fraction = static_cast<double>(head.timestamp & 0xffffffffULL) * kFraction;
  return seconds * 1'000'000 + std::llround(fraction * 1e6);
}

/// From twelve numbers: the columns of the matrix, then the position in millimetres.
std::optional<Pose> poseOf(const std::array<float, 12>& t) {
  const std::optional<Quat> rotation =
      rotationFromRows({t[0], t[3], t[6], t[1], t[4], t[7], t[2], t[5], t[8]});
  const Vec3 place_m{t[9] * kMillimetre_m, t[10] * kMillimetre_m, t[11] * kMillimetre_m};
  if (!rotation || !isFinite(place_m) || norm(place_m) > kFarthest_m) {
    return std::nullopt;
  }
  return Pose{place_m, *rotation};
}

/// What a sender adds to a message, by name.
using Metadata = std::map<std::string, std::string>;

/// Content of a message.
struct Content {
  std::span<const std::byte> body;
  Metadata said;  ///< of versions 2 and 3
};

std::string inCapitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// Returns why the sender says that a pose is none; empty: it is one. A pressed switch is no reason.
std::string lostBy(const Metadata& said, const std::string& instrument) {
  static const std::set<std::string> kSeen{"OK", "TOOL_OK", "VALID", "TRACKED", "VISIBLE"};
  static const std::set<std::string> kNo{"0", "FALSE", "NO", "INVALID"};
  for (const std::string& owner : {std::string(), instrument}) {
    for (const char* key : {"TransformStatus", "ToolStatus", "Status"}) {
      const auto status = said.find(owner + key);
      if (status != said.end() && !kSeen.contains(inCapitals(status->second)) &&
          inCapitals(status->second).find("SWITCH") == std::string::npos) {
        return status->second.empty() ? std::string(key) : status->second;
      }
    }
    for (const char* key : {"TransformValid", "Valid"}) {
      const auto valid = said.find(owner + key);
      if (valid != said.end() && kNo.contains(inCapitals(valid->second))) {
        return std::string(key) + " = " + valid->second;
      }
    }
  }
  return {};
}

void addPose(const std::optional<Pose>& pose, const std::string& instrument, const igtl_header& head,
             const Metadata& said, IgtlNews& news) {
  if (std::string lost = lostBy(said, instrument); !lost.empty()) {
    news.poses.push_back({instrument, {}, timeOf(head), std::move(lost)});
  } else if (pose) {
    news.poses.push_back({instrument, *pose, timeOf(head), {}});
  } else {
    ++news.refused;
  }
}

std::uint64_t bigEndian(std::span<const std::byte> bytes) {
  std::uint64_t value = 0;
  for (const std::byte byte : bytes) {
    value = (value << 8U) | std::to_integer<std::uint64_t>(byte);
  }
  return value;
}

/// Metadata: a count, then for each the lengths of name and value with the value's encoding between them,
/// then names and values. Entries of impossible sizes end the list.
Metadata metadataIn(std::span<const std::byte> heads, std::span<const std::byte> words) {
  constexpr std::size_t kEntry = 8;
  Metadata said;
  if (heads.size() < 2) {
    return said;
  }
  std::uint64_t left = bigEndian(heads.first(2));
  for (heads = heads.subspan(2); left > 0 && heads.size() >= kEntry; heads = heads.subspan(kEntry), --left) {
    const std::uint64_t name = bigEndian(heads.first(2));
    const std::uint64_t value = bigEndian(heads.subspan(4, 4));
    if (name + value > words.size()) {
      break;
    }
    const auto* const text = reinterpret_cast<const char*>(words.data());
    said[std::string(text, name)] = nameIn(text + name, value);
    words = words.subspan(name + value);
  }
  return said;
}

/// Content of a body: all of it, or from version 2 on the part between extended header and metadata. Empty:
/// impossible sizes.
Content contentOf(const igtl_header& head, std::span<const std::byte> body) {
  if (head.version < 2) {
    return {body, {}};
  }
  if (body.size() < kExtendedHead) {
    return {};
  }
  const std::uint64_t front = bigEndian(body.first(2));
  const std::uint64_t heads = bigEndian(body.subspan(2, 2));
  const std::uint64_t behind = heads + bigEndian(body.subspan(4, 4));
  if (front < kExtendedHead || front + behind > body.size()) {
    return {};
  }
  const std::span<const std::byte> tail = body.last(behind);
  return {body.subspan(front, body.size() - front - behind),
          metadataIn(tail.first(heads), tail.subspan(heads))};
}

void readTransform(const igtl_header& head, const Content& content, IgtlNews& news) {
  std::array<float, 12> numbers{};
  static_assert(sizeof numbers == IGTL_TRANSFORM_SIZE);
  if (content.body.size() != sizeof numbers) {
    ++news.refused;
    return;
  }
  std::memcpy(numbers.data(), content.body.data(), sizeof numbers);
  igtl_transform_convert_byte_order(numbers.data());
  addPose(poseOf(numbers), nameIn(head.device_name, sizeof head.device_name), head, content.said, news);
}

/// Position in millimetres and a whole quaternion, x y z w; a message without rotation is refused.
void readPosition(const igtl_header& head, const Content& content, IgtlNews& news) {
  igtl_position position;
  if (content.body.size() != sizeof position) {
    ++news.refused;
    return;
  }
  std::memcpy(&position, content.body.data(), sizeof position);
  igtl_position_convert_byte_order(&position);
  const auto& q = position.quaternion;
  const double length = std::sqrt(static_cast<double>(q[0]) * q[0] + static_cast<double>(q[1]) * q[1] +
                                  static_cast<double>(q[2]) * q[2] + static_cast<double>(q[3]) * q[3]);
  const Vec3 place_m{position.position[0] * kMillimetre_m, position.position[1] * kMillimetre_m,
                     position.position[2] * kMillimetre_m};
  std::optional<Pose> pose;
  if (std::abs(length - 1.0) < kUnitTolerance && isFinite(place_m) && norm(place_m) <= kFarthest_m) {
    pose = Pose{place_m, Quat{q[3] / length, q[0] / length, q[1] / length, q[2] / length}};
  }
  addPose(pose, nameIn(head.device_name, sizeof head.device_name), head, content.said, news);
}

void readTracking(const igtl_header& head, const Content& whole, IgtlNews& news) {
  static_assert(sizeof(igtl_tdata_element) == IGTL_TDATA_ELEMENT_SIZE);
  std::span<const std::byte> content = whole.body;
  if (content.size() % sizeof(igtl_tdata_element) != 0) {
    ++news.refused;
    return;
  }
  for (; !content.empty(); content = content.subspan(sizeof(igtl_tdata_element))) {
    igtl_tdata_element element;
    std::memcpy(&element, content.data(), sizeof element);
    igtl_tdata_convert_byte_order(&element, 1);
    std::array<float, 12> numbers{};
    std::memcpy(numbers.data(), element.transform, sizeof numbers);
    addPose(poseOf(numbers), nameIn(element.name, sizeof element.name), head, whole.said, news);
  }
}

/// Code (2 bytes), sub-code (8), name (20) and message.
void readStatus(std::span<const std::byte> content, IgtlNews& news) {
  constexpr std::size_t kNameAt = 10;
  constexpr std::size_t kWordsAt = 30;
  if (content.size() < kWordsAt) {
    return;
  }
  const std::uint64_t code = bigEndian(content.first(2));
  if (code == kStatusFine) {
    news.status = std::string();
    return;
  }
  const auto* const text = reinterpret_cast<const char*>(content.data());
  std::string words = nameIn(text + kWordsAt, content.size() - kWordsAt);
  if (words.empty()) {
    words = nameIn(text + kNameAt, kWordsAt - kNameAt);
  }
  news.status = words.empty() ? std::to_string(code) : words;
}

std::vector<std::byte> packed(std::string_view kind, std::string_view device, std::int64_t utc_us,
                              std::span<const std::byte> body) {
  igtl_header head{};
  head.version = IGTL_HEADER_VERSION;
  std::copy_n(kind.begin(), std::min(kind.size(), sizeof head.name), head.name);
  std::copy_n(device.begin(), std::min(device.size(), sizeof head.device_name), head.device_name);
  const auto seconds = static_cast<std::uint64_t>(utc_us / 1'000'000);
  const auto fraction =
      static_cast<std::uint64_t>(static_cast<double>(utc_us % 1'000'000) * 1e-6 / kFraction);
  head.timestamp = (seconds << 32U) | std::min<std::uint64_t>(fraction, 0xffffffffULL);
  head.body_size = body.size();
  std::vector<std::byte> message(sizeof head + body.size());
  std::copy(body.begin(), body.end(), message.begin() + sizeof head);
  head.crc = crc64(reinterpret_cast<unsigned char*>(message.data() + sizeof head), body.size(), 0);
  igtl_header_convert_byte_order(&head);
  std::memcpy(message.data(), &head, sizeof head);
  return message;
}

}  // namespace

void IgtlReader::beginBody() {
  const igtl_header head = headOf(head_);
  const std::string kind = kindOf(head);
  if (head.version < 1 || head.version > kNewestHeader || !isKind(kind)) {
    refuse(Text::tr("the data received are not OpenIGTLink"), Text::tr("tracker"),
           Text::tr("Check the address and port, and what is running there"));
  }
  if (head.body_size > kMaxMessage_bytes) {
    refuse(Text::tr("a message of %1 bytes was announced", std::to_string(head.body_size)),
           Text::tr("tracker"), Text::tr("Check the address and port, and what is running there"));
  }
  inBody_ = true;
  left_ = head.body_size;
  kept_ = isRead(kind) && head.body_size <= kMaxRead_bytes;
  body_.clear();
}

void IgtlReader::readBody(IgtlNews& news) const {
  const igtl_header head = headOf(head_);
  const std::string kind = kindOf(head);
  if (!kept_) {
    ++(isRead(kind) ? news.refused : news.others);
    return;
  }
  std::vector<std::byte> summed = body_;  // the library takes no const data
  if (crc64(reinterpret_cast<unsigned char*>(summed.data()), summed.size(), 0) != head.crc) {
    ++news.refused;
    return;
  }
  const Content content = contentOf(head, body_);
  if (kind == "TRANSFORM") {
    readTransform(head, content, news);
  } else if (kind == "POSITION") {
    readPosition(head, content, news);
  } else if (kind == "TDATA") {
    readTracking(head, content, news);
  } else {
    readStatus(content.body, news);
  }
}

void IgtlReader::take(std::span<const std::byte> bytes, IgtlNews& news) {
  static_assert(sizeof(igtl_header) == IGTL_HEADER_SIZE);
  while (!bytes.empty() || (inBody_ && left_ == 0)) {
    if (!inBody_) {
      const std::size_t part = std::min(bytes.size(), sizeof(igtl_header) - head_.size());
      head_.insert(head_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(part));
      bytes = bytes.subspan(part);
      if (head_.size() == sizeof(igtl_header)) {
        beginBody();
      }
      continue;
    }
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), left_));
    if (kept_) {
      body_.insert(body_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(part));
    }
    bytes = bytes.subspan(part);
    left_ -= part;
    if (left_ == 0) {
      readBody(news);
      inBody_ = false;
      head_.clear();
    }
  }
}

std::vector<std::byte> igtlTransform(std::string_view device, const Pose& pose, std::int64_t utc_us) {
  const std::array<double, 9> m = rowsOfRotation(pose.orientation);
  const Vec3 mm = pose.position_m * (1.0 / kMillimetre_m);
  std::array<float, 12> numbers{};
  for (std::size_t i = 0; i < m.size(); ++i) {
    numbers[i] = static_cast<float>(m[3 * (i % 3) + i / 3]);
  }
  numbers[9] = static_cast<float>(mm.x);
  numbers[10] = static_cast<float>(mm.y);
  numbers[11] = static_cast<float>(mm.z);
  igtl_transform_convert_byte_order(numbers.data());
  return packed("TRANSFORM", device, utc_us, std::as_bytes(std::span(numbers)));
}

std::vector<std::byte> igtlString(std::string_view device, std::string_view text, std::int64_t utc_us) {
  text = text.substr(0, 0xffffU);
  igtl_string_header head{kUtf8, static_cast<std::uint16_t>(text.size())};
  igtl_string_convert_byte_order(&head);
  std::vector<std::byte> body(sizeof head + text.size());
  std::memcpy(body.data(), &head, sizeof head);
  std::memcpy(body.data() + sizeof head, text.data(), text.size());
  return packed("STRING", device, utc_us, body);
}

std::vector<std::byte> igtlStartTracking() {
  constexpr int kEvery_ms = 10;
  igtl_stt_tdata request{};
  request.resolution = kEvery_ms;
  igtl_stt_tdata_convert_byte_order(&request);
  return packed("STT_TDATA", "Torsio", 0, std::as_bytes(std::span(&request, 1)));
}

}  // namespace torsio
