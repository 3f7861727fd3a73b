// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/row_seal.h"

#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include <sodium.h>

#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr const char* kSealColumns =
    "entry_sequence, position, table_name, row_key, removed, row_hash, personal_hash, simulated, before_hash";
constexpr std::string_view kEntries = R"({"entries":)";

std::string newSalt() {
  TORSIO_EXPECTS(sodium_init() >= 0);
  std::array<std::uint8_t, 16> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  return toHex(bytes);
}

}  // namespace

void forEachSeal(Connection& connection,
                 const std::function<void(std::int64_t, std::int64_t, const RowSeal&)>& hear) {
  forEachSelected(connection,
                  std::string("SELECT ") + kSealColumns + " FROM row_seal ORDER BY entry_sequence, position",
                  [&](const Statement& statement) {
                    RowReader row(statement);
                    const std::int64_t sequence = row.int64();
                    const std::int64_t position = row.int64();
                    RowSeal seal{.table = row.text(), .key = row.text()};
                    seal.removed = row.boolean();
                    seal.rowHash = row.text();
                    seal.personalHash = row.text();
                    seal.simulated = row.boolean();
                    seal.before = row.text();
                    hear(sequence, position, seal);
                  });
}

RowSeal sealedRow(const SealShape& shape, std::span<const Value> row, const std::string& seal) {
  RowSeal made{.table = std::string(shape.rule().table),
               .key = shape.keyOf(row),
               .rowHash = seal,
               .simulated = shape.simulated(row)};
  if (shape.hasPersonal(row)) {
    made.salt = newSalt();
    made.personalHash = shape.personal(row, made.salt);
  }
  return made;
}

void writeSeals(Connection& connection, const std::vector<RowSeal>& seals, const SealAuthor& author) {
  SealDigest digest;
  std::int64_t position = 0;
  for (const RowSeal& seal : seals) {
    digest.add(++position, seal);
  }
  const std::int64_t sequence = AuditRepository(connection)
                                    .append({.atUtc_us = author.atUtc_us,
                                             .actor = author.actor,
                                             .station = author.station,
                                             .action = AuditAction::kRecordSeal,
                                             .objectKind = AuditObject::kRowSeal,
                                             .newJson = sealedJson(author.entries, seals.size()),
                                             .reason = author.reason,
                                             .objectHash = digest.hex()});
  Statement insert = connection.prepare(insertInto("row_seal", kSealColumns));
  std::optional<Statement> salt;  // few tables hold personal data
  std::optional<Statement> forget;
  position = 0;
  for (const RowSeal& seal : seals) {
    insert.execute({sequence, ++position, seal.table, seal.key, seal.removed, seal.rowHash, seal.personalHash,
                    seal.simulated, seal.before});
    if (!seal.salt.empty()) {
      if (!salt) {
        salt = connection.prepare(insertInto("seal_salt", "table_name, row_key, salt") +
                                  " ON CONFLICT (table_name, row_key) DO UPDATE SET salt = excluded.salt");
      }
      salt->execute({seal.table, seal.key, seal.salt});
    } else if (!sealRuleOf(seal.table)->personal.empty()) {
      if (!forget) {
        forget = connection.prepare("DELETE FROM seal_salt WHERE table_name = ? AND row_key = ?");
      }
      forget->execute({seal.table, seal.key});
    }
  }
}

std::string sealedJson(std::int64_t entries, std::size_t rows) {
  return std::string(kEntries) + std::to_string(entries) + R"(,"rows":)" + std::to_string(rows) + "}";
}

std::int64_t entriesOf(const std::string& sealedJson) {
  std::int64_t entries = 0;
  if (sealedJson.starts_with(kEntries)) {
    std::from_chars(sealedJson.data() + kEntries.size(), sealedJson.data() + sealedJson.size(), entries);
  }
  return entries;
}

}  // namespace torsio
