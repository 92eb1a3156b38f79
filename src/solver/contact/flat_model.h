// A plane or a box, prepared for sweeps of many particles.
//
// A query of the scene transforms the shape each time and handles all cases: faces, edges, corners, and overlap at the
// start. Most particles miss, or hit a face that they were in front of, which takes one division. Other cases remain
// undecided here. A plane is a box of zero thickness and infinite width.
#pragma once

#include "scene/scene.h"

namespace gphys {

/// A face that a displacement presses on, perpendicular to a world axis.
struct PressedFace {
    Vec3 normal;
    double place;  // along the normal
    double into;   // metres by which the displacement of a substep penetrates it

    /// The contact point of a sphere with this displacement.
    Vec3 point(const Sphere& moving, Vec3 displacement) const {
        const double gap = dot(normal, moving.center) - place - moving.radius;
        return moving.center + displacement * (gap / into) - normal * moving.radius;
    }
};

class FlatModel {
public:
    /// Returns false if the model is another shape.
    bool prepare(const Scene& scene, gphys_model_id model);
    /// As gphys::sweep of the shape.
    TriState sweep(const Sphere& moving, Vec3 displacement, Hit& hit) const;
    /// The face that a displacement presses on most; for a model without rotation.
    PressedFace pressed_face(Vec3 displacement) const;
    /// The box of all centres at which a sphere rests on a face without rotation: between half of the gap and the gap
    /// away from it, while friction holds it against `displacement` in a substep. Empty if there are none.
    Aabb rest(double radius, double gap, Vec3 displacement, double friction) const;
    /// For a plane: a box around the part of it that is in the region.
    Aabb part_of_plane(const Aabb& region) const;

private:
    void place(const Plane& plane);
    void place(const Aabb& box);
    void place(const Obb& box);

    // Not initialised: there are many, and few are used.
    bool turned_;
    double low_[3], high_[3];  // corners; relative to the centre if it is rotated
    double center_[3], axes_[3][3];
};

}  // namespace gphys
