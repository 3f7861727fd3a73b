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
  std::string label{};  ///< the centre's own name
  /// Training time before it, from the study's curriculum; empty: the study follows none.
  std::optional<std::int64_t> afterExposure_us{};
  friend bool operator==(const Occasion&, const Occasion&) = default;
};

/// The occasions of a database or study in chronological order: training time never decreases, and stays
/// equal where only days or weeks pass (a follow-up). Their number is data.
class Occasions {
 public:
  Occasions() = default;
  /// Throws Error{kBadParameter} if a code is empty or duplicate.
  explicit Occasions(std::vector<Occasion> inOrder);

  [[nodiscard]] std::size_t size() const noexcept { return list_.size(); }
  [[nodiscard]] bool empty() const noexcept { return list_.empty(); }
  [[nodiscard]] auto begin() const noexcept { return list_.begin(); }
  [[nodiscard]] auto end() const noexcept { return list_.end(); }
  /// `position` must be below size().
  [[nodiscard]] const Occasion& at(std::size_t position) const;
  /// Returns the position of a code; empty if unknown.
  [[nodiscard]] std::optional<std::size_t> positionOf(const std::string& code) const noexcept;
  [[nodiscard]] bool contains(const std::string& code) const noexcept { return positionOf(code).has_value(); }
  /// Returns the occasion with this code; for an unknown code, one labelled with the code itself.
  [[nodiscard]] Occasion named(const std::string& code) const;

 private:
  std::vector<Occasion> list_;
};

/// Returns the names of the occasions for reports: "before", "after 20 min", or the label if no time is
/// known. An occasion with as much training as an earlier one adds its label: "after 40 min (six weeks
/// later)". Names are unique as long as labels are.
[[nodiscard]] std::vector<Text> occasionTexts(const Occasions& occasions);

}  // namespace torsio
