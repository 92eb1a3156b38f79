// The methods that everybody writes first, in float32 and in plain loops.
#include <algorithm>
#include <cmath>

#include "solver.h"

namespace bench {

namespace {

struct Vec {
    float x = 0, y = 0, z = 0;
};
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(Vec a, float s) { return {a.x * s, a.y * s, a.z * s}; }
float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

class Baseline : public Method {
public:
    explicit Baseline(const System& system) : system_(system), velocities_(system.positions.size()) {
        for (const gphys_vec3& p : system.positions) at_.push_back({p.x, p.y, p.z});
        for (const float m : system.masses) inverse_mass_.push_back(m > 0 ? 1 / m : 0);
    }
    std::vector<gphys_vec3> positions() const override { return as_given(at_); }
    std::vector<gphys_vec3> velocities() const override { return as_given(velocities_); }

protected:
    void project(float inverse_step_squared) {
        for (const Link& link : system_.links) {
            const Vec d = at_[link.b] - at_[link.a];
            const float length = std::sqrt(dot(d, d));
            const float wa = inverse_mass_[link.a], wb = inverse_mass_[link.b];
            if (length == 0 || wa + wb == 0) continue;
            const float softness = static_cast<float>(link.compliance) * inverse_step_squared;
            const Vec pull = d * ((length - static_cast<float>(link.rest)) / (length * (wa + wb + softness)));
            at_[link.a] = at_[link.a] + pull * wa;
            at_[link.b] = at_[link.b] - pull * wb;
        }
    }

    void push_out_of_post() {
        const float least = static_cast<float>(system_.post);
        for (size_t i = 0; least > 0 && i < at_.size(); ++i) {
            const float away = std::hypot(at_[i].x, at_[i].y);
            if (away >= least) continue;
            at_[i].x *= least / away;
            at_[i].y *= least / away;
        }
    }

    System system_;
    std::vector<Vec> at_, velocities_;
    std::vector<float> inverse_mass_;

private:
    static std::vector<gphys_vec3> as_given(const std::vector<Vec>& from) {
        std::vector<gphys_vec3> out;
        for (const Vec v : from) out.push_back({v.x, v.y, v.z});
        return out;
    }
};

class Jakobsen final : public Baseline {
public:
    Jakobsen(const System& system, uint32_t iterations) : Baseline(system), iterations_(iterations), before_(at_) {}
    void step(float h) override {
        const float keep = std::exp(-system_.damping * h);
        for (size_t i = 0; i < at_.size(); ++i) {
            if (inverse_mass_[i] == 0) continue;
            const Vec now = at_[i];
            at_[i] = now + (now - before_[i]) * keep + Vec{0, -static_cast<float>(gravity) * h * h, 0};
            before_[i] = now;
        }
        for (uint32_t i = 0; i < iterations_; ++i) {
            project(1 / (h * h));
            push_out_of_post();
        }
        for (size_t i = 0; i < at_.size(); ++i) velocities_[i] = (at_[i] - before_[i]) * (1 / h);
    }

private:
    uint32_t iterations_;
    std::vector<Vec> before_;
};

class Xpbd final : public Baseline {
public:
    Xpbd(const System& system, uint32_t substeps) : Baseline(system), substeps_(substeps) {}
    void step(float seconds) override {
        const float h = seconds / static_cast<float>(substeps_), keep = std::exp(-system_.damping * h);
        for (uint32_t substep = 0; substep < substeps_; ++substep) {
            const std::vector<Vec>& before = before_ = at_;
            for (size_t i = 0; i < at_.size(); ++i) {
                if (inverse_mass_[i] == 0) continue;
                velocities_[i].y -= static_cast<float>(gravity) * h;
                at_[i] = at_[i] + velocities_[i] * h;
            }
            project(1 / (h * h));
            push_out_of_post();
            for (size_t i = 0; i < at_.size(); ++i) velocities_[i] = (at_[i] - before[i]) * (keep / h);
        }
    }

private:
    uint32_t substeps_;
    std::vector<Vec> before_;
};

/// Links are springs with dashpots. Rigid ones are as stiff as both schemes bear: with w the highest frequency of the
/// system and h the substep, w^2 h^2 is at most 2/3, and dashpots of 2 h seconds times the stiffness damp each mode.
class Euler final : public Baseline {
public:
    Euler(const System& system, uint32_t substeps, bool is_explicit)
        : Baseline(system), substeps_(substeps), is_explicit_(is_explicit), forces_(system.positions.size()) {
        std::vector<float> degree(system.positions.size());
        for (const Link& link : system.links) ++degree[link.a], ++degree[link.b];
        most_links_ = *std::max_element(degree.begin(), degree.end());
    }
    void step(float seconds) override {
        const float h = seconds / static_cast<float>(substeps_), keep = std::exp(-system_.damping * h);
        for (uint32_t substep = 0; substep < substeps_; ++substep) {
            std::fill(forces_.begin(), forces_.end(), Vec{});
            for (const Link& link : system_.links) pull(link, h);
            for (size_t i = 0; i < at_.size(); ++i) {
                if (inverse_mass_[i] == 0) continue;
                const Vec old = velocities_[i];
                const Vec acceleration = forces_[i] * inverse_mass_[i] + Vec{0, -static_cast<float>(gravity), 0};
                velocities_[i] = (old + acceleration * h) * keep;
                at_[i] = at_[i] + (is_explicit_ ? old : velocities_[i]) * h;
            }
        }
    }

private:
    void pull(const Link& link, float h) {
        const Vec d = at_[link.b] - at_[link.a];
        const float length = std::sqrt(dot(d, d)), weights = inverse_mass_[link.a] + inverse_mass_[link.b];
        if (length == 0 || weights == 0) return;
        const float stiffest = 1 / (3 * h * h * most_links_ * weights);
        const float stiffness =
            link.compliance > 0 ? std::min(stiffest, 1 / static_cast<float>(link.compliance)) : stiffest;
        const float speed = dot(velocities_[link.b] - velocities_[link.a], d) / length;
        const Vec force = d * (stiffness * (length - static_cast<float>(link.rest) + 2 * h * speed) / length);
        forces_[link.a] = forces_[link.a] + force;
        forces_[link.b] = forces_[link.b] - force;
    }

    uint32_t substeps_;
    bool is_explicit_;
    float most_links_ = 0;
    std::vector<Vec> forces_;
};

}  // namespace

std::unique_ptr<Method> make_jakobsen(const System& system, uint32_t iterations) {
    return std::make_unique<Jakobsen>(system, iterations);
}
std::unique_ptr<Method> make_xpbd(const System& system, uint32_t substeps) {
    return std::make_unique<Xpbd>(system, substeps);
}
std::unique_ptr<Method> make_explicit_euler(const System& system, uint32_t substeps) {
    return std::make_unique<Euler>(system, substeps, true);
}
std::unique_ptr<Method> make_semi_implicit_euler(const System& system, uint32_t substeps) {
    return std::make_unique<Euler>(system, substeps, false);
}

}  // namespace bench
