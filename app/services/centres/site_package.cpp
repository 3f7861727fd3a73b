// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/centres/site_package.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/maintenance/signing_key.h"
#include "assessment/domain/study/site.h"
#include "db/repository/base/seal_rules.h"
#include "sim/core/error.h"
#include "sim/core/plain_text.h"

namespace torsio {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::string_view kMagic = "torsio-site 1\n";
constexpr std::size_t kMaxColumns = 200;
constexpr std::size_t kLongestName = 100;
constexpr std::size_t kLongestText = std::size_t{64} << 20U;     // bytes of one value
constexpr std::size_t kLongestManifest = std::size_t{8} << 20U;  // bytes
constexpr int kDeepest = 64;                                     // objects and lists within each other
constexpr std::int64_t kRowsPerProgress = 2000;

enum class Frame : std::uint8_t { kTable = 'T', kRow = 'R', kManifest = 'M', kSignature = 'S' };
enum class Kind : std::uint8_t { kNull = 0, kInteger = 1, kReal = 2, kText = 3, kBytes = 4, kFlag = 5 };

void putNumber(std::string& out, std::uint64_t number, int bytes) {
  for (int i = 0; i < bytes; ++i) {
    out += static_cast<char>((number >> (8 * i)) & 0xFFU);
  }
}

void putText(std::string& out, std::string_view text) {
  putNumber(out, text.size(), 4);
  out += text;
}

void putValue(std::string& out, const Value& value) {
  struct Visitor {
    std::string& out;
    void kind(Kind kind) const { out += static_cast<char>(kind); }
    void operator()(std::monostate) const { kind(Kind::kNull); }
    void operator()(std::int64_t number) const {
      kind(Kind::kInteger);
      putNumber(out, static_cast<std::uint64_t>(number), 8);
    }
    void operator()(double number) const {
      kind(Kind::kReal);
      putNumber(out, std::bit_cast<std::uint64_t>(number), 8);
    }
    void operator()(bool flag) const {
      kind(Kind::kFlag);
      putNumber(out, flag ? 1 : 0, 1);
    }
    void operator()(const std::string& text) const {
      kind(Kind::kText);
      putText(out, text);
    }
    void operator()(const Blob& bytes) const {
      kind(Kind::kBytes);
      putText(out, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
  };
  std::visit(Visitor{out}, value.storage());
}

[[noreturn]] void changed(const std::filesystem::path& file) {
  throw Error(ErrorCode::kVerifyFailed, Text::tr("this package is not as its centre signed it"),
              file.string(), Text::tr("Ask the centre for a new one; nothing was taken from it"));
}

[[noreturn]] void brokenRules(const std::filesystem::path& file) {
  refuse(Text::tr("this package does not follow the rules of such files"), file.string(),
         Text::tr("Ask the centre to export it again with torsio study export"));
}

std::string manifestText(const SiteManifest& manifest) {
  OrderedJson rows = OrderedJson::object();
  for (const auto& [table, count] : manifest.rows) {
    rows[table] = count;
  }
  OrderedJson protocol = OrderedJson::object();
  for (const auto& [part, json] : manifest.protocol.parts) {
    protocol[part] = OrderedJson::parse(json);
  }
  const OrderedJson text{{"format", "torsio site package 1"},
                         {"centre",
                          {{"id", manifest.centreId.text()},
                           {"code", manifest.centreCode},
                           {"name", manifest.centreName},
                           {"public_key", manifest.publicKey}}},
                         {"software", manifest.software},
                         {"made_utc_us", manifest.madeUtc_us},
                         {"trail", {{"length", manifest.trailLength}, {"hash", manifest.trailHash}}},
                         {"cohort", manifest.cohort},
                         {"evaluation", manifest.campaign},
                         {"simulated", manifest.simulated},
                         {"trainees", manifest.trainees},
                         {"left_out", manifest.leftOut},
                         {"sealed_rows", manifest.sealedRows},
                         {"other_rows", manifest.otherRows},
                         {"protocol_hash", manifest.protocol.hash()},
                         {"protocol", protocol},
                         {"rows", rows},
                         {"content_hash", manifest.contentHash}};
  return text.dump(1);
}

/// Returns whether objects and lists lie within each other no deeper than a manifest may have them.
bool isFlat(const std::string& text) {
  int depth = 0;
  bool inText = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inText) {
      i += c == '\\' ? 1 : 0;
      inText = c != '"';
    } else if (c == '"') {
      inText = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kDeepest) {
        return false;
      }
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return true;
}

/// Returns whether a text is "7f3a0000-0000-4000-8000-000000000000".
bool isUuid(const std::string& text) {
  constexpr std::string_view kPattern = "xxxxxxxx-xxxx-xxxx-xxxx-xxxxxxxxxxxx";
  return std::equal(text.begin(), text.end(), kPattern.begin(), kPattern.end(), [](char c, char expected) {
    return expected == '-' ? c == '-' : (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
  });
}

/// Throws nlohmann's exceptions for anything that is not such a manifest.
SiteManifest manifestOf(const nlohmann::json& json) {
  SiteManifest manifest;
  const nlohmann::json& centre = json.at("centre");
  manifest.centreId = centre.at("id").get<std::string>();
  manifest.centreCode = centre.at("code").get<std::string>();
  manifest.centreName = centre.at("name").get<std::string>();
  manifest.publicKey = centre.at("public_key").get<std::string>();
  manifest.software = json.at("software").get<std::string>();
  manifest.madeUtc_us = json.at("made_utc_us").get<std::int64_t>();
  manifest.trailLength = json.at("trail").at("length").get<std::int64_t>();
  manifest.trailHash = json.at("trail").at("hash").get<std::string>();
  manifest.cohort = json.at("cohort").get<std::string>();
  manifest.campaign = json.at("evaluation").get<std::string>();
  manifest.simulated = json.at("simulated").get<bool>();
  manifest.trainees = json.at("trainees").get<std::int64_t>();
  manifest.leftOut = json.at("left_out").get<std::int64_t>();
  manifest.sealedRows = json.at("sealed_rows").get<std::int64_t>();
  manifest.otherRows = json.at("other_rows").get<std::int64_t>();
  for (const auto& [part, content] : json.at("protocol").items()) {
    manifest.protocol.parts[part] = content.dump();
  }
  for (const auto& [table, count] : json.at("rows").items()) {
    manifest.rows[table] = count.get<std::int64_t>();
  }
  manifest.contentHash = json.at("content_hash").get<std::string>();
  return manifest;
}

/// Walks the frames of a file. No length in it is trusted: no more is read than the file has.
class Walk {
 public:
  explicit Walk(const std::filesystem::path& file) : file_(file), buffer_(std::size_t{1} << 20U) {
    std::error_code fault;
    if (!std::filesystem::exists(file, fault)) {
      throw Error(ErrorCode::kFileMissing, Text::tr("there is no such file"), file.string(),
                  Text::tr("Check the path"));
    }
    if (!std::filesystem::is_regular_file(file, fault)) {
      noPackage();
    }
    left_ = std::filesystem::file_size(file, fault);
    in_.rdbuf()->pubsetbuf(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    in_.open(file, std::ios::binary);
    std::string magic(kMagic.size(), '\0');
    if (!in_ || left_ < magic.size() || !in_.read(magic.data(), static_cast<std::streamsize>(magic.size())) ||
        magic != kMagic) {
      noPackage();
    }
    left_ -= magic.size();
    digest_.update(kMagic);
  }

  /// Calls `table` at the beginning of each table and `row` with each row. Leaves manifest and signature.
  template <typename OnTable, typename OnRow>
  void walk(const OnTable& table, const OnRow& row) {
    std::string name;
    std::vector<std::string> columns;
    std::vector<Value> values;
    std::string seal;
    for (;;) {
      held_.clear();
      const auto frame = static_cast<Frame>(number(1));
      if (frame == Frame::kManifest) {
        contentHash = digest_.hex();
        manifest = text(kLongestManifest);
        if (static_cast<Frame>(number(1)) != Frame::kSignature) {
          changed(file_);
        }
        signature = text(kLongestName * 2);
        if (left_ != 0) {
          changed(file_);
        }
        return;
      }
      if (frame == Frame::kTable) {
        name = text(kLongestName);
        if (!tables_.insert(name).second) {  // its rows would be read with other columns
          changed(file_);
        }
        columns.resize(static_cast<std::size_t>(number(2)));
        if (columns.size() > kMaxColumns) {
          changed(file_);
        }
        for (std::string& column : columns) {
          column = text(kLongestName);
        }
        digest_.update(held_);
        table(std::as_const(name), std::as_const(columns));
      } else if (frame == Frame::kRow && !columns.empty()) {
        seal = text(kLongestName);
        values.clear();
        for (std::size_t i = 0; i < columns.size(); ++i) {
          values.push_back(value());
        }
        digest_.update(held_);
        row(SitePackageRow{name, columns, seal, values});
      } else {
        changed(file_);
      }
    }
  }

  std::string contentHash;
  std::string manifest;
  std::string signature;

  [[noreturn]] void noPackage() const {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("is not a site package"), file_.string(),
                Text::tr("Give a file that torsio study export wrote"));
  }

 private:
  /// Reads bytes into what is hashed with this frame. Returns where they begin there.
  std::size_t take(std::size_t bytes) {
    if (bytes > left_) {
      changed(file_);
    }
    const std::size_t at = held_.size();
    held_.resize(at + bytes);
    if (!in_.read(held_.data() + at, static_cast<std::streamsize>(bytes))) {
      changed(file_);
    }
    left_ -= bytes;
    return at;
  }
  std::uint64_t number(std::size_t bytes) {
    const std::size_t at = take(bytes);
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      number |= std::uint64_t{static_cast<unsigned char>(held_[at + i])} << (8 * i);
    }
    return number;
  }
  std::string text(std::size_t most) {
    const std::size_t size = number(4);
    if (size > most) {
      changed(file_);
    }
    const std::size_t at = take(size);
    return held_.substr(at, size);
  }
  Value value() {
    switch (static_cast<Kind>(number(1))) {
      case Kind::kNull:
        return {};
      case Kind::kInteger:
        return static_cast<std::int64_t>(number(8));
      case Kind::kReal: {
        const auto real = std::bit_cast<double>(number(8));
        if (!std::isfinite(real)) {
          changed(file_);
        }
        return real;
      }
      case Kind::kText:
        return text(kLongestText);
      case Kind::kBytes: {
        const std::string bytes = text(kLongestText);
        const auto raw = std::as_bytes(std::span(bytes));
        return Blob(raw.begin(), raw.end());
      }
      case Kind::kFlag:
        return number(1) != 0;
    }
    changed(file_);
  }

  std::filesystem::path file_;
  std::vector<char> buffer_;
  std::ifstream in_;
  std::uint64_t left_ = 0;
  std::string held_;  // bytes of the current frame
  Digest digest_;
  std::set<std::string> tables_;
};

/// Collects what the rows of a package say about themselves, and compares it when all are read.
class SealCheck {
 public:
  explicit SealCheck(const std::filesystem::path& file) : file_(file) {}

  void take(const SitePackageRow& row) {
    ++rows[row.table];
    if (siteTableOf(row.table) == nullptr || row.table == "trial_chunk") {
      return;
    }
    try {
      sealer_.add(row.table, row.columns, row.values);
      if (!row.seal.empty()) {
        told_[row.table][sealer_.keyOf(row.table, row.columns, row.values)] = row.seal;
      }
    } catch (const Error&) {  // a column of the key is missing
      broken_ = true;
    }
  }

  void compare() {
    if (broken_) {
      brokenRules(file_);
    }
    for (const SiteTable& one : siteTables()) {
      const std::string table(one.table);
      if (sealer_.seals(table) != told_[table]) {
        throw Error(ErrorCode::kVerifyFailed, Text::tr("rows of the table %1 do not fit their seals", table),
                    file_.string(), Text::tr("Ask the centre for a new one; nothing was taken from it"));
      }
    }
  }

  std::map<std::string, std::int64_t> rows;

 private:
  std::filesystem::path file_;
  SiteSealer sealer_;
  bool broken_ = false;
  std::map<std::string, std::map<std::string, std::string>> told_;
};

void requireKnown(const std::filesystem::path& file, const std::string& table) {
  if (siteTableOf(table) == nullptr) {
    throw Error(ErrorCode::kNewerSchema,
                Text::tr("holds a table that this version does not know: %1", plainLine(table, 40)),
                file.string(), Text::tr("Update Torsio here first"));
  }
}

/// Returns a key as packages have it.
std::string keyIn(std::string given) {
  for (char& c : given) {
    c = c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  if (!given.empty() && !isPublicKey(given)) {
    throw Error(ErrorCode::kUsage, Text::tr("a public key is 64 hexadecimal digits"), plainLine(given, 80),
                Text::tr("Give the one that the centre told you"));
  }
  return given;
}

void requireKey(const std::filesystem::path& file, const SiteManifest& manifest,
                const std::string& publicKey) {
  if (!publicKey.empty() && manifest.publicKey != publicKey) {
    throw Error(ErrorCode::kVerifyFailed,
                Text::tr("is signed with another key than the one of centre %1", manifest.centreCode),
                file.string(), Text::tr("Ask the centre who made it; nothing was taken from it"));
  }
}

}  // namespace

std::optional<bool> isSimulated(const std::vector<std::string>& columns, const std::vector<Value>& values) {
  const auto place = std::find(columns.begin(), columns.end(), "demonstration");
  if (place == columns.end()) {
    return std::nullopt;
  }
  const Value& value = values[static_cast<std::size_t>(place - columns.begin())];
  if (const auto* flag = std::get_if<bool>(&value.storage())) {
    return *flag;
  }
  const auto* number = std::get_if<std::int64_t>(&value.storage());
  return number != nullptr && *number != 0;
}

SitePackageWriter::SitePackageWriter(std::ostream& out) : out_(out) {
  put(std::string(kMagic));
}

void SitePackageWriter::put(const std::string& bytes) {
  digest_.update(bytes);
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void SitePackageWriter::beginTable(const std::string& table, const std::vector<std::string>& columns) {
  table_ = table;
  std::string frame(1, static_cast<char>(Frame::kTable));
  putText(frame, table);
  putNumber(frame, columns.size(), 2);
  for (const std::string& column : columns) {
    putText(frame, column);
  }
  put(frame);
}

void SitePackageWriter::add(const std::string& seal, const std::vector<Value>& row) {
  std::string frame(1, static_cast<char>(Frame::kRow));
  putText(frame, seal);
  for (const Value& value : row) {
    putValue(frame, value);
  }
  put(frame);
  ++rows_[table_];
}

SiteManifest SitePackageWriter::finish(SiteManifest manifest,
                                       const std::function<std::string(const std::string& text)>& sign) {
  manifest.rows = rows_;
  manifest.contentHash = digest_.hex();
  const std::string text = manifestText(manifest);
  std::string frame(1, static_cast<char>(Frame::kManifest));
  putText(frame, text);
  frame += static_cast<char>(Frame::kSignature);
  putText(frame, sign(text));
  out_.write(frame.data(), static_cast<std::streamsize>(frame.size()));
  return manifest;
}

CheckedPackage checkSitePackage(const std::filesystem::path& file, const std::string& publicKey,
                                const ProgressCallback& progress) {
  const std::string wanted = keyIn(publicKey);
  Walk walk(file);
  SealCheck seals(file);
  std::optional<std::string> unknown;
  std::int64_t rows = 0;
  walk.walk(
      [&](const std::string& table, const std::vector<std::string>&) {
        if (siteTableOf(table) == nullptr && !unknown) {
          unknown = table;
        }
      },
      [&](const SitePackageRow& row) {
        seals.take(row);
        if (++rows % kRowsPerProgress == 0) {
          tellProgress(progress, Text::tr("Checking the package"), 0.0);
        }
      });
  if (!isFlat(walk.manifest)) {
    brokenRules(file);
  }
  CheckedPackage checked;
  try {
    const nlohmann::json told = nlohmann::json::parse(walk.manifest);
    if (!genuine(walk.manifest, walk.signature, told.at("centre").at("public_key").get<std::string>())) {
      changed(file);
    }
    checked.manifest = manifestOf(told);
  } catch (const nlohmann::json::exception&) {
    changed(file);
  }
  const SiteManifest& manifest = checked.manifest;
  if (manifest.contentHash != walk.contentHash) {
    changed(file);
  }
  requireKey(file, manifest, wanted);
  if (unknown) {
    requireKnown(file, *unknown);
  }
  if (manifest.rows != seals.rows || !isCentreCode(manifest.centreCode) ||
      !isUuid(manifest.centreId.text()) || manifest.cohort.empty()) {
    brokenRules(file);
  }
  seals.compare();
  Digest digest;
  digest.update(walk.manifest);
  checked.hash = digest.hex();
  return checked;
}

void readSitePackage(const std::filesystem::path& file, const CheckedPackage& checked,
                     const std::function<void(const SitePackageRow& row)>& take) {
  Walk walk(file);
  walk.walk([](const std::string&, const std::vector<std::string>&) {}, take);
  if (walk.contentHash != checked.manifest.contentHash) {
    changed(file);
  }
}

}  // namespace torsio
