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

}  // namespace

analysis::Operands operands(const shader::FamilyTable& table, std::span<const double> parameters) {
    const std::vector<double> numbers = numbers_of(table, parameters);
    analysis::Operands result;
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

std::array<float, shader::family_head_size> add_family(std::vector<float>& texels,
                                                       const shader::FamilyTable& table,
                                                       const analysis::Region& region,
                                                       std::span<const double> parameters) {
    const analysis::ActiveLists lists =
        active_lists(operands(table, parameters), with_margin(region), width_of(table, parameters));
    const std::vector<float> all = rows(table, numbers_of(table, parameters));
    const std::size_t cells = lists.cells.size(), row = 4 * table.texels;
    const std::size_t first_row = texels.size() / 4;
    const std::size_t end_of_rows = first_row + table.texels * table.members.size();
    const std::size_t end_of_heads = end_of_rows + 1 + cells;
    texels.reserve(4 * end_of_heads + row * lists.operands.size());
    texels.insert(texels.end(), all.begin(), all.end());
    const auto add_head = [&](std::size_t begin, std::size_t end) {
        texels.insert(texels.end(), {static_cast<float>(begin), static_cast<float>(end), 0, 0});
    };
    add_head(first_row, end_of_rows);
    for (std::size_t i = 0; i < cells; ++i) {
        if (lists.of(i).empty()) {
            add_head(first_row, end_of_rows);
            continue;
        }
        const std::size_t list = lists.cells[i];
        add_head(end_of_heads + table.texels * lists.begins[list],
                 end_of_heads + table.texels * lists.begins[list + 1]);
    }
    for (const std::uint32_t operand : lists.operands) {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(row * operand);
        texels.insert(texels.end(), begin, begin + static_cast<std::ptrdiff_t>(row));
    }
    return {static_cast<float>(lists.origin.x), static_cast<float>(lists.origin.y),
            static_cast<float>(lists.origin.z), static_cast<float>(1 / lists.size),
            static_cast<float>(lists.count.x),  static_cast<float>(lists.count.y),
            static_cast<float>(lists.count.z),  static_cast<float>(end_of_rows),
            static_cast<float>(first_row)};
}

}  // namespace compile
