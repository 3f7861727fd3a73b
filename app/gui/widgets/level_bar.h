// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include "app/gui/widgets/theme.h"

namespace torsio::gui {

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
