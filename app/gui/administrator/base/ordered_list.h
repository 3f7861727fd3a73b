// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QStringList>
#include <QWidget>

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace torsio::gui {

/// Moves an element up (-1) or down (+1). Returns where it is then.
template <typename T>
int moved(std::vector<T>& list, int row, int by) {
  const int to = row + by;
  if (row < 0 || row >= std::ssize(list) || to < 0 || to >= std::ssize(list)) {
    return row;
  }
  std::swap(list[static_cast<std::size_t>(row)], list[static_cast<std::size_t>(to)]);
  return to;
}

/// Things in an order: a list with buttons that add, remove and move them on the left, a form that scrolls
/// for the chosen one on the right. The page keeps the things and does what is wanted. GUI thread.
class OrderedList : public QWidget {
  Q_OBJECT

 public:
  /// `name`: object name of the list. Takes the form.
  OrderedList(const QString& name, QWidget* form, QWidget* parent = nullptr);

  /// Shows these lines with one of them chosen; the last one where there are fewer. Emits nothing.
  void setLines(const QStringList& lines, int row);
  /// Writes the chosen line anew.
  void setCurrentLine(const QString& line);
  /// -1: none.
  [[nodiscard]] int row() const;
  /// Nothing can be added, removed or moved.
  void setReadOnly(bool readOnly);
  /// What the list is called where it is read aloud.
  void setListName(const QString& name);
  void retranslate();

  /// The chosen element of the things that the lines stand for; null: none.
  template <typename T>
  [[nodiscard]] T* chosenOf(std::vector<T>& things) const {
    const int at = row();
    return at >= 0 && at < std::ssize(things) ? &things[static_cast<std::size_t>(at)] : nullptr;
  }
  /// Takes the chosen element out of the things that the lines stand for. Gives the row to choose then;
  /// empty: nothing is chosen.
  template <typename T>
  std::optional<int> removeChosen(std::vector<T>& things) const {
    if (chosenOf(things) == nullptr) {
      return std::nullopt;
    }
    things.erase(things.begin() + row());
    return row();
  }
  /// Moves the chosen element up (-1) or down (+1). Gives the row where it is then; empty: it stays.
  template <typename T>
  std::optional<int> moveChosen(std::vector<T>& things, int by) const {
    const int to = moved(things, row(), by);
    return to == row() ? std::nullopt : std::optional(to);
  }

 Q_SIGNALS:
  void chosen();
  void addWanted();
  void removeWanted();
  void moveWanted(int by);  ///< -1 up, +1 down

 private:
  void enableButtons();

  QListWidget* list_;
  QPushButton* add_;
  QPushButton* remove_;
  QPushButton* up_;
  QPushButton* down_;
  bool readOnly_ = false;
};

/// The field for a code that must be there and be its own, with the sentence that says when it is not.
class CodeField {
 public:
  CodeField();
  [[nodiscard]] QLineEdit* field() const noexcept { return field_; }
  [[nodiscard]] QLabel* problem() const noexcept { return problem_; }
  /// Shows a code, and no problem.
  void show(const std::string& code);
  /// What was typed in place of `before`; empty where nothing changes. A code that is missing, or among
  /// `taken`, is refused with the sentence for it, and `before` is shown again.
  [[nodiscard]] std::optional<std::string> changed(const std::string& before,
                                                   const std::vector<std::string>& taken,
                                                   const QString& missing, const QString& used);

 private:
  QLineEdit* field_;
  QLabel* problem_;
};

}  // namespace torsio::gui
