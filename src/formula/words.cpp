// SPDX-License-Identifier: MIT
#include "formula/words.h"

#include "formula/suggest.h"

namespace formula {

bool is_name(Within within, std::string_view word, bool called) {
    if (word.empty()) return false;
    switch (within) {
        case Within::statement:
            return true;
        case Within::parameter:
            return word != "in" && (word != "step" || called);
        case Within::iteration:
            return word != "for" && word != "until";
    }
    return true;
}

std::span<const std::string_view> modifiers() {
    static constexpr std::string_view words[] = {"angle",   "colour",      "group", "in",
                                                 "integer", "logarithmic", "step",  "tooltip"};
    return words;
}

bool resembles_modifier(Within within, std::string_view word) {
    return within == Within::parameter && !nearest(word, modifiers()).empty();
}

}  // namespace formula
