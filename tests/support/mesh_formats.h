// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/geometry/mesh/mesh_export.h"

namespace torsio::testing {

/// Meshes in formats that the program reads but does not write; millimetres, single precision.
namespace formats {

inline void append(std::string& bytes, const void* from, std::size_t size) {
  bytes.append(static_cast<const char*>(from), size);
}

inline std::vector<float> placesOf(const TriangleMesh& mesh) {
  std::vector<float> places;
  for (const Vec3& v : mesh.vertices_m) {
    for (const double x : {v.x, v.y, v.z}) {
      places.push_back(static_cast<float>(1000.0 * x));
    }
  }
  return places;
}

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      three = three << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[three >> (18U - 6U * k) & 63U];
    }
  }
  return text;
}

/// Returns vertices and indices in glTF's layout.
inline std::string gltfBuffer(const TriangleMesh& mesh) {
  std::string bytes;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    append(bytes, t.data(), sizeof t);
  }
  const std::vector<float> places = placesOf(mesh);
  append(bytes, places.data(), places.size() * sizeof(float));
  return bytes;
}

/// `uri`: of the buffer; empty in a GLB file. `more`: further members of the file, each followed by a comma.
inline std::string gltfJson(const TriangleMesh& mesh, const std::string& uri, const std::string& more = "") {
  const std::string corners = std::to_string(12 * mesh.triangles.size());
  const std::string places = std::to_string(12 * mesh.vertices_m.size());
  const std::string whole = std::to_string(12 * (mesh.triangles.size() + mesh.vertices_m.size()));
  return R"({"asset":{"version":"2.0"},)" + more +
         R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":1},"indices":0)" +
         (more.empty() ? "" : R"(,"material":0)") + R"(}]}],"buffers":[{"byteLength":)" + whole +
         (uri.empty() ? "" : R"(,"uri":")" + uri + '"') + R"(}],"bufferViews":[{"buffer":0,"byteLength":)" +
         corners + R"(,"target":34963},{"buffer":0,"byteOffset":)" + corners + R"(,"byteLength":)" + places +
         R"(,"target":34962}],"accessors":[{"bufferView":0,"componentType":5125,"count":)" +
         std::to_string(3 * mesh.triangles.size()) +
         R"(,"type":"SCALAR"},{"bufferView":1,"componentType":5126,"count":)" +
         std::to_string(mesh.vertices_m.size()) +
         R"(,"type":"VEC3","min":[-9999,-9999,-9999],"max":[9999,9999,9999]}]})";
}

}  // namespace formats

inline std::string binaryStl(const TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  const auto facets = static_cast<std::uint32_t>(mesh.triangles.size());
  formats::append(bytes, &facets, 4);
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    bytes.append(12, '\0');
    for (const std::uint32_t corner : t) {
      const Vec3& v = mesh.vertices_m[corner];
      for (const double x : {v.x, v.y, v.z}) {
        const auto mm = static_cast<float>(1000.0 * x);
        formats::append(bytes, &mm, 4);
      }
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

inline std::string offText(const TriangleMesh& mesh) {
  std::string text =
      "OFF\n" + std::to_string(mesh.vertices_m.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vec3& v : mesh.vertices_m) {
    for (const double x : {v.x, v.y, v.z}) {
      text.append(std::to_string(1000.0 * x)).append(" ");
    }
    text += '\n';
  }
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    text += '3';
    for (const std::uint32_t corner : t) {
      text.append(1, ' ').append(std::to_string(corner));
    }
    text += '\n';
  }
  return text;
}

inline std::string gltfText(const TriangleMesh& mesh, const std::string& more = "") {
  return formats::gltfJson(
      mesh, "data:application/octet-stream;base64," + formats::base64(formats::gltfBuffer(mesh)), more);
}

inline std::string glbBytes(const TriangleMesh& mesh) {
  std::string json = formats::gltfJson(mesh, "");
  json.append((4 - json.size() % 4) % 4, ' ');
  const std::string buffer = formats::gltfBuffer(mesh);
  std::string bytes = "glTF";
  const auto number = [&bytes](std::size_t value) {
    const auto word = static_cast<std::uint32_t>(value);
    formats::append(bytes, &word, 4);
  };
  number(2);
  number(12 + 8 + json.size() + 8 + buffer.size());
  number(json.size());
  bytes += "JSON" + json;
  number(buffer.size());
  bytes.append("BIN\0", 4).append(buffer);
  return bytes;
}

inline std::string daeText(const TriangleMesh& mesh) {
  std::string places;
  for (const float x : formats::placesOf(mesh)) {
    places += std::to_string(x) + ' ';
  }
  std::string corners;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) {
      corners += std::to_string(corner) + ' ';
    }
  }
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="millimeter" meter="0.001"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count=")" +
         std::to_string(3 * mesh.vertices_m.size()) + "\">" + places +
         R"(</float_array><technique_common><accessor source="#a" count=")" +
         std::to_string(mesh.vertices_m.size()) + R"(" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count=")" +
         std::to_string(mesh.triangles.size()) + R"("><input semantic="VERTEX" source="#v" offset="0"/><p>)" +
         corners + R"(</p></triangles>
</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node id="n">
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

/// Returns every supported format: extension and bytes.
inline std::vector<std::pair<std::string, std::string>> everyFormat(const TriangleMesh& mesh) {
  MeshExportOptions text;
  text.format = PlyFormat::kAscii;
  return {{".ply", plyBytes(mesh)},  {".ply", plyBytes(mesh, text)}, {".obj", objText(mesh)},
          {".stl", binaryStl(mesh)}, {".off", offText(mesh)},        {".gltf", gltfText(mesh)},
          {".glb", glbBytes(mesh)},  {".dae", daeText(mesh)}};
}

}  // namespace torsio::testing
