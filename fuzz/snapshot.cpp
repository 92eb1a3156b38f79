// Snapshots whose words were changed and whose checksum was mended: each is refused, which leaves the solver as it
// was, or is a state that can be asked, changed, stepped and taken again.
#include <algorithm>
#include <cmath>
#include <vector>

#include "check.h"
#include "foundation/archive.h"
#include "memory_hooks.h"
#include "mesh_source.h"
#include "program.h"

namespace fuzz {

const char* const target_name = "snapshot";

namespace {

constexpr uint32_t header_words = 5;  // magic, format, number of words, and the hash in two

void mend(std::vector<uint32_t>& words) {
    if (words.size() < header_words) return;
    gphys::WordHash hash;
    hash.put(words.data() + header_words, words.size() - header_words);
    words[2] = static_cast<uint32_t>(words.size());
    words[3] = static_cast<uint32_t>(hash.value());
    words[4] = static_cast<uint32_t>(hash.value() >> 32);
}

class Solver {
public:
    explicit Solver(const gphys_allocator* hooks) {
        gphys_solver_desc desc;
        call(gphys_solver_desc_init, &desc, static_cast<uint32_t>(sizeof desc));
        desc.allocator = hooks;
        desc.substeps = 2;
        call(gphys_solver_create, &desc, &solver_);
    }
    ~Solver() { call(gphys_solver_destroy, solver_); }
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;
    gphys_solver* get() const { return solver_; }

