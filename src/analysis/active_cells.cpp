// SPDX-License-Identifier: MIT
#include "analysis/active_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include <glm/glm.hpp>

#include "analysis/in_parallel.h"
#include "analysis/operand_choice.h"
#include "eval/batch.h"

namespace analysis {
namespace {

/// Cubes along the longest axis of the box.
constexpr int cubes_along = 4;

/// How deep nodes are at most below those of the cubes: 256 cells along the longest axis.
constexpr int deepest = 2;

/// Cells with so few operands are not worth smaller ones.
constexpr std::size_t short_list = 8;

/// So many near the surface are worth smaller cells even if there is no time.
constexpr std::size_t long_list = 32;

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
        std::size_t columns = 4;
        for (std::size_t k = 0; k < composition.minima.size(); ++k) {
            values_.emplace_back(composition.minima[k].operands);
            columns = std::max(columns, minimum_column(k) + 1);
        }
        columns_.resize(columns);
        if (!composition.outline) return;
        std::vector<double> parameters(composition.parameters.begin(),
                                       composition.parameters.end());
        eval::load_parameters<double>(*composition.outline, parameters, registers_);
    }

    /// With small cells everywhere, or only where lists are long near the surface; none if there
    /// was no time.
    std::optional<ActiveCells> cube(const glm::dvec3& low, double size, const Known& known,
                                    bool everywhere, const Budget* budget) {
        found_ = {};
        everywhere_ = everywhere;
        budget_ = everywhere ? budget : nullptr;
        found_.minima = composition_.minima.size();
        spent_ = 0;
        if (is_over(budget_)) return std::nullopt;
        node(eighths(known, low, size), low, size, 0);
        if (budget_ && budget_->was_over()) return std::nullopt;
        return std::move(found_);
    }

private:
    using Eighths = std::array<Known, parts>;

    static std::array<glm::dvec3, parts> middles_of_eighths(const glm::dvec3& low, double size) {
        std::array<glm::dvec3, parts> middles;
        for (int i = 0; i < parts; ++i) {
            middles[static_cast<std::size_t>(i)] = low + 0.5 * size * (corner(i) + 0.5);
        }
        return middles;
    }

    /// What is known of the eighths of a cell.
    Eighths eighths(const Known& known, const glm::dvec3& low, double size) {
        const auto middles = middles_of_eighths(low, size);
        const double reach = 0.25 * std::sqrt(3.0) * size + margin_;
        Eighths result;
        for (Known& each : result) each.lists.resize(known.lists.size());
        look_from(middles, known, reach, [&](std::size_t i, std::size_t k, OperandSpan chosen) {
            result[i].lists[k].assign(chosen.begin(), chosen.end());
        });
        const std::array values = fields(middles);
        for (std::size_t i = 0; i < parts; ++i) result[i].value = values[i];
        return result;
    }

    /// Finds each minimum at some points, and tells which operands matter within the reach of the
    /// i-th point in the k-th minimum.
    template <class Tell>
    void look_from(std::span<const glm::dvec3> points, const Known& known, double reach,
                   Tell tell) {
        for (std::size_t k = 0; k < known.lists.size(); ++k) {
            const OperandList& list = known.lists[k];
            const std::span<const double> values = values_[k].at(points, list);
            const std::optional<double> width = composition_.minima[k].width;
            spent_ += values.size();
            auto& minima = columns_[minimum_column(k)];
            minima.resize(points.size());
            for (std::size_t i = 0; i < points.size(); ++i) {
                const std::span row = values.subspan(i * list.size(), list.size());
                const OperandChoice::Found found = width ? choice_.blended(list, row, reach, *width)
                                                         : choice_.nearest(list, row, reach);
                minima[i] = found.least;
                tell(i, k, found.operands);
            }
        }
    }
    std::size_t minimum_column(std::size_t k) const {
        return composition_.outline ? index(composition_.minima[k].variable) : 3;
    }

    /// The field where the minima have been found.
    std::array<double, parts> fields(const std::array<glm::dvec3, parts>& points) {
        std::array<double, parts> values{};
        if (!composition_.outline) {
            std::ranges::copy(columns_[minimum_column(0)], values.begin());
            return values;
        }
        for (int axis = 0; axis < 3; ++axis) {
            auto& column = columns_[static_cast<std::size_t>(axis)];
            column.resize(parts);
            for (std::size_t i = 0; i < parts; ++i) column[i] = points[i][axis];
        }
        variables_.assign(columns_.begin(), columns_.end());
        const std::array roots{std::span<double>(values)};
        eval::evaluate_points(*composition_.outline, registers_, variables_, roots, scratch_);
        return values;
    }

