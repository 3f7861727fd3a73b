// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "sim/record/trial.h"

namespace torsio {

class Connection;

/// The database of this station when none is named: torsio.sqlite in the user's data folder, which is made
/// when missing. Needs a QCoreApplication (its name decides the folder). Throws Error{kFileUnwritable}.
[[nodiscard]] std::string defaultDatabase();

/// Recorded trials of one database, for the window. Belongs to the thread that made it.
class TrialStore {
 public:
  /// Opens or makes the database and brings its schema up to date. Throws Error, DbError.
  explicit TrialStore(const std::string& locator);
  ~TrialStore();

  /// Newest first, finished or not.
  [[nodiscard]] std::vector<TrialListing> list();
  [[nodiscard]] Trial load(const TrialId& trialId);
  /// Where it is, for people; never a password.
  [[nodiscard]] const std::string& location() const noexcept;

 private:
  std::unique_ptr<Connection> connection_;
};

}  // namespace torsio
