// Bullet's soft body: position solver, links as stiff as they can be.
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <btBulletDynamicsCommon.h>

#include <cmath>

#include "solver.h"

namespace bench {

namespace {

class BulletSoft final : public Method {
public:
    BulletSoft(const System& system, uint32_t iterations) : damping_(system.damping) {
        world_.setGravity({0, -static_cast<btScalar>(gravity), 0});
        world_.getWorldInfo().m_gravity = world_.getGravity();
        std::vector<btVector3> nodes;
        for (const gphys_vec3 p : system.positions) nodes.push_back({p.x, p.y, p.z});
        const std::vector<btScalar> masses(system.masses.begin(), system.masses.end());
        body_ = std::make_unique<btSoftBody>(&world_.getWorldInfo(), static_cast<int>(nodes.size()), nodes.data(),
                                             masses.data());
        body_->m_materials[0]->m_kLST = 1;
        for (const Link& link : system.links) {
            body_->appendLink(static_cast<int>(link.a), static_cast<int>(link.b), body_->m_materials[0]);
            btSoftBody::Link& made = body_->m_links[body_->m_links.size() - 1];
            made.m_rl = static_cast<btScalar>(link.rest);
            made.m_c1 = made.m_rl * made.m_rl;
        }
        body_->m_cfg.piterations = static_cast<int>(iterations);

        world_.addSoftBody(body_.get());
    }
    ~BulletSoft() override { world_.removeSoftBody(body_.get()); }
    void step(float seconds) override {
        body_->m_cfg.kDP = static_cast<btScalar>(1 - std::exp(-damping_ * seconds));
        world_.stepSimulation(seconds, 0);
    }
    std::vector<gphys_vec3> positions() const override { return read(&btSoftBody::Node::m_x); }
    std::vector<gphys_vec3> velocities() const override { return read(&btSoftBody::Node::m_v); }

private:
    std::vector<gphys_vec3> read(btVector3 btSoftBody::Node::*member) const {
        std::vector<gphys_vec3> out;
        for (int i = 0; i < body_->m_nodes.size(); ++i) {
            const btVector3& v = body_->m_nodes[i].*member;
            out.push_back({static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())});
        }
        return out;
    }

    double damping_;
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btSoftRigidDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::unique_ptr<btSoftBody> body_;
};

}  // namespace

std::unique_ptr<Method> make_bullet_soft(const System& system, uint32_t iterations) {
    return std::make_unique<BulletSoft>(system, iterations);
}

}  // namespace bench
