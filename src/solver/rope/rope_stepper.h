// One rope in the substeps of a step (rope_substep.cpp). It stops at each system of equations, so that the systems of
// several ropes can be solved side by side (rope_contact_lanes.h). A rope alone is moved by
//
//     while (rope.begin_part()) rope.end_part(rope.solve());
#pragma once

#include "solver/body.h"
#include "solver/contact/collision.h"
#include "solver/rope/rope_contacts.h"

namespace gphys {

/// One part of a substep, for move_in_halves.
struct RopeMotion {
    Body& body;
    const Vec3 gravity;
    RopeContacts* const contacts;  // of a rope near static models or with animation targets, else null
    bool by_trapezoid = false;     // else by the backward formula, as always in halves
    TimeScheme scheme{1, 0};
    bool with_contacts = false;  // whether contacts are part of the equations

    void begin(const CollisionContext& around, double h);
    bool solve();
    bool began_feasible() const;
    /// A rope that yields is halved less often, because its stretch is as large in a part of the substep.
    int unused_halvings() const { return body.rope.yields ? 5 : 0; }
    void finish(const CollisionContext& around, double h);
    void roll_back();
};

class RopeStepper {
public:
    /// `h`: seconds of a substep. `contacts` as in RopeMotion, after RopeContacts::begin_step.
    RopeStepper(Body& body, RopeContacts* contacts, const CollisionContext& step, Vec3 gravity, uint32_t substeps,
                double h)
        : motion_{body, gravity, contacts}, step_(step), substeps_(substeps), h_(h) {}

    Body& body() const { return motion_.body; }
    uint32_t substeps() const { return substeps_; }
    /// Predicts the next part. Returns false at the end of the step.
    bool begin_part();
    // Of the part under way: its seconds; the effective time step of its equations (TimeScheme::step); the contacts in
    // these, or null.
    double advance() const { return motion_.scheme.advance; }
    double effective_step() const { return motion_.scheme.step(body().settings.damping); }
    RopeContacts* contacts() const { return motion_.with_contacts ? motion_.contacts : nullptr; }
    /// Solves the equations of the part. Returns whether Newton's method has converged.
    bool solve() { return motion_.solve(); }
    /// Ends the part, after its equations have been solved.
    void end_part(bool solved);

private:
    void begin_substep();
    double part_length() const { return h_ * parts_[part_]; }

    RopeMotion motion_;
    const CollisionContext step_;
    const uint32_t substeps_;
    const double h_;
    uint32_t begun_ = 0;                           // substeps
    CollisionContext substep_{}, part_context_{};  // of the substep under way, and of its part
    const double* parts_ = nullptr;
    size_t part_count_ = 0, part_ = 0;
    double fraction_done_ = 0;  // of the substep
};

}  // namespace gphys
