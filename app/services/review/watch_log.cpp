// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/review/watch_log.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace torsio {

namespace {

constexpr std::int64_t kHundredth_us = 10'000;
constexpr double kPermille = 1000.0;

std::optional<std::int64_t> numberIn(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc{} || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return number;
}

}  // namespace

WatchLog::WatchLog(std::int64_t length_us, const SheetViewing& stored)
    : length_us_(length_us),
      slowest_(static_cast<double>(stored.slowest_permille) / kPermille),
      fastest_(static_cast<double>(stored.fastest_permille) / kPermille),
      worked_us_(stored.worked_us) {
  std::string_view rest = stored.watched;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    const std::string_view span = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::size_t dash = span.find('-');
    if (dash == std::string_view::npos) {
      continue;
    }
    const auto from = numberIn(span.substr(0, dash));
    const auto to = numberIn(span.substr(dash + 1));
    if (from && to) {
      add(*from * kHundredth_us, *to * kHundredth_us);
    }
  }
}

void WatchLog::played(std::int64_t from_us, std::int64_t to_us, double speed) {
  if (to_us <= from_us) {
    return;
  }
  add(from_us, to_us);
  slowest_ = std::min(slowest_, speed);
  fastest_ = std::max(fastest_, speed);
}

void WatchLog::join(const WatchLog& other) {
  for (const auto& [from, to] : other.spans_) {
    add(from, to);
  }
  slowest_ = std::min(slowest_, other.slowest_);
  fastest_ = std::max(fastest_, other.fastest_);
  worked_us_ = std::max(worked_us_, other.worked_us_);
}

std::vector<std::pair<std::int64_t, std::int64_t>> WatchLog::without(const WatchLog& other) const {
  std::vector<std::pair<std::int64_t, std::int64_t>> rest;
  for (const auto& [from, to] : spans_) {
    std::int64_t at = from;
    for (const auto& [known, end] : other.spans_) {
      if (end <= at || known >= to) {
        continue;
      }
      if (known > at) {
        rest.emplace_back(at, known);
      }
      at = end;
    }
    if (at < to) {
      rest.emplace_back(at, to);
    }
  }
  return rest;
}

void WatchLog::add(std::int64_t from, std::int64_t to) {
  from = std::max<std::int64_t>(from, 0);
  to = std::min(to, length_us_);
  if (to <= from) {
    return;
  }
  auto next = spans_.upper_bound(from);
  if (next != spans_.begin() && std::prev(next)->second >= from) {
    --next;
    from = next->first;
  }
  while (next != spans_.end() && next->first <= to) {
    to = std::max(to, next->second);
    next = spans_.erase(next);
  }
  spans_.emplace(from, to);
}

double WatchLog::share() const noexcept {
  if (length_us_ <= 0) {
    return 1.0;
  }
  std::int64_t seen = 0;
  for (const auto& [from, to] : spans_) {
    seen += to - from;
  }
  return static_cast<double>(seen) / static_cast<double>(length_us_);
}

SheetViewing WatchLog::stored() const {
  SheetViewing out;
  for (const auto& [from, to] : spans_) {
    if (!out.watched.empty()) {
      out.watched += ';';
    }
    // Rounded outwards, so that repeated saving and loading does not shrink a stretch.
    out.watched +=
        std::to_string(from / kHundredth_us) + '-' + std::to_string((to + kHundredth_us - 1) / kHundredth_us);
  }
  if (length_us_ > 0) {
    out.watched_permille = std::llround(share() * kPermille);
  }
  out.slowest_permille = std::llround(slowest_ * kPermille);
  out.fastest_permille = std::llround(fastest_ * kPermille);
  out.worked_us = worked_us_;
  return out;
}

}  // namespace torsio
