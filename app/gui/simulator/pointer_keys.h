// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <QCoreApplication>
#include <QString>

class QWidget;

namespace torsio::gui {

/// User-defined keys of movements. The controls only know the default keys; this maps a pressed key to the
/// default key of its movement.
class PointerKeys {
  Q_DECLARE_TR_FUNCTIONS(PointerKeys)

 public:
  struct Movement {
    const char* id;  ///< in the settings: "twist-left"
    int usual;       ///< default, Qt::Key
  };
  static constexpr std::size_t kMovements = 15;
  [[nodiscard]] static const std::array<Movement, kMovements>& movements();
  /// Name of a movement in the user's language.
  [[nodiscard]] static QString nameOf(std::size_t movement);

  PointerKeys();
  [[nodiscard]] int keyOf(std::size_t movement) const { return keys_[movement]; }
  /// Assigns a key. False, without a change, if another movement has it.
  [[nodiscard]] bool assign(std::size_t movement, int key);
  /// Returns the default key of the movement assigned to `pressed`. An unassigned key is returned unchanged,
  /// or as 0 if it is the default key of a reassigned movement.
  [[nodiscard]] int usualFor(int pressed) const;

  /// Returns how mouse and default keys move instrument and camera: effect and input.
  [[nodiscard]] static std::vector<std::pair<QString, QString>> help();

  /// Reads from the user's settings; invalid values get the defaults.
  [[nodiscard]] static PointerKeys stored();
  void store() const;

 private:
  std::array<int, kMovements> keys_;
};

/// Asks for the keys, one per movement, and stores them if accepted. True if they have changed.
bool askPointerKeys(QWidget* parent);
/// Shows PointerKeys::help().
void showPointerKeys(QWidget* parent);

}  // namespace torsio::gui
