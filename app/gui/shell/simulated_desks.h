// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>

#include <QFrame>
#include <QObject>
#include <QString>

#include "app/services/access/session_context.h"

class QLabel;
class QPushButton;

namespace torsio {
enum class SimulatedRole;
}

namespace torsio::gui {

/// The desk shown to a visitor among simulated people.
enum class VisitedDesk { kTrainee, kPhysician, kAdministrator };

/// The line above a visitor's desk: one button per desk, the current one pressed.
class VisitBar : public QFrame {
  Q_OBJECT

 public:
  explicit VisitBar(QWidget* parent = nullptr);

  void setSeen(VisitedDesk desk);
  [[nodiscard]] VisitedDesk seen() const noexcept { return seen_; }

 Q_SIGNALS:
  /// Another desk was requested; the mark stays until setSeen().
  void wanted(VisitedDesk desk);

 private:
  void retranslate();

  VisitedDesk seen_ = VisitedDesk::kAdministrator;
  QLabel* sentence_;
  std::map<VisitedDesk, QPushButton*> desks_;
};

class Founding;
class OpenRecord;
class ShellContext;

/// Desks of simulated people: an administrator views one, or a visitor looks round in a temporary record of
/// them. GUI thread.
class SimulatedDesks : public QObject {
  Q_OBJECT

 public:
  /// All outlive it.
  SimulatedDesks(OpenRecord& record, Founding& founding, QWidget* window);
  ~SimulatedDesks() override;

  [[nodiscard]] VisitBar& bar() const noexcept { return *bar_; }
  /// Returns whether the present record is temporary.
  [[nodiscard]] bool lookingRound() const noexcept { return round_ != nullptr; }
  /// Returns whether the present desk has no owner who could return to it.
  [[nodiscard]] bool active() const noexcept { return simulated_ || lookingRound(); }

  /// Founds a temporary record of simulated people; `first`: the desk to open in it.
  void lookRound(VisitedDesk first);
  /// Makes the founder of that record its visitor. Returns the desk to open first.
  VisitedDesk begin();
  /// Takes the visitor to another desk, as a simulated person or as themselves.
  void visit(VisitedDesk desk, ShellContext& shell);
  /// Shows an administrator, or the visitor, the desk of a simulated person.
  void view(SimulatedRole role, ShellContext& shell);
  /// Leaves the simulated people. True: deleted a temporary record; the record is closed and has its earlier
  /// locator.
  bool end();
  [[nodiscard]] static QString visitorsSentence();

 Q_SIGNALS:
  /// The desk of this actor is to be opened with this notification.
  void wanted(const torsio::Actor& actor, const QString& sentence);

 private:
  struct Round;

  OpenRecord& record_;
  Founding& founding_;
  VisitBar* bar_;
  std::unique_ptr<Round> round_;
  bool simulated_ = false;  ///< an administrator is viewing a simulated person's desk
};

}  // namespace torsio::gui
