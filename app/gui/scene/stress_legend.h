// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/gui/widgets/theme.h"

namespace torsio::gui {

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
  void changeEvent(QEvent* event) override;

 private:
  void describe();
  [[nodiscard]] QString figure(double stress_Pa) const;
  const Theme* theme_;
  double top_Pa_ = 0.0;
};

}  // namespace torsio::gui
