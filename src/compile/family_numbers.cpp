// SPDX-License-Identifier: MIT
#include "compile/family_numbers.h"

#include <algorithm>

#include "eval/tape.h"

namespace compile {
namespace {

/// The numbers of all members, one after the other.
std::vector<double> numbers_of(const shader::FamilyTable& table,
                               std::span<const double> parameters) {
    std::vector<double> numbers(table.numbers.roots.size()), scratch;
    eval::evaluate<double>(table.numbers, {}, parameters, numbers, scratch);
    return numbers;
}

std::optional<double> width_of(const shader::FamilyTable& table,
                               std::span<const double> parameters) {
    if (!table.is_smooth) return std::nullopt;
    return numbers_of(table, parameters).back();
}

/// The rows of all members.
std::vector<float> rows(const shader::FamilyTable& table, std::span<const double> numbers) {
    const std::size_t size = 4 * table.texels;
    std::vector<float> result(size * table.members.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < table.members.size(); ++i) {
        float* const row = result.data() + i * size;
        for (std::size_t k = 0; k < table.sizes[i]; ++k) {
            row[k] = static_cast<float>(numbers[next++]);
        }
        const std::size_t end = table.first_object ? size - 1 : size;
        if (table.kinds.size() > 1) row[end - 1] = static_cast<float>(table.members[i]);
        if (table.first_object) row[end] = static_cast<float>(*table.first_object + i);
    }
    return result;
}

/// Somewhat more than the region: what is at its walls is looked at as well.
analysis::Region with_margin(const analysis::Region& region) {
    const double margin = 1e-3 * std::max({region.half.x, region.half.y, region.half.z});
    analysis::Region wider = region;
    wider.half += margin;
    return wider;
}

analysis::Composition composition(const shader::FamilyTree& tree,
                                  std::span<const shader::FamilyTable> tables,
                                  std::span<const double> parameters) {
    analysis::Composition result;
    for (const shader::FamilyTable& table : tables) {
        result.minima.push_back(
            {operands(table, parameters), width_of(table, parameters), table.variable});
    }
    if (tree.outline) result.outline = &*tree.outline;
    result.parameters = parameters;
    result.may_be_far = tree.may_be_far;
    // Where a solid is cut by the bounds, its objects are told apart.
    result.inside_too = tree.outline.has_value();
    return result;
}

/// Writes the texels of a tree behind those of others.
class TreeTexels {
public:
    TreeTexels(std::vector<float>& texels, const shader::FamilyTree& tree,
               std::span<const shader::FamilyTable> tables, std::span<const double> parameters)
        : texels_(texels), tree_(tree), tables_(tables) {
        for (const shader::FamilyTable& table : tables) {
            first_rows_.push_back(texels.size() / 4);
            const std::vector<float>& own =
                rows_.emplace_back(rows(table, numbers_of(table, parameters)));
            texels.insert(texels.end(), own.begin(), own.end());
        }
        heads_ = texels.size() / 4;
    }

    std::vector<FamilyHeads> add(const analysis::ActiveCells& found) {
        const std::size_t head = 4 * tree_.head_texels();
        texels_.resize(texels_.size() + head * (1 + found.cells.size()));
        std::size_t place = 4 * heads_;
        set_list(place, first_rows_[0], [&](std::size_t i) { return tables_[i].members.size(); });
        const std::vector<std::size_t> begins = add_lists(found);
        for (const analysis::ActiveCells::Cell& cell : found.cells) {
            place += head;
            set(place, cell, found, begins);
        }
        std::vector<FamilyHeads> result;
        for (const std::size_t first_row : first_rows_) {
            result.push_back({static_cast<float>(found.origin.x),
                              static_cast<float>(found.origin.y),
                              static_cast<float>(found.origin.z),
                              static_cast<float>(1 / found.size), static_cast<float>(found.count.x),
                              static_cast<float>(found.count.y), static_cast<float>(found.count.z),
                              static_cast<float>(heads_), static_cast<float>(first_row)});
        }
        return result;
    }

private:
    using Cell = analysis::ActiveCells::Cell;

