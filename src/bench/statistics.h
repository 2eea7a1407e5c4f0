// SPDX-License-Identifier: MIT
// Numbers that stand for many measurements.
#pragma once

#include <cstdint>
#include <span>

namespace bench {

/// The value below which a part (0 to 1) of the values lies, linear between neighbours in order
/// (definition 7 of Hyndman and Fan 1996); NaN of nothing.
double quantile(std::span<const double> values, double part);

struct Quartiles {
    double lower = 0;
    double median = 0;
    double upper = 0;
};
Quartiles quartiles(std::span<const double> values);

/// Of values above 0; NaN of nothing.
double geometric_mean(std::span<const double> values);

/// Quartiles of a[i] / b[i]: how much longer the one took than the other in the same rounds, so
/// that a slow moment, which slows both down, leaves them alone. Of equal lengths.
Quartiles paired_ratio(std::span<const double> a, std::span<const double> b);

struct Interval {
    double low = 0;
    double high = 0;
};

/// Where the ratio median(b) / median(a) lies, for samples of two runs that have nothing in common:
/// the percentile bootstrap (Efron 1979) over 2000 resamplings, cut to the given confidence.
/// Deterministic for a seed. Heuristic: with few samples it is too narrow.
Interval ratio_of_medians(std::span<const double> a, std::span<const double> b, double confidence,
                          std::uint32_t seed);

}  // namespace bench
