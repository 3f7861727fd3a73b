// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_export.h"

#include <bit>
#include <cstdio>
#include <vector>

#include "sim/core/contracts.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

constexpr double kMillimetres = 1000.0;  // in one metre

void appendLittleEndian(std::string& out, std::uint32_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    out += static_cast<char>((value >> shift) & 0xffU);
  }
}

std::array<float, 3> millimetres(const Vec3& v) {
  return {static_cast<float>(v.x * kMillimetres), static_cast<float>(v.y * kMillimetres),
          static_cast<float>(v.z * kMillimetres)};
}

void appendText(std::string& out, std::span<const float> numbers) {
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    std::array<char, 32> text{};
    // Nine digits give back the same float.
    std::snprintf(text.data(), text.size(), k == 0 ? "%.9g" : " %.9g", static_cast<double>(numbers[k]));
    out += text.data();
  }
}

void appendNumbers(std::string& out, std::span<const float> numbers, bool binary) {
  if (!binary) {
    appendText(out, numbers);
    return;
  }
  for (const float x : numbers) {
    appendLittleEndian(out, std::bit_cast<std::uint32_t>(x));
  }
}

std::string safeComment(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') {
      c = ' ';
    }
  }
  return text;
}

std::string plyHeader(const TriangleMesh& mesh, const MeshExportOptions& options) {
  std::string out = "ply\nformat ";
  out += options.format == PlyFormat::kBinary ? "binary_little_endian" : "ascii";
  out += " 1.0\n";
  for (const std::string& line : options.comments) {
    out += "comment " + safeComment(line) + "\n";
  }
  out += "comment unit millimetre, axes LPS (x left, y back, z up)\n";
  out += "element vertex " + std::to_string(mesh.vertices_m.size()) + "\n";
  out += "property float x\nproperty float y\nproperty float z\n";
  if (options.normals) {
    out += "property float nx\nproperty float ny\nproperty float nz\n";
  }
  if (!options.texture.empty()) {
    out += "property float s\nproperty float t\n";
  }
  if (!options.colours.empty()) {
    out += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  }
  out += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  out += "property list uchar int vertex_indices\nend_header\n";
  return out;
}

}  // namespace

std::string plyBytes(const TriangleMesh& mesh, const MeshExportOptions& options) {
  TORSIO_EXPECTS(options.colours.empty() || options.colours.size() == mesh.vertices_m.size());
  TORSIO_EXPECTS(options.texture.empty() || options.texture.size() == mesh.vertices_m.size());
  const bool binary = options.format == PlyFormat::kBinary;
  const std::vector<Vec3> normals = options.normals ? vertexNormals(mesh) : std::vector<Vec3>{};
  std::string out = plyHeader(mesh, options);
  for (std::size_t i = 0; i < mesh.vertices_m.size(); ++i) {
    const std::array<float, 3> p = millimetres(mesh.vertices_m[i]);
    std::vector<float> numbers(p.begin(), p.end());
    if (options.normals) {
      const Vec3& n = normals[i];
      numbers.insert(numbers.end(),
                     {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
    }
    if (!options.texture.empty()) {
      numbers.insert(numbers.end(), options.texture[i].begin(), options.texture[i].end());
    }
    appendNumbers(out, numbers, binary);
    if (!options.colours.empty()) {
      for (const std::uint8_t c : options.colours[i]) {
        if (!binary) {
          out.append(1, ' ').append(std::to_string(c));
        }
        if (binary) {
          out += static_cast<char>(c);
        }
      }
    }
    if (!binary) {
      out += '\n';
    }
  }
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    out += binary ? std::string(1, '\3') : std::string("3");
    for (const std::uint32_t corner : t) {
      if (binary) {
        appendLittleEndian(out, corner);
      } else {
        out.append(1, ' ').append(std::to_string(corner));
      }
    }
    if (!binary) {
      out += '\n';
    }
  }
  return out;
}

std::string objText(const TriangleMesh& mesh, const MeshExportOptions& options) {
  std::string out;
  for (const std::string& line : options.comments) {
    out.append("# ").append(safeComment(line)).append("\n");
  }
  out += "# unit millimetre, axes LPS (x left, y back, z up)\n";
  for (const Vec3& v : mesh.vertices_m) {
    out += "v ";
    appendText(out, millimetres(v));
    out += '\n';
  }
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    out += 'f';
    for (const std::uint32_t corner : t) {
      out.append(1, ' ').append(std::to_string(corner + 1));
    }
    out += '\n';
  }
  return out;
}

void writePly(const std::filesystem::path& file, const TriangleMesh& mesh, const MeshExportOptions& options) {
  writeFileAtomically(file, plyBytes(mesh, options));
}

void writeObj(const std::filesystem::path& file, const TriangleMesh& mesh, const MeshExportOptions& options) {
  writeFileAtomically(file, objText(mesh, options));
}

}  // namespace torsio
