// The baseline for culling: every box against six planes and against the frustum's own box, eight
// boxes at a time, no tree at all.
#include <immintrin.h>

#include <cmath>

#include "implementation.h"

namespace bench {

namespace {

class SimdSweep final : public Implementation {
public:
    bool load(const std::vector<gphys_obb>& boxes) override {
        const size_t padded = (boxes.size() + 7) / 8 * 8;
        for (auto& lane : center_) lane.assign(padded, 0);
        // Padding is a box of negative extent, which no frustum touches.
        for (auto& lane : extent_) lane.assign(padded, -1e30f);
        for (size_t i = 0; i < boxes.size(); ++i) set(i, boxes[i]);
        return true;
    }

    __attribute__((target("avx2"))) bool cull(const gphys_frustum& f, uint64_t& total) override {
        seen_.resize(center_[0].size());
        gphys_vec3 corners[8];
        if (gphys_frustum_corners(&f, corners) != GPHYS_OK) return false;
        float low[3] = {corners[0].x, corners[0].y, corners[0].z}, high[3] = {low[0], low[1], low[2]};
        for (const gphys_vec3& corner : corners) {
            const float c[3] = {corner.x, corner.y, corner.z};
            for (int k = 0; k < 3; ++k) {
                low[k] = std::fmin(low[k], c[k]);
                high[k] = std::fmax(high[k], c[k]);
            }
        }
        uint32_t count = 0;
        for (size_t i = 0; i < center_[0].size(); i += 8) {
            unsigned mask = 0xff;
            for (const gphys_plane& plane : f.planes) {
                // Farthest point along the plane's normal: centre + |normal| * extent.
                const float n[3] = {plane.normal.x, plane.normal.y, plane.normal.z};
                const float o[3] = {f.origin.x, f.origin.y, f.origin.z};
                __m256 sum = _mm256_set1_ps(-plane.distance);
                for (int k = 0; k < 3; ++k) {
                    const __m256 offset = _mm256_sub_ps(_mm256_loadu_ps(&center_[k][i]), _mm256_set1_ps(o[k]));
                    sum = _mm256_add_ps(sum, _mm256_mul_ps(_mm256_set1_ps(n[k]), offset));
                    sum = _mm256_add_ps(
                        sum, _mm256_mul_ps(_mm256_set1_ps(std::fabs(n[k])), _mm256_loadu_ps(&extent_[k][i])));
                }
                mask &= static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(sum, _mm256_setzero_ps(), _CMP_GE_OQ)));
                if (mask == 0) break;
            }
            for (int k = 0; k < 3 && mask; ++k) {
                const __m256 center = _mm256_loadu_ps(&center_[k][i]), extent = _mm256_loadu_ps(&extent_[k][i]);
                const __m256 below = _mm256_cmp_ps(_mm256_add_ps(center, extent), _mm256_set1_ps(low[k]), _CMP_LT_OQ);
                const __m256 above = _mm256_cmp_ps(_mm256_sub_ps(center, extent), _mm256_set1_ps(high[k]), _CMP_GT_OQ);
                mask &= ~static_cast<unsigned>(_mm256_movemask_ps(_mm256_or_ps(below, above)));
            }
            for (; mask; mask &= mask - 1) {
                seen_[count++] = static_cast<uint32_t>(i) + static_cast<uint32_t>(__builtin_ctz(mask));
            }
        }
        total = count;
        return true;
    }

private:
    void set(size_t i, const gphys_obb& box) {
        const gphys_quat q = box.rotation;
        const float h[3] = {box.half_extents.x, box.half_extents.y, box.half_extents.z};
        const float r[3][3] = {
            {1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y - q.w * q.z), 2 * (q.x * q.z + q.w * q.y)},
            {2 * (q.x * q.y + q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z - q.w * q.x)},
            {2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)}};
        const float c[3] = {box.center.x, box.center.y, box.center.z};
        for (int k = 0; k < 3; ++k) {
            center_[k][i] = c[k];
            extent_[k][i] = std::fabs(r[k][0]) * h[0] + std::fabs(r[k][1]) * h[1] + std::fabs(r[k][2]) * h[2];
        }
    }

    std::vector<float> center_[3], extent_[3];
    std::vector<uint32_t> seen_;
};

}  // namespace

std::unique_ptr<Implementation> make_simd_sweep() { return std::make_unique<SimdSweep>(); }

}  // namespace bench
