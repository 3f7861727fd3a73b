// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include <QFrame>

class QLabel;
class QPushButton;

namespace torsio::gui {

/// The desk shown to a visitor among simulated people.
enum class VisitedDesk { kTrainee, kPhysician, kAdministrator };

/// The line above a visitor's desk: one button per desk, the current one pressed.
class VisitBar : public QFrame {
  Q_OBJECT

 public:
  explicit VisitBar(QWidget* parent = nullptr);

  void setSeen(VisitedDesk desk);
  [[nodiscard]] VisitedDesk seen() const noexcept { return seen_; }

 Q_SIGNALS:
  /// Another desk was requested; the mark stays until setSeen().
  void wanted(VisitedDesk desk);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();

  VisitedDesk seen_ = VisitedDesk::kAdministrator;
  QLabel* sentence_;
  std::map<VisitedDesk, QPushButton*> desks_;
};

}  // namespace torsio::gui
