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

/// The twist of a session that was let go nearest to its target.
struct BestTwist {
  TrialId trialId{};
  std::string moduleTitle{};
  TwistResult twist{};
  double error_rad = 0.0;  ///< absolute
  QImage picture{};        ///< of the organ before it was let go; null: not taken, or nothing can be drawn
};

/// What a trainee has done since the sign-in, told from the debriefs. One thread.
class SessionStory {
 public:
  /// Runs that began earlier belong to another session. Only the first call counts.
  void begin(std::int64_t now_us);
  /// Takes a run in, once. True: the best twist of the session is in it now.
  bool add(const Debrief& debrief);
  /// Of the best twist; does nothing when there is none.
  void setPicture(QImage picture);

  [[nodiscard]] std::size_t runs() const noexcept { return seen_.size(); }
  [[nodiscard]] std::size_t twists() const noexcept { return twists_; }  ///< completed
  [[nodiscard]] std::size_t onTarget() const noexcept { return onTarget_; }
  /// Empty until a twist was released on target.
  [[nodiscard]] const std::optional<BestTwist>& best() const noexcept { return best_; }

 private:
  std::optional<std::int64_t> begunUtc_us_;
  std::set<TrialId> seen_;
  std::size_t twists_ = 0;
  std::size_t onTarget_ = 0;
  std::optional<BestTwist> best_;
};

}  // namespace torsio::gui
