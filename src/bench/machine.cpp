// SPDX-License-Identifier: MIT
#include "bench/machine.h"

#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string_view>
#include <thread>

#include "bench/commit.h"

namespace bench {
namespace {

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "unknown";
}

std::string now() {
    const std::time_t time = std::time(nullptr);
    std::tm parts{};
    gmtime_r(&time, &parts);
    std::array<char, 32> text{};
    const std::size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return {text.data(), size};
}

/// Mesa reads it likewise (util/os_misc.c, env_var_as_boolean).
bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    if (!value) return false;
    const std::string_view text = value;
    return text == "1" || text == "true" || text == "y" || text == "yes";
}

}  // namespace

Machine describe_machine(const render::Context& context, const std::string& backend) {
    Machine machine;
    machine.processor = processor();
    machine.cores = static_cast<int>(std::thread::hardware_concurrency());
    machine.backend = backend;
    machine.renderer = context.renderer();
    machine.version = context.version();
    machine.date = now();
    machine.commit = std::string(commit());
    machine.shader_cache = !is_set("MESA_SHADER_CACHE_DISABLE");
    return machine;
}

}  // namespace bench
