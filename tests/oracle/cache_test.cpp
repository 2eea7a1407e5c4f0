// SPDX-License-Identifier: MIT
#include "oracle/cache.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "oracle/reference_file.h"
#include "oracle/traced.h"

namespace oracle {
namespace {

namespace fs = std::filesystem;

const Scene ball{.formula = "x^2 + y^2 + z^2 = 1"};

/// How often the key's reference is made while it is asked for once.
int made(const Cache& cache, const std::string& key) {
    int count = 0;
    const auto got = cache.get(key, [&]() -> base::Result<Reference> {
        ++count;
        return traced(ball);
    });
    EXPECT_TRUE(got);
    if (!got) return count;
    EXPECT_EQ(to_bytes(*got), to_bytes(traced(ball)));
    return count;
}

std::vector<fs::path> files(const fs::path& folder) {
    std::vector<fs::path> list;
    for (const auto& entry : fs::directory_iterator(folder)) list.push_back(entry.path());
    return list;
}

TEST(Cache, gives_the_same_bytes_again) {
    const TemporaryFolder folder;
    const Cache cache(folder / "new" / "place");
    EXPECT_EQ(made(cache, "a"), 1);
    EXPECT_EQ(made(cache, "a"), 0);
    EXPECT_EQ(made(cache, "b"), 1);
    EXPECT_EQ(files(folder / "new" / "place").size(), 2U);
}

TEST(Cache, makes_a_damaged_file_again) {
    const TemporaryFolder folder;
    const Cache cache(folder.path());
    made(cache, "a");
    const fs::path file = files(folder.path()).front();
    fs::resize_file(file, fs::file_size(file) - 1);
    EXPECT_EQ(made(cache, "a"), 1);
    EXPECT_EQ(made(cache, "a"), 0);
    std::ofstream(file, std::ios::binary | std::ios::in).seekp(100) << "damage";
    EXPECT_EQ(made(cache, "a"), 1);
}

TEST(Cache, removes_what_was_not_used_for_longest) {
    const TemporaryFolder folder;
    const std::uintmax_t size = to_bytes(traced(ball)).size();
    const Cache cache(folder.path(), 2 * size + 10);
    made(cache, "a");
    const fs::path a = files(folder.path()).front();
    made(cache, "b");
    fs::last_write_time(a, fs::last_write_time(a) - std::chrono::hours(1));
    made(cache, "c");
    EXPECT_FALSE(fs::exists(a));
    EXPECT_EQ(made(cache, "b"), 0);
    EXPECT_EQ(made(cache, "c"), 0);
    std::ofstream(folder / "of_someone_else") << "x";
    made(cache, "d");
    EXPECT_TRUE(fs::exists(folder / "of_someone_else"));
}

TEST(Cache, does_without_a_folder) {
    const TemporaryFolder folder;
    std::ofstream(folder / "file") << "x";
    for (const Cache& cache : {Cache({}), Cache(folder / "file" / "below")}) {
        EXPECT_EQ(made(cache, "a"), 1);
        EXPECT_EQ(made(cache, "a"), 1);
    }
}

TEST(Cache, tells_apart_all_that_a_reference_depends_on) {
    const TemporaryFolder folder;
    const Cache cache(folder.path());
    const compile::Formula formula = understood(ball.formula);
    std::size_t expected = 0;
    const auto ask = [&](const scene::Document& document, const Query& query, bool fresh) {
        expected += fresh;
        EXPECT_TRUE(trace(formula, document, query, cache));
        EXPECT_EQ(folder.size(), expected);
    };
    Query query{.width = 8, .height = 6, .region = {}, .threads = 1, .progress = {}};
    scene::Document document = ball.document();
    ask(document, query, true);
    ask(document, query, false);
    document.title = "another";
    document.settings.steps = 3;
    document.materials[0].colour = glm::dvec3(1, 0, 0);
    query.threads = 2;
    ask(document, query, false);
    query.region = std::array{1, 1, 3, 3};
    ask(document, query, true);
    query.region = std::array{1, 1, 3, 4};
    ask(document, query, true);
    query.height = 7;
    ask(document, query, true);
    document.bounds.half = glm::dvec3(1.5);
    ask(document, query, true);
    document.camera->eye.x += 1e-15;
    ask(document, query, true);
    document.time = 1;
    ask(document, query, true);
}

}  // namespace
}  // namespace oracle
