// SPDX-License-Identifier: MIT
#include "shader/family.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

#include "field/overloaded.h"
#include "field/parts.h"
#include "shader/domain.h"

namespace shader {
namespace {

using field::Field;
using field::FieldId;
using graph::NodeId;

/// Builds a family member by member.
class Recruiter {
public:
    Recruiter(Field& field, const std::vector<bool>& depends) : field_(field), depends_(depends) {}

    /// Takes a leaf as the next member, if it is alike enough.
    bool take(FieldId id) {
        const auto* leaf = std::get_if<field::Formula>(&field_[id]);
        if (!leaf || leaf->kind == field::Kind::sheet || leaf->metric != field::Metric::distance) {
            return false;
        }
        std::vector<NodeId> roots{leaf->value};
        if (leaf->colour) roots.insert(roots.end(), leaf->colour->begin(), leaf->colour->end());
        return take(std::move(roots));
    }
    /// Takes a distance, and the parts of a colour, as the next member.
    bool take(std::vector<NodeId> roots) {
        Generalisation it = generalise(field_.graph, depends_, roots);
        if (it.pattern.empty()) return false;
        const auto known = kinds_.find(it.pattern);
        std::size_t kind = family_.kinds.size();
        if (known != kinds_.end()) {
            kind = known->second;
        } else {
            if (kind == most_kinds || may_be_undefined(field_.graph, std::array{roots[0]})) {
                return false;
            }
            kinds_.emplace(std::move(it.pattern), kind);
            roots_.push_back(std::move(roots));
            family_.kinds.emplace_back();
        }
        family_.members.push_back({kind, std::move(it.numbers)});
        return true;
    }
    /// Forgets those that were taken.
    void dismiss() {
        kinds_.clear();
        roots_.clear();
        family_ = {};
    }
    /// The family of those that were taken.
    Family finish() {
        for (std::size_t kind = 0; kind < family_.kinds.size(); ++kind) tell_numbers(kind);
        Family family = std::move(family_);
        dismiss();
        return family;
    }

private:
    /// Numbers that all members of a kind share stay in its expressions, and those that are equal
    /// in each member become one variable.
    void tell_numbers(std::size_t kind) {
        std::vector<std::vector<NodeId>> columns;
        std::vector<Member*> members;
        for (Member& member : family_.members) {
            if (member.kind != kind) continue;
            columns.resize(member.numbers.size());
            for (std::size_t i = 0; i < columns.size(); ++i) {
                columns[i].push_back(member.numbers[i]);
            }
            members.push_back(&member);
            member.numbers.clear();
        }
        MemberKind& result = family_.kinds[kind];
        const std::span<const NodeId> roots = roots_[kind];
        const std::size_t of_value =
            generalise(field_.graph, depends_, roots.first(1)).numbers.size();
        std::map<std::vector<NodeId>, NodeId> known;
        std::vector<NodeId> numbers;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const std::vector<NodeId>& column = columns[i];
            const bool shared = std::ranges::count(column, column[0]) == std::ssize(column);
            const auto [place, is_new] = known.try_emplace(column, column[0]);
            if (is_new && !shared) {
                const auto name = "number" + std::to_string(result.variables.size());
                result.variables.push_back(field_.graph.new_variable(name));
                place->second = field_.graph.variable(result.variables.back());
                for (std::size_t k = 0; k < members.size(); ++k) {
                    members[k]->numbers.push_back(column[k]);
                }
            }
            numbers.push_back(place->second);
            if (i < of_value) result.value_numbers = result.variables.size();
        }
        const std::vector<NodeId> whole = with_numbers(field_.graph, depends_, roots, numbers);
        result.value = whole[0];
        if (roots.size() > 1) result.colour = {whole[1], whole[2], whole[3]};
    }

    Field& field_;
    const std::vector<bool>& depends_;
    std::map<std::vector<std::uint32_t>, std::size_t> kinds_{};  ///< by their patterns
    std::vector<std::vector<NodeId>> roots_{};  ///< of the first member of each kind
    Family family_{};
};

class Gatherer {
public:
    explicit Gatherer(Field& field)
        : field_(field), depends_(depends_on_variables(field.graph)), recruiter_(field, depends_) {}

