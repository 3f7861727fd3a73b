// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/surface/voxel_mask.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "sim/core/contracts.h"

namespace torsio {

VoxelMask::VoxelMask(const Count& count)
    : count_(count), words_((count[0] + 63) / 64), bits_(words_ * count[1] * count[2], 0) {}

std::size_t VoxelMask::voxels() const noexcept {
  std::size_t sum = 0;
  for (const std::uint64_t word : bits_) {
    sum += static_cast<std::size_t>(std::popcount(word));
  }
  return sum;
}

void VoxelMask::add(const VoxelMask& other) {
  TORSIO_EXPECTS(count_ == other.count_);
  for (std::size_t i = 0; i < bits_.size(); ++i) {
    bits_[i] |= other.bits_[i];
  }
}

void VoxelMask::keepOnly(const VoxelMask& other) {
  TORSIO_EXPECTS(count_ == other.count_);
  for (std::size_t i = 0; i < bits_.size(); ++i) {
    bits_[i] &= other.bits_[i];
  }
}

void VoxelMask::remove(const VoxelMask& other) {
  TORSIO_EXPECTS(count_ == other.count_);
  for (std::size_t i = 0; i < bits_.size(); ++i) {
    bits_[i] &= ~other.bits_[i];
  }
}

void VoxelMask::invert() {
  const std::size_t spare = 64 * words_ - count_[0];
  const std::uint64_t last = ~std::uint64_t{0} >> spare;
  for (std::size_t i = 0; i < bits_.size(); ++i) {
    bits_[i] = ~bits_[i] & ((i + 1) % words_ == 0 ? last : ~std::uint64_t{0});
  }
}

void VoxelMask::grow(bool corners) {
  const std::vector<std::uint64_t> before = bits_;
  const std::size_t spare = 64 * words_ - count_[0];
  const std::uint64_t last = ~std::uint64_t{0} >> spare;
  for (std::size_t i = 0; i < bits_.size(); ++i) {
    const std::size_t w = i % words_;
    const std::uint64_t fromLeft = (before[i] << 1U) | (w > 0 ? before[i - 1] >> 63U : 0);
    const std::uint64_t fromRight = (before[i] >> 1U) | (w + 1 < words_ ? before[i + 1] << 63U : 0);
    bits_[i] |= (fromLeft | fromRight) & (w + 1 == words_ ? last : ~std::uint64_t{0});
  }
  // A ball's corners grow from what has grown already, its faces from what there was.
  const auto spread = [this](const std::vector<std::uint64_t>& from, std::size_t stride, std::size_t lines) {
    for (std::size_t i = 0; i < bits_.size(); ++i) {
      const std::size_t line = i / stride % lines;
      bits_[i] |= (line > 0 ? from[i - stride] : 0) | (line + 1 < lines ? from[i + stride] : 0);
    }
  };
  spread(corners ? std::vector<std::uint64_t>(bits_) : before, words_, count_[1]);
  spread(corners ? std::vector<std::uint64_t>(bits_) : before, words_ * count_[1], count_[2]);
}

VoxelMask VoxelMask::grown(int voxels) const {
  VoxelMask result = *this;
  for (int step = 0; step < voxels; ++step) {
    result.grow(step % 2 == 1);
  }
  return result;
}

VoxelMask VoxelMask::shrunk(int voxels) const {
  VoxelMask result = *this;
  result.invert();
  result = result.grown(voxels);
  result.invert();
  return result;
}

VoxelMask VoxelMask::filledFrom(std::size_t borders) const {
  VoxelMask rest = *this;
  rest.invert();
  const MaskPieces pieces(rest, {0, 0, 0}, count_);
  std::vector<bool> holes(pieces.list().size());
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const auto& border = pieces.list()[i].atBorder;
    const auto counted = border.begin() + static_cast<std::ptrdiff_t>(borders);
    holes[i] = std::none_of(border.begin(), counted, [](bool touches) { return touches; });
  }
  VoxelMask result = pieces.mask(holes);
  result.add(*this);
  return result;
}

