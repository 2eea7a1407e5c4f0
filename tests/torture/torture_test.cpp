// SPDX-License-Identifier: MIT
// Every scene by every tracer against the oracle. How many pixels are wrong is recorded and may
// only shrink. `UPDATE_TORTURE=1` records what got better and what is new; `UPDATE_TORTURE=raise`
// takes everything as it is.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/file.h"
#include "image/png.h"
#include "oracle/marked_picture.h"
#include "torture/exact_answer.h"
#include "torture/known_failures.h"
#include "torture/scene.h"
#include "torture/tracing.h"
#include "torture/twin.h"
#include "torture/update.h"

namespace torture {
namespace {

namespace fs = std::filesystem;

const fs::path table_path =
    fs::path(ZEROSET_SOURCE_DIR) / "tests" / "torture" / "known_failures.json";
const fs::path failures_folder = fs::path(ZEROSET_BINARY_DIR) / "torture-failures";

/// The recorded numbers, and those of this run, which are written at its end if asked for.
class Table : public testing::Environment {
public:
    void SetUp() override {
        auto read = read_records(table_path);
        if (read) {
            recorded = std::move(*read);
        } else if (update() == Update::none) {
            ADD_FAILURE() << text_of(read.problems());
        }
    }

    void TearDown() override {
        if (update() == Update::none || updated.empty()) return;
        for (auto& [name, record] : updated) recorded[name] = std::move(record);
        const auto names = scene_names();
        std::erase_if(recorded, [&](const auto& entry) {
            return !std::binary_search(names.begin(), names.end(), entry.first);
        });
        const auto written = base::write_atomically(table_path, records_text(recorded));
        EXPECT_TRUE(written) << text_of(written.problems());
    }

    Records recorded;
    Records updated;
};

/// Owned by the test program, which must know it before the first test.
Table* const table = static_cast<Table*>(testing::AddGlobalTestEnvironment(new Table));

/// Leaves a picture of what is wrong for people to look at, and says where.
std::string keep_marked(const Scene& scene, const std::string& tracer,
                        const oracle::Reference& reference, const oracle::Metrics& metrics) {
    const fs::path path = failures_folder / fmt::format("{}-{}.png", test_name(scene.name), tracer);
    fs::create_directories(failures_folder);
    const auto written = image::write_png(path, oracle::marked_picture(reference, metrics));
    return written ? path.string() : text_of(written.problems());
}

std::string numbers(const Failures& f) {
    return fmt::format("{} missed, {} phantom, {} moved, {} unresolved", f.missed, f.phantom,
                       f.moved, f.unresolved);
}

/// What is right, as far as the oracle knows it, or else a closed form or a twin.
oracle::Reference reference_of(const Scene& scene) {
    oracle::Reference reference = trace(scene, width, height);
    if (reference.pixels.empty()) return reference;
    if (const auto shape = exact_shape(scene.name)) {
        decide(reference, exact_reference(*shape, scene.document, width, height));
    } else if (const auto twin = twin_of(scene)) {
        decide(reference, trace(*twin, width, height));
    }
    return reference;
}

/// Compares one tracer's numbers with the recorded ones, and returns those to be recorded.
Failures judge(const Scene& scene, const std::string& tracer, const oracle::Reference& reference,
               const oracle::Metrics& metrics, const SceneRecord* record) {
    const Failures now = failures_of(metrics);
    const auto known = record ? record->tracers.find(tracer) : decltype(record->tracers.end()){};
    if (!record || known == record->tracers.end()) {
        EXPECT_NE(update(), Update::none)
            << tracer << " is not recorded; UPDATE_TORTURE=1 records it: " << numbers(now);
        return now;
    }
    if (update() == Update::raise) return now;
    if (is_worse(now, known->second)) {
        ADD_FAILURE() << scene.name << " by " << tracer << " got worse: " << numbers(now)
                      << "; recorded are " << numbers(known->second) << "; see "
                      << keep_marked(scene, tracer, reference, metrics)
                      << "\nIf that must be, UPDATE_TORTURE=raise records it.";
        return known->second;
    }
    if (update() == Update::none && is_better(now, known->second)) {
        std::cout << scene.name << " by " << tracer << " got better: " << numbers(now)
                  << "; recorded are " << numbers(known->second)
                  << ". UPDATE_TORTURE=1 records it.\n";
    }
    return shrunk(now, known->second);
}

class Torture : public testing::TestWithParam<std::string> {};

TEST_P(Torture, is_no_worse_than_recorded) {
    const Scene scene = read_scene(GetParam());
    const oracle::Reference reference = reference_of(scene);
    ASSERT_EQ(reference.pixels.size(), static_cast<std::size_t>(width * height));
    const auto found = table->recorded.find(scene.name);
    const SceneRecord* record = found == table->recorded.end() ? nullptr : &found->second;
    SceneRecord result;
    for (const Variant& variant : variants()) {
        const std::string& tracer = variant.name;
        const auto metrics = oracle::compare(reference, render(scene, variant, width, height));
        ASSERT_TRUE(metrics) << tracer << ": " << text_of(metrics.problems());
        EXPECT_EQ(metrics->no_depth, 0u) << tracer << " wrote depths that are NaN or negative";
        result.compared = metrics->compared;
        result.undecided = metrics->undecided;
        result.fragile = metrics->fragile;
        result.tracers[tracer] = judge(scene, tracer, reference, *metrics, record);
    }
    if (record && update() != Update::raise) {
        EXPECT_LE(result.undecided, record->undecided + allowance(record->undecided))
            << "the oracle decides less";
        EXPECT_LE(result.fragile, record->fragile + allowance(record->fragile));
    }
    table->updated[scene.name] = std::move(result);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Torture, testing::ValuesIn(scene_names()),
                         [](const auto& info) { return test_name(info.param); });

TEST(KnownFailures, are_of_scenes_and_tracers_that_exist) {
    const auto names = scene_names();
    std::set<std::string> tracers;
    for (const Variant& variant : variants()) tracers.insert(variant.name);
    for (const auto& [name, record] : table->recorded) {
        EXPECT_TRUE(std::binary_search(names.begin(), names.end(), name))
            << name << " is no scene; UPDATE_TORTURE=1 removes it";
        for (const auto& [tracer, failures] : record.tracers) {
            EXPECT_TRUE(tracers.contains(tracer)) << name << ": " << tracer << " is no tracer";
        }
    }
}

}  // namespace
}  // namespace torture