    FieldId visit(FieldId id) {
        if (families_.contains(id)) return id;
        const field::Node node = field_[id];  // a copy: adding nodes moves them
        return std::visit(field::Overloaded{
                              [&](const field::Union&) { return unite(id); },
                              [&](const field::Intersection&) { return intersect(id); },
                              [&](const field::Complement& it) {
                                  const FieldId a = visit(it.a);
                                  return a == it.a ? id : field_.add(field::Complement{a});
                              },
                              [&](const field::Choice& it) {
                                  field::Choice choice = it;
                                  choice.a = visit(it.a);
                                  choice.b = visit(it.b);
                                  return field_.add(choice);
                              },
                              // In place: bounds are found by the number of the cells.
                              [&](const field::Cells& it) {
                                  const FieldId a = visit(it.a);
                                  std::get<field::Cells>(field_.nodes[index(id)]).a = a;
                                  return id;
                              },
                              [&](const auto&) { return id; },
                          },
                          node);
    }
    std::map<FieldId, Family> families() { return std::move(families_); }

private:
    template <class Node>
    void collect(FieldId id, std::vector<FieldId>& list) const {
        const auto* node = families_.contains(id) ? nullptr : std::get_if<Node>(&field_[id]);
        if (!node) return list.push_back(id);
        const auto [a, b] = *node;
        collect<Node>(a, list);
        collect<Node>(b, list);
    }
    /// The operands of the tree of such nodes, from left to right.
    template <class Node>
    std::vector<FieldId> operands(FieldId id) const {
        std::vector<FieldId> list;
        collect<Node>(id, list);
        return list;
    }
    template <class Node>
    FieldId balance(std::span<const FieldId> list) {
        if (list.size() == 1) return list[0];
        const std::size_t half = list.size() / 2;
        const FieldId a = balance<Node>(list.first(half)), b = balance<Node>(list.subspan(half));
        return field_.add(Node{a, b});
    }

    FieldId unite(FieldId id) {
        const std::vector<FieldId> list = operands<field::Union>(id);
        std::vector<FieldId> result;
        for (std::size_t begin = 0; begin < list.size();) {
            std::size_t end = begin;
            while (end < list.size() && recruiter_.take(list[end])) ++end;
            if (end - begin >= field::many) {
                result.push_back(
                    balance<field::Union>(std::span(list).subspan(begin, end - begin)));
                families_.emplace(result.back(), recruiter_.finish());
            } else {
                recruiter_.dismiss();
                end = std::max(end, begin + 1);
                for (std::size_t i = begin; i < end; ++i) result.push_back(visit(list[i]));
            }
            begin = end;
        }
        return result == list ? id : balance<field::Union>(result);
    }

    /// What is cut out by one after the other is cut out at once.
    FieldId intersect(FieldId id) {
        const std::vector<FieldId> list = operands<field::Intersection>(id);
        const auto cut = [&](FieldId it) -> const field::Complement* {
            return std::get_if<field::Complement>(&field_[it]);
        };
        std::vector<FieldId> result;
        for (std::size_t begin = 0; begin < list.size();) {
            std::vector<FieldId> holes;
            std::size_t end = begin;
            for (; end < list.size() && cut(list[end]); ++end) {
                holes.push_back(cut(list[end])->a);
            }
            if (holes.size() >= field::many) {
                const FieldId all = balance<field::Union>(holes);
                result.push_back(field_.add(field::Complement{visit(all)}));
            } else {
                end = std::max(end, begin + 1);
                for (std::size_t i = begin; i < end; ++i) result.push_back(visit(list[i]));
            }
            begin = end;
        }
        return result == list ? id : balance<field::Intersection>(result);
    }

    Field& field_;
    const std::vector<bool> depends_;
    Recruiter recruiter_;
    std::map<FieldId, Family> families_;
};

}  // namespace

std::map<FieldId, Family> gather_families(Field& field) {
    Gatherer gatherer(field);
    field.root = gatherer.visit(field.root);
    return gatherer.families();
}

std::optional<Family> family_of(field::Field& field, const std::vector<bool>& depends,
                                const field::Minimum& minimum) {
    Recruiter recruiter(field, depends);
    for (const NodeId operand : minimum.operands) {
        if (!recruiter.take({operand})) return std::nullopt;
    }
    Family family = recruiter.finish();
    family.width = minimum.width;
    return family;
}

}  // namespace shader
