// Whether half-spaces have a common point, by a certificate that is cheap to check. A linear program in double
// precision selects three planes that meet in such a point, or up to four half-spaces without a common point (Helly).
// CGAL's interval arithmetic, or else its exact numbers, then verifies this. If that fails, an exact linear program
// decides.
#pragma once

#include <optional>

#include "oracle.h"

namespace test {

/// The points p with dot(normal, p) >= distance.
template <class Scalar>
struct HalfSpace {
    VectorOf<Scalar> normal;
    Scalar distance;
};
template <class Scalar>
using HalfSpaces = boost::container::static_vector<HalfSpace<Scalar>, 12>;

/// A linear program by the algorithm of Seidel (1991), in doubles: the lowest point along a direction, within a large
/// box. Half-spaces are added one by one. If one excludes the optimum so far, the next optimum is on its plane.
class ProgramGuess {
public:
    /// The sides of the box are numbered by negative numbers.
    static constexpr double box = 64;
    static int box_side(int axis, bool high) { return -1 - (2 * axis + high); }

    explicit ProgramGuess(const HalfSpaces<double>& spaces) {
        Row rows[12];
        int count = 0;
        for (const HalfSpace<double>& space : spaces) {
            const double size = largest(space.normal), unit = size > 0 ? 1 / size : 1;
            rows[count] = {
                {space.normal.x * unit, space.normal.y * unit, space.normal.z * unit}, space.distance * unit, count};
            ++count;
        }
        const int axes[3] = {0, 1, 2};
        const double objective[3] = {1, .71, .43};
        double point[3];
        feasible_ = solve(rows, count, 3, axes, objective, point);
    }
    bool feasible() const { return feasible_; }
    /// The numbers of the planes that meet in the optimum, or of half-spaces without a common point.
    const boost::container::static_vector<int, 4>& deciding() const { return deciding_; }

private:
    static constexpr double slack = 1e-9, flat = 1e-12;

    /// dot(factor, p) >= right
    struct Row {
        double factor[3], right;
        int number;
    };

    bool excluded_by(int number) {
        deciding_ = {number};
        return false;
    }

    bool solve(const Row* rows, int count, int dimensions, const int* axes, const double* objective, double* point) {
        if (dimensions == 1) return solve_line(rows, count, axes[0], objective[0], point[0]);
        deciding_.clear();
        for (int k = 0; k < dimensions; ++k) {
            point[k] = objective[k] >= 0 ? -box : box;
            deciding_.push_back(box_side(axes[k], objective[k] < 0));
        }
        for (int i = 0; i < count; ++i) {
            const Row& row = rows[i];
            double height = -row.right;
            int out = 0;
            for (int k = 0; k < dimensions; ++k) {
                height += row.factor[k] * point[k];
                if (std::fabs(row.factor[k]) > std::fabs(row.factor[out])) out = k;
            }
            if (height >= -slack) continue;
            if (std::fabs(row.factor[out]) <= flat) return excluded_by(row.number);
            // The problem in its plane, with the axis of the largest factor eliminated.
            Row rest[12];
            int rest_axes[2];
            double rest_objective[2], rest_point[2];
            const auto put_in = [&](const double* from, double* to) {
                const double share = from[out] / row.factor[out];
                for (int k = 0, n = 0; k < dimensions; ++k) {
                    if (k != out) to[n++] = from[k] - share * row.factor[k];
                }
                return share;
            };
            for (int j = 0; j < i; ++j) {
                const double share = put_in(rows[j].factor, rest[j].factor);
                rest[j].right = rows[j].right - share * row.right;
                rest[j].number = rows[j].number;
            }
            put_in(objective, rest_objective);
            for (int k = 0, n = 0; k < dimensions; ++k) {
                if (k != out) rest_axes[n++] = axes[k];
            }
            const bool found = solve(rest, i, dimensions - 1, rest_axes, rest_objective, rest_point);
            deciding_.push_back(row.number);
            if (!found) return false;
            point[out] = row.right / row.factor[out];
            for (int k = 0, n = 0; k < dimensions; ++k) {
                if (k == out) continue;
                point[k] = rest_point[n++];
                point[out] -= row.factor[k] / row.factor[out] * point[k];
            }
        }
        return true;
    }
    bool solve_line(const Row* rows, int count, int axis, double objective, double& point) {
        double low = -box, high = box;
        int lower = box_side(axis, false), upper = box_side(axis, true);
        for (int i = 0; i < count; ++i) {
            const double factor = rows[i].factor[0], at = rows[i].right / factor;
            if (std::fabs(factor) <= flat) {
                if (rows[i].right > slack) return excluded_by(rows[i].number);
            } else if (factor > 0 && at > low) {
                low = at, lower = rows[i].number;
            } else if (factor < 0 && at < high) {
                high = at, upper = rows[i].number;
            }
        }
        deciding_ = {lower, upper};
        if (low > high + slack) return false;
        deciding_ = {objective >= 0 ? lower : upper};
        point = objective >= 0 ? low : high;
        return true;
    }

