// SPDX-License-Identifier: MIT
// The turns of q -> q^2 + c with as many derivatives as a kind of numbers has. Internal to the
// library.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "numeric/jet.h"
#include "oracle/quaternion_ball.h"

namespace oracle {

template <class T>
struct NumberTraits {
    static constexpr int slopes = 0, bends = 0;
    using Number = T;
};
template <class T, int n, int order>
struct NumberTraits<numeric::Jet<T, n, order>> {
    static constexpr int slopes = n, bends = order == 2 ? n * (n + 1) / 2 : 0;
    using Number = T;
};

/// A quaternion whose components are of type T: double, intervals, or jets of either. Enclosed are
/// all values and derivatives that the components enclose; of doubles the middles are meant.
template <class T>
class QuaternionJet {
public:
    /// Real part first; those that are left out are 0.
    explicit QuaternionJet(std::span<const T> components) {
        for (const T& each : components) regular_ = regular_ && is_regular_number(each);
        for (int part = 0; part < parts; ++part) {
            std::array<numeric::Interval, 4> box;
            for (std::size_t i = 0; i < components.size(); ++i) {
                box[i] = part_of(components[i], part);
            }
            if (part == 0) {
                value_ = ball_around<long double>(box);
            } else {
                derivatives_[at(part - 1)] = ball_around<double>(box);
            }
        }
    }

    /// Heuristic: later turns will tell no more.
    bool is_hopeless() const { return !(value_.radius < 8) && !(value_.radius < value_.length); }

    /// The next turn; `constant` may depend on the same variables.
    void turn(const QuaternionJet& constant) {
        std::array<QuaternionBall<double>, derivatives> next;
        for (int i = 0; i < Traits::slopes; ++i) next[at(i)] = products(value_, slope(i));
        if constexpr (Traits::bends > 0) {
            numeric::for_each_pair<Traits::slopes>([&](int i, int j, int place) {
                next[at(Traits::slopes + place)] =
                    sum(products(value_, bend(place)), products(slope(i), slope(j)));
            });
        }
        for (std::size_t i = 0; i < next.size(); ++i) {
            derivatives_[i] = sum(next[i], constant.derivatives_[i]);
        }
        value_ = sum(square(value_), constant.value_);
        regular_ = regular_ && constant.regular_;
    }

    /// |q|^2.
    T norm() const {
        T result(number(oracle::norm(value_)));
        if constexpr (numeric::AnyJet<T>) {
            result.smooth = regular_;
            for (int i = 0; i < Traits::slopes; ++i) {
                result.set_slope(i, twice(inner_product(value_, slope(i))));
            }
            if constexpr (Traits::bends > 0) {
                numeric::for_each_pair<Traits::slopes>([&](int i, int j, int place) {
                    result.set_bend(place, twice(inner_product(slope(i), slope(j)) +
                                                 inner_product(value_, bend(place))));
                });
            }
        }
        return result;
    }

private:
    using Traits = NumberTraits<T>;
    using Number = typename Traits::Number;
    static constexpr int parts = 1 + Traits::slopes + Traits::bends;
    static constexpr std::size_t derivatives = parts - 1;

    static constexpr std::size_t at(int part) { return static_cast<std::size_t>(part); }
    const QuaternionBall<double>& slope(int i) const { return derivatives_[at(i)]; }
    const QuaternionBall<double>& bend(int place) const {
        return derivatives_[at(Traits::slopes + place)];
    }

    static bool is_regular_number(const T& component) {
        if constexpr (numeric::AnyJet<T>) {
            return component.smooth && numeric::is_regular(component.value);
        } else {
            return numeric::is_regular(component);
        }
    }
    static numeric::Interval part_of(const T& component, int part) {
        if constexpr (numeric::AnyJet<T>) {
            if (part == 0) return component.value;
            const int place = part - 1 - Traits::slopes;
            if (place < 0) {
                return component.has_slope(part - 1) ? component.slope(part - 1) : Number(0.0);
            }
            if constexpr (Traits::bends > 0) {
                return component.has_bend(place) ? component.bend(place) : Number(0.0);
            }
            return 0.0;
        } else {
            return component;
        }
    }
    Number twice(const numeric::Interval& enclosure) const { return number(enclosure + enclosure); }
    Number number(numeric::Interval enclosure) const {
        if constexpr (std::is_same_v<Number, double>) {
            return enclosure.lo + 0.5 * (enclosure.hi - enclosure.lo);
        } else {
            enclosure.jumps = !regular_;
            return enclosure;
        }
    }

    /// In more digits than the derivatives: over many turns its rounding grows as they do.
    QuaternionBall<long double> value_;
    std::array<QuaternionBall<double>, derivatives> derivatives_;
    bool regular_ = true;  ///< proven to be smooth
};

}  // namespace oracle
