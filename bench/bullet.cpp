// Bullet: collision world with a dynamic box tree, mesh shape with its own tree.
#include <btBulletCollisionCommon.h>

#include <limits>

#include "implementation.h"

namespace bench {

namespace {

btVector3 vector(gphys_vec3 v) { return {v.x, v.y, v.z}; }
btTransform placement(gphys_vec3 position, gphys_quat q) {
    return btTransform(btQuaternion(q.x, q.y, q.z, q.w), vector(position));
}

/// Closest hit that also keeps which triangle of a mesh it was.
struct Closest final : btCollisionWorld::ClosestRayResultCallback {
    using ClosestRayResultCallback::ClosestRayResultCallback;
    int triangle = -1;
    btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool in_world) override {
        triangle = result.m_localShapeInfo ? result.m_localShapeInfo->m_triangleIndex : -1;
        return ClosestRayResultCallback::addSingleResult(result, in_world);
    }
};

struct Count final : btCollisionWorld::ContactResultCallback {
    uint64_t objects = 0;
    const btCollisionObject* last = nullptr;
    const btCollisionObject* query = nullptr;
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* a, int, int,
                             const btCollisionObjectWrapper* b, int, int) override {
        const btCollisionObject* other =
            a->getCollisionObject() == query ? b->getCollisionObject() : a->getCollisionObject();
        if (point.getDistance() <= 0 && other != last) {
            ++objects;
            last = other;
        }
        return 0;
    }
};

class Bullet final : public Implementation {
public:
    // Queries need no pairs of overlapping objects: so none are looked for.
    Bullet() { broadphase_.m_deferedcollide = true; }
    ~Bullet() override { clear(); }
    bool is_slow() const override { return true; }

    bool load(const std::vector<gphys_obb>& boxes) override {
        clear();
        for (const gphys_obb& b : boxes) {
            add(box_of(b.half_extents), placement(b.center, b.rotation));
        }
        return true;
    }

    bool load(const std::vector<gphys_sphere>& spheres) override {
        clear();
        for (const gphys_sphere& s : spheres) {
            add(std::make_unique<btSphereShape>(s.radius), placement(s.center, {0, 0, 0, 1}));
        }
        return true;
    }

    /// Without the margin around it, which is another shape, and with its tables of faces, which clip rays. A shape has
    /// one scale, so there is one for each object.
    bool load_hull(const Triangles& mesh, const std::vector<gphys_transform>& placements) override {
        clear();
        for (const gphys_transform& t : placements) {
            auto hull = std::make_unique<btConvexHullShape>(&mesh.vertices[0].x, static_cast<int>(mesh.vertices.size()),
                                                            static_cast<int>(sizeof mesh.vertices[0]));
            hull->setLocalScaling(btVector3(t.scale, t.scale, t.scale));
            hull->setMargin(0);
            hull->initializePolyhedralFeatures();
            add(std::move(hull), placement(t.position, t.rotation));
        }
        return true;
    }

    bool load(const Triangles& mesh) override {
        clear();
        arrays_ = arrays_of(mesh);
        add(std::make_unique<btBvhTriangleMeshShape>(arrays_.get(), true), btTransform::getIdentity());
        return true;
    }

    /// One tree for all, which is what its scaled mesh shape is for.
    bool load(const Triangles& mesh, const std::vector<Stretched>& stretched) override {
        clear();
        shared_arrays_ = arrays_of(mesh);
        shared_ = std::make_unique<btBvhTriangleMeshShape>(shared_arrays_.get(), true);
        for (const Stretched& s : stretched) {
            add(std::make_unique<btScaledBvhTriangleMeshShape>(shared_.get(), vector(s.scale) * s.place.scale),
                placement(s.place.position, s.place.rotation));
        }
        return true;
    }

    bool closest(const std::vector<gphys_ray>& rays) override {
        answers_.resize(rays.size());
        for (size_t i = 0; i < rays.size(); ++i) {
            const btVector3 from = vector(rays[i].origin), to = from + vector(rays[i].direction) * rays[i].t_max;
            Closest hit(from, to);
            world_->rayTest(from, to, hit);
            answers_[i] = hit.hasHit() ? Answer{hit.m_closestHitFraction * rays[i].t_max,
                                                arrays_ ? static_cast<uint32_t>(hit.triangle)
                                                        : static_cast<uint32_t>(hit.m_collisionObject->getUserIndex())}
                                       : Answer{std::numeric_limits<float>::infinity(), no_object};
        }
        return true;
    }

    bool segments(const std::vector<gphys_segment>& segments) override {
        answers_.resize(segments.size());
        for (size_t i = 0; i < segments.size(); ++i) {
            const btVector3 from = vector(segments[i].a), to = vector(segments[i].b);
            Closest hit(from, to);
            world_->rayTest(from, to, hit);
            answers_[i] = hit.hasHit() ? Answer{hit.m_closestHitFraction,
                                                static_cast<uint32_t>(hit.m_collisionObject->getUserIndex())}
                                       : Answer{std::numeric_limits<float>::infinity(), no_object};
        }
        return true;
    }

