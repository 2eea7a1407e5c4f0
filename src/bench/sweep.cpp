// SPDX-License-Identifier: MIT
#include "bench/sweep.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace bench {
namespace {

/// A setting, and the values that make sense.
struct Knob {
    std::string_view name;
    double least, most;
    double (*get)(const scene::Settings&);
    void (*set)(scene::Settings&, double);
};

constexpr std::array<Knob, 3> knobs{{
    {"epsilon", 1e-6, 100, [](const scene::Settings& s) { return s.epsilon; },
     [](scene::Settings& s, double value) { s.epsilon = value; }},
    {"lipschitz", 1e-3, 1e6, [](const scene::Settings& s) { return s.lipschitz; },
     [](scene::Settings& s, double value) { s.lipschitz = value; }},
    {"steps", 1, 100000, [](const scene::Settings& s) { return static_cast<double>(s.steps); },
     [](scene::Settings& s, double value) { s.steps = static_cast<int>(std::lround(value)); }},
}};

const Knob* find(std::string_view name) {
    const auto knob = std::ranges::find(knobs, name, &Knob::name);
    return knob == knobs.end() ? nullptr : &*knob;
}

base::Result<double> read_value(std::string_view text, const Knob& knob) {
    double value = 0;
    const char* last = text.data() + text.size();
    const auto [end, problem] = std::from_chars(text.data(), last, value);
    if (problem != std::errc() || end != last || !(value >= knob.least && value <= knob.most)) {
        return base::error(fmt::format("'{}' is no value of {}; it goes from {} to {}", text,
                                       knob.name, knob.least, knob.most));
    }
    return value;
}

}  // namespace

base::Result<Sweep> read_sweep(std::string_view text) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const Knob* knob = find(text.substr(0, equals));
    if (!knob || equals == text.size()) {
        return base::error(fmt::format(
            "'{}' should be lipschitz=, steps= or epsilon= and values, such as lipschitz=0.5,1,2",
            text));
    }
    Sweep sweep{std::string(knob->name), {}};
    for (std::size_t begin = equals + 1; begin <= text.size();) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        const auto value = read_value(text.substr(begin, comma - begin), *knob);
        if (!value) return value.problems();
        sweep.values.push_back(*value);
        begin = comma + 1;
    }
    return sweep;
}

std::map<std::string, double> own_values(const scene::Settings& settings) {
    std::map<std::string, double> values;
    for (const Knob& knob : knobs) values.emplace(knob.name, knob.get(settings));
    return values;
}

std::vector<Move> moves(const std::vector<Sweep>& sweeps, const scene::Settings& settings) {
    std::vector<Move> list{Move{}};
    for (const Sweep& sweep : sweeps) {
        const double own = find(sweep.name)->get(settings);
        for (const double value : sweep.values) {
            const Move move{sweep.name, value};
            if (value != own && std::ranges::find(list, move) == list.end()) list.push_back(move);
        }
    }
    return list;
}

scene::Settings moved(scene::Settings settings, const Move& move) {
    if (const Knob* knob = find(move.name)) knob->set(settings, move.value);
    return settings;
}

std::string text(const Move& move) {
    return move.name.empty() ? "as set" : fmt::format("{} {}", move.name, move.value);
}

}  // namespace bench
