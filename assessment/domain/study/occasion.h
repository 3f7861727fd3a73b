// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

/// A point in time of a study at which the raters score everybody.
struct Occasion {
  std::string code{};   ///< "pre": in the record and in files
  std::string label{};  ///< what the centre calls it
  /// After so much training, by the curriculum of a study; empty: the study follows none.
  std::optional<std::int64_t> afterExposure_us{};
  friend bool operator==(const Occasion&, const Occasion&) = default;
};

/// The occasions of a record or of one study, in order of time: a later one has more training behind it, or
/// as much where only days or weeks have passed (a follow-up). How many there are is data.
class Occasions {
 public:
  Occasions() = default;
  /// Throws Error{kBadParameter} when a code is empty or stands twice.
  explicit Occasions(std::vector<Occasion> inOrder);

  [[nodiscard]] std::size_t size() const noexcept { return list_.size(); }
  [[nodiscard]] bool empty() const noexcept { return list_.empty(); }
  [[nodiscard]] auto begin() const noexcept { return list_.begin(); }
  [[nodiscard]] auto end() const noexcept { return list_.end(); }
  /// `position` must be below size().
  [[nodiscard]] const Occasion& at(std::size_t position) const;
  /// Gives the position of a code; empty: there is no such occasion.
  [[nodiscard]] std::optional<std::size_t> positionOf(const std::string& code) const noexcept;
  [[nodiscard]] bool contains(const std::string& code) const noexcept { return positionOf(code).has_value(); }
  /// Gives the occasion with this code; of an unknown code one that is called by its code.
  [[nodiscard]] Occasion named(const std::string& code) const;

 private:
  std::vector<Occasion> list_;
};

/// Names each occasion in reports: "before", "after 20 min", or its label where no time is known. One that
/// comes after as much training as an earlier one has its label beside it: "after 40 min (six weeks later)".
/// No two are called the same while their labels differ.
[[nodiscard]] std::vector<Text> occasionTexts(const Occasions& occasions);

}  // namespace torsio
