// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include "app/gui/widgets/theme.h"

namespace torsio::gui {

/// The twist angle as a number inside a ring, which shows progress, target and tolerance at a glance. The
/// accessible description says the same.
class AngleDial : public QWidget {
  Q_OBJECT

 public:
  explicit AngleDial(QWidget* parent = nullptr);

  void retranslate();
  void setTheme(const Theme& theme);
  void setTarget(double target_rad, double tolerance_rad);
  void setAngle(double angle_rad);
  /// Sets the elapsed fraction of the holding time, 0 to 1: a thin inner ring fills.
  void setHeld(double share);
  [[nodiscard]] double held() const noexcept { return held_; }

  [[nodiscard]] bool onTarget() const noexcept;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void describe();

  const Theme* theme_;
  double angle_rad_ = 0.0;
  double target_rad_ = 0.0;
  double tolerance_rad_ = 0.0;
  double held_ = 0.0;
};

/// A quantity with name, number and a bar up to a limit. Above the limit, the bar turns amber with a text.
class LevelBar : public QWidget {
  Q_OBJECT

 public:
  /// `decimals`: of the number.
  LevelBar(const QString& name, const QString& unit, int decimals, QWidget* parent = nullptr);

  /// Call with texts in the present language.
  void setName(const QString& name, const QString& unit);
  void setTheme(const Theme& theme);
  /// The bar extends slightly beyond the limit; 0: no known limit.
  void setLimit(double limit);
  void setValue(double value);

  [[nodiscard]] bool overLimit() const noexcept { return limit_ > 0.0 && value_ >= limit_; }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QString figure() const;
  void describe();

  const Theme* theme_;
  QString name_;
  QString unit_;
  int decimals_;
  double value_ = 0.0;
  double limit_ = 0.0;
};

}  // namespace torsio::gui
