// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include <QCoreApplication>
#include <QString>

class QWidget;

namespace torsio::gui {

/// Which key moves what. The controls know the usual keys only; this turns a pressed key into the usual one
/// of its movement, so that any movement may lie on any key.
class PointerKeys {
  Q_DECLARE_TR_FUNCTIONS(PointerKeys)

 public:
  struct Movement {
    const char* id;  ///< in the settings: "twist-left"
    int usual;       ///< Qt::Key
  };
  static constexpr std::size_t kMovements = 15;
  [[nodiscard]] static const std::array<Movement, kMovements>& movements();
  /// Name of a movement in the user's language.
  [[nodiscard]] static QString nameOf(std::size_t movement);

  PointerKeys();
  [[nodiscard]] int keyOf(std::size_t movement) const { return keys_[movement]; }
  /// False, and nothing changes, when another movement has the key already.
  [[nodiscard]] bool assign(std::size_t movement, int key);
  /// The usual key of the movement that lies on `pressed`. A key without a movement is itself, unless it is
  /// the usual key of one that was put elsewhere: then 0.
  [[nodiscard]] int usualFor(int pressed) const;

  /// From and to this user's settings. What cannot be read there stays usual.
  [[nodiscard]] static PointerKeys stored();
  void store() const;

 private:
  std::array<int, kMovements> keys_;
};

/// Asks for the keys, one a movement; keeps them when the user says so. True when they changed.
bool askPointerKeys(QWidget* parent);

}  // namespace torsio::gui
