// The parts of a substep, for bodies that move alone and in islands.
#pragma once

#include "solver/contact/collision.h"
#include "solver/time_scheme.h"

namespace gphys {

class FlightPlanes;
class Team;

/// step.cpp: one substep of a single body.
void move(Body& body, const CollisionContext& around, Vec3 gravity, double h);
/// The same in two parts, between which other bodies may push its particles. The first part moves bodies without
/// constraints, and only predicts all others. `planes` and `team`: as in fly (particles/free_flight.h).
void begin_move(Body& body, const CollisionContext& around, Vec3 gravity, double h, FlightPlanes* planes, Team* team);
void end_move(Body& body, const CollisionContext& around, Vec3 gravity, double h);

/// Moves the attached particles from first to end with their models, to the end of the substep, in h seconds; and
/// particles that animation targets carry with these.
void follow_models(Body& body, const CollisionContext& around, double h, uint32_t first, uint32_t end);

/// Substep i of a step, or of the rest of one.
inline CollisionContext part_of_step(const CollisionContext& step, uint32_t i, uint32_t substeps) {
    CollisionContext part = step;
    const double length = step.end - step.begin;
    part.begin = step.begin + length * (static_cast<double>(i) / substeps);
    part.end = i + 1 < substeps ? step.begin + length * (static_cast<double>(i + 1) / substeps) : step.end;
    return part;
}

/// A substep in parts: move(part of the context, part of h).
template <size_t count, class Move>
void move_in_parts(const double (&parts)[count], const CollisionContext& around, double h, Move&& move) {
    double done = 0;
    for (const double part : parts) {
        CollisionContext within = around;
        within.begin = around.begin + (around.end - around.begin) * done;
        done += part;
        within.end = around.begin + (around.end - around.begin) * done;
        move(within, h * part);
    }
}

template <class Motion>
bool move_in_halves(Motion& motion, const CollisionContext& around, double h, int halvings = 7);

/// The rest of move_in_halves, after the first solution.
template <class Motion>
bool end_in_halves(Motion& motion, const CollisionContext& around, double h, bool solved, int halvings = 7) {
    // Where links turn by a radian, the method may cycle for a while before it converges.
    constexpr int most_solutions = 8;
    constexpr double halves[] = {0.5, 0.5};
    const bool is_solvable = solved || motion.began_feasible();
    for (int i = 1; is_solvable && !solved && i < most_solutions; ++i) solved = motion.solve();
    if (solved || !is_solvable || halvings <= motion.unused_halvings()) {
        motion.finish(around, h);
        return solved;
    }
    motion.roll_back();
    solved = true;
    move_in_parts(halves, around, h, [&](const CollisionContext& within, double part) {
        solved = move_in_halves(motion, within, part, solved ? halvings - 1 : 0) && solved;
    });
    return solved;
}

/// If Newton's method does not converge, the substep is too long for it. Then it is divided into halves, recursively:
/// half a second becomes parts of 4 ms, in which a link of 1 mm that swings under gravity turns by 0.4 radians. In the
/// shortest parts the last iterate is accepted. `motion` has begin(around, h), solve(), began_feasible() and
/// unused_halvings(), and then either finish(around, h) or roll_back(). Returns whether all parts were solved.
template <class Motion>
bool move_in_halves(Motion& motion, const CollisionContext& around, double h, int halvings) {
    motion.begin(around, h);
    return end_in_halves(motion, around, h, motion.solve(), halvings);
}

/// The first substep after an interruption. Not after a contact: contacts interrupt all the time, and the motion has no
/// second derivative there.
template <class Move>
void start_slowly(const CollisionContext& around, double h, Move&& move) {
    move_in_parts(starting_parts, around, h, move);
}

}  // namespace gphys
