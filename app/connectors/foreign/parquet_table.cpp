// SPDX-License-Identifier: GPL-3.0-or-later
// The format: https://parquet.apache.org/docs/file-format. Numbers of fields and kinds below are those of its
// parquet.thrift.
#include "app/connectors/foreign/parquet_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/connectors/foreign/parquet_column.h"
#include "app/connectors/foreign/parquet_meta.h"
#include "app/connectors/foreign/parquet_thrift.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::string_view kParquetMark = "PAR1";
constexpr std::string_view kEncryptedMark = "PARE";
constexpr std::size_t kFooterEnd = 8;                // its length and the mark
constexpr std::size_t kMaxFooterBytes = 16U << 20U;  // limit: what a damaged file may make this program hold
constexpr std::int64_t kMaxRows = 50'000'000;

/// Parses "state[3]"; empty for another form.
std::optional<std::pair<std::string, std::size_t>> itemOf(const std::string& wanted) {
  const std::size_t bracket = wanted.rfind('[');
  if (bracket == std::string::npos || bracket == 0 || wanted.back() != ']') {
    return std::nullopt;
  }
  std::size_t item = 0;
  const char* const end = wanted.data() + wanted.size() - 1;
  const auto [stop, error] = std::from_chars(wanted.data() + bracket + 1, end, item);
  return stop == end && error == std::errc() ? std::optional(std::pair(wanted.substr(0, bracket), item))
                                             : std::nullopt;
}

}  // namespace

bool isParquet(const std::filesystem::path& file) {
  std::array<char, kParquetMark.size()> head{};
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), head.size());
  return in && std::string_view(head.data(), head.size()) == kParquetMark;
}

class ParquetTable::Reader {
 public:
  Reader(const std::filesystem::path& file, std::string name, const std::vector<std::string>& columns)
      : file_(file, std::move(name)) {
    readFooter();
    for (const std::string& column : columns) {
      choose(column);
    }
  }