MaskPieces::MaskPieces(const VoxelMask& mask, const VoxelMask::Count& low, const VoxelMask::Count& high)
    : count_(mask.count()) {
  listRuns(mask);
  const std::vector<std::uint32_t> roots = joinedRuns();
  std::vector<std::uint32_t> number(runs_.size(), 0);
  std::uint32_t pieces = 0;
  for (std::uint32_t i = 0; i < runs_.size(); ++i) {
    if (roots[i] == i) {
      number[i] = pieces++;
    }
    runs_[i].piece = number[roots[i]];  // a root comes before what hangs on it
  }
  pieces_.resize(pieces);
  measure(low, high);
  // The largest first; of equals the one that begins earlier.
  std::vector<std::uint32_t> order(pieces);
  for (std::uint32_t i = 0; i < pieces; ++i) {
    order[i] = i;
  }
  std::stable_sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
    return pieces_[a].voxels > pieces_[b].voxels;
  });
  std::vector<std::uint32_t> rank(pieces);
  std::vector<MaskPiece> sorted(pieces);
  for (std::uint32_t i = 0; i < pieces; ++i) {
    rank[order[i]] = i;
    sorted[i] = pieces_[order[i]];
  }
  pieces_ = std::move(sorted);
  for (Run& run : runs_) {
    run.piece = rank[run.piece];
  }
}

void MaskPieces::listRuns(const VoxelMask& mask) {
  const std::size_t rows = count_[1] * count_[2];
  firstOfRow_.assign(rows + 1, 0);
  for (std::size_t r = 0; r < rows; ++r) {
    const std::uint64_t* const words = mask.row(r % count_[1], r / count_[1]);
    std::size_t x = 0;
    bool inside = false;
    while (x < count_[0]) {
      const std::uint64_t word = (inside ? ~words[x / 64] : words[x / 64]) >> (x % 64);
      const std::size_t left = 64 - x % 64;
      const std::size_t same = std::min<std::size_t>(static_cast<std::size_t>(std::countr_zero(word)), left);
      x = std::min(x + same, count_[0]);
      if (same == left || x == count_[0]) {
        continue;
      }
      if (inside) {
        runs_.back().to = static_cast<std::uint32_t>(x);
      } else {
        runs_.push_back({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(count_[0]), 0});
      }
      inside = !inside;
    }
    firstOfRow_[r + 1] = runs_.size();
  }
}

std::vector<std::uint32_t> MaskPieces::joinedRuns() {
  std::vector<std::uint32_t> parent(runs_.size());
  for (std::uint32_t i = 0; i < parent.size(); ++i) {
    parent[i] = i;
  }
  const auto root = [&parent](std::uint32_t i) {
    while (parent[i] != i) {
      i = parent[i] = parent[parent[i]];
    }
    return i;
  };
  const auto joinRows = [&](std::size_t a, std::size_t b) {
    std::size_t i = firstOfRow_[a];
    std::size_t j = firstOfRow_[b];
    while (i < firstOfRow_[a + 1] && j < firstOfRow_[b + 1]) {
      if (runs_[i].from < runs_[j].to && runs_[j].from < runs_[i].to) {
        const std::uint32_t p = root(static_cast<std::uint32_t>(i));
        const std::uint32_t q = root(static_cast<std::uint32_t>(j));
        parent[std::max(p, q)] = std::min(p, q);
      }
      ++(runs_[i].to < runs_[j].to ? i : j);
    }
  };
  for (std::size_t r = 0; r + 1 < firstOfRow_.size(); ++r) {
    if (r % count_[1] > 0) {
      joinRows(r - 1, r);
    }
    if (r >= count_[1]) {
      joinRows(r - count_[1], r);
    }
  }
  for (std::uint32_t i = 0; i < parent.size(); ++i) {
    parent[i] = root(i);
  }
  return parent;
}

