// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio::gui {

/// What renders the picture.
enum class Renderer {
  kSoftware,  ///< the processor, which the servo and the window also need
  kGraphicsCard,
};

/// Switches between fine and fast rendering by frame times, with hysteresis: down when the picture stutters,
/// up when there is spare time, with a longer wait after every drop. A software renderer stays fast: even a
/// single fine frame would exceed the response time for scrubbing, at the servo's expense. Plain value.
class QualityControl {
 public:
  explicit QualityControl(Renderer renderer = Renderer::kSoftware) noexcept
      : mayBeFine_(renderer == Renderer::kGraphicsCard), fine_(mayBeFine_) {}

  /// Adds the time since the previous frame, s; ignores pauses without drawing. True if fine() has changed.
  bool note(double frame_s) noexcept;
  [[nodiscard]] bool fine() const noexcept { return fine_; }

 private:
  void change(bool fine) noexcept;
  bool mayBeFine_;
  bool fine_;
  double mean_s_ = 0.0;
  double watched_s_ = 0.0;  // time for which the mean has been on one side
  double wait_s_ = 4.0;     // before the next attempt to switch up
};

}  // namespace torsio::gui
