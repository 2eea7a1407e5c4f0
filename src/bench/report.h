// SPDX-License-Identifier: MIT
// What was measured: everything that tables, plots and pages are made of.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/sweep.h"

namespace bench {

/// Where and when.
struct Machine {
    std::string processor;  ///< the model's name
    int cores = 0;
    std::string backend;       ///< osmesa or egl
    std::string renderer;      ///< the driver's own string
    std::string version;       ///< of OpenGL and of the driver
    std::string date;          ///< UTC, ISO 8601
    std::string commit;        ///< of the source; empty if it was not built from a repository
    bool shader_cache = true;  ///< whether the driver may keep programs on disk
};

/// How the picture differs from the reference, as oracle::Metrics counts it.
struct Errors {
    std::size_t compared = 0, undecided = 0, fragile = 0;
    std::size_t missed = 0, phantom = 0, moved = 0;
    double depth_median = 0, depth_99 = 0, depth_largest = 0;  ///< relative
    double normal_median = 0, normal_99 = 0;                   ///< degrees

    std::size_t wrong() const { return missed + phantom + moved; }

    friend bool operator==(const Errors&, const Errors&) = default;
};

/// What each part of a program costs: medians over the rounds of programs that do ever more.
/// Seconds a frame.
struct Passes {
    double geometry = 0;  ///< to the surface
    double normal = 0;    ///< the same and the normal
    double shading = 0;   ///< the same and light without shadows
    double shadows = 0;   ///< everything

    friend bool operator==(const Passes&, const Passes&) = default;
};

/// What moving a slider costs, as in the studio: nothing is linked. Medians of a few moves.
struct SliderMove {
    double before_seconds = 0;   ///< from the new value to drawing: analyses within their budget
    double picture_seconds = 0;  ///< from the new value to the finished picture
    bool coarse = false;         ///< the budget was over before all bounds were close

    friend bool operator==(const SliderMove&, const SliderMove&) = default;
};

/// Shares of the whole frame, which add up to 1; a difference below 0 counts as none.
std::array<double, 4> shares(const Passes& passes);

/// One tracer, or one program to compare with, with one setting.
struct Entry {
    std::string tracer;
    Move move;
    std::vector<double> seconds;  ///< a frame, by round; slow ones have no later rounds
    double link_seconds = 0;      ///< of its program
    double first_frame_seconds = 0;
    std::optional<double> evaluations;  ///< of the field by primary rays, a pixel
    std::size_t hit = 0, miss = 0, unresolved = 0;
    std::optional<Errors> errors;
    std::optional<Passes> passes;

    friend bool operator==(const Entry&, const Entry&) = default;
};

/// All of one preset. In each round each of its entries was drawn once, but for slow ones.
struct PresetReport {
    std::string preset;
    bool smooth = false;                 ///< proven: smooth, and defined all over the bounds
    bool proven = true;                  ///< the reference proves what it does not call undecided
    double parse_seconds = 0;            ///< from the text to a field that has passed all passes
    double analyse_seconds = 0;          ///< from that to the program's text and numbers: a median
    std::optional<SliderMove> slider{};  ///< none if the formula has no number to move
    std::vector<double> yardstick_seconds;   ///< by round: what a fixed program took beside them
    std::map<std::string, double> settings;  ///< the preset's own, of those that can be moved
    std::vector<Entry> entries;

    friend bool operator==(const PresetReport&, const PresetReport&) = default;
};

/// One run.
struct Report {
    Machine machine;
    int width = 0, height = 0, rounds = 0;
    int reference_width = 0, reference_height = 0;  ///< of the pictures that are judged
    std::string command;                            ///< that repeats it
    std::vector<PresetReport> presets;
};

/// The entry of a tracer with this setting; null if there is none.
const Entry* find(const PresetReport& preset, const std::string& tracer, const Move& move = {});

/// How many times as long the one took as the other: the median over the rounds that both were
/// drawn in. None if there is no other, or no such round.
std::optional<double> time_ratio(const Entry& entry, const Entry* other);

/// The shader by hand that stands for this preset: the fractal's own, else sphere tracing of the
/// formula; null if there is none.
const Entry* plain_of(const PresetReport& preset);

/// Names of what tracers are compared with.
inline constexpr std::string_view plain_name = "plain";
inline constexpr std::string_view plain_sphere_name = "plain sphere";
inline constexpr std::string_view plain_first_order_name = "plain first-order";
inline constexpr std::string_view limit_name = "limit";

}  // namespace bench
