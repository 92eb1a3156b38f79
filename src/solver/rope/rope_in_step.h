// A rope that is moved alone through the substeps of a step (rope_substep.cpp): from one system of equations to the
// next, so that those of several ropes can be solved side by side (ropes_beside_models.h).
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
    bool by_trapezoid = false;     // by the trapezoid rule; never in halves
    TimeScheme scheme{1, 0};
    bool beside = false;  // whether contacts are solved together with the links

    void begin(const CollisionContext& around, double h);
    bool solve();
    bool began_in_shape() const;
    void finish(const CollisionContext& around, double h);
    void roll_back();
};

class RopeInStep {
public:
    /// `h`: seconds of a substep. `contacts` as in RopeMotion, after RopeContacts::begin_step.
    RopeInStep(Body& body, RopeContacts* contacts, const CollisionContext& step, Vec3 gravity, uint32_t substeps,
               double h)
        : motion_{body, gravity, contacts}, step_(step), substeps_(substeps), h_(h) {}

    Body& body() const { return motion_.body; }
    uint32_t substeps() const { return substeps_; }
    /// Predicts the next part. Returns false at the end of the step.
    bool begin_part();
    /// Seconds of the part; and the effective time step of the equations (TimeScheme::step), and their contacts or
    /// null.
    double advance() const { return motion_.scheme.advance; }
    double effective_step() const { return motion_.scheme.step(body().settings.damping); }
    RopeContacts* contacts() const { return motion_.beside ? motion_.contacts : nullptr; }
    /// Solves the equations of the rope alone. Returns whether the lengths of all links have been found.
    bool solve() { return motion_.solve(); }
    /// Ends the part, after its equations have been solved.
    void end_part(bool found);

private:
    void begin_substep();
    double part_length() const { return h_ * parts_[part_]; }

    RopeMotion motion_;
    const CollisionContext step_;
    const uint32_t substeps_;
    const double h_;
    uint32_t made_ = 0;                      // substeps begun
    CollisionContext substep_{}, within_{};  // the substep under way, and its part
    const double* parts_ = nullptr;
    size_t part_count_ = 0, part_ = 0;
    double done_ = 0;  // fraction of the substep before the next part
};

}  // namespace gphys
