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

constexpr int kRowMark_px = 4;  ///< width of the bar at the left of the current row

/// The rubric with its anchors, one row a line, and a comment. Number keys score the marked row, arrows move
/// and adjust, N says "not assessable". It changes the editor that it was given and tells each change
/// (SheetEditorPanel adds the rest of an editor).
class SheetPanel : public QWidget {
  Q_OBJECT

 public:
  /// `largeTargets`: buttons of at least 44 pixels, for fingers.
  explicit SheetPanel(bool largeTargets = false, QWidget* parent = nullptr);

  void setTheme(const Theme& theme);
  void retranslate();
  /// Scores alone, in compact rows: no comment, no "not assessable".
  void setScoresOnly(RowShape shape = RowShape::kCompact);
  /// Goes on to the next row after a figure. After a "1" that may become a "10" it waits for the next key.
  void setAdvancing(bool advancing) noexcept {
    advancing_ = advancing;
    typed_points_.reset();
  }
  [[nodiscard]] bool advancing() const noexcept { return advancing_; }
  /// A sealed sheet is read only.
  void setReadOnly(bool readOnly);
  /// After undo, redo or another change from outside.
  void refresh();

  [[nodiscard]] bool readOnly() const noexcept { return readOnly_; }
  [[nodiscard]] const std::string& currentRow() const noexcept { return current_; }
  void setCurrentRow(const std::string& row);
  /// Scrolls no further than it takes to see the current row whole.
  void showCurrentRow();
  /// Digits, arrows, N, Backspace, Delete. False: not a key of the sheet.
  bool handleKey(int key, Qt::KeyboardModifiers modifiers);
  /// Puts the keyboard on the marked row.
  void takeFocus();

 Q_SIGNALS:
  /// The editor was changed by the user.
  void edited();
  void rowChanged();

 protected:
  /// The editor outlives its showing. Null: empty.
  void setEditor(SheetEditor* editor);
  [[nodiscard]] QPlainTextEdit* commentField() const noexcept { return comment_; }
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// Tab stays in the sheet: from the comment to the first row, and back. Ctrl+Enter and the mouse lead out.
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
  QFrame* edge_;  ///< between rows that are cut and the overall mark
  QVBoxLayout* rowsLayout_;
  QVBoxLayout* overallLayout_;  ///< below what scrolls: the overall mark is always seen
  QVBoxLayout* commentLayout_;  ///< below that, as wide as the scales
  QLabel* commentLabel_;
  QPlainTextEdit* comment_;
  std::vector<ScoreRow*> rows_;
  std::string current_;
  std::optional<std::int64_t> typed_points_;
  bool advancing_ = false;
  bool filling_ = false;
};

/// One line of the rubric: name, scale as buttons, the answer, anchors, and a field for why not.
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
  /// Whether a finger or the mouse is being put on it just now: then nothing may scroll away.
  [[nodiscard]] bool underFinger() const noexcept { return underFinger_; }
  /// Height down to the end of the scale; the anchors stand below.
  [[nodiscard]] int scaleEnd() const;
  /// Opens the field for the reason and puts the keyboard there.
  void askReason();

 Q_SIGNALS:
  void scored(qint64 steps);
  void reasoned(const QString& reason);
  void takenBack(const torsio::SheetAnswer& before);  ///< the reason was given up: so it was
  void wanted();                                      ///< clicked or tabbed to
  void finished();                                    ///< the reason is complete: back to the keys

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
  bool laidOut_ = false;  // has a width of its own
  bool underFinger_ = false;
  bool readOnly_ = false;
  int hovered_ = -1;
  SheetAnswer answer_;
  std::optional<SheetAnswer> asked_;  // the answer when the reason was asked for
  const Theme* theme_;
  QLabel* name_;
  QLabel* value_;
  QWidget* strip_;  // room for the cells
  QLabel* anchor_;
  QLineEdit* reason_;
};

}  // namespace torsio::gui
