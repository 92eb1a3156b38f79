// A plane or a box, prepared for sweeps of many particles.
//
// A query of the scene transforms the shape each time and handles all cases: faces, edges, corners, and overlap at the
// start. Most particles miss, or hit a face that they were in front of, which takes one division. Other cases remain
// undecided here. A plane is a box of zero thickness and infinite width.
#pragma once

#include "scene/scene.h"

namespace gphys {

/// The face of a contact, perpendicular to a world axis.
struct ContactFace {
    Vec3 normal;
    double place;  // along the normal
    double into;   // metres: the displacement of a substep against the normal

    /// The contact point of a sphere with this displacement.
    Vec3 point(const Sphere& moving, Vec3 displacement) const {
        const double gap = dot(normal, moving.center) - place - moving.radius;
        return moving.center + displacement * (gap / into) - normal * moving.radius;
    }
};

class FlatModel {
public:
    /// Returns false if the model is neither a plane nor a box.
    bool prepare(const Scene& scene, gphys_model_id model);
    /// As gphys::sweep of the shape.
    TriState sweep(const Sphere& moving, Vec3 displacement, Hit& hit) const;
    /// The face that a displacement is most opposed to; for a model without rotation.
    ContactFace contact_face(Vec3 displacement) const;
    /// The box of all centres at which a sphere is at rest on a face without rotation: its distance is between half of
    /// the gap and the gap, and friction cancels `displacement` in a substep. Empty if there are none.
    Aabb resting_region(double radius, double gap, Vec3 displacement, double friction) const;
    /// For a plane: a box around the part of it that is in the region.
    Aabb part_of_plane(const Aabb& region) const;

private:
    void place(const Plane& plane);
    void place(const Aabb& box);
    void place(const Obb& box);

    // Not initialised: there are many, and few are used.
    bool rotated_;
    double low_[3], high_[3];  // corners; relative to the centre if it is rotated
    double center_[3], axes_[3][3];
};

}  // namespace gphys
