// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QString>

#include "app/gui/shell/shell_setup.h"
#include "app/services/maintenance/station_anchor.h"

namespace torsio::gui {

/// The record of this station: the session, the writer for data that nobody waits for, and the worker that
/// sends learning records. GUI thread.
class OpenRecord {
 public:
  /// `setup` must outlive it.
  explicit OpenRecord(const ShellSetup& setup) : setup_(setup), locator_(setup.locator) {}

  [[nodiscard]] const QString& locator() const noexcept { return locator_; }
  /// Takes effect with the next open().
  void setLocator(const QString& locator) { locator_ = locator; }
  [[nodiscard]] SessionKey key() const;
  /// Returns the session; null while the record is closed.
  [[nodiscard]] SessionContext* session() const noexcept { return session_.get(); }
  /// Returns the writer; null until startLine().
  [[nodiscard]] StationWriter* line() const noexcept { return line_.get(); }

  /// Opens a session without an actor. Throws DbError.
  void open();
  void startLine();
  /// Stops the writer and the worker of learning records.
  void stopLine();
  /// Calls stopLine(), and records that the station leaves.
  void leave();
  /// Calls leave(), and ends the session.
  void close();
  /// Signs the actor out. Returns the head of the audit trail for an administrator; with an empty line and
  /// the reason if it cannot be read.
  std::optional<LeftHead> signOut();
  /// Reconnects after the server was lost. False: still or again away.
  [[nodiscard]] bool reconnect();

 private:
  const ShellSetup& setup_;
  QString locator_;
  std::unique_ptr<SessionContext> session_;
  std::unique_ptr<StationWriter> line_;
  std::shared_ptr<void> lessons_;  ///< an LrsWorker, if that connector is built in
};

/// Returns whether the window may close without showing the head. Prints to standard error where it was
/// stored.
[[nodiscard]] bool closesSilently(const LeftHead& head);

}  // namespace torsio::gui
