// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio::gui {

/// What draws the picture.
enum class Renderer {
  kSoftware,  ///< the processor, which the servo and the window need too
  kGraphicsCard,
};

/// Decides between the fine and the fast picture by how long frames take, with hysteresis: down when the
/// picture stutters, up when there is room to spare, and after every fall a longer wait before the next try.
/// On a software renderer it stays fast: a single fine frame there takes longer than an answer to somebody
/// who scrubs may take, and what it takes it takes from the servo. Plain value.
class QualityControl {
 public:
  explicit QualityControl(Renderer renderer = Renderer::kSoftware) noexcept
      : mayBeFine_(renderer == Renderer::kGraphicsCard), fine_(mayBeFine_) {}

  /// Time since the frame before, s. Gaps in which nothing was drawn do not count. True when fine() changed.
  bool note(double frame_s) noexcept;
  [[nodiscard]] bool fine() const noexcept { return fine_; }

 private:
  void change(bool fine) noexcept;
  bool mayBeFine_;
  bool fine_;
  double mean_s_ = 0.0;
  double watched_s_ = 0.0;  // how long the mean has been on one side
  double wait_s_ = 4.0;     // before the next try upwards
};

}  // namespace torsio::gui
