// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <QString>

namespace torsio {

/// The objects of a PDF that Qt wrote, to be changed and written anew. Any thread, one at a time.
class PdfFile {
 public:
  /// Throws Error{kBadData} when the file is none of Qt's form.
  explicit PdfFile(const std::string& pdf);

  /// What stands between "N 0 obj" and "endobj". Throws Error{kBadData} when there is no such object.
  [[nodiscard]] const std::string& object(std::uint64_t id) const;
  void replace(std::uint64_t id, std::string text);
  /// Returns the number of the new object.
  std::uint64_t add(std::string text);
  /// Adds lines at the end of a dictionary that is an object of its own.
  void addTo(std::uint64_t id, const std::string& lines);

  [[nodiscard]] std::uint64_t catalog() const { return catalog_; }
  [[nodiscard]] std::uint64_t info() const { return info_; }
  /// In the order in which they are read.
  [[nodiscard]] const std::vector<std::uint64_t>& pages() const { return pages_; }
  /// The number of the object that `key` of another one refers to ("/Contents "). Throws Error{kBadData}.
  [[nodiscard]] std::uint64_t reference(std::uint64_t id, const std::string& key) const;

  /// What a stream holds, uncompressed. Throws Error{kBadData}.
  [[nodiscard]] std::string stream(std::uint64_t id) const;
  /// Puts something else into a stream, compressed.
  void setStream(std::uint64_t id, const std::string& content);

  /// The whole file.
  [[nodiscard]] std::string written() const;

  /// A text string of a PDF: UTF-16 with a byte order mark, in hexadecimal.
  [[nodiscard]] static std::string textString(const QString& text);
  /// "12 0 R".
  [[nodiscard]] static std::string referenceTo(std::uint64_t id);

 private:
  void readPages();

  std::string head_;
  std::vector<std::string> objects_;  // by number; empty: free
  std::string id_;                    // of the file, as the trailer has it
  std::uint64_t catalog_ = 0;
  std::uint64_t info_ = 0;  // 0: none
  std::vector<std::uint64_t> pages_;
};

}  // namespace torsio
