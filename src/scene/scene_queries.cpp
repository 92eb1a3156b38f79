// Questions to the scene. Each walks the octree (and the few models that no octree can hold), asks
// the exact shape of each candidate, and tells the octree what is not worth visiting any more.
#include <cmath>
#include <new>
#include <optional>

#include "scene/quick_tests.h"
#include "scene/scene.h"
#include "scene/slot_set.h"
#include "shapes/halfspaces.h"

namespace gphys {

namespace {

/// The best answer so far: smallest value, then lowest id, in whatever order the octree delivers.
struct Winner {
    double value;
    uint32_t slot = Octree::none;

    bool exists() const { return slot != Octree::none; }
    bool is_beaten_by(double other, uint32_t other_slot, const IdTable& ids) const {
        return !exists() || other < value || (other == value && ids.id(other_slot) < ids.id(slot));
    }
};

bool overlaps_shape(const MeshInstance& instance, const Shape& query) { return overlaps(instance, query); }
template <class Primitive>
bool overlaps_shape(const Primitive& shape, const Shape& query) {
    return overlaps(Shape(shape), query);
}

bool closest_point_of(const MeshInstance& instance, Vec3 point, double max_distance, Vec3& out, uint32_t& triangle) {
    return closest_point(instance, point, max_distance, out, triangle);
}
template <class Primitive>
bool closest_point_of(const Primitive& shape, Vec3 point, double, Vec3& out, uint32_t& triangle) {
    triangle = GPHYS_NO_TRIANGLE;
    out = closest_point(shape, point);
    return true;
}

bool is_met(const MeshInstance& instance, const Ray& ray) { return raycast_any(instance, ray); }
template <class Primitive>
bool is_met(const Primitive& shape, const Ray& ray) {
    Hit hit;
    return raycast(shape, ray, hit);
}

/// Whether a box may touch a plane. The error of the sums is below 8 roundings of 2^-53 of what is
/// added up.
bool may_touch(const Plane& plane, const Box& box) {
    double middle = -plane.distance, reach = 0, magnitude = std::fabs(plane.distance);
    for (int k = 0; k < 3; ++k) {
        const double low = box.min[k], high = box.max[k], normal = plane.normal[k];
        middle += normal * ((low + high) * 0.5);
        reach += std::fabs(normal) * ((high - low) * 0.5);
        magnitude += std::fabs(normal) * std::max(std::fabs(low), std::fabs(high));
    }
    return std::fabs(middle) <= reach + 0x1p-50 * magnitude;
}

Box box_around(const Frustum& frustum) {
    Box box;
    return bounds(frustum, box) ? box : all_of_space;
}

}  // namespace

/// Room for what is made later, of which nothing is written until then.
template <class T>
class Later {
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

/// The first hit of one ray, among candidates in any order.
class Scene::FirstOfRay {
public:
    /// The ray, which must live as long, is cut short where it hits. `out` gets the first hit so far;
    /// without any it is left alone.
    FirstOfRay(const Scene& scene, Ray& ray, uint32_t layers, gphys_hit& out)
        : scene_(&scene), rest_(&ray), t_max_(ray.t_max), out_(&out) {
        for (const uint32_t slot : scene.unbounded_) {
            if (scene.models_[slot].layers & layers) ask(slot);
        }
    }

    /// A model in the layers.
    void ask(uint32_t slot) {
        scene_->with_shape(slot, [&](const auto& shape) { ask(slot, shape); });
    }
    template <class Placed>
    void ask(uint32_t slot, const Placed& shape) {
        Hit hit;
        if (gphys::raycast(shape, *rest_, hit)) take(slot, hit);
    }

    gphys_status status() const { return winner_.exists() ? GPHYS_OK : GPHYS_NO_HIT; }

private:
    void take(uint32_t slot, const Hit& hit) {
        if (!winner_.is_beaten_by(hit.t, slot, scene_->ids_)) return;
        winner_ = {hit.t, slot};
        *out_ = to_hit(hit, scene_->ids_.id(slot), scene_->tags_[slot]);
        // Shapes tell exactly what lies beyond t_max, while t is rounded (to 2^-50 of it at worst).
        // The slack keeps those in whose rounded t is the same, for the lower id to win.
        rest_->t_max = std::min(t_max_, hit.t * (1 + 0x1p-40));
    }

