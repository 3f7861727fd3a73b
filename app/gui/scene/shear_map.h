// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include <QWidget>

#include "app/gui/widgets/theme.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

/// Shear stress on the drawn skin: the model's patches (Eq. 13), interpolated smoothly between their centres.
/// Zero on caps beyond the ends. GUI thread; shares ownership of the scene.
class ShearMap {
 public:
  ShearMap() = default;
  explicit ShearMap(std::shared_ptr<const Scene> scene);

  /// Returns the top of the scale: the largest shear of the exercise at its target angle, Pa; for an organ
  /// that came twisted, the largest on the way to its largest twist. Fixed, so that a colour always means the
  /// same.
  [[nodiscard]] double top_Pa() const noexcept { return top_Pa_; }
  /// Computes the fraction of the scale at each vertex of the mesh, 0..1 (1 if above the scale).
  void evaluate(const OrganState& state, std::span<float> share);
  [[nodiscard]] bool empty() const noexcept { return scene_ == nullptr; }

 private:
  struct Weight {
    std::array<int, 4> patches{};
    std::array<float, 4> weights{};  ///< zero on a cap
  };
  std::shared_ptr<const Scene> scene_;
  std::vector<Weight> weights_;  // one per vertex
  std::vector<double> patch_Pa_;
  double top_Pa_ = 0.0;
};

/// Returns the colour of a fraction of the scale, sRGB 0..1: the map "cividis" in seven stops, from dark blue
/// over grey to yellow, with evenly increasing lightness, distinguishable with every kind of colour vision.
[[nodiscard]] std::array<float, 3> shearColour(float share) noexcept;

/// Legend of the shear map: a colour bar with numbers, over the scene. Its accessible description says the
/// same.
class StressLegend : public QWidget {
  Q_OBJECT

 public:
  explicit StressLegend(QWidget* parent = nullptr);
  void setTop(double top_Pa);
  void setTheme(const Theme& theme);
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void describe();
  [[nodiscard]] QString figure(double stress_Pa) const;
  const Theme* theme_;
  double top_Pa_ = 0.0;
};

}  // namespace torsio::gui
