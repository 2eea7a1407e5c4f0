// SPDX-License-Identifier: MIT
#include "contract/arguments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace contract {

const std::vector<float>& awkward_numbers() {
    using limits = std::numeric_limits<float>;
    static const std::vector<float> numbers = [] {
        std::vector<float> list{0.0F,
                                1.0F,
                                0.5F,
                                2.0F,
                                3.0F,
                                2.5F,
                                1e-30F,
                                1e-18F,
                                1e18F,
                                1e30F,
                                88.0F,
                                104.0F,
                                1e-5F,
                                1e5F,
                                8388609.0F,
                                limits::min(),
                                limits::denorm_min(),
                                1e-40F,
                                limits::max(),
                                limits::infinity()};
        for (const float whole : {1.0F, 2.0F}) {
            list.push_back(std::nextafter(whole, 0.0F));
            list.push_back(std::nextafter(whole, 3.0F));
        }
        for (int n = 1; n <= 8; ++n) {
            list.push_back(static_cast<float>(n * std::numbers::pi / 2));
        }
        const std::size_t positive = list.size();
        for (std::size_t i = 0; i < positive; ++i) list.push_back(-list[i]);
        list.push_back(limits::quiet_NaN());
        return list;
    }();
    return numbers;
}

std::vector<Arguments> awkward_arguments(int arity, Random& random) {
    const std::vector<float>& numbers = awkward_numbers();
    const std::size_t count = numbers.size();
    std::vector<Arguments> list;
    for (std::size_t i = 0; i < (arity == 1 ? count : count * count); ++i) {
        Arguments arguments{numbers[i % count], numbers[i / count], 0, 0};
        if (arity > 2) {
            for (float& argument : arguments) argument = numbers[random() % count];
        }
        list.push_back(arguments);
    }
    return list;
}

float random_number(const Range& range, Random& random) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const double most = std::max(std::abs(range.low), std::abs(range.high));
    const double sign = random() % 2 == 0 ? 1 : -1;
    double number = 0;
    switch (random() % 6) {
        case 0:
            number = between(range.low, range.high);
            break;
        case 1:
            number = sign * most * std::exp2(between(-120, 0));
            break;
        case 2:
            number = sign * most * std::exp2(between(-10, 0));
            break;
        case 3:
            number = between(-4, 4);
            break;
        case 4:
            number = std::round(between(-20, 20));
            break;
        default: {
            const double near = awkward_numbers()[random() % (awkward_numbers().size() - 1)];
            number = near + near * sign * std::exp2(between(-24, -2));
            break;
        }
    }
    float rounded = static_cast<float>(std::clamp(number, range.low, range.high));
    // Rounding must not lead out of the range, and denormal numbers count as 0 on some machines.
    if (rounded > range.high) rounded = std::nextafter(rounded, -INFINITY);
    if (rounded < range.low) rounded = std::nextafter(rounded, INFINITY);
    return std::fpclassify(rounded) == FP_SUBNORMAL ? 0.0F : rounded;
}

std::vector<Arguments> random_arguments(const Row& row, std::size_t count, Random& random) {
    std::vector<Arguments> list(count);
    for (Arguments& arguments : list) {
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            arguments[i] = random_number(row.ranges[i], random);
        }
    }
    return list;
}

}  // namespace contract
