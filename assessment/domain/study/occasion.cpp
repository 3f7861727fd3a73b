// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/study/occasion.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr double kMicrosecondsPerMinute = 60e6;

/// Formats minutes: "20", "12.5".
std::string minutesText(std::int64_t us) {
  const double minutes = static_cast<double>(us) / kMicrosecondsPerMinute;
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), minutes, std::chars_format::fixed,
                                 minutes == std::trunc(minutes) ? 0 : 1);
  return std::string(text.data(), end.ptr);
}

/// "before", "after 20 min", or the label if no time is known.
Text occasionText(const Occasion& occasion) {
  if (!occasion.afterExposure_us) {
    return Text(occasion.label);
  }
  if (*occasion.afterExposure_us == 0) {
    return Text::tr("before");
  }
  return Text::tr("after %1 min", minutesText(*occasion.afterExposure_us));
}

}  // namespace

Occasions::Occasions(std::vector<Occasion> inOrder) : list_(std::move(inOrder)) {
  std::set<std::string> codes;
  for (const Occasion& occasion : list_) {
    if (occasion.code.empty() || !codes.insert(occasion.code).second) {
      refuseParameter(Text::tr("an occasion has no code of its own"), occasion.label,
                      Text::tr("Give every occasion another code"));
    }
  }
}

const Occasion& Occasions::at(std::size_t position) const {
  TORSIO_EXPECTS(position < list_.size());
  return list_[position];
}

std::optional<std::size_t> Occasions::positionOf(const std::string& code) const noexcept {
  const auto found =
      std::find_if(list_.begin(), list_.end(), [&](const Occasion& one) { return one.code == code; });
  return found == list_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - list_.begin()));
}

Occasion Occasions::named(const std::string& code) const {
  const std::optional<std::size_t> position = positionOf(code);
  return position ? list_[*position] : Occasion{code, code, {}};
}

std::vector<Text> occasionTexts(const Occasions& occasions) {
  std::vector<Text> texts;
  std::set<std::int64_t> times_us;
  std::set<std::string> taken;
  for (const Occasion& occasion : occasions) {
    const bool timeIsTaken = occasion.afterExposure_us && !times_us.insert(*occasion.afterExposure_us).second;
    Text text = occasionText(occasion);
    if (timeIsTaken) {
      text = Text::tr("%1 (%2)", text, occasion.label);
    }
    while (!taken.insert(text.str()).second) {
      text = Text::tr("%1 (%2)", text, occasion.code);
    }
    texts.push_back(std::move(text));
  }
  return texts;
}

}  // namespace torsio
