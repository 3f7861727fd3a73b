// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QWidget>

#include "app/gui/widgets/theme.h"
#include "app/services/review/sheet_editor.h"
#include "assessment/domain/rating/rubric.h"

class QFrame;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QScrollArea;
class QVBoxLayout;

namespace torsio::gui {

class ScoreRow;

/// Usual: name above the scale. Large: for fingers. Compact: name beside the scale, for long forms.
enum class RowShape { kUsual, kLarge, kCompact };

constexpr int kRowMark_px = 4;  ///< width of the bar left of the current row

/// The rubric with anchors, one row per line, and a comment. Number keys score the current row, arrows move
/// and adjust, N means "not assessable". Changes its editor and reports each change (SheetEditorPanel adds
/// the rest). GUI thread.
class SheetPanel : public QWidget {
  Q_OBJECT

 public:
  /// `largeTargets`: buttons of at least 44 pixels, for fingers.
  explicit SheetPanel(bool largeTargets = false, QWidget* parent = nullptr);

  void setTheme(const Theme& theme);
  void retranslate();
  /// Shows only scores, in compact rows: no comment, no "not assessable".
  void setScoresOnly(RowShape shape = RowShape::kCompact);
  /// Moves to the next row after a digit. A "1" that may become "10" waits for the next key.
  void setAdvancing(bool advancing) noexcept {
    advancing_ = advancing;
    typed_points_.reset();
  }
  [[nodiscard]] bool advancing() const noexcept { return advancing_; }
  /// Makes a sealed sheet read-only.
  void setReadOnly(bool readOnly);
  /// Redraws after undo, redo or another external change.
  void refresh();

  [[nodiscard]] bool readOnly() const noexcept { return readOnly_; }
  [[nodiscard]] const std::string& currentRow() const noexcept { return current_; }
  void setCurrentRow(const std::string& row);
  /// Scrolls just enough to show the whole current row.
  void showCurrentRow();
  /// Handles digits, arrows, N, Backspace, Delete. False: another key.
  bool handleKey(int key, Qt::KeyboardModifiers modifiers);
  /// Focuses the current row.
  void takeFocus();

 Q_SIGNALS:
  /// The user changed the editor.
  void edited();
  void rowChanged();

 protected:
  /// Shows an editor, which must outlive its display; null: empty.
  void setEditor(SheetEditor* editor);
  [[nodiscard]] QPlainTextEdit* commentField() const noexcept { return comment_; }
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// Keeps Tab within the sheet: from the comment to the first row, and back. Ctrl+Enter and the mouse leave
  /// it.
  bool focusNextPrevChild(bool next) override;

 private:
  void build();
  void fitRows();
  void step(int direction);
  void adjust(std::int64_t steps);
  void digit(int value);
  void choose(const std::string& row, std::int64_t steps);
  void changed();

  RowShape shape_;
  bool readOnly_ = false;
  bool scoresOnly_ = false;
  SheetEditor* editor_ = nullptr;
  const Theme* theme_;
  QScrollArea* scroll_;
  QFrame* edge_;  ///< between clipped rows and the overall mark
  QVBoxLayout* rowsLayout_;
  QVBoxLayout* overallLayout_;  ///< outside the scroll area: the overall mark is always visible
  QVBoxLayout* commentLayout_;  ///< below it, as wide as the scales
  QLabel* commentLabel_;
  QPlainTextEdit* comment_;
  std::vector<ScoreRow*> rows_;
  std::string current_;
  std::optional<std::int64_t> typed_points_;
  bool advancing_ = false;
  bool filling_ = false;
};

/// A row of the rubric: name, scale as buttons, answer, anchors, and a field for the reason.
class ScoreRow : public QWidget {
  Q_OBJECT

 public:
  ScoreRow(std::string code, const QString& label, const ScoreScale& scale, std::vector<RubricAnchor> anchors,
           RowShape shape, QWidget* parent);

  [[nodiscard]] const std::string& code() const noexcept { return code_; }
  void setTheme(const Theme& theme);
  void retranslate();
  void setAnswer(const SheetAnswer& answer);
  void setCurrent(bool current);
  void setReadOnly(bool readOnly);
  /// Returns whether it is being pressed by finger or mouse; then nothing may scroll.
  [[nodiscard]] bool underFinger() const noexcept { return underFinger_; }
  /// Returns the height to the end of the scale; the anchors are below it.
  [[nodiscard]] int scaleEnd() const;
  /// Opens and focuses the reason's field.
  void askReason();

 Q_SIGNALS:
  void scored(qint64 steps);
  void reasoned(const QString& reason);
  void takenBack(const torsio::SheetAnswer& before);  ///< reason cancelled; the answer before
  void wanted();                                      ///< clicked or reached by Tab
  void finished();                                    ///< the reason is complete

 protected:
  void paintEvent(QPaintEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] QString allAnchors() const;
  void keepAnchorRoom();
  [[nodiscard]] QString nearestAnchor(std::int64_t steps) const;
  [[nodiscard]] std::vector<QRect> cells() const;
  [[nodiscard]] int cellAt(const QPoint& at) const;
  [[nodiscard]] std::int64_t stepsOf(int cell) const;
  [[nodiscard]] int cellCount() const;
  void arrange();
  void describe();
  void showAnchor();

  std::string code_;
  QString label_;
  ScoreScale scale_;
  std::vector<RubricAnchor> anchors_;
  RowShape shape_;
  bool current_ = false;
  bool laidOut_ = false;  // its width is known
  bool underFinger_ = false;
  bool readOnly_ = false;
  int hovered_ = -1;
  SheetAnswer answer_;
  std::optional<SheetAnswer> asked_;  // answer before the reason was asked for
  const Theme* theme_;
  QLabel* name_;
  QLabel* value_;
  QWidget* strip_;  // area of the cells
  QLabel* anchor_;
  QLineEdit* reason_;
};

}  // namespace torsio::gui
