// Raycasts of the scene: a BVH traversal; for each candidate a conservative test, then the exact one if that is
// undecided. Single rays use conservative_tests.h, but for boxes on wide instruction sets box_kernels.h. Batches use
// kernels that test eight pairs of a ray and a model at a time: on wide instruction sets hit_kernels.h, which gives the
// exact hit, else scene_kernels.h.
#include <algorithm>
#include <array>
#include <functional>
#include <new>
#include <numeric>
#include <optional>

#include "foundation/compiler.h"
#include "geometry/faces.h"
#include "scene/best_candidate.h"
#include "scene/conservative_tests.h"
#include "scene/scene.h"

namespace gphys {

namespace {

/// raycast against the sides that the filter allows. Meshes test the sides of their triangles themselves.
template <class Placed>
bool cast(const Placed& shape, const Ray& ray, Hit& hit) {
    return raycast(shape, ray, hit) &&
           (ray.faces.are_all() || !is_surface(shape) || ray.faces.include((hit.flags & GPHYS_HIT_BACK) != 0));
}
bool cast(const MeshInstance& instance, const Ray& ray, Hit& hit) { return raycast(instance, ray, hit); }
bool cast(const PlacedMesh& mesh, const Ray& ray, gphys_hit& hit) { return raycast(mesh, ray, hit); }
bool cast(const PlacedMesh& mesh, const Ray& ray, gphys_distance& found) { return raycast_distance(mesh, ray, found); }

bool is_hit(const MeshInstance& instance, const Ray& ray) { return raycast_any(instance, ray); }
template <class Primitive>
bool is_hit(const Primitive& shape, const Ray& ray) {
    Hit hit;
    return cast(shape, ray, hit);
}

gphys_hit hit_of(const Hits8::Rounded& hit, uint32_t model, uint32_t tag) {
    return {model, tag, hit.t, hit.point, hit.normal, GPHYS_NO_TRIANGLE, 0, 0, 0};
}

/// Whether rays of a batch are cast one by one. Measured: what a group of rays sets up costs as much as it saves at 5
/// rays among 100,000 boxes, 12 among 1000 boxes or small meshes, 15 in a large mesh.
bool are_few(uint32_t count, uint32_t models, uint32_t large_meshes) {
    constexpr uint32_t many_models = 30000;
    return count < (large_meshes > 0 ? 16 : models < many_models ? 12 : 6);
}

}  // namespace

/// Uninitialised storage for one T.
template <class T>
class Scene::Storage {
public:
    template <class... Arguments>
    void make(Arguments&&... arguments) {
        new (room_) T(std::forward<Arguments>(arguments)...);
    }
    T& operator*() { return *std::launder(reinterpret_cast<T*>(room_)); }
    T* operator->() { return &**this; }

private:
    static_assert(std::is_trivially_destructible_v<T>);
    alignas(T) unsigned char room_[sizeof(T)];
};

/// The closest hit of one ray, from candidates in any order. Answer is gphys_hit, or gphys_distance without point and
/// normal.
template <class Answer>
class Scene::FirstHitOfRay {
    static constexpr bool only_distance = std::is_same_v<Answer, gphys_distance>;

public:
    /// The ray must outlive this; each hit lowers its t_max. `out` is the closest hit so far, and unchanged without
    /// one. Tests the unbounded models at once.
    template <class Filter>
    FirstHitOfRay(const Scene& scene, Ray& ray, const Filter& filter, Answer& out)
        : scene_(&scene), rest_(&ray), t_max_(ray.t_max), out_(&out) {
        for (const uint32_t slot : scene.unbounded_) {
            if (scene.may_pass(filter, slot) && scene.may_hit_plane(slot, ray) && scene.passes(filter, slot))
                scene.with_plane(slot, [&](const Plane& plane) { return test(slot, plane); });
        }
    }

    // Tests of models that may pass the filter. Not inlined is what few models need.

