// A plane or a box, prepared for the sweeps of many particles.
//
// The scene places the shape anew for each question and answers all of it: faces, edges and corners, a
// start within. Most particles pass by or meet a face that they were in front of, which takes a division;
// what is not so simple stays open. A plane is a box of no thickness and infinite width.
#pragma once

#include "scene/scene.h"

namespace gphys {

/// A face that something is pressed on, across one of the axes of the world.
struct PressedFace {
    Vec3 normal;
    double place;  // along the normal
    double into;   // metres by which it is pressed in a substep

    /// Where a sphere that is pressed so touches it.
    Vec3 point(const Sphere& moving, Vec3 displacement) const {
        const double gap = dot(normal, moving.center) - place - moving.radius;
        return moving.center + displacement * (gap / into) - normal * moving.radius;
    }
};

class FlatModel {
public:
    /// False if the model is something else.
    bool prepare(const Scene& scene, gphys_model_id model);
    /// As gphys::sweep of the shape.
    TriState sweep(const Sphere& moving, Vec3 displacement, Hit& hit) const;
    /// Of a model that is not turned, the one on which a displacement presses most.
    PressedFace pressed_face(Vec3 displacement) const;
    /// Where a sphere that is pressed by so much in a substep lies on a face that is not turned, no further off than
    /// some gap and no nearer than half of it, while friction holds it: a box for its centre, empty if nowhere.
    Aabb rest(double radius, double gap, Vec3 displacement, double friction) const;
    /// Of a plane: a box around the part of it that is in the region.
    Aabb part_of_plane(const Aabb& region) const;

private:
    void place(const Plane& plane);
    void place(const Aabb& box);
    void place(const Obb& box);

    // Not initialised: there is room for many, and few are used.
    bool turned_;
    double low_[3], high_[3];  // corners, from the centre if it is turned
    double center_[3], axes_[3][3];
};

}  // namespace gphys