    bool feasible_;
    boost::container::static_vector<int, 4> deciding_;
};

/// Checks a certificate. Scalar is exact or an interval; no result if intervals leave it undecided.
template <class Scalar>
class ProgramProof {
public:
    ProgramProof(const HalfSpaces<Scalar>& spaces, const ProgramGuess& guess) : spaces_(spaces), zero_(0) {
        for (const int number : guess.deciding()) {
            by_.push_back(number >= 0 ? spaces[number] : box_side(number));
            in_box_ = in_box_ || number < 0;
        }
        if (guess.feasible() ? is_met() : !in_box_ && is_void()) feasible_ = guess.feasible();
    }
    std::optional<bool> feasible() const { return feasible_; }

private:
    using Vec = VectorOf<Scalar>;

    static HalfSpace<Scalar> box_side(int number) {
        const int axis = (-1 - number) / 2;
        const Scalar one((-1 - number) % 2 ? -1 : 1), zero(0);
        return {{axis == 0 ? one : zero, axis == 1 ? one : zero, axis == 2 ? one : zero}, Scalar(-ProgramGuess::box)};
    }
    static Scalar determinant(const Vec& a, const Vec& b, const Vec& c) { return dot(a, cross(b, c)); }

    /// Whether the common point of three planes (Cramer's rule) is in all half-spaces.
    bool is_met() const {
        const Vec &a = by_[0].normal, &b = by_[1].normal, &c = by_[2].normal;
        Scalar unit = determinant(a, b, c);
        Vec point = cross(b, c) * by_[0].distance + cross(c, a) * by_[1].distance + cross(a, b) * by_[2].distance;
        if (CGAL::certainly(unit < zero_)) unit = -unit, point = -point;
        if (!CGAL::certainly(unit > zero_)) return false;
        return std::all_of(spaces_.begin(), spaces_.end(), [&](const HalfSpace<Scalar>& space) {
            return CGAL::certainly(dot(space.normal, point) >= space.distance * unit);
        });
    }
    /// Whether a sum of the inequalities with weights >= 0 is 0 >= a positive number (Farkas' lemma).
    bool is_void() const {
        switch (by_.size()) {
            case 1:
                return excludes({Scalar(1)});
            case 2:
                for (int k = 0; k < 3; ++k) {
                    if (excludes({of(1, k), -of(0, k)})) return true;
                }
                return false;
            case 3:
                for (int k = 0; k < 3; ++k) {
                    const int u = (k + 1) % 3, v = (k + 2) % 3;
                    const auto turn = [&](int i, int j) { return of(i, u) * of(j, v) - of(i, v) * of(j, u); };
                    if (excludes({turn(1, 2), turn(2, 0), turn(0, 1)})) return true;
                }
                return false;
            default: {
                const auto volume = [&](int i, int j, int k) {
                    return determinant(by_[i].normal, by_[j].normal, by_[k].normal);
                };
                return excludes({volume(1, 2, 3), -volume(0, 2, 3), volume(0, 1, 3), -volume(0, 1, 2)});
            }
        }
    }
    const Scalar& of(int i, int axis) const {
        const Vec& n = by_[i].normal;
        return axis == 0 ? n.x : axis == 1 ? n.y : n.z;
    }
    /// Whether the weights prove it. The weighted normals must cancel; with four, they do so by the choice of the
    /// weights.
    bool excludes(std::initializer_list<Scalar> weights) const {
        bool all_up = true, all_down = true;
        Vec sum(zero_, zero_, zero_);
        Scalar distance = zero_;
        int i = 0;
        for (const Scalar& weight : weights) {
            all_up = all_up && CGAL::certainly(weight >= zero_);
            all_down = all_down && CGAL::certainly(weight <= zero_);
            sum = sum + by_[i].normal * weight;
            distance += by_[i].distance * weight;
            ++i;
        }
        const auto is_zero = [&](const Scalar& s) { return CGAL::certainly(s == zero_); };
        if (i < 4 && !(is_zero(sum.x) && is_zero(sum.y) && is_zero(sum.z))) return false;
        return all_up ? CGAL::certainly(distance > zero_) : all_down && CGAL::certainly(distance < zero_);
    }

    const HalfSpaces<Scalar>& spaces_;
    const Scalar zero_;
    boost::container::static_vector<HalfSpace<Scalar>, 4> by_;
    bool in_box_ = false;
    std::optional<bool> feasible_;
};

/// build(T()) returns the half-spaces in numbers of type T.
template <class Build>
std::optional<bool> is_feasible(const Build& build) {
    const ProgramGuess guess(build(0.0));
    {
        const Upward upward;
        if (const auto feasible = ProgramProof<Range>(build(Range()), guess).feasible()) return feasible;
    }
    return ProgramProof<Binary>(build(Binary()), guess).feasible();
}

}  // namespace test