    template <class Filter>
    void test_box(const Filter& filter, uint32_t slot) {
        Hits8::Rounded hit;
        const TriState verdict = scene_->raycast_box(slot, *rest_, hit);
        if (verdict == TriState::yes) {
            accept_if_seen(filter, slot, hit.t, [&](uint32_t model, uint32_t tag) {
                if constexpr (only_distance) {
                    return gphys_distance{hit.t, model, GPHYS_NO_TRIANGLE};
                } else {
                    return hit_of(hit, model, tag);
                }
            });
        } else if (verdict == TriState::undecided && may_precede(slot) && scene_->passes(filter, slot)) {
            test(slot);
        }
    }
    template <class Filter>
    GPHYS_NOINLINE void test_mesh(const Filter& filter, uint32_t slot) {
        if (scene_->passes(filter, slot)) test_mesh(slot);
    }
    template <class Filter>
    GPHYS_NOINLINE void test_other(const Filter& filter, uint32_t slot, const ConservativeRay& conservative_ray) {
        const auto conservative = [&](const auto& shape) { return conservative_ray.rejects(shape, rest_->t_max); };
        scene_->decide(filter, slot, conservative, [&](const auto& shape) { return test(slot, shape); });
    }

    /// Whether the model would be the closest if the ray began in it. Not after a lower id in which it does.
    bool may_precede(uint32_t slot) const { return best_.is_beaten_by(0, slot, scene_->ids_); }

    // Tests of models that pass the filter. Each returns whether t_max was lowered.

    GPHYS_NOINLINE bool test(uint32_t slot) {
        if (scene_->has_mesh_kernel(slot, *rest_)) return test_mesh(slot);
        return scene_->with_shape(slot, [&](const auto& shape) { return test(slot, shape); });
    }
    /// Of a mesh that has a kernel for the ray.
    bool test_mesh(uint32_t slot) {
        Answer found;
        return cast(scene_->placed_mesh(slot), *rest_, found) &&
               accept(slot, found.t, [&](uint32_t model, uint32_t tag) {
                   if constexpr (only_distance) {
                       return gphys_distance{found.t, model, found.triangle};
                   } else {
                       found.model = model;
                       found.tag = tag;
                       return found;
                   }
               });
    }
    template <class Placed>
    bool test(uint32_t slot, const Placed& shape) {
        if constexpr (only_distance && std::is_same_v<Placed, MeshInstance>) {
            gphys_distance found;
            return raycast_distance(shape, *rest_, found) && accept(slot, found.t, [&](uint32_t model, uint32_t) {
                       return gphys_distance{found.t, model, found.triangle};
                   });
        }
        Hit hit;
        return cast(shape, *rest_, hit) &&
               accept(slot, reported(hit.t), [&](uint32_t model, uint32_t tag) { return answer_of(hit, model, tag); });
    }
    /// A hit with reported t; hit_of(id, tag) makes its Answer.
    template <class HitOf>
    bool accept(uint32_t slot, float t, const HitOf& hit_of) {
        return accept_if_seen(uint32_t{GPHYS_ALL_LAYERS}, slot, t, hit_of);
    }
    template <class Filter, class HitOf>
    bool accept_if_seen(const Filter& filter, uint32_t slot, float t, const HitOf& hit_of) {
        if (!best_.is_beaten_by(t, slot, scene_->ids_) || !scene_->passes(filter, slot)) return false;
        best_ = {t, slot};
        *out_ = hit_of(scene_->ids_.id(slot), scene_->tags_[slot]);
        // Not t itself: models reported at the same t may have a lower id.
        rest_->t_max = std::min(t_max_, limit_of_ties<double>(t));
        return true;
    }

    gphys_status status() const { return best_.exists() ? GPHYS_OK : GPHYS_NO_HIT; }

private:
    static Answer answer_of(const Hit& hit, uint32_t model, uint32_t tag) {
        if constexpr (only_distance) {
            return {reported(hit.t), model, hit.triangle};
        } else {
            return to_hit(hit, model, tag);
        }
    }

