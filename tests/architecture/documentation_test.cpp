// SPDX-License-Identifier: GPL-3.0-or-later
// What the documents point at exists: pictures, other documents, files of the project.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> documents() {
  const fs::path root = TORSIO_SOURCE_DIR;
  std::vector<fs::path> found{root / "README.md", root / "CHANGELOG.md"};
  for (const char* folder : {"app", "assessment", "assets", "db", "docs", "sim", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.path().extension() == ".md") found.push_back(entry.path());
  return found;
}

/// The targets of `[words](target)` that are paths, without what follows a `#`.
std::vector<std::string> linkedPaths(const fs::path& document) {
  std::ifstream in(document);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  static const std::regex kLink(R"(\]\(([^)\s#]+)(#[^)]*)?\))");
  std::vector<std::string> paths;
  for (std::sregex_iterator link(text.begin(), text.end(), kLink); link != std::sregex_iterator(); ++link)
    if (const std::string target = (*link)[1]; target.find("://") == std::string::npos)
      paths.push_back(target);
  return paths;
}

TEST(Documentation, EveryLinkLeadsToAFile) {
  std::size_t links = 0;
  for (const fs::path& document : documents())
    for (const std::string& path : linkedPaths(document)) {
      ++links;
      EXPECT_TRUE(fs::exists(document.parent_path() / path))
          << document.string() << " points at " << path << ", which is not there";
    }
  EXPECT_GT(links, 40U);  // the guide alone has more: the expression finds them
}

}  // namespace
