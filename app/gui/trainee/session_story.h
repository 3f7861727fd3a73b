// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include <QImage>

#include "app/services/training/debrief.h"
#include "assessment/domain/ids.h"

namespace torsio::gui {

/// The twist of a session released nearest to its target.
struct BestTwist {
  TrialId trialId{};
  std::string moduleTitle{};
  TwistResult twist{};
  double error_rad = 0.0;  ///< absolute
  QImage picture{};        ///< of the organ before its release; null: not taken, or nothing can be drawn
};

/// A trainee's work since sign-in, from the debriefs. Use from one thread.
class SessionStory {
 public:
  /// Excludes runs that started earlier. Only the first call counts.
  void begin(std::int64_t now_us);
  /// Adds a run, once. True: it contains the session's best twist.
  bool add(const Debrief& debrief);
  /// Sets the best twist's picture; no effect without one.
  void setPicture(QImage picture);

  [[nodiscard]] std::size_t runs() const noexcept { return seen_.size(); }
  [[nodiscard]] std::size_t twists() const noexcept { return twists_; }  ///< completed
  [[nodiscard]] std::size_t onTarget() const noexcept { return onTarget_; }
  /// Empty until a twist has been released on target.
  [[nodiscard]] const std::optional<BestTwist>& best() const noexcept { return best_; }

 private:
  std::optional<std::int64_t> begunUtc_us_;
  std::set<TrialId> seen_;
  std::size_t twists_ = 0;
  std::size_t onTarget_ = 0;
  std::optional<BestTwist> best_;
};

}  // namespace torsio::gui