    const Scene* scene_;
    Ray* rest_;     // its t_max: the limit for further hits
    double t_max_;  // of the caller's ray
    BestCandidate best_;
    Answer* out_;
};

TriState Scene::raycast_box(uint32_t slot, const Ray& ray, Hits8::Rounded& hit) const {
    const Model& model = models_[slot];
    const float* const words = &model.world.position.x;
    if (model.type() == GPHYS_SHAPE_AABB) return box_kernels_->raycast_aabb(ray, words, hit);
    return box_kernels_->raycast_obb(ray, words, tail_of(slot), hit);
}
TriState Scene::meets_box(uint32_t slot, const Ray& ray) const {
    const Model& model = models_[slot];
    const float* const words = &model.world.position.x;
    if (model.type() == GPHYS_SHAPE_AABB) return box_kernels_->meets_aabb(ray, words);
    return box_kernels_->meets_obb(ray, words, tail_of(slot));
}

/// Not inlined is what few models need.
GPHYS_NOINLINE bool Scene::meets_mesh(uint32_t slot, const Ray& ray) const {
    return gphys::raycast_any(placed_mesh(slot), ray);
}

template <class Filter, class Answer>
gphys_status Scene::raycast_by(const Ray& ray, const Filter& filter, Answer& out) const {
    Ray rest = filtered(ray, filter);
    FirstHitOfRay<Answer> first(*this, rest, filter, out);
    const auto make_visit = [&] {
        return [&, conservative_ray = ConservativeRay(ray, !box_kernels_)](uint32_t slot, double& t_max)
                   GPHYS_INLINE_LAMBDA {
                       if (!may_pass(filter, slot)) return;
                       if (has_box_kernel(slot)) {
                           first.test_box(filter, slot);
                       } else if (has_mesh_kernel(slot, ray)) {
                           first.test_mesh(filter, slot);
                       } else {
                           first.test_other(filter, slot, conservative_ray);
                       }
                       t_max = rest.t_max;
                   };
    };
    // `ray`, not `rest`: a load from the fresh copy would stall on store forwarding.
    bvh_.raycast_by(ray, rest.t_max, make_visit, model_memory());
    return first.status();
}

/// The meshes that most rays of a batch may hit, such as the level around a camera. They are tested before the
/// traversal of the scene's BVH, with all rays at once, so that coherent rays share the traversal of the mesh, too.
class Scene::LargeMeshes {
public:
    /// cast_mesh(mesh, rays, count, hit) calls hit(ray, answer) for the rays that hit the mesh. accept(ray, slot,
    /// answer) gets them.
    template <class Filters, class CastMesh, class Accept>
    LargeMeshes(const Scene& scene, const Ray* rays, uint32_t count, const Filters& filters, const CastMesh& cast_mesh,
                const Accept& accept) {
        if (std::any_of(rays, rays + count, is_cast_singly)) return;
        for (uint32_t i = 0; i < scene.large_mesh_count_; ++i) {
            const uint32_t slot = scene.large_meshes_[i];
            if (!all_pass(scene, slot, count, filters)) continue;
            with_placed(scene.stored<ModelMesh>(slot), scene.models_[slot].world, [&](const MeshInstance& mesh) {
                if (!most_may_hit(mesh, rays, count)) return;
                cast_mesh(mesh, rays, count, [&](uint32_t i, const auto& answer) { accept(i, slot, answer); });
                slots_[count_++] = slot;
            });
        }
    }

    uint32_t count() const { return count_; }
    bool contains(uint32_t slot) const { return std::find(slots_, slots_ + count_, slot) != slots_ + count_; }

private:
    static bool is_cast_singly(const Ray& ray) { return ray.is_segment || !ray.faces.are_all(); }
    static bool all_pass(const Scene& scene, uint32_t slot, uint32_t, uint32_t layers) {
        return scene.may_pass(layers, slot);
    }
    static bool all_pass(const Scene& scene, uint32_t slot, uint32_t count, const BatchFilters& filters) {
        for (uint32_t i = 0; i < (filters.step == 0 ? 1 : count); ++i) {
            if (!scene.may_pass(filters.of(i), slot) || !scene.passes(filters.of(i), slot)) return false;
        }
        return true;
    }
    /// Decided by a sample of eight rays.
    static bool most_may_hit(const MeshInstance& mesh, const Ray* rays, uint32_t count) {
        uint32_t near = 0;
        for (uint32_t k = 0; k < 8; ++k) near += may_hit(mesh, rays[k * count / 8]);
        return near > 4;
    }

