// FCL: boxes in its dynamic tree with exact collision tests. It has no ray query.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/collision.h>

#include "implementation.h"

namespace bench {

namespace {

using Object = fcl::CollisionObject<float>;

fcl::Vector3<float> vector(gphys_vec3 v) { return {v.x, v.y, v.z}; }
fcl::Quaternion<float> rotation(gphys_quat q) { return {q.w, q.x, q.y, q.z}; }

/// Counts the objects that overlap the query exactly; false: go on.
bool count_overlap(Object* a, Object* b, void* count) {
    fcl::CollisionResult<float> result;
    *static_cast<uint64_t*>(count) += fcl::collide(a, b, fcl::CollisionRequest<float>(), result) > 0;
    return false;
}

class Fcl final : public Implementation {
public:
    bool load(const std::vector<gphys_obb>& boxes) override {
        tree_ = std::make_unique<fcl::DynamicAABBTreeCollisionManager<float>>();
        objects_.clear();
        std::vector<Object*> added;
        for (const gphys_obb& b : boxes) {
            objects_.push_back(std::make_unique<Object>(std::make_shared<fcl::Box<float>>(2 * vector(b.half_extents)),
                                                        fcl::Transform3<float>::Identity()));
            place(*objects_.back(), b);
            added.push_back(objects_.back().get());
        }
        tree_->registerObjects(added);
        tree_->setup();
        return true;
    }

    bool overlap(const std::vector<gphys_sphere>& spheres, uint64_t& total) override {
        total = 0;
        for (const gphys_sphere& s : spheres) {
            total += overlapping(std::make_shared<fcl::Sphere<float>>(s.radius), vector(s.center));
        }
        return true;
    }
    bool overlap(const std::vector<gphys_aabb>& boxes, uint64_t& total) override {
        total = 0;
        for (const gphys_aabb& b : boxes) {
            const fcl::Vector3<float> low = vector(b.min), high = vector(b.max);
            total += overlapping(std::make_shared<fcl::Box<float>>(high - low), (low + high) / 2);
        }
        return true;
    }

    bool move_all(const std::vector<gphys_obb>& boxes) override {
        for (size_t i = 0; i < boxes.size(); ++i) place(*objects_[i], boxes[i]);
        tree_->update();
        return true;
    }

private:
    static void place(Object& object, const gphys_obb& box) {
        object.setTransform(rotation(box.rotation), vector(box.center));
        object.computeAABB();
    }

    uint64_t overlapping(std::shared_ptr<fcl::CollisionGeometry<float>> shape, const fcl::Vector3<float>& center) {
        uint64_t count = 0;
        Object query(shape, fcl::Matrix3<float>::Identity(), center);
        tree_->collide(&query, &count, count_overlap);
        return count;
    }

    std::vector<std::unique_ptr<Object>> objects_;
    std::unique_ptr<fcl::DynamicAABBTreeCollisionManager<float>> tree_;
};

}  // namespace

std::unique_ptr<Implementation> make_fcl() { return std::make_unique<Fcl>(); }

}  // namespace bench
