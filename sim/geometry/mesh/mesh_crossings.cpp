// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_crossings.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace torsio {

namespace {

constexpr std::size_t kTrianglesInLeaf = 4;
// How far an edge reaches through a triangle on either side to cut it, a hundredth of a millimetre: the
// slivers of a flat end lie off its plane by the rounding of their file, and a twist warps them by a few
// micrometres.
constexpr double kLeastDepth_m = 1e-5;

struct CrossingBox : BoundingBox {
  [[nodiscard]] bool meets(const CrossingBox& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y &&
           low.z <= b.high.z && b.low.z <= high.z;
  }
};

// Six times the signed volume of a tetrahedron.
double volumeOf(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return dot(b - a, cross(c - a, d - a));
}

using Corners = std::array<Vec3, 3>;

bool segmentCuts(const Vec3& p, const Vec3& q, const Corners& t) {
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double from = dot(normal, p - t[0]);
  const double to = dot(normal, q - t[0]);
  const double least = kLeastDepth_m * norm(normal);
  if (!((from > least && to < -least) || (from < -least && to > least))) {
    return false;
  }
  const double a = volumeOf(p, q, t[0], t[1]);
  const double b = volumeOf(p, q, t[1], t[2]);
  const double c = volumeOf(p, q, t[2], t[0]);
  return (a > 0.0 && b > 0.0 && c > 0.0) || (a < 0.0 && b < 0.0 && c < 0.0);
}

bool trianglesCut(const Corners& a, const Corners& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = i < 2 ? i + 1 : 0;
    if (segmentCuts(a[i], a[next], b) || segmentCuts(b[i], b[next], a)) {
      return true;
    }
  }
  return false;
}

// A hierarchy of boxes over the triangles, halved at the median of the longest side.
class CrossingSearch {
 public:
  explicit CrossingSearch(const TriangleMesh& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    for (std::size_t t = 0; t < order_.size(); ++t) {
      CrossingBox box;
      for (const Vec3& corner : cornersOf(t)) {
        box.add(corner);
      }
      boxes_.push_back(box);
    }
    if (!order_.empty()) {
      build(0, order_.size());
    }
  }

  std::vector<TrianglePair> pairs() {
    if (!nodes_.empty()) {
      within(0);
    }
    std::sort(found_.begin(), found_.end());
    return std::move(found_);
  }

 private:
  struct Node {
    CrossingBox box;
    std::size_t first = 0;
    std::size_t last = 0;
    std::size_t left = 0;  // 0: a leaf
    std::size_t right = 0;
  };

  [[nodiscard]] Corners cornersOf(std::size_t t) const {
    const TriangleMesh::Triangle& corners = mesh_.triangles[t];
    return {mesh_.vertices_m[corners[0]], mesh_.vertices_m[corners[1]], mesh_.vertices_m[corners[2]]};
  }

  std::size_t build(std::size_t first, std::size_t last) {
    const std::size_t here = nodes_.size();
    nodes_.push_back({{}, first, last, 0, 0});
    CrossingBox box;
    for (std::size_t i = first; i < last; ++i) {
      box.add(boxes_[order_[i]].low);
      box.add(boxes_[order_[i]].high);
    }
    nodes_[here].box = box;
    if (last - first <= kTrianglesInLeaf) {
      return here;
    }
    const Vec3 side = box.high - box.low;
    const auto along = [&side](const Vec3& p) {
      return side.x >= side.y && side.x >= side.z ? p.x : (side.y >= side.z ? p.y : p.z);
    };
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last), [&](std::uint32_t a, std::uint32_t b) {
      return along(boxes_[a].low + boxes_[a].high) < along(boxes_[b].low + boxes_[b].high);
    });
    const std::size_t left = build(first, middle);
    const std::size_t right = build(middle, last);
    nodes_[here].left = left;
    nodes_[here].right = right;
    return here;
  }

  void compare(std::uint32_t a, std::uint32_t b) {
    if (!boxes_[a].meets(boxes_[b])) {
      return;
    }
    for (const std::uint32_t corner : mesh_.triangles[a]) {
      const TriangleMesh::Triangle& other = mesh_.triangles[b];
      if (corner == other[0] || corner == other[1] || corner == other[2]) {
        return;
      }
    }
    if (trianglesCut(cornersOf(a), cornersOf(b))) {
      found_.push_back({std::min(a, b), std::max(a, b)});
    }
  }

  void within(std::size_t n) {
    const Node& node = nodes_[n];
    if (node.left == 0) {
      for (std::size_t i = node.first; i < node.last; ++i) {
        for (std::size_t j = i + 1; j < node.last; ++j) {
          compare(order_[i], order_[j]);
        }
      }
      return;
    }
    within(node.left);
    within(node.right);
    between(node.left, node.right);
  }

  void between(std::size_t a, std::size_t b) {
    const Node& one = nodes_[a];
    const Node& other = nodes_[b];
    if (!one.box.meets(other.box)) {
      return;
    }
    if (one.left == 0 && other.left == 0) {
      for (std::size_t i = one.first; i < one.last; ++i) {
        for (std::size_t j = other.first; j < other.last; ++j) {
          compare(order_[i], order_[j]);
        }
      }
      return;
    }
    const bool divideOne =
        other.left == 0 || (one.left != 0 && one.last - one.first >= other.last - other.first);
    if (divideOne) {
      between(one.left, b);
      between(one.right, b);
    } else {
      between(a, other.left);
      between(a, other.right);
    }
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> order_;
  std::vector<CrossingBox> boxes_;
  std::vector<Node> nodes_;
  std::vector<TrianglePair> found_;
};

}  // namespace

std::vector<TrianglePair> crossingTriangles(const TriangleMesh& mesh) {
  return CrossingSearch(mesh).pairs();
}

}  // namespace torsio
