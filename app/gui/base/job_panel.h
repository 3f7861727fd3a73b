// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QString>

class QLabel;
class QProgressBar;
class QPushButton;

namespace torsio::gui {

/// "0:12 left", "3 min left"; empty while `remaining_s` is negative (not known).
[[nodiscard]] QString timeLeft(double remaining_s);

/// A long job: its name, present step, progress, remaining time, and a cancel button.
class JobPanel : public QFrame {
  Q_OBJECT

 public:
  /// What is around it. In a header it has one line less and shortens what does not fit.
  enum class Place { kCard, kHeader };

  explicit JobPanel(QWidget* parent, Place place = Place::kCard);

  void begin(const QString& title);
  void move(const QString& step, double fraction, double remaining_s);
  void end();

 Q_SIGNALS:
  void cancelled();

 private:
  void fitInto(Place place);
  void retranslate();
  QLabel* title_;
  QLabel* step_;
  QLabel* left_;
  QProgressBar* bar_;
  QPushButton* cancel_;
};

}  // namespace torsio::gui
