// The two methods that everybody writes first, in float32 and in plain loops.
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

class Projection : public Method {
public:
    explicit Projection(const System& system) : system_(system), velocities_(system.positions.size()) {
        for (const gphys_vec3& p : system.positions) at_.push_back({p.x, p.y, p.z});
        for (const float m : system.masses) inverse_mass_.push_back(m > 0 ? 1 / m : 0);
    }
    std::vector<gphys_vec3> positions() const override { return as_given(at_); }
    std::vector<gphys_vec3> velocities() const override { return as_given(velocities_); }

protected:
    void project(float inverse_step_squared) {
        for (const Link& link : system_.links) {
            const Vec d = at_[link.b] - at_[link.a];
            const float length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
            const float wa = inverse_mass_[link.a], wb = inverse_mass_[link.b];
            if (length == 0 || wa + wb == 0) continue;
            const float softness = static_cast<float>(link.compliance) * inverse_step_squared;
            const Vec pull = d * ((length - static_cast<float>(link.rest)) / (length * (wa + wb + softness)));
            at_[link.a] = at_[link.a] + pull * wa;
            at_[link.b] = at_[link.b] - pull * wb;
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

class Jakobsen final : public Projection {
public:
    Jakobsen(const System& system, uint32_t iterations) : Projection(system), iterations_(iterations), before_(at_) {}
    void step(float h) override {
        const float keep = std::exp(-system_.damping * h);
        for (size_t i = 0; i < at_.size(); ++i) {
            if (inverse_mass_[i] == 0) continue;
            const Vec now = at_[i];
            at_[i] = now + (now - before_[i]) * keep + Vec{0, -static_cast<float>(gravity) * h * h, 0};
            before_[i] = now;
        }
        for (uint32_t i = 0; i < iterations_; ++i) project(1 / (h * h));
        for (size_t i = 0; i < at_.size(); ++i) velocities_[i] = (at_[i] - before_[i]) * (1 / h);
    }

private:
    uint32_t iterations_;
    std::vector<Vec> before_;
};

class Xpbd final : public Projection {
public:
    Xpbd(const System& system, uint32_t substeps) : Projection(system), substeps_(substeps) {}
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
            for (size_t i = 0; i < at_.size(); ++i) velocities_[i] = (at_[i] - before[i]) * (keep / h);
        }
    }

private:
    uint32_t substeps_;
    std::vector<Vec> before_;
};

}  // namespace

std::unique_ptr<Method> make_jakobsen(const System& system, uint32_t iterations) {
    return std::make_unique<Jakobsen>(system, iterations);
}
std::unique_ptr<Method> make_xpbd(const System& system, uint32_t substeps) {
    return std::make_unique<Xpbd>(system, substeps);
}

}  // namespace bench
