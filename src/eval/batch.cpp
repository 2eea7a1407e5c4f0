// SPDX-License-Identifier: MIT
#include "eval/batch.h"

#include <algorithm>
#include <cassert>

#include "numeric/real.h"

// The loops over lanes are compiled for each of these instruction sets, and the machine's best one
// is chosen when the program starts. None of them rounds differently: contraction to fused
// operations is switched off for this file.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define ZEROSET_FOR_EACH_MACHINE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define ZEROSET_FOR_EACH_MACHINE
#endif
#define ZEROSET_INLINE __attribute__((always_inline))

namespace eval {
namespace {

/// The loops run over whole groups of lanes, so that no vector has a remainder.
constexpr std::size_t group = 8;

/// The lanes of an argument, or one number for all of them.
struct Operand {
    const double* lanes = nullptr;
    bool uniform = false;
};

/// Registers of one block: uniform ones as single numbers, the others as block_size lanes.
struct Block {
    std::span<const double> uniform;
    std::vector<double>& lanes;  ///< of the other registers, then room to spread four uniform ones
    std::size_t groups = 0;

    double* lanes_of(std::size_t number) const {
        return lanes.data() + (number - uniform.size()) * block_size;
    }
    Operand operand(std::size_t number) const {
        if (number < uniform.size()) return {uniform.data() + number, true};
        return {lanes_of(number), false};
    }
};

template <class F>
ZEROSET_INLINE inline void for_lanes(std::size_t groups, F each) {
#pragma GCC ivdep  // a result may share its place with an argument, lane by lane
    for (std::size_t i = 0; i < groups * group; ++i) each(i);
}

template <class F>
ZEROSET_INLINE inline void unary(F f, std::size_t groups, double* result, const Operand& a) {
    const double* x = a.lanes;
    for_lanes(groups, [=](std::size_t i) ZEROSET_INLINE { result[i] = f(x[i]); });
}

template <class F>
ZEROSET_INLINE inline void binary(F f, std::size_t groups, double* result, const Operand& a,
                                  const Operand& b) {
    const double *x = a.lanes, *y = b.lanes;
    if (a.uniform) {
        const double number = *x;
        for_lanes(groups, [=](std::size_t i) ZEROSET_INLINE { result[i] = f(number, y[i]); });
    } else if (b.uniform) {
        const double number = *y;
        for_lanes(groups, [=](std::size_t i) ZEROSET_INLINE { result[i] = f(x[i], number); });
    } else {
        for_lanes(groups, [=](std::size_t i) ZEROSET_INLINE { result[i] = f(x[i], y[i]); });
    }
}

/// The lanes of an argument; a uniform one is spread over `room`.
inline const double* spread(const Operand& a, double* room) {
    if (!a.uniform) return a.lanes;
    std::fill_n(room, block_size, *a.lanes);
    return room;
}

ZEROSET_INLINE inline void run(const Tape::Instruction& instruction, const Block& block) {
    const auto& arguments = instruction.arguments;
    double* const result = block.lanes_of(instruction.result);
    double* const room = block.lanes.data() + block.lanes.size() - 4 * block_size;
    const std::size_t groups = block.groups;
    const auto operand = [&](std::size_t i) { return block.operand(arguments[i]); };
    const auto lanes = [&](std::size_t i) { return spread(operand(i), room + i * block_size); };
    switch (instruction.op) {
        case graph::Op::constant:
        case graph::Op::variable:
        case graph::Op::parameter:
            assert(false);
            return;
#define ZEROSET_LANES_1(name)                                                              \
    return unary([](double a) ZEROSET_INLINE { return numeric::name(a); }, groups, result, \
                 operand(0))
#define ZEROSET_LANES_2(name)                                                                    \
    return binary([](double a, double b) ZEROSET_INLINE { return numeric::name(a, b); }, groups, \
                  result, operand(0), operand(1))
#define ZEROSET_LANES_3(name)                                        \
    {                                                                \
        const double *a = lanes(0), *b = lanes(1), *c = lanes(2);    \
        return for_lanes(groups, [=](std::size_t i) ZEROSET_INLINE { \
            result[i] = numeric::name(a[i], b[i], c[i]);             \
        });                                                          \
    }
#define ZEROSET_LANES_4(name)                                                    \
    {                                                                            \
        const double *a = lanes(0), *b = lanes(1), *c = lanes(2), *d = lanes(3); \
        return for_lanes(groups, [=](std::size_t i) ZEROSET_INLINE {             \
            result[i] = numeric::name(a[i], b[i], c[i], d[i]);                   \
        });                                                                      \
    }
#define OPERATOR(name, arity, glsl, file) \
    case graph::Op::name:                 \
        ZEROSET_LANES_##arity(name);
#include "graph/operators.def"
    }
}

ZEROSET_FOR_EACH_MACHINE
void run_block(std::span<const Tape::Instruction> instructions, const Block& block) {
    for (const Tape::Instruction& instruction : instructions) run(instruction, block);
}

}  // namespace

void evaluate_points(const Tape& tape, std::span<const double> registers,
                     std::span<const std::span<const double>> variables,
                     std::span<const std::span<double>> roots, std::vector<double>& scratch) {
    assert(registers.size() == tape.register_count && roots.size() == tape.roots.size());
    const std::size_t uniform_count = tape.uniform_count();
    scratch.resize((tape.register_count - uniform_count + 4) * block_size);
    Block block{registers.first(uniform_count), scratch};
    const std::span instructions = std::span(tape.instructions).subspan(tape.independent);
    const std::size_t points = roots.empty() ? 0 : roots[0].size();
    for (std::size_t begin = 0; begin < points; begin += block_size) {
        const std::size_t count = std::min(block_size, points - begin);
        block.groups = (count + group - 1) / group;
        for (std::size_t i = 0; i < tape.variables.size(); ++i) {
            const std::span<const double> values = variables[graph::index(tape.variables[i])];
            double* const lanes = block.lanes_of(uniform_count + i);
            std::ranges::copy(values.subspan(begin, count), lanes);
            std::fill(lanes + count, lanes + block.groups * group, lanes[0]);
        }
        run_block(instructions, block);
        for (std::size_t i = 0; i < roots.size(); ++i) {
            const Operand root = block.operand(tape.roots[i]);
            double* const to = roots[i].data() + begin;
            if (root.uniform) {
                std::fill_n(to, count, *root.lanes);
            } else {
                std::copy_n(root.lanes, count, to);
            }
        }
    }
}

}  // namespace eval