    const Scene* scene_;
    Ray* rest_;     // how far other models can still come before the hit
    double t_max_;  // of the ray as it was given
    Winner winner_{infinity};
    gphys_hit* out_;
};

gphys_status Scene::raycast(const Ray& ray, uint32_t layers, gphys_hit& out) const {
    Ray rest = ray;
    const QuickRay quick_ray(ray);
    FirstOfRay first(*this, rest, layers, out);
    const auto quick = [&](const auto& shape) { return quick_ray.refuses(shape, rest.t_max); };
    const auto visit = [&](uint32_t slot, double& t_max) {
        if (!(models_[slot].layers & layers)) return;
        decide(slot, quick, [&](const auto& shape) {
            first.ask(slot, shape);
            return true;
        });
        t_max = rest.t_max;
    };
    octree_.raycast(rest, visit, model_memory());
    return first.status();
}

/// The quick tests of many rays, eight at a time.
class Scene::QuickRays {
public:
    /// The rays must live as long.
    QuickRays(const Scene& scene, const Ray* rays, uint32_t count, uint32_t layers)
        : scene_(scene), rays_(rays), layers_(layers) {
        if (count > 0) scene.kernels_.ray_quads(rays, count, quads_);
    }

    /// Whether rays[k] meets slots[k], k < count <= 8; one that is not in the layers it does not.
    Verdicts8 ask(const uint32_t* rays, const uint32_t* slots, uint32_t count) const {
        static_assert(offsetof(Model, world) == 0 && offsetof(Model, shape) == shape_at * sizeof(float));
        Verdicts8 all{0xffu << count & 0xff, 0};
        RaysAndModels pairs;
        uint32_t slot_of[8], of_type[GPHYS_SHAPE_MESH + 1] = {};
        for (uint32_t k = 0; k < 8; ++k) {
            const uint32_t pair = k < count ? k : 0;
            slot_of[k] = slots[pair];
            const Model& model = scene_.models_[slot_of[k]];
            pairs.ray[k] = quads_ + rays[pair];
            pairs.model[k] = &model.world.position.x;
            all.no |= uint32_t{(model.layers & layers_) == 0} << k;
            of_type[model.type()] |= 1u << k;
        }
        const auto ask_some = [&](gphys_shape_type type, auto kernel, const auto& other_of) {
            const uint32_t some = of_type[type];
            if (some == 0) return Verdicts8{0, 0};
            RaysAndModels of_one_type;
            const auto first = static_cast<uint32_t>(__builtin_ctz(some));
            for (uint32_t k = 0; k < 8; ++k) {
                const uint32_t pair = (some >> k & 1) != 0 ? k : first;
                of_one_type.ray[k] = pairs.ray[pair];
                of_one_type.model[k] = pairs.model[pair];
                of_one_type.other[k] = other_of(slot_of[pair]);
            }
            const Verdicts8 verdicts = kernel(of_one_type);
            return Verdicts8{verdicts.no & some, verdicts.yes & some};
        };
        const SceneKernels& kernels = scene_.kernels_;
        const auto none = [](uint32_t) -> const float* { return nullptr; };
        const auto own = [&](uint32_t slot) { return reinterpret_cast<const float*>(scene_.models_[slot].shape); };
        const auto tail = [&](uint32_t slot) {
            return reinterpret_cast<const float*>(scene_.shape_tails_[slot].words);
        };
        const auto ball = [&](uint32_t slot) { return &scene_.stored<const Mesh*>(slot)->ball().center.x; };
        for (const Verdicts8& verdicts : {ask_some(GPHYS_SHAPE_SPHERE, kernels.rays_and_spheres, own),
                                          ask_some(GPHYS_SHAPE_AABB, kernels.rays_and_aabbs, none),
                                          ask_some(GPHYS_SHAPE_OBB, kernels.rays_and_obbs, tail)}) {
            all.no |= verdicts.no;
            all.yes |= verdicts.yes;
        }
        // Of a mesh the ball is around it.
        all.no |= ask_some(GPHYS_SHAPE_MESH, kernels.rays_and_spheres, ball).no;
        all.yes &= ~all.no;
        return all;
    }
    /// The ray ends earlier.
    void shorten(uint32_t ray) { quads_[ray].end = ray_end(rays_[ray].t_max, rays_[ray].direction); }

private:
    const Scene& scene_;
    const Ray* rays_;
    uint32_t layers_;
    RayQuads quads_[rays_at_once];
};

/// A primitive that several rays in a row ask about, placed once for all of them.
class Scene::SharedModel {
public:
    explicit SharedModel(const Scene& scene) : scene_(scene) {}

