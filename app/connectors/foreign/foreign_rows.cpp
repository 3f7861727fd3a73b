// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/foreign/foreign_rows.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "sim/core/byte_order_mark.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && blank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

/// File and line for error messages.
class RowReaderBase : public ForeignRows {
 public:
  RowReaderBase(const ForeignMap& map, std::string name) : map_(map), name_(std::move(name)) {}

 protected:
  [[noreturn]] void refuseLine(std::size_t line, const Text& what, const Text& remedy) const {
    refuse(what, name_ + ", line " + std::to_string(line), remedy);
  }
  [[nodiscard]] double number(std::string_view text, std::size_t line, const std::string& column) const {
    text = trimmed(text);
    if (!text.empty() && text.front() == '+') {
      text.remove_prefix(1);
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
      refuse(Text::tr("'%1' is not a number", std::string(text)),
             name_ + ", line " + std::to_string(line) + ", " + column,
             Text::tr("Write numbers with a decimal point; leave out lines without a pose"));
    }
    return value;
  }
  [[nodiscard]] const ForeignMap& map() const noexcept { return map_; }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

 private:
  const ForeignMap& map_;
  std::string name_;
};

/// 76 numbers: for each arm position 3, matrix 9, velocities 6, gripper 1.
class JigsawsRows final : public RowReaderBase {
 public:
  JigsawsRows(const ForeignMap& map, std::string name) : RowReaderBase(map, std::move(name)) {
    constexpr std::array<std::string_view, 4> kArms = {"master left", "master right", "slave left",
                                                       "slave right"};
    const auto arm = std::find(kArms.begin(), kArms.end(), map.instrument);
    if (arm == kArms.end()) {
      refuse(Text::tr("JIGSAWS has no instrument '%1'", map.instrument), map.name,
             Text::tr("Name master left, master right, slave left or slave right"));
    }
    if (map.rotation != RotationForm::kMatrixRows && map.rotation != RotationForm::kMatrixColumns) {
      refuse(Text::tr("JIGSAWS has rotation matrices"), map.name,
             Text::tr("Name their form: matrix rows or matrix columns"));
    }
    first_ = kPerArm * static_cast<std::size_t>(arm - kArms.begin());
  }
  bool read(std::string_view line, std::size_t number, ForeignRow& row) override {
    line = trimmed(line);
    if (line.empty()) {
      return false;
    }
    std::size_t count = 0;
    std::array<double, kPerArm> own{};
    while (!line.empty()) {
      const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
      const double value = this->number(line.substr(0, end), number, "column " + std::to_string(count + 1));
      if (count >= first_ && count < first_ + kPerArm) {
        own[count - first_] = value;
      }
      ++count;
      line = trimmed(line.substr(end));
    }
    if (count != kNumbers) {
      refuseLine(number, Text::tr("the line has %1 {number|numbers}, not 76", count),
                 Text::tr("Use the kinematics files of JIGSAWS as they are"));
    }
    row.position = {own[0], own[1], own[2]};
    row.rotation.assign(own.begin() + 3, own.begin() + 12);
    row.grip = own[kPerArm - 1];
    return true;
  }

 private:
  static constexpr std::size_t kPerArm = 19;
  static constexpr std::size_t kNumbers = 76;
  std::size_t first_ = 0;
};

/// A table with a header; RFC 4180 without quotes, spaces around names and numbers are ignored.
class TableRows : public RowReaderBase, public ForeignCells {
 public:
  using RowReaderBase::RowReaderBase;

  bool read(std::string_view line, std::size_t number, ForeignRow& row) override {
    if (trimmed(line).empty()) {
      return false;
    }
    split(line);
    return takeCells(number, row);
  }
  bool readCells(const std::vector<std::string_view>& cells, std::size_t number, ForeignRow& row) override {
    cells_ = cells;
    return takeCells(number, row);
  }