    uint64_t hash() const {
        uint32_t halves[2] = {};
        call(gphys_solver_get_hash, solver_, halves);
        return uint64_t{halves[1]} << 32 | halves[0];
    }
    std::vector<uint32_t> snapshot() const {
        uint32_t total = 0;
        call(gphys_solver_get_snapshot, solver_, nullptr, 0u, &total);
        std::vector<uint32_t> words(total);
        FUZZ_CHECK(call(gphys_solver_get_snapshot, solver_, words.data(), total, &total) == GPHYS_OK,
                   "a snapshot is taken");
        return words;
    }

private:
    gphys_solver* solver_ = nullptr;
};

/// Bodies of all kinds: what they are made of differs, and so do the words.
void fill(Program& p, gphys_solver* solver, const gphys_scene* scene, gphys_model_id floor, const gphys_mesh* mesh) {
    std::vector<gphys_body_id> bodies;
    const uint32_t count = 1 + p.below(4);
    for (uint32_t i = 0; i < count; ++i) {
        gphys_body_desc desc;
        call(gphys_body_desc_init, &desc, static_cast<uint32_t>(sizeof desc));
        desc.radius = 0.1f;
        desc.compliance = p.one_in(2) ? 1e-4f : 0;
        desc.self_collision = p.one_in(3) ? 1 : 0;
        desc.body_layers = p.below(2);
        // By an earlier choice, so that the programs of the corpus keep their meaning.
        desc.bending_stiffness = desc.body_layers == 1 ? 0.1f : 0;
        const float x = static_cast<float>(i), y = 0.05f + static_cast<float>(p.below(3)) / 2;
        const gphys_vec3 points[5] = {{x, y, 0}, {x, y, 0.5f}, {x, y, 1}, {x, y + 0.3f, 1.5f}, {x, y, 2}};
        const gphys_vec3 u{1, 0, 0}, v{0, 0, 1};
        const gphys_transform place{{x, y + 1, 0}, {0, 0, 0, 1}, 1};
        gphys_body_id body = 0;
        switch (p.below(4)) {
            case 0:
                call(gphys_solver_add_particles, solver, &desc, points, 12u, 1 + p.below(5), &body);
                break;
            case 1:
                call(gphys_solver_add_rope, solver, &desc, points, 12u, 2 + p.below(4), 0.0f, &body);
                break;
            case 2:
                call(gphys_solver_add_cloth, solver, &desc, &points[0], &u, &v, 2 + p.below(3), 2 + p.below(3), &body);
                break;
            default:
                call(gphys_solver_add_cloth_mesh, solver, &desc, mesh, &place, &body);
                call(gphys_solver_set_volume, solver, body, -1.0f, 0.0f);
        }
        if (body == 0) continue;
        if (p.one_in(3)) call(gphys_solver_set_pinned, solver, body, 0u, 1u, 1);
        const uint32_t members[] = {0, 1, 2, 3};
        gphys_cluster_id cluster = 0;
        // By an earlier choice, so that the programs of the corpus keep their meaning.
        for (uint32_t k = 0; desc.body_layers && k < 2; ++k) {
            call(gphys_solver_add_cluster, solver, body, members + k, 3u - k, &cluster);
        }
        gphys_constraint_info links[8];
        uint32_t total = 0;
        call(gphys_solver_get_constraints, solver, body, links, 8u, &total);
        for (uint32_t k = 0; desc.body_layers && k < std::min(total, 8u); ++k) {
            const float force = 0.5f * static_cast<float>(k);
            call(gphys_solver_set_breaking_forces, solver, body, &links[k].id, &force, 0u, 1u);
        }
        if (p.one_in(3)) call(gphys_solver_attach, solver, scene, body, 0u, floor, nullptr);
        bodies.push_back(body);
    }
    gphys_joint_id joint = 0;
    if (bodies.size() >= 2 && p.one_in(2)) {
        call(gphys_solver_join, solver, bodies[0], 0u, bodies[1], 0u, p.one_in(2) ? -1.0f : 0.0f, 0.0f, &joint);
    }
    if (p.one_in(4) && bodies.size() > 1) call(gphys_solver_remove_body, solver, bodies[0]);
    for (uint32_t i = p.below(4); i > 0; --i) call(gphys_solver_step, solver, p.one_in(3) ? nullptr : scene, 0.02f);
}

void damage(Program& p, std::vector<uint32_t>& words) {
    constexpr uint32_t likely[] = {0,          1,          2,          0xffffffff, 0x7fffffff, 0x80000000,
                                   0x7ff00000, 0x7ff80000, 0xfff00000, 0x3ff00000, 0x40000000, 0x00ffffff,
                                   0x01000000, 0x7f800000, 0x7fc00000, 3};
    const uint32_t changes = 1 + p.below(4);
    for (uint32_t i = 0; i < changes && words.size() > header_words; ++i) {
        const uint32_t size = static_cast<uint32_t>(words.size());
        const uint32_t at = header_words + p.below(std::min(size - header_words, 65536u));
        switch (p.below(8)) {
            case 0:
                words[at] = p.word();
                break;
            case 1:
                words[at] += p.one_in(2) ? 1 : 0xffffffff;
                break;
            case 2:
                words[at] ^= 1u << p.below(32);
                break;
            case 3:
                words.resize(header_words + p.below(std::min(size - header_words, 65536u)));
                break;
            case 4:
                words.insert(words.begin() + at, words[at]);
                break;
            case 5:
                words[at] = words[header_words + p.below(size - header_words)];
                break;
            default:
                words[at] = likely[p.byte() & 15];
        }
    }
    mend(words);
    if (p.one_in(30) && words.size() >= header_words) words[p.below(header_words)] = p.word();
}

/// Everything that can be done with a restored solver.
void use(Program& p, Solver& solver, const gphys_scene* scene) {
    gphys_body_id bodies[16];
    uint32_t total = 0;
    call(gphys_solver_get_bodies, solver.get(), bodies, 16u, &total);
    const uint32_t count = std::min(total, 16u);
    gphys_solver_stats stats;
    gphys_contact contacts[16];
    gphys_body_contact touches[16];
    gphys_impulse impulses[16];
    gphys_joint_info joints[16];
    const auto check_finite = [](const std::vector<gphys_vec3>& vectors) {
        for (const gphys_vec3& v : vectors) {
            FUZZ_CHECK(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z),
                       "what a solver tells of its bodies is finite");
        }
    };
    const auto ask = [&] {
        for (uint32_t i = 0; i < count; ++i) {
            gphys_body_info info;
            if (call(gphys_solver_get_body_info, solver.get(), bodies[i], &info) != GPHYS_OK) continue;
            std::vector<gphys_vec3> vectors(info.particle_count);
            std::vector<uint32_t> numbers(3 * size_t{info.triangle_count} + 1);
            std::vector<gphys_constraint_info> links(info.constraint_count + 1);
            float volume = 0, pressure = 0;
            call(gphys_solver_get_positions, solver.get(), bodies[i], 0u, info.particle_count, vectors.data(), 12u);
            check_finite(vectors);
            call(gphys_solver_get_velocities, solver.get(), bodies[i], 0u, info.particle_count, vectors.data(), 12u);
            check_finite(vectors);
            call(gphys_solver_get_triangles, solver.get(), bodies[i], numbers.data(), 3 * info.triangle_count, &total);
            call(gphys_solver_get_constraints, solver.get(), bodies[i], links.data(), info.constraint_count, &total);
            call(gphys_solver_get_volume, solver.get(), bodies[i], &volume, &pressure);
            if (info.constraint_count > 0) {
                float force = 0;
                call(gphys_solver_get_breaking_forces, solver.get(), bodies[i], &links[0].id, 1u, &force, 4u);
                FUZZ_CHECK(force >= 0, "a breaking force is a number");
            }
            gphys_cluster_id clusters[4];
            call(gphys_solver_get_clusters, solver.get(), bodies[i], clusters, 4u, &total);
            for (uint32_t k = 0; k < std::min(total, 4u); ++k) {
                uint32_t members[4], count_of = 0;
                call(gphys_solver_get_cluster_particles, solver.get(), bodies[i], clusters[k], members, 4u, &count_of);
                FUZZ_CHECK(count_of >= 2 && members[0] < info.particle_count, "a cluster has particles of its body");
            }
            call(gphys_solver_get_stats, solver.get(), bodies[i], &stats);
            check_finite({{volume, pressure, stats.strain_max},
                          {stats.strain_rms, stats.kinetic_energy, stats.potential_energy}});
        }
        call(gphys_solver_get_contacts, solver.get(), contacts, 16u, &total);
        for (uint32_t i = 0; i < std::min(total, 16u); ++i) check_finite({contacts[i].point, contacts[i].normal});
        call(gphys_solver_get_body_contacts, solver.get(), touches, 16u, &total);
        for (uint32_t i = 0; i < std::min(total, 16u); ++i) {
            check_finite({touches[i].normal, {touches[i].distance, touches[i].impulse, 0}});
        }
        call(gphys_solver_get_impulses, solver.get(), impulses, 16u, &total);
        for (uint32_t i = 0; i < std::min(total, 16u); ++i) check_finite({impulses[i].linear, impulses[i].angular});
        call(gphys_solver_get_joints, solver.get(), 0u, joints, 16u, &total);
        call(gphys_solver_get_sleeping, solver.get(), bodies, 0u, &total);
    };
    ask();
    // The words may ask for a thousand substeps, which is no fault but takes long.
    call(gphys_solver_set_substeps, solver.get(), 2u);
    call(gphys_solver_step, solver.get(), p.one_in(2) ? scene : nullptr, 0.01f);
    const gphys_vec3 there{0, 1, 0};
    gphys_constraint_id link = 0;
    if (count > 0) {
        call(gphys_solver_set_positions, solver.get(), bodies[0], 0u, 1u, &there, 12u);
        call(gphys_solver_add_distance, solver.get(), bodies[0], 0u, 1u, -1.0f, 0.0f, &link);
        if (p.one_in(3)) call(gphys_solver_remove_body, solver.get(), bodies[0]);
    }
    gphys_body_id more = 0;
    call(gphys_solver_add_particles, solver.get(), nullptr, &there, 12u, 1u, &more);
    call(gphys_solver_step, solver.get(), scene, 0.01f);
    ask();
    const std::vector<uint32_t> words = solver.snapshot();
    FUZZ_CHECK(call(gphys_solver_restore, solver.get(), words.data(), static_cast<uint32_t>(words.size())) == GPHYS_OK,
               "a state that came of any words is restored");
    note(solver.hash());
}

}  // namespace

