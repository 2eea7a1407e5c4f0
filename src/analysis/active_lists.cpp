// SPDX-License-Identifier: MIT
#include "analysis/active_lists.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <thread>

#include <glm/glm.hpp>

#include "eval/batch.h"

namespace analysis {
namespace {

using List = std::vector<std::uint32_t>;

/// Blocks of cells along the longest axis of the box; each is divided by halves on its own.
constexpr int blocks_along = 4;

/// How often a block is halved at most: cells get about a third of the distance between neighbours
/// among the operands, where these are spread evenly in space or over a surface.
int halvings(std::size_t operands) {
    const double cells = 3 * std::sqrt(static_cast<double>(operands));
    return std::clamp(static_cast<int>(std::lround(std::log2(cells / blocks_along))), 1, 4);
}

/// Shorter lists are not worth the smallest cells.
constexpr std::size_t short_list = 12;

/// The values of operands at the centres of cells.
class Values {
public:
    explicit Values(const Operands& operands) : operands_(operands) {
        std::size_t variables = 3;
        for (const Operands::Kind& kind : operands.kinds) {
            eval::load_parameters<double>(*kind.value, {}, registers_.emplace_back());
            for (const graph::VariableId id : kind.variables) {
                variables = std::max(variables, index(id) + 1);
            }
        }
        columns_.resize(variables);
    }

    /// Row after row, one for each point, the values of the operands in the list.
    const std::vector<double>& at(std::span<const glm::dvec3> points, const List& list) {
        result_.resize(points.size() * list.size());
        for (std::size_t kind = 0; kind < operands_.kinds.size(); ++kind) {
            of_kind(kind, points, list);
        }
        return result_;
    }

private:
    void of_kind(std::size_t number, std::span<const glm::dvec3> points, const List& list) {
        const Operands::Kind& kind = operands_.kinds[number];
        places_.clear();
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (operands_.kind[list[i]] == number) places_.push_back(i);
        }
        if (places_.empty()) return;
        const std::size_t row = places_.size(), size = row * points.size();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            columns_[axis].clear();
            for (const glm::dvec3& point : points) {
                columns_[axis].insert(columns_[axis].end(), row, point[static_cast<int>(axis)]);
            }
        }
        for (std::size_t k = 0; k < kind.variables.size(); ++k) {
            std::vector<double>& column = columns_[index(kind.variables[k])];
            column.resize(size);
            for (std::size_t i = 0; i < row; ++i) {
                column[i] = kind.numbers[k][operands_.place[list[places_[i]]]];
            }
            for (std::size_t i = row; i < size; ++i) column[i] = column[i - row];
        }
        std::vector<std::span<const double>> variables(columns_.begin(), columns_.end());
        found_.resize(size);
        const std::array roots{std::span(found_)};
        eval::evaluate_points(*kind.value, registers_[number], variables, roots, scratch_);
        for (std::size_t i = 0; i < size; ++i) {
            result_[i / row * list.size() + places_[i % row]] = found_[i];
        }
    }

    const Operands& operands_;
    std::vector<std::vector<double>> registers_;  ///< of the kinds
    std::vector<std::vector<double>> columns_;    ///< by variable
    std::vector<std::size_t> places_;             ///< in the list, of one kind
    std::vector<double> found_, result_, scratch_;
};

/// Those that can be the smallest somewhere within the reach of the point with these values, the
/// least of which is told.
List nearest(const List& list, std::span<const double> values, double reach, double& least) {
    least = INFINITY;
    for (const double value : values) least = value < least ? value : least;
    List kept;
    for (std::size_t i = 0; i < list.size(); ++i) {
        // Values that are undefined stay, whatever they are.
        if (!(values[i] > least + 2 * reach)) kept.push_back(list[i]);
    }
    return kept;
}

/// The polynomial smooth minimum (field::smooth_union).
double smooth_minimum(double a, double b, double width) {
    const double overlap = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - overlap * overlap * width / 4;
}

/// An operand that is by n widths farther than another changes the smooth minimum by at most
/// exp(-2 (n - 2)) / 4 widths: while that sinks by a width, what it owes to earlier operands
/// becomes smaller by more than exp(-2). So that is less than 3e-8.
constexpr double most_widths = 10;

/// Those that a smooth minimum is made of, one after the other, within the reach of the point: what
/// is farther than the width from the minimum so far changes nothing, and if it is so much smaller
/// then all before it change nothing. The minimum so far is 1-Lipschitz as well; `least` is the
/// last one, at the point.
List blended(const List& list, std::span<const double> values, double reach, double width,
             double& least) {
    List kept;
    double nearest = INFINITY;
    for (const double value : values) nearest = value < nearest ? value : nearest;
    const double far = nearest + 2 * reach + most_widths * width;
    least = INFINITY;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (values[i] >= least + width + 2 * reach || values[i] > far) continue;
        if (values[i] + width + 2 * reach <= least) kept.clear();
        least = kept.empty() ? values[i] : smooth_minimum(least, values[i], width);
        kept.push_back(list[i]);
    }
    return kept;
}

/// A block's lists and, of each of its cells, which of them is its own.
struct Block {
    std::vector<List> lists{{}};  ///< the first one is that of cells outside of the region
    std::vector<std::uint32_t> cells;
};

