// SPDX-License-Identifier: MIT
#include "formula/number.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace formula {
namespace {

std::size_t digits(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    return end - at;
}

/// Whether a spelled number that does not fit is too large rather than too small: by the decimal
/// place of its first digit that is not 0.
bool is_large(std::string_view spelling) {
    const std::size_t exponent_at = std::min(spelling.find_first_of("eE"), spelling.size());
    const std::string_view mantissa = spelling.substr(0, exponent_at);
    const std::size_t first = mantissa.find_first_of("123456789");
    if (first == std::string_view::npos) return false;
    const long point = static_cast<long>(std::min(mantissa.find('.'), mantissa.size()));
    const long place = point - static_cast<long>(first);
    std::string_view exponent = spelling.substr(std::min(exponent_at + 1, spelling.size()));
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    long power = 0;
    const auto [end, problem] =
        std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
    if (problem == std::errc::result_out_of_range) return !exponent.starts_with('-');
    return power > -place;
}

}  // namespace

std::size_t number_length(std::string_view text) {
    const std::size_t whole = digits(text, 0);
    std::size_t end = whole;
    if (text.substr(whole).starts_with('.')) {
        const std::size_t fraction = digits(text, whole + 1);
        if (whole + fraction == 0) return 0;
        end = whole + 1 + fraction;
    }
    if (end == 0 || end >= text.size() || (text[end] != 'e' && text[end] != 'E')) return end;
    const bool sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-');
    const std::size_t power = end + (sign ? 2 : 1);
    const std::size_t count = digits(text, power);
    return count == 0 ? end : power + count;
}

std::optional<double> number_value(std::string_view spelling) {
    double value = 0;
    const auto [end, problem] =
        std::from_chars(spelling.data(), spelling.data() + spelling.size(), value);
    if (problem == std::errc::result_out_of_range) {
        if (is_large(spelling)) return std::nullopt;
        return 0.0;
    }
    return value;
}

}  // namespace formula