    uint32_t slots_[most_large_meshes], count_ = 0;
};

namespace {

// Raycasts of large meshes: hit(ray, answer) for each ray that hits. Not inlined, so that their arrays are on the stack
// only while they are needed.

template <class Visit>
void for_each_bit(uint64_t bits, const Visit& visit) {
    for (; bits != 0; bits &= bits - 1) visit(static_cast<uint32_t>(lowest_bit(bits)));
}

template <class OnHit>
GPHYS_NOINLINE void raycast_mesh(const MeshInstance& mesh, const Ray* rays, uint32_t count, gphys_hit*,
                                 const OnHit& hit) {
    gphys_hit hits[Scene::rays_at_once];
    gphys_hit* out[Scene::rays_at_once];
    for (uint32_t i = 0; i < count; ++i) out[i] = hits + i;
    for_each_bit(gphys::raycast_many(mesh, rays, count, out), [&](uint32_t i) { hit(i, hits[i]); });
}
template <class OnHit>
GPHYS_NOINLINE void raycast_mesh(const MeshInstance& mesh, const Ray* rays, uint32_t count, gphys_distance*,
                                 const OnHit& hit) {
    gphys_distance found[Scene::rays_at_once];
    const uint64_t bits = mesh.mesh.raycast_distance_many(rays, count, mesh.place(), found);
    for_each_bit(bits, [&](uint32_t i) { hit(i, found[i]); });
}
template <class OnHit>
GPHYS_NOINLINE void raycast_any_of_mesh(const MeshInstance& mesh, const Ray* rays, uint32_t count, const OnHit& hit) {
    for_each_bit(mesh.mesh.raycast_any_many(rays, count, mesh.place()), [&](uint32_t i) { hit(i, true); });
}

// One of eight hits as the answer of a ray.

gphys_hit answer_of(const Hits8& hits, uint32_t k, uint32_t model, uint32_t tag) {
    return hit_of(hits.rounded[k], model, tag);
}
gphys_distance answer_of(const float (&t)[8], uint32_t k, uint32_t model, uint32_t) {
    return {t[k], model, GPHYS_NO_TRIANGLE};
}
float reported_t(const Hits8& hits, uint32_t k) { return hits.rounded[k].t; }
float reported_t(const float (&t)[8], uint32_t k) { return t[k]; }

template <class Answers>
auto kernels_for(const HitKernels& kernels) {
    if constexpr (std::is_same_v<Answers, Hits8>) {
        return std::array{kernels.spheres, kernels.aabbs, kernels.obbs};
    } else {
        return std::array{kernels.sphere_distances, kernels.aabb_distances, kernels.obb_distances};
    }
}

}  // namespace

/// Up to eight pairs of a ray (by index) and a candidate model, sorted by the type of the model.
class Scene::EightPairs {
public:
    template <class Filters>
    EightPairs(const Scene& scene, const uint32_t* numbers, const uint32_t* slots, uint32_t count,
               const Filters& filters, const LargeMeshes& large)
        : scene_(scene), numbers_(numbers), slots_(slots) {
        static_assert(offsetof(Model, world) == 0 && offsetof(Model, shape) == shape_at * sizeof(float));
        for (uint32_t k = 0; k < count; ++k) {
            const Model& model = scene.models_[slots[k]];
            const bool passes_mask = scene.may_pass(filter_of_item(filters, numbers[k]), slots[k]);
            of_type_[model.type()] |= uint32_t{passes_mask && !large.contains(slots[k])} << k;
        }
    }

