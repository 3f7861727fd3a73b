// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QString>

#include "app/gui/base/translated_text.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace torsio::gui {

struct Theme;

/// What went wrong and what to do, with folded details and a copy button. Stays until closed, follows the
/// language, and never covers the work.
class ProblemPanel : public QFrame {
  Q_OBJECT

 public:
  explicit ProblemPanel(QWidget* parent = nullptr);

  void tell(const Problem& problem);
  /// Off for screens that show nothing else.
  void setClosable(bool closable);
  /// Returns the whole text, as copied by the button.
  [[nodiscard]] QString wholeText() const;
  void setTheme(const Theme& theme);
  void retranslate();

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
