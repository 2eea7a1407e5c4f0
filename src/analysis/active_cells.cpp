// SPDX-License-Identifier: MIT
#include "analysis/active_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include <glm/glm.hpp>

#include "analysis/in_parallel.h"
#include "eval/batch.h"

namespace analysis {
namespace {

/// Cubes along the longest axis of the box.
constexpr int cubes_along = 4;

/// How deep nodes are at most below those of the cubes: 256 cells along the longest axis.
constexpr int deepest = 2;

/// Cells with so few operands are not worth smaller ones.
constexpr std::size_t short_list = 8;

/// A cell is far where the surface is farther from its middle than so many times its corners.
constexpr double far_reaches = 2;

/// How much the value in a far cell may be off the linear one, in parts of it.
constexpr double most_bend = 0.01;

/// Values of operands that one cube is worth at most: where they are spent, it gets no more of the
/// smallest cells.
constexpr std::size_t most_values = 200'000;

constexpr int parts = 8;

/// More than there are.
constexpr std::size_t all_operands = 1'000'000'000;

glm::dvec3 corner(int i) { return {i & 1, (i >> 1) & 1, i >> 2}; }

/// Those that can be the smallest somewhere within the reach of the point with these values, the
/// least of which is told.
OperandList nearest(const OperandList& list, std::span<const double> values, double reach,
                    double& least) {
    least = INFINITY;
    for (const double value : values) least = value < least ? value : least;
    OperandList kept;
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
OperandList blended(const OperandList& list, std::span<const double> values, double reach,
                    double width, double& least) {
    OperandList kept;
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

/// What is known of a cell: which operands of each minimum can matter in it, and the field at its
/// middle.
struct Known {
    std::vector<OperandList> lists;
    double value = 0;

    std::size_t count() const {
        std::size_t operands = 0;
        for (const OperandList& list : lists) operands += list.size();
        return operands;
    }
};

/// Divides one cube.
class Divider {
public:
    Divider(const Composition& composition, const Region& region, double margin)
        : composition_(composition), region_(region), margin_(margin) {
        std::size_t variables = 3;
        for (const ManyOperands& minimum : composition.minima) {
            values_.emplace_back(minimum.operands);
            variables = std::max(variables, index(minimum.variable) + 1);
        }
        columns_.resize(variables);
        if (!composition.outline) return;
        std::vector<double> parameters(composition.parameters.begin(),
                                       composition.parameters.end());
        eval::load_parameters<double>(*composition.outline, parameters, registers_);
    }

    /// With nodes so deep below it at most; none if there was no time.
    std::optional<ActiveCells> cube(const glm::dvec3& low, double size, const Known& known,
                                    int depth, const Budget* budget) {
        found_ = {};
        depth_ = depth;
        budget_ = depth > 0 ? budget : nullptr;
        found_.minima = composition_.minima.size();
        spent_ = 0;
        if (is_over(budget_)) return std::nullopt;
        node(eighths(known, low, size), low, size, 0);
        if (budget_ && budget_->was_over()) return std::nullopt;
        return std::move(found_);
    }

private:
    using Eighths = std::array<Known, parts>;

    /// What is known of the eighths of a cell.
    Eighths eighths(const Known& known, const glm::dvec3& low, double size) {
        std::array<glm::dvec3, parts> middles;
        for (int i = 0; i < parts; ++i) {
            middles[static_cast<std::size_t>(i)] = low + 0.5 * size * (corner(i) + 0.5);
        }
        const double reach = 0.25 * std::sqrt(3.0) * size + margin_;
        Eighths result;
        std::array<std::vector<double>, parts> least;
        for (std::size_t k = 0; k < known.lists.size(); ++k) {
            const OperandList& list = known.lists[k];
            const std::span<const double> values = values_[k].at(middles, list);
            const std::optional<double> width = composition_.minima[k].width;
            spent_ += values.size();
            for (std::size_t i = 0; i < parts; ++i) {
                const std::span row = values.subspan(i * list.size(), list.size());
                double& here = least[i].emplace_back();
                result[i].lists.push_back(width ? blended(list, row, reach, *width, here)
                                                : nearest(list, row, reach, here));
            }
        }
        tell_values(middles, least, result);
        return result;
    }

    /// The field where the minima have these values.
    void tell_values(std::span<const glm::dvec3> points,
                     std::span<const std::vector<double>> minima, Eighths& result) {
        if (!composition_.outline) {
            for (std::size_t i = 0; i < parts; ++i) result[i].value = minima[i][0];
            return;
        }
        for (int axis = 0; axis < 3; ++axis) {
            auto& column = columns_[static_cast<std::size_t>(axis)];
            column.clear();
            for (const glm::dvec3& point : points) column.push_back(point[axis]);
        }
        for (std::size_t k = 0; k < composition_.minima.size(); ++k) {
            auto& column = columns_[index(composition_.minima[k].variable)];
            column.clear();
            for (const std::vector<double>& each : minima) column.push_back(each[k]);
        }
        const std::vector<std::span<const double>> variables(columns_.begin(), columns_.end());
        std::array<double, parts> values{};
        const std::array roots{std::span<double>(values)};
        eval::evaluate_points(*composition_.outline, registers_, variables, roots, scratch_);
        for (std::size_t i = 0; i < parts; ++i) result[i].value = values[i];
    }

    bool is_far(double value, double size) const {
        const double reach = 0.5 * std::sqrt(3.0) * size + margin_;
        const bool may_be = composition_.may_be_far && (value > 0 || composition_.inside_too);
        return may_be && std::abs(value) >= far_reaches * reach;
    }
    /// The slope of the field between the middles of the eighths, if they are all far and nearly
    /// as it tells.
    static std::optional<glm::dvec3> slope(const Known& known, const Eighths& eighths,
                                           double size) {
        glm::dvec3 gradient(0);
        for (int i = 0; i < parts; ++i) {
            gradient += eighths[static_cast<std::size_t>(i)].value * (2.0 * corner(i) - 1.0);
        }
        gradient /= 2 * size;
        for (int i = 0; i < parts; ++i) {
            const glm::dvec3 way = 0.25 * size * (2.0 * corner(i) - 1.0);
            const double value = eighths[static_cast<std::size_t>(i)].value;
            const double bend = std::abs(known.value + glm::dot(gradient, way) - value);
            if (!(bend <= most_bend * std::abs(value))) return std::nullopt;
        }
        return gradient;
    }

    std::uint32_t list_of(const Known& known) {
        const auto number = static_cast<std::uint32_t>((found_.begins.size() - 1) / found_.minima);
        for (const OperandList& list : known.lists) {
            found_.operands.insert(found_.operands.end(), list.begin(), list.end());
            found_.begins.push_back(static_cast<std::uint32_t>(found_.operands.size()));
        }
        return number;
    }
    ActiveCells::Cell listed(const Known& known) {
        return {.kind = ActiveCells::Cell::Kind::listed, .place = list_of(known)};
    }

    /// Whether a cell's lists are as short as they need to be, or hardly shorter than those of the
    /// cell of double its size, which hold so many operands.
    bool is_enough(const Known& known, std::size_t around, double size, int level) const {
        const std::size_t operands = known.count();
        if (operands <= short_list || level > depth_) return true;
        if (level < deepest) return false;
        // The smallest cells are for what is near the surface.
        const bool near = std::abs(known.value) <= size && 4 * operands <= 3 * around;
        return !near || spent_ > most_values;
    }

    /// Adds the cells of a node, which is a cube of this size, and returns its first.
    std::uint32_t node(const Eighths& eighths, const glm::dvec3& low, double size, int level) {
        const auto first = static_cast<std::uint32_t>(found_.cells.size());
        found_.cells.resize(first + ActiveCells::cells_a_node);
        for (int i = 0; i < parts; ++i) {
            eighth(eighths[static_cast<std::size_t>(i)], low + 0.5 * size * corner(i), 0.5 * size,
                   first, glm::ivec3(2.0 * corner(i)), level);
        }
        return first;
    }
    /// Sets the eight cells of an eighth of a node, which are at `at` in it and beyond.
    void eighth(const Known& known, const glm::dvec3& low, double size, std::uint32_t first,
                const glm::ivec3& at, int level) {
        if (!clip(region_, {low, low + size})) return;
        if (is_over(budget_)) return;
        const auto place = [&](int i) {
            const glm::ivec3 to = at + glm::ivec3(corner(i));
            return first + static_cast<std::uint32_t>((to.z * 4 + to.y) * 4 + to.x);
        };
        if (is_enough(known, all_operands, size, level) && !is_far(known.value, 0.5 * size)) {
            const ActiveCells::Cell cell = listed(known);
            for (int i = 0; i < parts; ++i) found_.cells[place(i)] = cell;
            return;
        }
        const Eighths cells = eighths(known, low, size);
        for (int i = 0; i < parts; ++i) {
            const glm::dvec3 corner_of = low + 0.5 * size * corner(i);
            const ActiveCells::Cell cell = this->cell(cells[static_cast<std::size_t>(i)], corner_of,
                                                      0.5 * size, known.count(), level);
            found_.cells[place(i)] = cell;
        }
    }
    ActiveCells::Cell cell(const Known& known, const glm::dvec3& low, double size,
                           std::size_t around, int level) {
        if (!clip(region_, {low, low + size})) return {};
        const bool enough = is_enough(known, around, size, level + 1),
                   may_be_far = is_far(known.value, size);
        if (enough && !may_be_far) return listed(known);
        const Eighths within = eighths(known, low, size);
        if (may_be_far) {
            if (const auto gradient = slope(known, within, size)) {
                return {.kind = ActiveCells::Cell::Kind::far,
                        .value = known.value - std::copysign(margin_, known.value),
                        .gradient = *gradient};
            }
        }
        if (enough) return listed(known);
        const std::uint32_t first = node(within, low, size, level + 1);
        return {.kind = ActiveCells::Cell::Kind::divided, .place = first};
    }

    const Composition& composition_;
    Region region_;
    double margin_;
    std::vector<OperandValues> values_;  ///< of the minima
    std::vector<double> registers_, scratch_;
    std::vector<std::vector<double>> columns_;
    ActiveCells found_;
    std::size_t spent_ = 0;
    int depth_ = deepest;
    const Budget* budget_ = nullptr;
};

/// The cubes' cells and lists one after the other, their first nodes before all others.
void join(std::span<const ActiveCells> cubes, ActiveCells& result) {
    using Kind = ActiveCells::Cell::Kind;
    constexpr std::uint32_t first_node = ActiveCells::cells_a_node;
    auto next = static_cast<std::uint32_t>(cubes.size()) * first_node;
    std::vector<ActiveCells::Cell> below;
    for (const ActiveCells& cube : cubes) {
        const auto lists = static_cast<std::uint32_t>((result.begins.size() - 1) / result.minima);
        const auto operands = static_cast<std::uint32_t>(result.operands.size());
        for (std::uint32_t i = 0; i < cube.cells.size(); ++i) {
            ActiveCells::Cell cell = cube.cells[i];
            if (cell.kind == Kind::divided) cell.place += next - first_node;
            if (cell.kind == Kind::listed) cell.place += lists;
            (i < first_node ? result.cells : below).push_back(cell);
        }
        next += static_cast<std::uint32_t>(cube.cells.size()) - first_node;
        for (std::size_t i = 1; i < cube.begins.size(); ++i) {
            result.begins.push_back(operands + cube.begins[i]);
        }
        result.operands.insert(result.operands.end(), cube.operands.begin(), cube.operands.end());
    }
    result.cells.insert(result.cells.end(), below.begin(), below.end());
}

Known all_of(const Composition& composition) {
    Known known;
    for (const ManyOperands& minimum : composition.minima) {
        OperandList& all = known.lists.emplace_back(minimum.operands.kind.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(i);
    }
    return known;
}

}  // namespace

ActiveCells::Place ActiveCells::at(const glm::dvec3& p) const {
    const auto step = [](glm::dvec3& local, int most) {
        const glm::ivec3 cell = glm::clamp(glm::ivec3(glm::floor(local)), 0, most - 1);
        local -= glm::dvec3(cell);
        return cell;
    };
    glm::dvec3 local = (p - origin) / size;
    const glm::ivec3 cube = glm::clamp(glm::ivec3(glm::floor(local)), glm::ivec3(0), count - 1);
    local -= glm::dvec3(cube);
    std::size_t node =
        cells_a_node * static_cast<std::size_t>((cube.z * count.y + cube.y) * count.x + cube.x);
    for (double side = size / cells_aside;; side /= cells_aside) {
        local *= cells_aside;
        const glm::ivec3 cell = step(local, cells_aside);
        const std::size_t place =
            node + static_cast<std::size_t>((cell.z * cells_aside + cell.y) * cells_aside + cell.x);
        if (cells[place].kind != Cell::Kind::divided) return {place, p + side * (0.5 - local)};
        node = cells[place].place;
    }
}

ActiveCells active_cells(const Composition& composition, const Region& region,
                         const Budget* budget) {
    const Cell box = bounding_cell(region);
    const glm::dvec3 extent = box.high - box.low;
    const double longest = std::max({extent.x, extent.y, extent.z});
    ActiveCells result;
    result.minima = composition.minima.size();
    result.origin = box.low;
    result.size = longest / cubes_along;
    for (int i = 0; i < 3; ++i) {
        result.count[i] = std::max(1, static_cast<int>(std::ceil(extent[i] / result.size)));
    }
    const Known all = all_of(composition);
    std::vector<ActiveCells> found(
        static_cast<std::size_t>(result.count.x * result.count.y * result.count.z));
    const auto divide_all = [&](int depth) {
        const auto divide = [&](Divider& divider, std::size_t i) {
            const int number = static_cast<int>(i), row = number / result.count.x;
            const glm::dvec3 place(number % result.count.x, row % result.count.y,
                                   row / result.count.y);
            auto cube =
                divider.cube(box.low + result.size * place, result.size, all, depth, budget);
            if (cube) found[i] = std::move(*cube);
        };
        const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
        in_parallel(
            found.size(), threads, [&] { return Divider(composition, region, 1e-6 * longest); },
            divide, 1);
    };
    if (budget) {
        for (int depth = 0; depth < deepest; ++depth) divide_all(depth);
    }
    divide_all(deepest);
    join(found, result);
    return result;
}

}  // namespace analysis
