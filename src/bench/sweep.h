// SPDX-License-Identifier: MIT
// The settings that trade time for accuracy, and lists of values for them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scene/document.h"

namespace bench {

/// One setting moved away from the preset's own; an empty name moves none.
struct Move {
    std::string name;
    double value = 0;

    friend bool operator==(const Move&, const Move&) = default;
};

/// Values of one setting, each of which is tried while all others stay.
struct Sweep {
    std::string name;
    std::vector<double> values;
};

/// Understands `lipschitz=0.5,1,2`; the settings are `steps`, `epsilon` and `lipschitz`.
base::Result<Sweep> read_sweep(std::string_view text);

/// The preset's own values, by name.
std::map<std::string, double> own_values(const scene::Settings& settings);

/// What is tried of a scene: first its own settings, then each value of each sweep that is another.
std::vector<Move> moves(const std::vector<Sweep>& sweeps, const scene::Settings& settings);

scene::Settings moved(scene::Settings settings, const Move& move);

/// "lipschitz 2"; "as set" for none.
std::string text(const Move& move);

}  // namespace bench
