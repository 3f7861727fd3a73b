// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/services/maintenance/station_anchor.h"

class QLabel;
class QPushButton;

namespace torsio::gui {

/// What an administrator takes along when signing out: length, time and hash of the audit trail's head, where
/// it was stored, and a copy button. Hidden until there is one.
class HeadNotice : public QWidget {
  Q_OBJECT

 public:
  explicit HeadNotice(QWidget* parent = nullptr);

  void tell(const LeftHead& head);
  void forget();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();

  LeftHead head_;
  QLabel* heading_;
  QLabel* facts_;
  QLabel* hash_;
  QLabel* where_;
  QPushButton* copy_;
};

}  // namespace torsio::gui