 protected:
  bool takeCells(std::size_t number, ForeignRow& row) {
    if (header_.empty()) {
      for (const std::string_view cell : cells_) {
        header_.emplace_back(cell);
      }
      findColumns();
      return false;
    }
    if (cells_.size() != header_.size()) {
      refuseLine(number,
                 Text::tr("the line has %1 {value|values} and the header %2", cells_.size(), header_.size()),
                 Text::tr("Give every line as many values as there are columns"));
    }
    row.gap = map().leavesGaps && lacksPose();
    if (row.gap) {
      return true;
    }
    row.position = {at(position_[0], number), at(position_[1], number), at(position_[2], number)};
    row.rotation.clear();
    for (const std::size_t column : rotation_) {
      row.rotation.push_back(at(column, number));
    }
    if (grip_) {
      row.grip = at(*grip_, number);
    }
    if (time_) {
      row.time_us = std::llround(at(*time_, number) * (1e6 * map().timeUnit_s));
    }
    return true;
  }
  virtual void findColumns() {
    for (std::size_t i = 0; i < position_.size(); ++i) {
      position_[i] = columnNamed(map().position[i]);
    }
    for (const std::string& name : map().rotationColumns) {
      rotation_.push_back(columnNamed(name));
    }
    if (map().grip) {
      grip_ = columnNamed(map().grip->column);
    }
    if (!map().timeColumn.empty()) {
      time_ = columnNamed(map().timeColumn);
    }
  }
  [[nodiscard]] const std::vector<std::string>& header() const noexcept { return header_; }

  std::array<std::size_t, 3> position_{};
  std::vector<std::size_t> rotation_;
  std::optional<std::size_t> grip_;

 private:
  [[nodiscard]] std::size_t columnNamed(const std::string& wanted) const {
    if (std::count(header_.begin(), header_.end(), wanted) != 1) {
      refuseLine(1, Text::tr("there must be exactly one column '%1'", wanted),
                 Text::tr("Check the names in the map and in the first line"));
    }
    return static_cast<std::size_t>(std::find(header_.begin(), header_.end(), wanted) - header_.begin());
  }
  [[nodiscard]] bool lacksPose() const {
    const auto empty = [this](std::size_t column) {
      return cells_[column].empty() || lowerCase(std::string(cells_[column])) == "nan";
    };
    return std::any_of(position_.begin(), position_.end(), empty) ||
           std::any_of(rotation_.begin(), rotation_.end(), empty);
  }
  [[nodiscard]] double at(std::size_t column, std::size_t line) const {
    return number(cells_[column], line, header_[column]);
  }
  void split(std::string_view line) {
    if (header_.empty()) {
      line = withoutByteOrderMark(line);
    }
    cells_.clear();
    for (;;) {
      const std::size_t end = line.find(',');
      std::string_view cell = trimmed(line.substr(0, end));
      if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
        cell = cell.substr(1, cell.size() - 2);
      }
      cells_.push_back(cell);
      if (end == std::string_view::npos) {
        return;
      }
      line.remove_prefix(end + 1);
    }
  }

  std::vector<std::string> header_;
  std::vector<std::string_view> cells_;
  std::optional<std::size_t> time_;
};

/// Finds columns by the words in their names: "PSM1_position_x", "MTML_orientation_w".
class RosmaRows final : public TableRows {
 public:
  RosmaRows(const ForeignMap& map, std::string name) : TableRows(map, std::move(name)) {
    if (map.rotation != RotationForm::kQuaternionXyzw && map.rotation != RotationForm::kNone) {
      refuse(Text::tr("ROSMA has quaternions, x y z w"), map.name,
             Text::tr("Name their form: quaternion xyzw, or none"));
    }
  }

 private:
  void findColumns() override {
    for (std::size_t i = 0; i < position_.size(); ++i) {
      position_[i] = columnWith("position", std::string(1, "xyz"[i]));
    }
    if (map().rotation != RotationForm::kNone) {
      for (const char axis : {'x', 'y', 'z', 'w'}) {
        rotation_.push_back(columnWith("orientation", std::string(1, axis)));
      }
    }
    if (map().grip) {
      grip_ = columnWith("grip", "");
    }
  }
  [[nodiscard]] std::size_t columnWith(const std::string& word, const std::string& ending) const {
    const std::string own = lowerCase(map().instrument);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < header().size(); ++i) {
      const std::string name = lowerCase(header()[i]);
      const bool ends = name.ends_with("_" + ending) || name.ends_with("." + ending) ||
                        name.ends_with(" " + ending) || ending.empty();
      if (name.starts_with(own) && ends && name.find(word) != std::string::npos &&
          name.find("joint") == std::string::npos) {
        found.push_back(i);
      }
    }
    if (found.size() != 1) {
      refuseLine(1, Text::tr("%1 has not one column of %2 %3", map().instrument, word, ending),
                 Text::tr("Name an instrument of the file: MTML, MTMR, PSM1 or PSM2"));
    }
    return found.front();
  }
};