    /// The head at a place among the floats, for lists of these lengths one after the other.
    template <class Length>
    void set_list(std::size_t place, std::size_t begin, Length length) {
        texels_[place] = static_cast<float>(begin);
        for (std::size_t i = 0; i < tables_.size(); ++i) {
            begin += tables_[i].texels * length(i);
            texels_[place + shader::FamilyTree::end_place(i)] = static_cast<float>(begin);
        }
    }
    void set(std::size_t place, const Cell& cell, const analysis::ActiveCells& found,
             std::span<const std::size_t> begins) {
        switch (cell.kind) {
            case Cell::Kind::everything:
                std::copy_n(texels_.begin() + static_cast<std::ptrdiff_t>(4 * heads_),
                            4 * tree_.head_texels(),
                            texels_.begin() + static_cast<std::ptrdiff_t>(place));
                return;
            case Cell::Kind::listed:
                set_list(place, begins[cell.place],
                         [&](std::size_t i) { return found.of(cell.place, i).size(); });
                return;
            case Cell::Kind::far:
                for (int i = 0; i < 3; ++i) {
                    texels_[place + static_cast<std::size_t>(i)] =
                        static_cast<float>(cell.gradient[i]);
                }
                texels_[place + 3] = static_cast<float>(cell.value);
                return;
            case Cell::Kind::divided:
                texels_[place] =
                    -static_cast<float>(heads_ + tree_.head_texels() * (1 + cell.place));
                return;
        }
    }
    /// Adds all lists and tells where each begins.
    std::vector<std::size_t> add_lists(const analysis::ActiveCells& found) {
        std::vector<std::size_t> begins;
        const std::size_t lists = (found.begins.size() - 1) / found.minima;
        for (std::size_t list = 0; list < lists; ++list) {
            begins.push_back(texels_.size() / 4);
            for (std::size_t i = 0; i < tables_.size(); ++i) {
                const auto row = static_cast<std::ptrdiff_t>(4 * tables_[i].texels);
                for (const std::uint32_t operand : found.of(list, i)) {
                    const auto begin = rows_[i].begin() + row * operand;
                    texels_.insert(texels_.end(), begin, begin + row);
                }
            }
        }
        // Two rows are read at once.
        texels_.resize(texels_.size() + widest_row());
        return begins;
    }

    std::size_t widest_row() const {
        std::size_t texels = 0;
        for (const shader::FamilyTable& table : tables_) texels = std::max(texels, table.texels);
        return 4 * texels;
    }

    std::vector<float>& texels_;
    const shader::FamilyTree& tree_;
    std::span<const shader::FamilyTable> tables_;
    std::vector<std::vector<float>> rows_;
    std::vector<std::size_t> first_rows_;
    std::size_t heads_ = 0;
};

}  // namespace

analysis::Operands operands(const shader::FamilyTable& table, std::span<const double> parameters) {
    const std::vector<double> numbers = numbers_of(table, parameters);
    analysis::Operands result;
    result.parameters = parameters;
    for (const shader::FamilyTable::Kind& kind : table.kinds) {
        result.kinds.push_back({&kind.value, kind.variables, {}});
        result.kinds.back().numbers.resize(kind.variables.size());
    }
    std::vector<std::uint32_t> known(table.kinds.size(), 0);
    std::size_t next = 0;
    for (std::size_t i = 0; i < table.members.size(); ++i) {
        const std::size_t kind = table.members[i];
        result.kind.push_back(static_cast<std::uint32_t>(kind));
        result.place.push_back(known[kind]++);
        for (std::size_t k = 0; k < table.sizes[i]; ++k) {
            result.kinds[kind].numbers[k].push_back(numbers[next++]);
        }
    }
    return result;
}

std::vector<FamilyHeads> add_tree(std::vector<float>& texels, const shader::FamilyTree& tree,
                                  std::span<const shader::FamilyTable> tables,
                                  const analysis::Region& region,
                                  std::span<const double> parameters,
                                  const analysis::Budget* budget) {
    TreeTexels made(texels, tree, tables, parameters);
    return made.add(
        active_cells(composition(tree, tables, parameters), with_margin(region), budget));
}

}  // namespace compile
