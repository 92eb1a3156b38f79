// The contact search of cloth particles: finds the ball in which a particle may move, and the contact planes in it.
#pragma once

#include "scene/closest_features.h"
#include "solver/contact/collision.h"
#include "solver/quads.h"

namespace gphys {

/// Searches for the particles of a body, at the end of a substep or the beginning of the step. Particles that are
/// neighbours in memory and in space share one search.
class ContactSearch {
public:
    /// `time`: seconds until the next search.
    ContactSearch(const CollisionContext& around, Body& body, Vec3 gravity, double time)
        : around_(around),
          body_(body),
          particles_(body.particles),
          moving_colliders_(body.cloth.moving_colliders),
          link_length_(body.cloth.batches.link_length),
          state_(body.cloth.state),
          contacts_(body.cloth.contacts),
          search_balls_(body.cloth.cache.search_balls),
          gravity_(gravity),
          time_(time) {}

    /// Finds the balls and the contact planes of particles, and moves the particles out of models. Records the contacts
    /// that they had before.
    void run(const uint32_t* particles, uint32_t count);
    /// The same from the positions of the last search, without moving models; only for contact planes and balls.
    void repeat(const uint32_t* particles, uint32_t count);

private:
    static constexpr uint32_t most_points = ClosestFeatures::most_points;
    // Near more parts the radius is reduced: contact planes are infinite, and the plane of a distant part would exclude
    // free space.
    static constexpr uint32_t most_parts = 64;
    // Metres out of a model at once: what a particle may leave in a short substep. The same in all searches, so that
    // one that is repeated after a snapshot finds the same.
    static constexpr double most_push = leaving_speed * 0.002;

    void search_from_balls(const uint32_t* particles, uint32_t count);
    Vec3 place_of(uint32_t p) const { return get(&search_balls_[4 * size_t{p}]); }
    double clearance(uint32_t p, Vec3 at) const;
    double farthest(uint32_t p) const;
    float farthest_or_known(uint32_t p) const;
    Aabb places_of(const uint32_t* particles, uint32_t count, double& range) const;
    bool set_free(const uint32_t* particles, uint32_t count);
    uint32_t count_together(const uint32_t* particles, uint32_t count) const;
    bool search_together(const uint32_t* particles, uint32_t count);
    void search_alone(uint32_t p);
    bool find_colliders_near(const Aabb& places, double range);
    double wanted_reach(uint32_t p) const;
    double reach(uint32_t p);
    bool collect(const uint32_t* particles, uint32_t count);
    void place_balls(uint32_t p, uint32_t point);
    void set_contacts(uint32_t p, uint32_t point);
    double push_out(float* ball, ClothContact& found) const;
    void choose_planes(uint32_t p, Vec3 at, double& reach, ClothContact& found);

    const CollisionContext& around_;
    Body& body_;  // records contact points and impulses
    const Particles& particles_;
    const Vector<MovingCollider>& moving_colliders_;
    const double link_length_;
    ClothState& state_;
    ClothContacts& contacts_;
    Vector<float>& search_balls_;
    const Vec3 gravity_;
    const double time_;
    bool repeats_ = false;
    NearColliders near_;         // moving models near the particles; if not all fit, a particle gets no ball
    double reach_[most_points];  // metres beyond the particle's radius
    // By point; for moving models in the frame of the scene, at the end of the step:
    Sphere balls_[most_points], moving_balls_[NearColliders::most][most_points];
    ClosestFeatures parts_;
};

}  // namespace gphys