/// <log TimeStampSec="1" TimeStampNSec="5" type="transform" DeviceName="Tip" transform="16 numbers" />
class PerkTutorRows final : public RowReaderBase {
 public:
  PerkTutorRows(const ForeignMap& map, std::string name) : RowReaderBase(map, std::move(name)) {
    if (map.rotation != RotationForm::kMatrixRows && map.rotation != RotationForm::kMatrixColumns) {
      refuse(Text::tr("Perk Tutor has matrices of 16 numbers"), map.name,
             Text::tr("Name their form: matrix rows or matrix columns"));
    }
    const std::string file = lowerCase(this->name());
    if (file.ends_with(".sqbr") || file.ends_with(".mrb")) {
      refuse(Text::tr("sequences of Slicer are not read"), this->name(),
             Text::tr("Save the transforms as XML in Perk Tutor"));
    }
  }
  bool read(std::string_view line, std::size_t number, ForeignRow& row) override {
    if (line.find("<log") == std::string_view::npos || attribute(line, "type") != "transform" ||
        attribute(line, "DeviceName") != map().instrument) {
      return false;
    }
    const double seconds = this->number(attribute(line, "TimeStampSec").value_or(""), number, "TimeStampSec");
    const double nanoseconds =
        this->number(attribute(line, "TimeStampNSec").value_or(""), number, "TimeStampNSec");
    row.time_us = std::llround(seconds) * kSecond_us + std::llround(nanoseconds / 1e3);
    const std::array<double, 16> m = transform(attribute(line, "transform").value_or(""), number);
    const bool rows = map().rotation == RotationForm::kMatrixRows;
    row.position = rows ? Vec3{m[3], m[7], m[11]} : Vec3{m[12], m[13], m[14]};
    row.rotation.clear();
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        row.rotation.push_back(m[4 * i + k]);
      }
    }
    return true;
  }

 private:
  static std::optional<std::string_view> attribute(std::string_view line, const std::string& key) {
    const std::string head = " " + key + "=\"";
    const std::size_t at = line.find(head);
    if (at == std::string_view::npos) {
      return std::nullopt;
    }
    line.remove_prefix(at + head.size());
    return line.substr(0, line.find('"'));
  }
  [[nodiscard]] std::array<double, 16> transform(std::string_view text, std::size_t line) const {
    std::array<double, 16> numbers{};
    std::size_t count = 0;
    for (text = trimmed(text); !text.empty(); ++count) {
      const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
      const double value = number(text.substr(0, end), line, "transform");
      if (count < numbers.size()) {
        numbers[count] = value;
      }
      text = trimmed(text.substr(end));
    }
    if (count != numbers.size()) {
      refuseLine(line, Text::tr("the transform has %1 {number|numbers}, not 16", count),
                 Text::tr("Use the files of Perk Tutor as they are"));
    }
    return numbers;
  }
};

}  // namespace

std::unique_ptr<ForeignRows> foreignRows(const ForeignMap& map, ForeignLayout layout,
                                         const std::string& name) {
  switch (layout) {
    case ForeignLayout::kJigsaws:
      return std::make_unique<JigsawsRows>(map, name);
    case ForeignLayout::kRosma:
      return std::make_unique<RosmaRows>(map, name);
    case ForeignLayout::kPerkTutor:
      return std::make_unique<PerkTutorRows>(map, name);
    case ForeignLayout::kCsv:
    case ForeignLayout::kParquet:
      break;
  }
  TORSIO_EXPECTS(layout != ForeignLayout::kParquet);
  return std::make_unique<TableRows>(map, name);
}

std::vector<std::string> tableColumns(const ForeignMap& map) {
  std::vector<std::string> all;
  const auto add = [&all](const std::string& column) {
    if (!column.empty() && std::find(all.begin(), all.end(), column) == all.end()) {
      all.push_back(column);
    }
  };
  add(map.timeColumn);
  std::for_each(map.position.begin(), map.position.end(), add);
  std::for_each(map.rotationColumns.begin(), map.rotationColumns.end(), add);
  add(map.grip ? map.grip->column : std::string());
  return all;
}

std::unique_ptr<ForeignCells> foreignCells(const ForeignMap& map, const std::string& name) {
  return std::make_unique<TableRows>(map, name);
}

}  // namespace torsio
