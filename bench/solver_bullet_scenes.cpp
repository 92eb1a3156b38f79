// Bullet's soft bodies among its collision objects, and its rigid spheres. Not the sheet over a mesh: a soft body makes
// a field of distances for each triangle that it comes near, which takes seconds a frame.
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <btBulletDynamicsCommon.h>

#include "solver.h"

namespace bench {

namespace {

gphys_vec3 as_given(const btVector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

class BulletScene final : public Method {
public:
    BulletScene() {
        world_.setGravity({0, -static_cast<btScalar>(gravity), 0});
        world_.getWorldInfo().m_gravity = world_.getGravity();
        world_.getWorldInfo().m_sparsesdf.Initialize();
    }
    ~BulletScene() override {
        for (const auto& body : bodies_) world_.removeSoftBody(body.get());
        for (const auto& object : objects_) world_.removeCollisionObject(object.get());
    }
    void step(float seconds) override { world_.stepSimulation(seconds, 0); }
    std::vector<gphys_vec3> positions() const override { return read(&btSoftBody::Node::m_x); }
    std::vector<gphys_vec3> velocities() const override { return read(&btSoftBody::Node::m_v); }

    void add(std::unique_ptr<btCollisionShape> shape, const btVector3& at) {
        auto object = std::make_unique<btCollisionObject>();
        object->setCollisionShape(shape.get());
        object->setWorldTransform(btTransform(btQuaternion::getIdentity(), at));
        world_.addCollisionObject(object.get());
        shapes_.push_back(std::move(shape));
        objects_.push_back(std::move(object));
    }
    /// Of the particles from `first` on, without links.
    btSoftBody& add(const gphys_vec3* first, uint32_t count) {
        std::vector<btVector3> nodes;
        for (uint32_t i = 0; i < count; ++i) nodes.emplace_back(first[i].x, first[i].y, first[i].z);
        const std::vector<btScalar> masses(count, btScalar(1) / static_cast<btScalar>(count));
        bodies_.push_back(
            std::make_unique<btSoftBody>(&world_.getWorldInfo(), static_cast<int>(count), nodes.data(), masses.data()));
        btSoftBody& body = *bodies_.back();
        body.m_cfg.kDF = btScalar(0.5);
        world_.addSoftBody(&body);
        return body;
    }

private:
    std::vector<gphys_vec3> read(btVector3 btSoftBody::Node::*member) const {
        std::vector<gphys_vec3> out;
        for (const auto& body : bodies_) {
            for (int i = 0; i < body->m_nodes.size(); ++i) out.push_back(as_given(body->m_nodes[i].*member));
        }
        return out;
    }

    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btSoftRigidDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btCollisionObject>> objects_;
    std::vector<std::unique_ptr<btSoftBody>> bodies_;
};

class BulletBalls final : public Method {
public:
    BulletBalls(const Pit& pit, uint32_t iterations, uint32_t substeps) : sphere_(pit.radius), substeps_(substeps) {
        world_.setGravity({0, -static_cast<btScalar>(gravity), 0});
        world_.getSolverInfo().m_numIterations = static_cast<int>(iterations);
        const btScalar wide = pit.half_width;
        for (const btVector3& normal :
             {btVector3(1, 0, 0), btVector3(-1, 0, 0), btVector3(0, 0, 1), btVector3(0, 0, -1)}) {
            add_plane(normal, -wide);
        }
        add_plane({0, 1, 0}, 0);
        btVector3 inertia;
        sphere_.calculateLocalInertia(1, inertia);
        for (const gphys_vec3& p : pit.balls) {
            btRigidBody::btRigidBodyConstructionInfo info(1, nullptr, &sphere_, inertia);
            info.m_startWorldTransform.setOrigin({p.x, p.y, p.z});
            info.m_friction = 0;
            balls_.push_back(std::make_unique<btRigidBody>(info));
            world_.addRigidBody(balls_.back().get());
        }
    }
    ~BulletBalls() override {
        for (const auto& ball : balls_) world_.removeRigidBody(ball.get());
        for (const auto& wall : walls_) world_.removeCollisionObject(wall.get());
    }
    void step(float seconds) override {
        for (uint32_t i = 0; i < substeps_; ++i) {
            world_.stepSimulation(seconds / static_cast<btScalar>(substeps_), 0);
        }
    }
    std::vector<gphys_vec3> positions() const override {
        return read([](const btRigidBody& ball) { return ball.getWorldTransform().getOrigin(); });
    }
    std::vector<gphys_vec3> velocities() const override {
        return read([](const btRigidBody& ball) { return ball.getLinearVelocity(); });
    }

private:
    void add_plane(const btVector3& normal, btScalar offset) {
        planes_.push_back(std::make_unique<btStaticPlaneShape>(normal, offset));
        walls_.push_back(std::make_unique<btCollisionObject>());
        walls_.back()->setCollisionShape(planes_.back().get());
        walls_.back()->setFriction(0);
        world_.addCollisionObject(walls_.back().get());
    }
    template <class Get>
    std::vector<gphys_vec3> read(Get&& get) const {
        std::vector<gphys_vec3> out;
        for (const auto& ball : balls_) out.push_back(as_given(get(*ball)));
        return out;
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    btSphereShape sphere_;
    uint32_t substeps_;
    std::vector<std::unique_ptr<btStaticPlaneShape>> planes_;
    std::vector<std::unique_ptr<btCollisionObject>> walls_;
    std::vector<std::unique_ptr<btRigidBody>> balls_;
};

}  // namespace

std::unique_ptr<Method> make_bullet_pit(const Pit& pit, uint32_t iterations) {
    return std::make_unique<BulletBalls>(pit, iterations, 1);
}

std::unique_ptr<Method> make_bullet_pit_substeps(const Pit& pit, uint32_t substeps) {
    return std::make_unique<BulletBalls>(pit, 10, substeps);
}

std::unique_ptr<Method> make_bullet_post(const System& rope, uint32_t iterations) {
    auto scene = std::make_unique<BulletScene>();
    scene->add(std::make_unique<btCapsuleShapeZ>(post_radius, 4), {0, 0, 0});
    btSoftBody& body = scene->add(rope.positions.data(), rope.body_size);
    body.getCollisionShape()->setMargin(post_rope_radius);
    for (uint32_t i = 0; i < rope.body_size; ++i) body.setMass(static_cast<int>(i), rope.masses[i]);
    body.m_materials[0]->m_kLST = 1;
    for (const Link& link : rope.links) body.appendLink(static_cast<int>(link.a), static_cast<int>(link.b));
    body.m_cfg.piterations = static_cast<int>(iterations);
    body.m_cfg.kDF = 0;
    return scene;
}

std::unique_ptr<Method> make_bullet_rain(const Rain& rain) {
    auto scene = std::make_unique<BulletScene>();
    for (const gphys_aabb& box : rain.boxes) {
        const btVector3 low(box.min.x, box.min.y, box.min.z), high(box.max.x, box.max.y, box.max.z);
        scene->add(std::make_unique<btBoxShape>((high - low) / 2), (low + high) / 2);
    }
    scene->add(std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), btScalar(0)), {0, 0, 0});
    for (size_t first = 0; first < rain.particles.size(); first += cloud_size) {
        scene->add(&rain.particles[first], cloud_size);
    }
    return scene;
}

}  // namespace bench
