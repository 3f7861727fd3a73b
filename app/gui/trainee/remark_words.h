// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "assessment/domain/rating/remark.h"

class QBoxLayout;
class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace torsio::gui {

/// The latest text of a remark. If it was edited, "edited" unfolds earlier versions; one's own can be edited
/// in place (Ctrl+Enter saves, Esc discards).
class RemarkWords : public QWidget {
  Q_OBJECT

 public:
  explicit RemarkWords(QWidget* parent = nullptr);

  /// `editedUtc_us`: 0 if never edited. `own`: written by the reader, who may edit it.
  void setWords(const QString& text, std::int64_t editedUtc_us, const std::vector<RemarkWording>& earlier,
                bool own);
  /// Sets the text before the remark, such as "You answered"; empty: none.
  void setLead(const QString& lead);

 Q_SIGNALS:
  /// The text was changed; trimmed, never empty.
  void edited(const QString& text);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void setEditing(bool editing);
  void save();
  void showText();

  QString words_;
  QString lead_;
  QLabel* text_;
  QPushButton* history_;
  QPushButton* edit_;
  QLabel* earlier_;
  QWidget* editor_;
  QPlainTextEdit* field_;
  QPushButton* save_;
};

}  // namespace torsio::gui