    /// The pairs whose models pass the filter's mask and are not among the large meshes.
    uint32_t candidates() const {
        return std::accumulate(std::begin(of_type_), std::end(of_type_), 0u, std::bit_or<>());
    }
    /// The result of kernel(pairs) for the pairs with models of a type.
    template <class RayForm, class Kernel>
    TriStates8 test(gphys_shape_type type, const RayForm* rays, const Kernel& kernel) const {
        const uint32_t some = of_type_[type];
        if (some == 0) return {0, 0};
        RaysAndModels<RayForm> pairs;
        // Other lanes repeat the first pair of this type.
        const auto first = static_cast<uint32_t>(lowest_bit(some));
        for (uint32_t k = 0; k < 8; ++k) {
            const uint32_t pair = (some >> k & 1) != 0 ? k : first, slot = slots_[pair];
            pairs.ray[k] = rays + numbers_[pair];
            pairs.model[k] = &scene_.models_[slot].world.position.x;
            pairs.other[k] = other_words(type, slot);
        }
        const TriStates8 results = kernel(pairs);
        return {results.no & some, results.yes & some};
    }

private:
    const float* other_words(gphys_shape_type type, uint32_t slot) const {
        switch (type) {
            case GPHYS_SHAPE_SPHERE:
                return reinterpret_cast<const float*>(scene_.models_[slot].shape);
            case GPHYS_SHAPE_OBB:
                return scene_.tail_of(slot);
            case GPHYS_SHAPE_MESH: {
                const ModelMesh stored = scene_.stored<ModelMesh>(slot);
                return stored.is_scaled ? scene_.tail_of(slot) : &stored.mesh->ball().center.x;
            }
            default:
                return nullptr;
        }
    }

    const Scene& scene_;
    const uint32_t *numbers_, *slots_;
    uint32_t of_type_[GPHYS_SHAPE_MESH + 1] = {};
};

/// The conservative tests of many rays, eight at a time. Rays that meet no model's box set up nothing.
class Scene::ConservativeRays {
public:
    /// The rays must outlive this.
    ConservativeRays(const Scene& scene, const Ray* rays, uint32_t count)
        : kernels_(scene.kernels_), rays_(rays), count_(count) {}

    TriStates8 test(const EightPairs& pairs) {
        if (!is_set_up_) kernels_.ray_quads(rays_, count_, quads_);
        is_set_up_ = true;
        TriStates8 all = {0, 0};
        for (const TriStates8& results : {pairs.test(GPHYS_SHAPE_SPHERE, quads_, kernels_.rays_and_spheres),
                                          pairs.test(GPHYS_SHAPE_AABB, quads_, kernels_.rays_and_aabbs),
                                          pairs.test(GPHYS_SHAPE_OBB, quads_, kernels_.rays_and_obbs)}) {
            all.no |= results.no;
            all.yes |= results.yes;
        }
        // The bounding sphere of a mesh: only "no" is valid.
        all.no |= pairs.test(GPHYS_SHAPE_MESH, quads_, kernels_.rays_and_spheres).no;
        return all;
    }
    /// Call after t_max of a ray was lowered.
    void shorten(uint32_t ray) {
        if (is_set_up_) quads_[ray].end = ray_end(rays_[ray].t_max, rays_[ray].direction);
    }

private:
    const SceneKernels& kernels_;
    const Ray* rays_;
    uint32_t count_;
    bool is_set_up_ = false;
    RayQuads quads_[rays_at_once];
};

/// Keeps a primitive in world space for consecutive rays that test the same model.
class Scene::SharedModel {
public:
    explicit SharedModel(const Scene& scene) : scene_(scene) {}

