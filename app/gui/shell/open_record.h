// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QString>

#include "app/gui/shell/shell_setup.h"
#include "app/services/maintenance/station_anchor.h"

namespace torsio::gui {

/// The record that this station works with: the session of whoever signed in, the line for what nobody waits
/// for, and the learning records that leave meanwhile. GUI thread.
class OpenRecord {
 public:
  /// `setup` outlives it.
  explicit OpenRecord(const ShellSetup& setup) : setup_(setup), locator_(setup.locator) {}

  [[nodiscard]] const QString& locator() const noexcept { return locator_; }
  /// From the next open() on.
  void setLocator(const QString& locator) { locator_ = locator; }
  [[nodiscard]] SessionKey key() const;
  /// Null while the record is closed.
  [[nodiscard]] SessionContext* session() const noexcept { return session_.get(); }
  /// Null until startLine().
  [[nodiscard]] StationWriter* line() const noexcept { return line_.get(); }

  /// A session for nobody yet. Throws DbError.
  void open();
  void startLine();
  /// Stops what works beside the session.
  void stopLine();
  /// The same, and tells the record that the station leaves.
  void leave();
  /// Leaves, and ends the session.
  void close();
  /// Nobody is signed in any more. Returns the head of the audit trail when an administrator left; without a
  /// line where it cannot be read, and then why.
  std::optional<LeftHead> signOut();
  /// After the server was away. False: it is away again, or never was back.
  [[nodiscard]] bool reconnect();

 private:
  const ShellSetup& setup_;
  QString locator_;
  std::unique_ptr<SessionContext> session_;
  std::unique_ptr<StationWriter> line_;
  std::shared_ptr<void> lessons_;  ///< an LrsWorker, where that connector is built in
};

}  // namespace torsio::gui
