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

/// Moves an element up (-1) or down (+1). Returns its new index.
template <typename T>
int moved(std::vector<T>& list, int row, int by) {
  const int to = row + by;
  if (row < 0 || row >= std::ssize(list) || to < 0 || to >= std::ssize(list)) {
    return row;
  }
  std::swap(list[static_cast<std::size_t>(row)], list[static_cast<std::size_t>(to)]);
  return to;
}

/// Editor of an ordered list: on the left the list with buttons to add, remove and move, on the right a
/// scrolling form for the selected element. The page owns the elements and carries out the requests. GUI
/// thread.
class OrderedList : public QWidget {
  Q_OBJECT

 public:
  /// `name`: object name of the list. Takes ownership of the form.
  OrderedList(const QString& name, QWidget* form, QWidget* parent = nullptr);

  /// Shows these lines and selects `row`, or the last one if there are fewer. Emits nothing.
  void setLines(const QStringList& lines, int row);
  /// Replaces the text of the selected line.
  void setCurrentLine(const QString& line);
  /// Returns the selected row; -1: none.
  [[nodiscard]] int row() const;
  /// Disables adding, removing and moving.
  void setReadOnly(bool readOnly);
  /// Sets the accessible name of the list.
  void setListName(const QString& name);
  void retranslate();

  /// Returns the selected element of the things listed; null: none.
  template <typename T>
  [[nodiscard]] T* chosenOf(std::vector<T>& things) const {
    const int at = row();
    return at >= 0 && at < std::ssize(things) ? &things[static_cast<std::size_t>(at)] : nullptr;
  }
  /// Removes the selected element. Returns the row to select next; empty: nothing was selected.
  template <typename T>
  std::optional<int> removeChosen(std::vector<T>& things) const {
    if (chosenOf(things) == nullptr) {
      return std::nullopt;
    }
    things.erase(things.begin() + row());
    return row();
  }
  /// Moves the selected element up (-1) or down (+1). Returns its new row; empty: it did not move.
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

/// A field for a required, unique code, with its error message.
class CodeField {
 public:
  CodeField();
  [[nodiscard]] QLineEdit* field() const noexcept { return field_; }
  [[nodiscard]] QLabel* problem() const noexcept { return problem_; }
  /// Shows a code without an error.
  void show(const std::string& code);
  /// Returns the code typed instead of `before`; empty if unchanged. Refuses a missing code or one in `taken`
  /// with its message, and shows `before` again.
  [[nodiscard]] std::optional<std::string> changed(const std::string& before,
                                                   const std::vector<std::string>& taken,
                                                   const QString& missing, const QString& used);

 private:
  QLineEdit* field_;
  QLabel* problem_;
};

}  // namespace torsio::gui