void run(Program& p) {
    const MeshSource tetrahedron({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
    const MeshHandle mesh = tetrahedron.create();
    gphys_scene* scene = nullptr;
    call(gphys_scene_create, nullptr, &scene);
    struct DestroyScene {
        void operator()(gphys_scene* s) const { call(gphys_scene_destroy, s); }
    };
    const std::unique_ptr<gphys_scene, DestroyScene> owner(scene);
    const gphys_aabb box{{-10, -1, -10}, {10, 0, 10}};
    gphys_model_id floor = 0;
    call(gphys_scene_add, scene, gphys_shape_type{GPHYS_SHAPE_AABB}, &box, nullptr, nullptr, &floor);

    MemoryHooks memory;
    const gphys_allocator hooks = memory.hooks();
    {
        const Solver origin(&hooks);
        fill(p, origin.get(), scene, floor, mesh.get());
        const std::vector<uint32_t> good = origin.snapshot();
        for (int i = 0; i < 12 && !p.done(); ++i) {
            Solver target(&hooks);
            if (p.one_in(2)) fill(p, target.get(), scene, floor, mesh.get());
            std::vector<uint32_t> words = good;
            damage(p, words);
            const uint64_t before = target.hash();
            // What nobody computed may be too large or too small to go on with: 1e15 N on 1e-60 kg.
            const MayRaise made_up;
            const gphys_status status =
                call(gphys_solver_restore, target.get(), words.data(), static_cast<uint32_t>(words.size()));
            FUZZ_CHECK(status == GPHYS_OK || status == GPHYS_ERROR_INVALID_ARGUMENT,
                       "words are restored or refused as an argument");
            if (status != GPHYS_OK) {
                FUZZ_CHECK(target.hash() == before, "a solver that refuses words is as before");
                continue;
            }
            FUZZ_CHECK(target.snapshot() == words, "a state that was restored gives its words again");
            use(p, target, scene);
        }
    }
    FUZZ_CHECK(memory.live_bytes() == 0, "solvers that are destroyed give back their memory");
}

}  // namespace fuzz
