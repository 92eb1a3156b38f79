// gphys_solver_*: rigid clusters of a body.
#include "c_api/api.h"
#include "c_api/handles.h"
#include "c_api/lists.h"
#include "c_api/solver_settings.h"

using namespace gphys;

namespace {

gphys_status check_members(Solver& solver, const Body& body, const uint32_t* particles, uint32_t count) {
    Vector<uint8_t> taken(body.particles.size(), &solver.memory);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t p = particles[i];
        const char* range = nullptr;
        if (p >= taken.size()) range = "below the particle count of the body";
        if (!range && taken[p]) range = "another particle than those before it";
        if (range) return fail(GPHYS_ERROR_INVALID_ARGUMENT, "particles", i, Defect{"", 0, double(p), range});
        taken[p] = 1;
    }
    return GPHYS_OK;
}

gphys_status check_cluster(const gphys_solver* solver, gphys_body_id body, gphys_cluster_id cluster) {
    GPHYS_TRY(check_body(solver, body));
    return gphys::check_cluster(unwrap(solver)->body(body).cloth.clusters, cluster);
}

}  // namespace

gphys_status gphys_solver_add_cluster(gphys_solver* solver, gphys_body_id body, const uint32_t* particles,
                                      uint32_t count, gphys_cluster_id* out_cluster) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        GPHYS_REQUIRE_IN_RANGE(count >= 2, "count", count, "at least 2");
        GPHYS_REQUIRE_POINTERS(particles, out_cluster);
        Body& b = unwrap(solver)->body(body);
        GPHYS_TRY(check_members(*unwrap(solver), b, particles, count));
        return add_cluster(b, particles, count, *out_cluster);
    });
}

gphys_status gphys_solver_remove_cluster(gphys_solver* solver, gphys_body_id body, gphys_cluster_id cluster) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_cluster(solver, body, cluster));
        return remove_cluster(unwrap(solver)->body(body), cluster);
    });
}

gphys_status gphys_solver_get_clusters(const gphys_solver* solver, gphys_body_id body, gphys_cluster_id* out_clusters,
                                       uint32_t capacity, uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_body(solver, body));
        return list_smallest("out_clusters", out_clusters, capacity, out_total, [&](auto& clusters) {
            list_clusters(unwrap(solver)->body(body).cloth.clusters, clusters);
        });
    });
}

gphys_status gphys_solver_get_cluster_particles(const gphys_solver* solver, gphys_body_id body,
                                                gphys_cluster_id cluster, uint32_t* out_particles, uint32_t capacity,
                                                uint32_t* out_total) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_cluster(solver, body, cluster));
        GPHYS_TRY(check_list("out_particles", out_particles, capacity, out_total));
        const ClusterRange members = members_of(unwrap(solver)->body(body).cloth.clusters, IdTable::slot_of(cluster));
        for (uint32_t i = 0; i < std::min(members.size(), capacity); ++i) out_particles[i] = members.first[i].particle;
        return listed(members.size(), capacity, out_total);
    });
}
