// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QString>

#include "app/gui/base/problem.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace torsio::gui {

struct Theme;

/// What went wrong, in one sentence, and what to do; details folded; a button that copies all of it. Stays
/// until it is closed, follows the language, and never covers the work.
class ProblemPanel : public QFrame {
  Q_OBJECT

 public:
  explicit ProblemPanel(QWidget* parent = nullptr);

  void tell(const Problem& problem);
  /// False on screens that have nothing else to show.
  void setClosable(bool closable);
  /// Everything, as the copy button gives it.
  [[nodiscard]] QString wholeText() const;
  void setTheme(const Theme& theme);
  void retranslate();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void say();
  void showDetails(bool shown);

  Problem problem_;
  QLabel* sign_;
  QLabel* happened_;
  QLabel* remedy_;
  QPlainTextEdit* details_;
  QPushButton* fold_;
  QPushButton* copy_;
  QPushButton* close_;
};

}  // namespace torsio::gui
