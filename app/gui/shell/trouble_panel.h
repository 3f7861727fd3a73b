// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>

#include <QWidget>

class QPushButton;

namespace torsio::gui {

class ProblemPanel;
struct Theme;

/// Shown when the database cannot be used: what happened, what to do, and two ways to continue.
class TroublePanel : public QWidget {
  Q_OBJECT

 public:
  explicit TroublePanel(QWidget* parent = nullptr);
  void tell(const std::exception_ptr& problem);
  void setTheme(const Theme& theme);

 Q_SIGNALS:
  void retryWanted();
  void otherDatabaseWanted();

 private:
  void retranslate();
  ProblemPanel* problem_;
  QPushButton* retry_;
  QPushButton* other_;
};

}  // namespace torsio::gui
