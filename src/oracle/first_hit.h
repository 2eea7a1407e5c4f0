// SPDX-License-Identifier: MIT
// The first point of a shape along a ray, proven.
#pragma once

#include <optional>
#include <vector>

#include "oracle/along_ray.h"
#include "oracle/heuristic_distance.h"
#include "oracle/reference.h"

namespace oracle {

/// What was found of a shape: nothing before `near`.
struct Found {
    enum class Of { solid, sheet };
    Verdict verdict = Verdict::miss;
    double near = numeric::infinity;
    double far = numeric::infinity;
    Of of = Of::solid;
    std::size_t number = 0;  ///< of the part or of the sheet
    bool at_start = false;   ///< the stretch begins in a solid

    double middle() const { return far > near ? near + 0.5 * (far - near) : near; }
};

/// The nearer of two findings; where both may be the first, what encloses either.
Found nearer(const Found& a, const Found& b);

/// Where the surfaces of a shape may be first along the rays of a beam: of each of its solids and
/// sheets ascending stretches.
using Places = std::vector<std::vector<Stretch>>;

/// Finds first hits by bisection with interval arithmetic. Not for several threads.
class FirstHit {
public:
    explicit FirstHit(const Shape& shape);

    /// All of a stretch.
    Places anywhere(const Stretch& stretch) const;
    /// What of the places is left for the rays of a narrower beam: what is proven empty for all of
    /// them is taken out, and what is behind a surface that all of them meet. At `within` all of
    /// them are within the bounds, or have left them.
    Places narrowed(const Beam& beam, const Places& places, double within);
    /// Whether there are parts with loops among those that something is proven of.
    bool proves_loops() const;
    enum class Of { all, formulas };
    /// Of all parts that are not estimated, or of those of them without loops, within the stretch,
    /// for a ray of the beam that the places are of. A hit is enclosed to 1e-9 of its distance.
    /// Undecided is where f comes so close to 0 that its sign cannot be told, and where the effort
    /// is spent. What an estimated solid cuts off of a sheet is guessed.
    Found operator()(const Ray& ray, const Stretch& stretch, const Places& places, Of of = Of::all);

private:
    /// A part of the shape: the zeros of the function, or where it is not above 0.
    struct Target {
        Found::Of of = Found::Of::solid;
        std::size_t number = 0;
        Function function;
        const Sheet* sheet = nullptr;

        bool is_sheet() const { return of == Found::Of::sheet; }
    };
    /// What is known of a piece.
    enum class Fate { empty, hit, unknown };

    Piece piece_of(const Target& target, const Stretch& stretch);
    bool is_empty(const Target& target, const Piece& piece, const numeric::Interval& values);
    std::vector<Stretch> narrowed(const Target& target, const std::vector<Stretch>& stretches,
                                  double within, double& end);
    bool all_meet(const Target& target, const Piece& piece);
    bool has_loops(const Target& target) const;
    Found search(const Target& target, const Stretch& stretch,
                 const std::vector<Stretch>& stretches);
    Found search_loops(const Target& target, const Stretch& stretch,
                       const std::vector<Stretch>& stretches);
    Found bisect(const Target& target, const Stretch& stretch, int& effort);
    double march(const Target& target, double& t, double end, int& effort);
    Found found_on(const Target& target, const Piece& piece, const Stretch& stretch);
    Fate judge(const Target& target, Piece& piece);
    Fate judge_solid(const Target& target, Piece& piece, const RayJet& jet);
    Fate judge_sheet(const Target& target, Piece& piece, const RayJet& jet);
    bool isolate_root(const Function& function, Piece& piece);
    void split(const Function& function, const Piece& piece);
    bool is_clipped_away(const Target& target, const Piece& piece);
    /// Heuristic: by a point of a small piece of a ray.
    bool is_guessed_inside(std::size_t solid, const Piece& piece);
    bool is_drawn_throughout(const Target& target, const Piece& piece);
    std::optional<Piece> hit_around(const Target& target, const Piece& piece,
                                    const Stretch& stretch);
    double end_of_unsettled(const Function& function, const Piece& piece, double end);
    double coarse(double t) const;
    double fine(double t) const;
    void take_rounding(const glm::dvec3& origin, double t);

    const Shape& shape_;
    AlongRay along_;
    HeuristicDistance distance_;
    std::vector<Target> targets_;
    std::vector<Piece> open_;  ///< to be looked at, the nearest last
    double rounding_ = 0;      ///< of the coordinates of the ray's points
};

}  // namespace oracle