    /// What is about to be asked about.
    void expect(const uint32_t* slots, uint32_t count) {
        expected_ = count > 1 && (slots[0] == slots[1] || slots[count - 2] == slots[count - 1]);
    }
    /// Null if that is not worth it.
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

void Scene::raycast_many(Ray* rays, uint32_t count, uint32_t layers, gphys_hit* const* out) const {
    Later<FirstOfRay> first[rays_at_once];
    for (uint32_t i = 0; i < count; ++i) first[i].make(*this, rays[i], layers, *out[i]);
    QuickRays quick(*this, rays, count, layers);
    SharedModel shared(*this);
    const auto visit = [&](uint32_t ray, uint32_t slot, double& t_max) {
        FirstOfRay& of = *first[ray];
        if (const Shape* placed = shared.place(slot)) {
            of.ask(slot, *placed);
        } else {
            of.ask(slot);
        }
        if (t_max == rays[ray].t_max) return;
        t_max = rays[ray].t_max;
        quick.shorten(ray);
    };
    const auto select = [&](const uint32_t* some, const uint32_t* slots, uint32_t size) {
        shared.expect(slots, size);
        return ~quick.ask(some, slots, size).no & 0xff;
    };
    octree_.raycast_many(rays, count, visit, model_memory(), select);
}

/// Whether a ray meets a plane, which no octree holds.
bool Scene::meets_unbounded(const Ray& ray, uint32_t layers) const {
    return std::any_of(unbounded_.begin(), unbounded_.end(), [&](uint32_t slot) {
        return (models_[slot].layers & layers) &&
               with_shape(slot, [&](const auto& shape) { return is_met(shape, ray); });
    });
}

bool Scene::raycast_any(const Ray& ray, uint32_t layers) const {
    if (meets_unbounded(ray, layers)) return true;
    const QuickRay quick_ray(ray);
    const auto quick = [&](const auto& shape) { return quick_ray(shape, ray.t_max); };
    const auto exact = [&](const auto& shape) { return is_met(shape, ray); };
    const auto ask = [&](uint32_t slot) { return (models_[slot].layers & layers) && decide(slot, quick, exact); };
    return octree_.raycast_any(ray, ask, model_memory());
}

uint64_t Scene::raycast_any_many(Ray* rays, uint32_t count, uint32_t layers) const {
    uint64_t met = 0;
    for (uint32_t i = 0; i < count; ++i) {
        if (!meets_unbounded(rays[i], layers)) continue;
        met |= uint64_t{1} << i;
        // Those that are done already have no way to go.
        rays[i].t_max = -1;
    }
    const QuickRays quick(*this, rays, count, layers);
    const auto visit = [&](uint32_t ray, uint32_t slot, double& t_max) {
        const auto exact = [&](const auto& shape) { return is_met(shape, rays[ray]); };
        if ((met >> ray & 1) == 0 && !with_shape(slot, exact)) return;
        met |= uint64_t{1} << ray;
        t_max = -1;
    };
    const auto select = [&](const uint32_t* some, const uint32_t* slots, uint32_t size) {
        const Verdicts8 verdicts = quick.ask(some, slots, size);
        for (uint32_t k = 0; k < size; ++k) met |= uint64_t{verdicts.yes >> k & 1} << some[k];
        return ~verdicts.no & 0xff;
    };
    octree_.raycast_many(rays, count, visit, model_memory(), select);
    return met;
}

void Scene::raycast_all(const Ray& ray, uint32_t layers, Smallest<gphys_hit, FirstHit>& out) const {
    const QuickRay quick_ray(ray);
    Hit hit;
    const auto quick = [&](const auto& shape) { return quick_ray.refuses(shape, ray.t_max); };
    const auto exact = [&](const auto& shape) {
        hit = Hit();
        return gphys::raycast(shape, ray, hit);
    };
    const auto ask = [&](uint32_t slot) {
        if (!(models_[slot].layers & layers) || !decide(slot, quick, exact)) return;
        out.add(to_hit(hit, ids_.id(slot), tags_[slot]));
    };
    for (const uint32_t slot : unbounded_) ask(slot);
    octree_.raycast(
        ray, [&](uint32_t slot, double&) { ask(slot); }, model_memory());
}

/// Those of a list that a ball meets: Aabbs by eight, others by ask(slot).
template <class Ask>
void Scene::overlap_ball(const BallLanes& ball, const uint32_t* slots, uint32_t count, uint32_t layers, const Ask& ask,
                         Smallest<gphys_model_id>& out) const {
    constexpr uint32_t quads = sizeof(Model) / (4 * sizeof(float));
    static_assert(quads == 4);
    uint32_t boxes[8], first_quad[8], waiting = 0;
    const auto decide_boxes = [&] {
        for (uint32_t k = waiting; k < 8; ++k) first_quad[k] = first_quad[0];
        const Verdicts8 verdicts =
            kernels_.boxes_near(reinterpret_cast<const float*>(models_.data()), first_quad, ball);
        for (uint32_t k = 0; k < waiting; ++k) out.add_if(verdicts.yes >> k & 1, ids_.id(boxes[k]));
        uint32_t open = ~(verdicts.no | verdicts.yes) & ((1u << waiting) - 1);
        for (; open != 0; open &= open - 1) ask(boxes[__builtin_ctz(open)]);
        waiting = 0;
    };
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t slot = slots[i];
        if (!(models_[slot].layers & layers)) continue;
        if (models_[slot].type() != GPHYS_SHAPE_AABB) {
            ask(slot);
            continue;
        }
        boxes[waiting] = slot;
        first_quad[waiting] = quads * slot;
        if (++waiting == 8) decide_boxes();
    }
    if (waiting > 0) decide_boxes();
}

void Scene::overlap(const Shape& query, uint32_t layers, Smallest<gphys_model_id>& out) const {
    const auto exact = [&](const auto& shape) { return overlaps_shape(shape, query); };
    std::visit(
        [&](const auto& shape) {
            using Query = std::decay_t<decltype(shape)>;
            const auto quick = quick_overlap(shape);
            const auto ask = [&](uint32_t slot) {
                out.add_if((models_[slot].layers & layers) && decide(slot, quick, exact), ids_.id(slot));
                return true;
            };
            for (const uint32_t slot : unbounded_) ask(slot);
            // What is wholly inside a solid is found without a look at it.
            const bool inside_is_found = (common_layers_ & layers) != 0;
            const auto find = [&](uint32_t slot, bool wholly_inside) {
                if (!wholly_inside || !inside_is_found) return ask(slot);
                out.add(ids_.id(slot));
                return true;
            };
            const ItemMemory models = model_memory(), if_inside = inside_is_found ? id_memory() : models;
            if constexpr (std::is_same_v<Query, Plane>) {
                octree_.overlap([&](const Box& box) { return may_touch(shape, box); }, ask);
            } else if constexpr (std::is_same_v<Query, Frustum>) {
                octree_.frustum(shape, box_around(shape), find, models, if_inside);
            } else if constexpr (std::is_same_v<Query, Sphere>) {
                const BallLanes ball(shape.center, shape.radius);
                const auto find_all = [&](const uint32_t* slots, uint32_t count, bool wholly_inside) {
                    if (wholly_inside && inside_is_found) {
                        for (uint32_t i = 0; i < count; ++i) out.add(ids_.id(slots[i]));
                    } else {
                        overlap_ball(ball, slots, count, layers, ask, out);
                    }
                    return true;
                };
                octree_.overlap_ball(shape.center, shape.radius, find_all, models, if_inside);
            } else if constexpr (std::is_same_v<Query, Aabb>) {
                octree_.overlap_box(gphys::bounds(shape), find, models, if_inside);
            } else {
                octree_.overlap_box(
                    gphys::bounds(shape), [&](uint32_t slot, bool) { return ask(slot); }, models, models);
            }
        },
        query);
}

gphys_status Scene::nearest(Vec3 point, double max_distance, uint32_t layers, gphys_nearest& out) const {
    const QuickPoint quick_point(point);
    Winner winner{max_distance * max_distance};
    double reach = max_distance;
    Vec3 closest, candidate;
    uint32_t closest_triangle = GPHYS_NO_TRIANGLE, triangle = GPHYS_NO_TRIANGLE;
    const auto quick = [&](const auto& shape) { return unless_no(quick_point(shape, reach)); };
    const auto exact = [&](const auto& shape) { return closest_point_of(shape, point, reach, candidate, triangle); };
    const auto ask = [&](uint32_t slot) {
        if (!(models_[slot].layers & layers) || !decide(slot, quick, exact)) return;
        const double square = length_squared(candidate - point);
        if (square > winner.value || !winner.is_beaten_by(square, slot, ids_)) return;
        winner = {square, slot};
        reach = std::sqrt(square);
        closest = candidate;
        closest_triangle = triangle;
    };
    for (const uint32_t slot : unbounded_) ask(slot);
    const auto visit = [&](uint32_t slot, double& within) {
        ask(slot);
        within = reach;
    };
    octree_.nearest(point, reach, visit, model_memory());
    if (!winner.exists()) return GPHYS_NO_HIT;
    out = to_nearest(closest, reach, closest_triangle, ids_.id(winner.slot), tags_[winner.slot]);
    return GPHYS_OK;
}

gphys_status Scene::sweep(const Sphere& moving, Vec3 displacement, uint32_t layers, gphys_hit& out) const {
    Hit first, hit;
    Winner winner{infinity};
    const auto exact = [&](const auto& shape) {
        hit = Hit();
        return gphys::sweep(shape, moving, displacement, hit);
    };
    const auto ask = [&](uint32_t slot) {
        if (!(models_[slot].layers & layers) || !with_shape(slot, exact)) return;
        if (!winner.is_beaten_by(hit.t, slot, ids_)) return;
        winner = {hit.t, slot};
        first = hit;
    };
    for (const uint32_t slot : unbounded_) ask(slot);
    const auto visit = [&](uint32_t slot, double& t_max) {
        ask(slot);
        t_max = std::min(t_max, winner.value);
    };
    octree_.sweep(moving.center, displacement, moving.radius, visit, model_memory());
    if (!winner.exists()) return GPHYS_NO_HIT;
    out = to_hit(first, ids_.id(winner.slot), tags_[winner.slot]);
    return GPHYS_OK;
}

uint32_t Scene::cull(const Frustum& frustum, uint32_t layers, gphys_model_id* out, uint32_t capacity) const {
    const bool all_in_layers = (common_layers_ & layers) != 0;
    // Calls add(slot), and returns how often.
    const auto walk = [&](const auto& add) {
        uint32_t total = 0;
        const auto add_if_in_layers = [&](uint32_t slot) {
            if (!(models_[slot].layers & layers)) return;
            add(slot);
            ++total;
        };
        for (const uint32_t slot : unbounded_) {
            const auto is_seen = [&](const auto& shape) { return overlaps_shape(shape, frustum); };
            if (with_shape(slot, is_seen)) add_if_in_layers(slot);
        }
        octree_.frustum(frustum, box_around(frustum), [&](const uint32_t* slots, uint32_t count) {
            if (all_in_layers) {
                std::for_each(slots, slots + count, add);
                total += count;
            } else {
                std::for_each(slots, slots + count, add_if_in_layers);
            }
            return true;
        });
        return total;
    };

    // Thousands of ids cost more to sort than to find. Where the array has room for it behind them,
    // a set of their slots puts them in order.
    const uint32_t beyond = SlotSet::words_for(ids_.slots()) + SlotSet::spare;
    if (capacity > beyond) {
        SlotSet slots(out + (capacity - beyond + SlotSet::spare), ids_.slots());
        const uint32_t total = walk([&](uint32_t slot) { slots.add(slot); });
        if (total <= capacity - beyond) {
            slots.list(slot_set_kernels_, ids_.ids(), out);
            // Slots that were used again have later generations. Counted to the end, several are compared at once.
            uint32_t descents = 0;
            for (uint32_t i = 1; i < total; ++i) descents += out[i] < out[i - 1];
            if (descents != 0) std::sort(out, out + total);
            return total;
        }
    }
    Smallest<gphys_model_id> lowest(out, capacity);
    walk([&](uint32_t slot) { lowest.add(ids_.id(slot)); });
    return lowest.finish();
}

}  // namespace gphys
