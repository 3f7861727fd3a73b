// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/services/base/progress.h"
#include "app/services/centres/protocol.h"
#include "assessment/domain/ids.h"
#include "db/connection/value.h"
#include "sim/core/digest.h"

namespace torsio {

/// What a site package (*.torsio-site) says about itself; signed.
struct SiteManifest {
  CentreId centreId{};
  std::string centreCode{};
  std::string centreName{};
  std::string publicKey{};  ///< with which the package is signed, 64 hexadecimal digits
  std::string software{};
  std::int64_t madeUtc_us = 0;
  std::int64_t trailLength = 0;  ///< head of the centre's audit trail
  std::string trailHash{};
  std::string cohort{};
  std::string campaign{};  ///< empty: no evaluation of models
  bool simulated = false;  ///< some row of it; pooling refuses a package that has both kinds
  std::int64_t trainees = 0;
  std::int64_t leftOut = 0;     ///< trainees who do not agree to research
  std::int64_t sealedRows = 0;  ///< rows whose seal is the one of the centre's own trail
  std::int64_t otherRows = 0;   ///< rows that differ from theirs, since something was withheld
  TrialProtocol protocol{};
  std::map<std::string, std::int64_t> rows{};  ///< by table
  std::string contentHash{};                   ///< of everything before the manifest
};

/// Writes the rows of a package, then its manifest and signature.
class SitePackageWriter {
 public:
  explicit SitePackageWriter(std::ostream& out);
  void beginTable(const std::string& table, const std::vector<std::string>& columns);
  /// `seal`: of the row as it stands here; empty: its table has none.
  void add(const std::string& seal, const std::vector<Value>& row);
  /// Fills in rows and contentHash, calls `sign` with the text of the manifest, and ends the package. Returns
  /// the manifest.
  SiteManifest finish(SiteManifest manifest, const std::function<std::string(const std::string& text)>& sign);

 private:
  void put(const std::string& bytes);

  std::ostream& out_;
  Digest digest_;
  std::string table_;
  std::map<std::string, std::int64_t> rows_;
};

/// One row of a package.
struct SitePackageRow {
  const std::string& table;
  const std::vector<std::string>& columns;
  const std::string& seal;
  std::vector<Value>& values;
};

/// Returns what a row says about itself; empty: nothing.
[[nodiscard]] std::optional<bool> isSimulated(const std::vector<std::string>& columns,
                                              const std::vector<Value>& values);

struct CheckedPackage {
  SiteManifest manifest{};
  std::string hash{};  ///< of the manifest, which holds that of the content: identifies the package
};

/// Reads a package to its end and checks signature, content and the seal of every row. `publicKey`: the key
/// that it must be signed with, in small or capital letters; empty: any. Throws Error: kUsage if that is no
/// key; kFileMissing; kFileUnreadable if it is no package, or its first line was changed; kVerifyFailed if a
/// byte was changed, it is cut off, or signed with another key; kBadData if it breaks the rules of such
/// files; kNewerSchema if a newer version made it; what `progress` throws.
[[nodiscard]] CheckedPackage checkSitePackage(const std::filesystem::path& file,
                                              const std::string& publicKey = {},
                                              const ProgressCallback& progress = {});

/// Calls `take` with every row of a package that was checked before, parents first. Throws Error
/// (kVerifyFailed) if the file has changed since.
void readSitePackage(const std::filesystem::path& file, const CheckedPackage& checked,
                     const std::function<void(const SitePackageRow& row)>& take);

}  // namespace torsio