  bool next(std::vector<std::string>& cells) {
    while (rowsLeft_ == 0) {
      if (groupsLeft_ == 0) {
        return false;
      }
      nextGroup();
    }
    --rowsLeft_;
    for (ParquetColumnReader& column : columns_) {
      column.next();
    }
    cells.resize(wanted_.size());
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      cells[i] = columns_[wanted_[i].column].item(wanted_[i].item);
    }
    return true;
  }
  [[nodiscard]] std::string timeUnit(std::size_t column) const {
    return columns_[wanted_[column].column].leaf().timeUnit;
  }

 private:
  /// A cell of a row.
  struct Wanted {
    std::size_t column = 0;  ///< of columns_
    std::size_t item = 0;
  };

  [[noreturn]] void refuseFile(const Text& what, const Text& remedy) const {
    refuse(what, file_.name(), remedy);
  }

  void readFooter() {
    const std::size_t least = kParquetMark.size() + kFooterEnd;
    const std::string end = file_.size() < least ? std::string(kFooterEnd, '\0')
                                                 : file_.bytesAt(file_.size() - kFooterEnd, kFooterEnd);
    const std::string mark = end.substr(kFooterEnd - kParquetMark.size());
    if (mark == kEncryptedMark) {
      refuseFile(Text::tr("the Parquet file is encrypted"), Text::tr("Write it without encryption"));
    }
    if (mark != kParquetMark || file_.bytesAt(0, kParquetMark.size()) != kParquetMark) {
      refuseFile(Text::tr("this is not a complete Parquet file"),
                 Text::tr("Choose a Parquet file, or name the form that this file has"));
    }
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      length |= static_cast<std::size_t>(static_cast<unsigned char>(end[i])) << 8U * i;
    }
    if (length > file_.size() - least || length > kMaxFooterBytes) {
      refuseDamagedParquet(file_.name());
    }
    const std::size_t dataEnd = file_.size() - kFooterEnd - length;
    file_.endDataAt(dataEnd);
    footer_ = file_.bytesAt(dataEnd, length);
    try {
      hearFooter();
    } catch (const ThriftReader::Damaged&) {
      refuseDamagedParquet(file_.name());
    }
    if (rows_ < 0 || rows_ > kMaxRows) {
      refuseFile(Text::tr("the file has %1 {row|rows}, more than 50 million", rows_),
                 Text::tr("Split it into a file for each recording"));
    }
  }

  void hearFooter() {
    ThriftReader in(footer_);
    in.fields([&](int field, unsigned) {
      switch (field) {
        case 2:
          leaves_ = leavesOf(in);
          return true;
        case 3:
          rows_ = in.whole();
          return true;
        case 4: {
          groupsAt_ = in.at();
          in.skip(ThriftReader::kList);
          return true;
        }
        default:
          return false;
      }
    });
    if (groupsAt_ > 0) {
      groups_.emplace(std::string_view(footer_).substr(groupsAt_));
      groupsLeft_ = groups_->list().size;
    }
  }

  /// `wanted`: the name of a column, or of an item of its lists: "state[3]".
  void choose(const std::string& wanted) {
    const auto isIt = [](const std::string& name) {
      return [&name](const ParquetLeaf& leaf) { return leaf.name == name; };
    };
    auto found = std::find_if(leaves_.begin(), leaves_.end(), isIt(wanted));
    std::size_t item = 0;
    bool isItem = false;
    if (const auto named = itemOf(wanted); found == leaves_.end() && named) {
      found = std::find_if(leaves_.begin(), leaves_.end(), isIt(named->first));
      item = named->second;
      isItem = true;
    }
    if (found == leaves_.end() || (isItem && found->shape == ParquetLeaf::Shape::kFlat)) {
      refuseFile(Text::tr("there must be exactly one column '%1'", wanted),
                 Text::tr("Use one of its columns: %1", knownColumns()));
    }
    if (found->shape == ParquetLeaf::Shape::kGroups) {
      refuse(Text::tr("the column has groups of values, or lists of lists"), file_.placeOf(*found),
             Text::tr("Write each of its numbers as a column of its own"));
    }
    if (found->shape == ParquetLeaf::Shape::kList && !isItem) {
      refuse(Text::tr("each row of the column has a list"), file_.placeOf(*found),
             Text::tr("Name an item of it, counted from 0: %1", found->name + "[0]"));
    }
    if (std::count_if(leaves_.begin(), leaves_.end(), isIt(found->name)) > 1) {
      refuseFile(Text::tr("there must be exactly one column '%1'", found->name),
                 Text::tr("Rename the others"));
    }
    requireReadable(*found);
    const auto leaf = static_cast<std::size_t>(found - leaves_.begin());
    const auto known = std::find(leafOf_.begin(), leafOf_.end(), leaf);
    wanted_.push_back({static_cast<std::size_t>(known - leafOf_.begin()), item});
    if (known == leafOf_.end()) {
      columns_.emplace_back(file_, *found);
      leafOf_.push_back(leaf);
    }
  }

  [[nodiscard]] std::string knownColumns() const {
    std::string known;
    constexpr std::size_t kMaxNames = 300;  // letters
    for (const ParquetLeaf& leaf : leaves_) {
      if (known.size() > kMaxNames) {
        return known + ", …";
      }
      known +=
          (known.empty() ? "" : ", ") + leaf.name + (leaf.shape == ParquetLeaf::Shape::kList ? "[0]" : "");
    }
    return known;
  }

  void requireReadable(const ParquetLeaf& leaf) const {
    const bool number = leaf.kind == ParquetKind::kInt32 || leaf.kind == ParquetKind::kInt64 ||
                        leaf.kind == ParquetKind::kFloat || leaf.kind == ParquetKind::kDouble ||
                        leaf.kind == ParquetKind::kBoolean;
    constexpr std::int64_t kMaxScale = 18;
    if (!number && !(leaf.kind == ParquetKind::kBytes && leaf.isText)) {
      refuse(Text::tr("the column is stored in a way that is not read (%1)",
                      leaf.isHalf                             ? "FLOAT16"
                      : leaf.kind == ParquetKind::kInt96      ? "INT96"
                      : leaf.kind == ParquetKind::kFixedBytes ? "FIXED_LEN_BYTE_ARRAY"
                                                              : "BYTE_ARRAY"),
             file_.placeOf(leaf),
             Text::tr("Write it as whole numbers, as decimal numbers of 32 or 64 bits, or as text"));
    }
    if (leaf.scale < 0 || leaf.scale > kMaxScale) {
      refuseDamagedParquet(file_.name());
    }
  }

  void nextGroup() {
    --groupsLeft_;
    std::vector<ParquetChunk> found(columns_.size());
    std::int64_t rows = -1;
    std::size_t chunks = 0;
    try {
      groups_->fields([&](int field, unsigned) {
        if (field == 3) {
          rows = groups_->whole();
          return true;
        }
        if (field != 1) {
          return false;
        }
        chunks = groups_->list().size;
        for (std::size_t i = 0; i < chunks; ++i) {
          const ParquetChunk chunk = chunkOf(*groups_);
          for (std::size_t c = 0; c < columns_.size(); ++c) {
            if (leafOf_[c] == i) {
              found[c] = chunk;
            }
          }
        }
        return true;
      });
    } catch (const ThriftReader::Damaged&) {
      refuseDamagedParquet(file_.name());
    }
    if (chunks != leaves_.size() || rows < 0 || rows > rows_ - rowsSeen_) {
      refuseDamagedParquet(file_.name());
    }
    rowsSeen_ += rows;
    rowsLeft_ = rows;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      columns_[c].begin(found[c], rows);
    }
    if (groupsLeft_ == 0 && rowsSeen_ != rows_) {
      refuseDamagedParquet(file_.name());
    }
  }

  ParquetBytes file_;
  std::string footer_;
  std::vector<ParquetLeaf> leaves_;
  std::vector<ParquetColumnReader> columns_;
  std::vector<std::size_t> leafOf_;  ///< of each of these columns, its place among all
  std::vector<Wanted> wanted_;
  std::int64_t rows_ = 0;
  std::int64_t rowsSeen_ = 0;  ///< in row groups up to the current one
  std::int64_t rowsLeft_ = 0;  ///< in the current one
  std::size_t groupsAt_ = 0;
  std::size_t groupsLeft_ = 0;
  std::optional<ThriftReader> groups_;
};

ParquetTable::ParquetTable(const std::filesystem::path& file, std::string name,
                           const std::vector<std::string>& columns)
    : reader_(std::make_unique<Reader>(file, std::move(name), columns)) {}
ParquetTable::~ParquetTable() = default;

bool ParquetTable::next(std::vector<std::string>& cells) {
  return reader_->next(cells);
}

std::string ParquetTable::timeUnit(std::size_t column) const {
  return reader_->timeUnit(column);
}

}  // namespace torsio