    bool sweeps(const std::vector<Sweep>& sweeps) override {
        answers_.resize(sweeps.size());
        for (size_t i = 0; i < sweeps.size(); ++i) {
            const btSphereShape shape(sweeps[i].sphere.radius);
            answers_[i] = sweep(shape, placement(sweeps[i].sphere.center, {0, 0, 0, 1}), sweeps[i].displacement);
        }
        return true;
    }
    bool sweeps(const std::vector<CapsuleSweep>& sweeps) override {
        answers_.resize(sweeps.size());
        for (size_t i = 0; i < sweeps.size(); ++i) {
            const gphys_capsule& capsule = sweeps[i].solid;
            const btVector3 a = vector(capsule.a), b = vector(capsule.b);
            const btCapsuleShape shape(capsule.radius, (b - a).length());
            const btTransform from(shortestArcQuat(btVector3(0, 1, 0), (b - a).normalized()), (a + b) / 2);
            answers_[i] = sweep(shape, from, sweeps[i].displacement);
        }
        return true;
    }
    bool sweeps(const std::vector<BoxSweep>& sweeps) override {
        answers_.resize(sweeps.size());
        for (size_t i = 0; i < sweeps.size(); ++i) {
            const gphys_obb& box = sweeps[i].solid;
            answers_[i] = sweep(*box_of(box.half_extents), placement(box.center, box.rotation), sweeps[i].displacement);
        }
        return true;
    }

    bool overlap(const std::vector<gphys_sphere>& queries, uint64_t& total) override {
        if (arrays_) return false;
        total = 0;
        for (const gphys_sphere& q : queries) {
            btSphereShape shape(q.radius);
            btCollisionObject object;
            object.setCollisionShape(&shape);
            object.setWorldTransform(placement(q.center, {0, 0, 0, 1}));
            Count count;
            count.query = &object;
            world_->contactTest(&object, count);
            total += count.objects;
        }
        return true;
    }

    bool move_all(const std::vector<gphys_obb>& boxes) override {
        for (size_t i = 0; i < boxes.size(); ++i) {
            objects_[i]->setWorldTransform(placement(boxes[i].center, boxes[i].rotation));
        }
        world_->updateAabbs();
        return true;
    }

private:
    /// Without a margin: Bullet rounds the edges and corners of a box by it.
    static std::unique_ptr<btBoxShape> box_of(gphys_vec3 half_extents) {
        auto box = std::make_unique<btBoxShape>(vector(half_extents));
        box->setMargin(0);
        return box;
    }

    Answer sweep(const btConvexShape& shape, const btTransform& from, gphys_vec3 way) const {
        btTransform to = from;
        to.setOrigin(from.getOrigin() + vector(way));
        btCollisionWorld::ClosestConvexResultCallback hit(from.getOrigin(), to.getOrigin());
        world_->convexSweepTest(&shape, from, to, hit);
        if (!hit.hasHit()) return {std::numeric_limits<float>::infinity(), no_object};
        return {hit.m_closestHitFraction, static_cast<uint32_t>(hit.m_hitCollisionObject->getUserIndex())};
    }

    std::unique_ptr<btTriangleIndexVertexArray> arrays_of(const Triangles& mesh) {
        mesh_ = mesh;
        return std::make_unique<btTriangleIndexVertexArray>(
            static_cast<int>(mesh_.count()), reinterpret_cast<int*>(mesh_.indices.data()), 12,
            static_cast<int>(mesh_.vertices.size()), &mesh_.vertices[0].x, static_cast<int>(sizeof(gphys_vec3)));
    }

    void clear() {
        for (auto& object : objects_) world_->removeCollisionObject(object.get());
        objects_.clear();
        shapes_.clear();
        shared_.reset();
        shared_arrays_.reset();
        arrays_.reset();
        world_ = std::make_unique<btCollisionWorld>(&dispatcher_, &broadphase_, &configuration_);
    }

    void add(std::unique_ptr<btCollisionShape> shape, const btTransform& where) {
        auto object = std::make_unique<btCollisionObject>();
        object->setCollisionShape(shape.get());
        object->setWorldTransform(where);
        object->setUserIndex(static_cast<int>(objects_.size()));
        world_->addCollisionObject(object.get());
        shapes_.push_back(std::move(shape));
        objects_.push_back(std::move(object));
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btNullPairCache no_pairs_;
    btDbvtBroadphase broadphase_{&no_pairs_};
    std::unique_ptr<btCollisionWorld> world_ =
        std::make_unique<btCollisionWorld>(&dispatcher_, &broadphase_, &configuration_);
    Triangles mesh_;
    std::unique_ptr<btTriangleIndexVertexArray> arrays_;         // of a mesh that is the whole content
    std::unique_ptr<btTriangleIndexVertexArray> shared_arrays_;  // of one that all objects share
    std::unique_ptr<btBvhTriangleMeshShape> shared_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btCollisionObject>> objects_;
};

}  // namespace

std::unique_ptr<Implementation> make_bullet() { return std::make_unique<Bullet>(); }

}  // namespace bench