void MaskPieces::measure(const VoxelMask::Count& low, const VoxelMask::Count& high) {
  for (std::size_t r = 0; r + 1 < firstOfRow_.size(); ++r) {
    const std::size_t y = r % count_[1];
    const std::size_t z = r / count_[1];
    for (std::size_t i = firstOfRow_[r]; i < firstOfRow_[r + 1]; ++i) {
      const Run& run = runs_[i];
      MaskPiece& piece = pieces_[run.piece];
      const auto length = static_cast<double>(run.to - run.from);
      piece.voxels += run.to - run.from;
      piece.middle[0] += length * 0.5 * (static_cast<double>(run.from) + static_cast<double>(run.to) - 1.0);
      piece.middle[1] += length * static_cast<double>(y);
      piece.middle[2] += length * static_cast<double>(z);
      const std::array<bool, 6> touches{run.from <= low[0], run.to >= high[0], y <= low[1],
                                        y + 1 >= high[1],   z <= low[2],       z + 1 >= high[2]};
      for (std::size_t side = 0; side < touches.size(); ++side) {
        piece.atBorder[side] = piece.atBorder[side] || touches[side];
      }
    }
  }
  for (MaskPiece& piece : pieces_) {
    for (double& along : piece.middle) {
      along /= static_cast<double>(piece.voxels);
    }
  }
}

std::size_t MaskPieces::at(std::size_t x, std::size_t y, std::size_t z) const noexcept {
  const std::size_t r = z * count_[1] + y;
  for (std::size_t i = firstOfRow_[r]; i < firstOfRow_[r + 1]; ++i) {
    if (runs_[i].from <= x && x < runs_[i].to) {
      return runs_[i].piece;
    }
  }
  return pieces_.size();
}

VoxelMask MaskPieces::mask(std::size_t piece) const {
  std::vector<bool> wanted(pieces_.size(), false);
  wanted[piece] = true;
  return mask(wanted);
}

VoxelMask MaskPieces::mask(const std::vector<bool>& wanted) const {
  VoxelMask result(count_);
  for (std::size_t r = 0; r + 1 < firstOfRow_.size(); ++r) {
    for (std::size_t i = firstOfRow_[r]; i < firstOfRow_[r + 1]; ++i) {
      for (std::size_t x = runs_[i].from; wanted[runs_[i].piece] && x < runs_[i].to; ++x) {
        result.set(x, r % count_[1], r / count_[1]);
      }
    }
  }
  return result;
}

void fillLids(VoxelMask& mask, const VoxelMask::Count& low, const VoxelMask::Count& high) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = axis == 0 ? 1 : 0;
    const std::size_t v = axis == 2 ? 1 : 2;
    for (const std::size_t layer : {low[axis], high[axis] - 1}) {
      const auto voxel = [&](std::size_t a, std::size_t b) {
        VoxelMask::Count at{};
        at[axis] = layer, at[u] = low[u] + a, at[v] = low[v] + b;
        return at;
      };
      VoxelMask flat({high[u] - low[u] + 2, high[v] - low[v] + 2, 1});  // with a margin all round
      for (std::size_t b = 0; b < high[v] - low[v]; ++b) {
        for (std::size_t a = 0; a < high[u] - low[u]; ++a) {
          const auto [x, y, z] = voxel(a, b);
          if (mask.at(x, y, z)) {
            flat.set(a + 1, b + 1, 0);
          }
        }
      }
      if (flat.voxels() == 0) {
        continue;
      }
      const VoxelMask lid = flat.filledInPlane();
      for (std::size_t b = 0; b < high[v] - low[v]; ++b) {
        for (std::size_t a = 0; a < high[u] - low[u]; ++a) {
          if (lid.at(a + 1, b + 1, 0)) {
            const auto [x, y, z] = voxel(a, b);
            mask.set(x, y, z);
          }
        }
      }
    }
  }
}

BrushWork brushOver(const WorkGrid& grid, const std::vector<BrushDab>& dabs, VoxelMask& mask,
                    VoxelMask& tissue) {
  const VoxelMask before = mask;
  for (std::size_t first = 0; first < dabs.size();) {
    VoxelMask stroke(mask.count());
    std::size_t behind = first;
    for (; behind < dabs.size() && dabs[behind].adds == dabs[first].adds; ++behind) {
      eachVoxelIn(dabs[behind], grid.volume, grid.low(), grid.high(),
                  [&stroke](std::size_t x, std::size_t y, std::size_t z) { stroke.set(x, y, z); });
    }
    if (dabs[first].adds) {
      mask.add(stroke);
    } else {
      mask.remove(stroke);
      tissue.remove(stroke);
    }
    first = behind;
  }
  VoxelMask added = mask;
  added.remove(before);
  VoxelMask erased = before;
  erased.remove(mask);
  return {added.voxels(), erased.voxels()};
}

}  // namespace torsio