    bool is_far(double value, double size) const {
        const double reach = 0.5 * std::sqrt(3.0) * size + margin_;
        const bool may_be = composition_.may_be_far && (value > 0 || composition_.inside_too);
        return may_be && std::abs(value) >= far_reaches * reach;
    }
    /// The slope of the field between the middles of a cell's eighths, with its value at the cell's
    /// middle, if all their values are nearly as it tells.
    static std::optional<glm::dvec3> slope_between(const std::array<double, parts>& values,
                                                   double middle, double size) {
        glm::dvec3 gradient(0);
        for (int i = 0; i < parts; ++i) {
            gradient += values[static_cast<std::size_t>(i)] / (2 * size) * (2.0 * corner(i) - 1.0);
        }
        for (int i = 0; i < parts; ++i) {
            const double value = values[static_cast<std::size_t>(i)];
            const double told = middle + 0.25 * size * glm::dot(gradient, 2.0 * corner(i) - 1.0);
            if (!(std::abs(told - value) <= most_bend * std::abs(value))) return std::nullopt;
        }
        return gradient;
    }
    /// The same of a cell itself.
    std::optional<glm::dvec3> slope_in(const Known& known, const glm::dvec3& low, double size) {
        const auto points = middles_of_eighths(low, size);
        look_from(points, known, 0, [](std::size_t, std::size_t, OperandSpan) {});
        return slope_between(fields(points), known.value, size);
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
        if (operands <= short_list || level > deepest) return true;
        const bool near = std::abs(known.value) <= size;
        if (!everywhere_) return level > 1 || (level == 1 && !(near && operands > long_list));
        if (level < deepest) return false;
        // The smallest cells are for what is near the surface.
        return !near || 4 * operands > 3 * around || spent_ > most_values;
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
        std::array<double, parts> values;
        for (std::size_t i = 0; i < parts; ++i) values[i] = cells[i].value;
        const std::optional<glm::dvec3> slope = slope_between(values, known.value, size);
        for (int i = 0; i < parts; ++i) {
            const glm::dvec3 corner_of = low + 0.5 * size * corner(i);
            const ActiveCells::Cell cell = this->cell(cells[static_cast<std::size_t>(i)], corner_of,
                                                      0.5 * size, known.count(), slope, level);
            found_.cells[place(i)] = cell;
        }
    }
    ActiveCells::Cell cell(const Known& known, const glm::dvec3& low, double size,
                           std::size_t around, const std::optional<glm::dvec3>& slope_around,
                           int level) {
        if (!clip(region_, {low, low + size})) return {};
        const bool enough = is_enough(known, around, size, level + 1),
                   may_be_far = is_far(known.value, size);
        if (enough && !may_be_far) return listed(known);
        if (may_be_far) {
            // What may bend beyond the middles around it is asked by itself.
            const bool very_far = is_far(known.value, 2 * size);
            if (const auto gradient =
                    very_far && slope_around ? slope_around : slope_in(known, low, size)) {
                return {.kind = ActiveCells::Cell::Kind::far,
                        .value = known.value - std::copysign(margin_, known.value),
                        .gradient = *gradient};
            }
        }
        if (enough) return listed(known);
        const std::uint32_t first = node(eighths(known, low, size), low, size, level + 1);
        return {.kind = ActiveCells::Cell::Kind::divided, .place = first};
    }

    const Composition& composition_;
    Region region_;
    double margin_;
    std::vector<OperandValues> values_;  ///< of the minima
    OperandChoice choice_;
    std::vector<double> registers_, scratch_;
    std::vector<std::vector<double>> columns_;
    std::vector<std::span<const double>> variables_;  ///< the columns
    ActiveCells found_;
    std::size_t spent_ = 0;
    bool everywhere_ = true;
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
    const auto divide_all = [&](bool everywhere) {
        const auto divide = [&](Divider& divider, std::size_t i) {
            const int number = static_cast<int>(i), row = number / result.count.x;
            const glm::dvec3 place(number % result.count.x, row % result.count.y,
                                   row / result.count.y);
            auto cube =
                divider.cube(box.low + result.size * place, result.size, all, everywhere, budget);
            if (cube) found[i] = std::move(*cube);
        };
        const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
        in_parallel(
            found.size(), threads, [&] { return Divider(composition, region, 1e-6 * longest); },
            divide, 1);
    };
    if (budget) divide_all(false);
    divide_all(true);
    join(found, result);
    return result;
}

}  // namespace analysis