    /// Announces the models of the next tests.
    void expect(const uint32_t* slots, uint32_t count) {
        expected_ = count > 1 && (slots[0] == slots[1] || slots[count - 2] == slots[count - 1]);
    }
    /// Null if no other test is likely to use it.
    const Shape* place(uint32_t slot) {
        if (!expected_ || scene_.models_[slot].type() == GPHYS_SHAPE_MESH) return nullptr;
        if (slot != slot_) {
            scene_.with_shape(slot, [&](const auto& shape) {
                if constexpr (std::is_constructible_v<Shape, decltype(shape)>) placed_.emplace(shape);
            });
            slot_ = slot;
        }
        return &*placed_;
    }

private:
    const Scene& scene_;
    bool expected_ = false;
    uint32_t slot_ = none;
    std::optional<Shape> placed_;
};

/// Tests pairs by the kernels that compute hits: hit(k, answers) for each hit. Returns the mask of decided pairs.
/// Answers is Hits8, or eight floats for distances.
template <class Answers, class OnHit>
uint32_t Scene::hits_by_kernels(const EightPairs& pairs, const Ray* rays, const OnHit& hit) const {
    uint32_t decided = pairs
                           .test(GPHYS_SHAPE_MESH, rays,
                                 [&](const auto& some) {
                                     return TriStates8{hit_kernels_->miss_balls(some), 0};
                                 })
                           .no;
    const auto test = [&](gphys_shape_type type, auto kernel) {
        Answers hits;
        const TriStates8 results = pairs.test(type, rays, [&](const auto& some) { return kernel(some, hits); });
        decided |= results.no | results.yes;
        for (uint32_t rest = results.yes; rest != 0; rest &= rest - 1) {
            hit(static_cast<uint32_t>(lowest_bit(rest)), hits);
        }
    };
    const auto kernels = kernels_for<Answers>(*hit_kernels_);
    test(GPHYS_SHAPE_SPHERE, kernels[0]);
    test(GPHYS_SHAPE_AABB, kernels[1]);
    test(GPHYS_SHAPE_OBB, kernels[2]);
    return decided;
}

/// The models of the BVH except the large meshes. Not inlined, so that its arrays are not on the stack beside theirs.
template <class Filters, class Answer>
GPHYS_NOINLINE void Scene::raycast_bvh_by(Ray* rays, uint32_t count, const Filters& filters, const LargeMeshes& large,
                                          Storage<FirstHitOfRay<Answer>>* first) const {
    using First = FirstHitOfRay<Answer>;
    ConservativeRays conservative(*this, rays, count);
    SharedModel shared(*this);
    const auto visit = [&](const uint32_t* numbers, const uint32_t* slots, uint32_t size) {
        const EightPairs pairs(*this, numbers, slots, size, filters, large);
        uint32_t undecided = pairs.candidates(), shorter = 0;
        if (hit_kernels_) {
            using Answers = std::conditional_t<std::is_same_v<Answer, gphys_distance>, float[8], Hits8>;
            undecided &= ~hits_by_kernels<Answers>(pairs, rays, [&](uint32_t k, const auto& hits) {
                const auto hit_of = [&](uint32_t model, uint32_t tag) { return answer_of(hits, k, model, tag); };
                shorter |= uint32_t{first[numbers[k]]->accept_if_seen(filter_of_item(filters, numbers[k]), slots[k],
                                                                      reported_t(hits, k), hit_of)}
                           << k;
            });
        } else {
            undecided &= ~conservative.test(pairs).no;
            shared.expect(slots, size);
        }
        for (; undecided != 0; undecided &= undecided - 1) {
            const auto k = static_cast<uint32_t>(lowest_bit(undecided));
            First& of = *first[numbers[k]];
            if (!of.may_precede(slots[k]) || !passes(filter_of_item(filters, numbers[k]), slots[k])) continue;
            const Shape* placed = shared.place(slots[k]);
            if (!(placed ? of.test(slots[k], *placed) : of.test(slots[k]))) continue;
            shorter |= 1u << k;
            conservative.shorten(numbers[k]);
        }
        return shorter;
    };
    bvh_.raycast_many(rays, count, visit, model_memory());
}

template <class Filters, class Answer>
void Scene::raycast_many_by(Ray* rays, uint32_t count, const Filters& filters, Answer* const* out) const {
    if (are_few(count, size(), large_mesh_count_)) {
        for (uint32_t i = 0; i < count; ++i) raycast_by(rays[i], filter_of_item(filters, i), *out[i]);
        return;
    }
    raycast_together_by(rays, count, filters, out);
}

/// Not inlined, so that its arrays are not on the stack of those that cast few rays.
template <class Filters, class Answer>
GPHYS_NOINLINE void Scene::raycast_together_by(Ray* rays, uint32_t count, const Filters& filters,
                                               Answer* const* out) const {
    Storage<FirstHitOfRay<Answer>> first[rays_at_once];
    filter_rays(rays, count, filters);
    for (uint32_t i = 0; i < count; ++i) first[i].make(*this, rays[i], filter_of_item(filters, i), *out[i]);
    const LargeMeshes large(
        *this, rays, count, filters,
        [](const MeshInstance& mesh, const Ray* of, uint32_t some, const auto& hit) {
            raycast_mesh(mesh, of, some, static_cast<Answer*>(nullptr), hit);
        },
        [&](uint32_t i, uint32_t slot, auto answer) {
            first[i]->accept(slot, answer.t, [&](uint32_t model, uint32_t tag) {
                answer.model = model;
                if constexpr (std::is_same_v<Answer, gphys_hit>) answer.tag = tag;
                return answer;
            });
        });
    if (large.count() < bvh_.size()) raycast_bvh_by(rays, count, filters, large, first);
}

bool Scene::may_hit_plane(uint32_t slot, const Ray& ray) const {
    return may_hit(conservative_shape(stored<gphys_plane>(slot), models_[slot].world), ray);
}

/// Whether a ray hits a plane. Planes are unbounded and not in the BVH.
template <class Filter>
bool Scene::hits_unbounded(const Ray& ray, const Filter& filter) const {
    const auto exact = [&](const Plane& plane) { return is_hit(plane, ray); };
    for (const uint32_t slot : unbounded_) {
        if (may_pass(filter, slot) && may_hit_plane(slot, ray) && with_plane(slot, exact) && passes(filter, slot))
            return true;
    }
    return false;
}

template <class Filter>
bool Scene::raycast_any_by(const Ray& given, const Filter& filter) const {
    const Ray& ray = filtered(given, filter);
    if (hits_unbounded(ray, filter)) return true;
    const auto exact = [&](const auto& shape) { return is_hit(shape, ray); };
    const auto make_visit = [&] {
        return [&, conservative_ray = ConservativeRay(ray, !box_kernels_)](uint32_t slot) {
            if (!may_pass(filter, slot)) return false;
            if (has_box_kernel(slot)) {
                const TriState verdict = meets_box(slot, ray);
                if (verdict == TriState::no || !passes(filter, slot)) return false;
                return verdict == TriState::yes || with_shape(slot, exact);
            }
            if (has_mesh_kernel(slot, ray)) return passes(filter, slot) && meets_mesh(slot, ray);
            const auto conservative = [&](const auto& shape) { return conservative_ray(shape, ray.t_max); };
            return decide(filter, slot, conservative, exact);
        };
    };
    return bvh_.raycast_any_by(ray, make_visit, model_memory());
}

template <class Filters>
uint64_t Scene::raycast_any_many_by(Ray* rays, uint32_t count, const Filters& filters) const {
    uint64_t hits = 0;
    if (are_few(count, size(), large_mesh_count_)) {
        for (uint32_t i = 0; i < count; ++i) hits |= uint64_t{raycast_any_by(rays[i], filter_of_item(filters, i))} << i;
        return hits;
    }
    return raycast_any_together_by(rays, count, filters);
}

template <class Filters>
GPHYS_NOINLINE uint64_t Scene::raycast_any_together_by(Ray* rays, uint32_t count, const Filters& filters) const {
    uint64_t hits = 0;
    filter_rays(rays, count, filters);
    for (uint32_t i = 0; i < count; ++i) {
        if (!hits_unbounded(rays[i], filter_of_item(filters, i))) continue;
        hits |= uint64_t{1} << i;
        // A negative t_max excludes the ray from the traversals.
        rays[i].t_max = -1;
    }
    const LargeMeshes large(
        *this, rays, count, filters,
        [](const MeshInstance& mesh, const Ray* of, uint32_t some, const auto& hit) {
            raycast_any_of_mesh(mesh, of, some, hit);
        },
        [&](uint32_t i, uint32_t, bool) {
            hits |= uint64_t{1} << i;
            rays[i].t_max = -1;
        });
    if (large.count() == bvh_.size()) return hits;
    ConservativeRays conservative(*this, rays, count);
    const auto visit = [&](const uint32_t* numbers, const uint32_t* slots, uint32_t size) {
        const EightPairs pairs(*this, numbers, slots, size, filters, large);
        const TriStates8 results = conservative.test(pairs);
        const auto passes_filter = [&](uint32_t k) { return passes(filter_of_item(filters, numbers[k]), slots[k]); };
        uint32_t done = results.yes;
        if constexpr (std::is_same_v<Filters, BatchFilters>) {
            for (uint32_t rest = done; rest != 0; rest &= rest - 1) {
                const auto k = static_cast<uint32_t>(lowest_bit(rest));
                if (!passes_filter(k)) done &= ~(1u << k);
            }
        }
        for (uint32_t undecided = pairs.candidates() & ~(results.no | results.yes); undecided != 0;
             undecided &= undecided - 1) {
            const auto k = static_cast<uint32_t>(lowest_bit(undecided));
            const auto exact = [&](const auto& shape) { return is_hit(shape, rays[numbers[k]]); };
            if ((hits >> numbers[k] & 1) == 0 && passes_filter(k) && with_shape(slots[k], exact)) done |= 1u << k;
        }
        for (uint32_t rest = done; rest != 0; rest &= rest - 1) {
            const uint32_t ray = numbers[lowest_bit(rest)];
            hits |= uint64_t{1} << ray;
            rays[ray].t_max = -1;
        }
        return done;
    };
    bvh_.raycast_any_many(rays, count, visit, model_memory());
    return hits;
}

void Scene::raycast_all(const Ray& given, const QueryFilter& filter, Smallest<gphys_hit, FirstHit>& out) const {
    const Ray ray = filtered(given, filter);
    const ConservativeRay conservative_ray(ray);
    Hit hit;
    const auto conservative = [&](const auto& shape) { return conservative_ray.rejects(shape, ray.t_max); };
    const auto exact = [&](const auto& shape) {
        hit = Hit();
        return cast(shape, ray, hit);
    };
    const auto test = [&](uint32_t slot) {
        if (!may_pass(filter, slot) || !decide(filter, slot, conservative, exact)) return;
        out.add(to_hit(hit, ids_.id(slot), tags_[slot]));
    };
    for (const uint32_t slot : unbounded_) test(slot);
    bvh_.raycast(
        ray, ray.t_max, [&](uint32_t slot, double&) { test(slot); }, model_memory());
}

gphys_status Scene::raycast(const Ray& ray, uint32_t layers, gphys_hit& out) const {
    return raycast_by(ray, layers, out);
}
gphys_status Scene::raycast(const Ray& ray, const QueryFilter& filter, gphys_hit& out) const {
    return raycast_by(ray, filter, out);
}

void Scene::raycast_many(Ray* rays, uint32_t count, uint32_t layers, gphys_hit* const* out) const {
    raycast_many_by(rays, count, layers, out);
}
void Scene::raycast_many(Ray* rays, uint32_t count, const BatchFilters& filters, gphys_hit* const* out) const {
    raycast_many_by(rays, count, filters, out);
}

void Scene::raycast_distance_many(Ray* rays, uint32_t count, uint32_t layers, gphys_distance* const* out) const {
    raycast_many_by(rays, count, layers, out);
}
void Scene::raycast_distance_many(Ray* rays, uint32_t count, const BatchFilters& filters,
                                  gphys_distance* const* out) const {
    raycast_many_by(rays, count, filters, out);
}

bool Scene::raycast_any(const Ray& ray, uint32_t layers) const { return raycast_any_by(ray, layers); }
bool Scene::raycast_any(const Ray& ray, const QueryFilter& filter) const { return raycast_any_by(ray, filter); }

uint64_t Scene::raycast_any_many(Ray* rays, uint32_t count, uint32_t layers) const {
    return raycast_any_many_by(rays, count, layers);
}
uint64_t Scene::raycast_any_many(Ray* rays, uint32_t count, const BatchFilters& filters) const {
    return raycast_any_many_by(rays, count, filters);
}

}  // namespace gphys
