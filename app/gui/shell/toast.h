// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QTimer>

namespace torsio::gui {

/// A message at the lower edge of its parent that disappears by itself. Takes no clicks and no focus.
class Toast : public QLabel {
  Q_OBJECT

 public:
  explicit Toast(QWidget* parent);
  void say(const QString& sentence);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  QTimer timer_;
};

}  // namespace torsio::gui
