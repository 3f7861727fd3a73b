// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/inverse3/inverse3_messages.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "sim/core/device_sample.h"

namespace torsio {

namespace {

using Json = nlohmann::json;

/// A part of an object; null when it is missing or something else stands there.
Json part(const Json& from, const char* name) {
  const auto found = from.is_object() ? from.find(name) : from.end();
  return from.is_object() && found != from.end() ? *found : Json();
}

double numberOf(const Json& from, const char* name) {
  const Json value = part(from, name);
  return value.is_number() ? value.get<double>() : std::nan("");
}

std::string textOf(const Json& from, const char* name) {
  const Json value = part(from, name);
  return value.is_string() ? value.get<std::string>() : std::string();
}

/// The device of this id in a list of them; null when there is none.
Json deviceOf(const Json& list, const std::string& wanted) {
  if (list.is_array()) {
    for (const Json& device : list) {
      const std::string id = textOf(device, "device_id");
      if (!id.empty() && (wanted.empty() || id == wanted)) {
        return device;
      }
    }
  }
  return {};
}

std::optional<Vec3> cursorOf(const Json& state) {
  const Json place = part(state, "cursor_position");
  const Vec3 cursor_m{numberOf(place, "x"), numberOf(place, "y"), numberOf(place, "z")};
  const double way_m = norm(cursor_m);
  return std::isfinite(way_m) && way_m <= kInverse3Reach_m ? std::optional(cursor_m) : std::nullopt;
}

std::optional<Quat> orientationOf(const Json& state) {
  const Json turn = part(state, "orientation");
  const Quat q{numberOf(turn, "w"), numberOf(turn, "x"), numberOf(turn, "y"), numberOf(turn, "z")};
  const double length = norm(q);
  return std::isfinite(length) && length > 0.5 && length < 2.0 ? std::optional(normalized(q)) : std::nullopt;
}

std::uint32_t buttonsOf(const Json& state) {
  const Json pressed = part(state, "buttons");
  std::uint32_t buttons = 0;
  for (const auto& [name, bit] :
       {std::pair("a", kButtonGrip), std::pair("b", kButtonSecond), std::pair("c", kButtonBookmark)}) {
    const Json value = part(pressed, name);
    buttons |= value.is_boolean() && value.get<bool>() ? static_cast<std::uint32_t>(bit) : 0U;
  }
  return buttons;
}

}  // namespace

std::optional<Inverse3Message> inverse3Message(const std::string& json, const std::string& wanted) {
  const Json whole = Json::parse(json, nullptr, false);
  if (!whole.is_object()) {
    return std::nullopt;
  }
  Inverse3Message message;
  const Json device = deviceOf(part(whole, "inverse3"), wanted);
  message.deviceId = textOf(device, "device_id");
  const Json version = part(part(part(device, "config"), "device_info"), "firmware_version");
  message.firmware = version.is_null() ? std::string() : version.dump();
  message.cursor_m = cursorOf(part(device, "state"));
  for (const char* const kind : {"wireless_verse_grip", "verse_grip"}) {
    const Json grip = part(deviceOf(part(whole, kind), {}), "state");
    if (!message.orientation && grip.is_object()) {
      message.orientation = orientationOf(grip);
      message.buttons = buttonsOf(grip);
    }
  }
  return message;
}

std::string inverse3Force(const std::string& deviceId, const Vec3& force_N) {
  const Json values{{"x", force_N.x}, {"y", force_N.y}, {"z", force_N.z}};
  const Json command{{"device_id", deviceId}, {"commands", {{"set_cursor_force", {{"values", values}}}}}};
  return Json{{"inverse3", Json::array({command})}}.dump();
}

}  // namespace torsio