class Divider {
public:
    Divider(const Operands& operands, const Region& region, std::optional<double> width,
            double margin, int levels)
        : values_(operands), region_(region), width_(width), margin_(margin), levels_(levels) {}

    Block block(const glm::dvec3& low, double size, const List& all) {
        const int side = 1 << levels_;
        block_ = {};
        block_.cells.assign(static_cast<std::size_t>(side) * side * side, 0);
        divide(all, 0, low, size, {0, 0, 0}, 0);
        return std::move(block_);
    }

private:
    /// Whether smaller cells are not worth it. The smallest are for long lists near the surface.
    bool is_enough(const List& list, double least, double size, int level) const {
        const bool last = level + 1 == levels_ && levels_ > 1;
        const bool plain = list.size() <= short_list || std::abs(least) > size;
        return level == levels_ || list.size() == 1 || (last && plain);
    }
    void divide(const List& list, double least, const glm::dvec3& low, double size,
                const glm::ivec3& place, int level) {
        if (!clip(region_, {low, low + size})) return;
        if (is_enough(list, least, size, level)) return put(list, place, level);
        const double half = 0.5 * size;
        std::array<glm::dvec3, 8> centres;
        for (int i = 0; i < 8; ++i) {
            centres[static_cast<std::size_t>(i)] = low + half * (corner(i) + 0.5);
        }
        const std::vector<double> values = values_.at(centres, list);
        const double reach = 0.5 * std::sqrt(3.0) * half + margin_;
        for (int i = 0; i < 8; ++i) {
            const std::span row =
                std::span(values).subspan(static_cast<std::size_t>(i) * list.size(), list.size());
            double least_there = 0;
            const List kept = width_ ? blended(list, row, reach, *width_, least_there)
                                     : nearest(list, row, reach, least_there);
            divide(kept, least_there, low + half * corner(i), half,
                   2 * place + glm::ivec3(corner(i)), level + 1);
        }
    }
    /// Gives the list to all smallest cells of the cell.
    void put(List list, const glm::ivec3& place, int level) {
        const int side = 1 << levels_, part = 1 << (levels_ - level);
        const auto number = static_cast<std::uint32_t>(block_.lists.size());
        block_.lists.push_back(std::move(list));
        const glm::ivec3 from = part * place;
        for (int z = from.z; z < from.z + part; ++z) {
            for (int y = from.y; y < from.y + part; ++y) {
                const auto row = block_.cells.begin() + (z * side + y) * side + from.x;
                std::fill(row, row + part, number);
            }
        }
    }
    static glm::dvec3 corner(int i) { return {i & 1, (i >> 1) & 1, i >> 2}; }

    Values values_;
    Region region_;
    std::optional<double> width_;
    double margin_;
    int levels_;
    Block block_;
};

/// The blocks' lists one after the other, and the cells of all of them.
void join(const std::vector<Block>& found, const glm::ivec3& blocks, int side,
          ActiveLists& result) {
    std::vector<std::uint32_t> first;  // list of each block
    result.begins.push_back(0);
    for (const Block& block : found) {
        first.push_back(static_cast<std::uint32_t>(result.begins.size() - 1));
        for (const List& list : block.lists) {
            result.operands.insert(result.operands.end(), list.begin(), list.end());
            result.begins.push_back(static_cast<std::uint32_t>(result.operands.size()));
        }
    }
    for (int z = 0; z < result.count.z; ++z) {
        for (int y = 0; y < result.count.y; ++y) {
            for (int x = 0; x < result.count.x; ++x) {
                const auto block = static_cast<std::size_t>(
                    (z / side * blocks.y + y / side) * blocks.x + x / side);
                const auto cell =
                    static_cast<std::size_t>((z % side * side + y % side) * side + x % side);
                result.cells.push_back(first[block] + found[block].cells[cell]);
            }
        }
    }
}

}  // namespace

ActiveLists active_lists(const Operands& operands, const Region& region,
                         std::optional<double> width) {
    const Cell box = bounding_cell(region);
    const glm::dvec3 extent = box.high - box.low;
    const double longest = std::max({extent.x, extent.y, extent.z});
    const int levels = halvings(operands.kind.size());
    const int side = 1 << levels;
    ActiveLists result;
    result.origin = box.low;
    result.size = longest / (blocks_along * side);
    glm::ivec3 blocks;
    for (int i = 0; i < 3; ++i) {
        blocks[i] = std::max(1, static_cast<int>(std::ceil(extent[i] / longest * blocks_along)));
    }
    result.count = side * blocks;

    List all(operands.kind.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(i);
    const double block_size = result.size * side;
    std::vector<Block> found(static_cast<std::size_t>(blocks.x * blocks.y * blocks.z));
    std::atomic<int> next = 0;
    const auto work = [&] {
        Divider divider(operands, region, width, 1e-6 * longest, levels);
        for (int i = next++; i < std::ssize(found); i = next++) {
            const glm::dvec3 place(i % blocks.x, i / blocks.x % blocks.y,
                                   i / (blocks.x * blocks.y));
            found[static_cast<std::size_t>(i)] =
                divider.block(box.low + block_size * place, block_size, all);
        }
    };
    std::thread other(work);
    work();
    other.join();

    join(found, blocks, side, result);
    return result;
}

}  // namespace analysis
