// Baselines for culling, without a tree: every box against six planes and against the frustum's own box, eight boxes
// at a time; or blocks of 64 boxes that are near each other, with a box around each block that is tested first.
#include <immintrin.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "implementation.h"

namespace bench {

namespace {

/// A frustum as the tests need it: each plane with the absolute values of its normal, and the box of its corners.
struct View {
    float normal[6][3], reach[6][3], distance[6];
    float low[3], high[3];

    bool prepare(const gphys_frustum& f) {
        gphys_vec3 corners[8];
        if (gphys_frustum_corners(&f, corners) != GPHYS_OK) return false;
        for (int k = 0; k < 3; ++k) {
            low[k] = INFINITY;
            high[k] = -INFINITY;
        }
        for (const gphys_vec3& corner : corners) {
            const float c[3] = {corner.x, corner.y, corner.z};
            for (int k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], c[k]);
                high[k] = std::max(high[k], c[k]);
            }
        }
        for (int p = 0; p < 6; ++p) {
            const gphys_plane& plane = f.planes[p];
            const float n[3] = {plane.normal.x, plane.normal.y, plane.normal.z};
            const float o[3] = {f.origin.x, f.origin.y, f.origin.z};
            distance[p] = plane.distance;
            for (int k = 0; k < 3; ++k) {
                normal[p][k] = n[k];
                reach[p][k] = std::fabs(n[k]);
                distance[p] += n[k] * o[k];
            }
        }
        return true;
    }
};

/// Boxes as six arrays, padded to whole eights by boxes of negative extent, which no frustum touches.
struct Boxes {
    std::vector<float> center[3], extent[3];

    void resize(size_t count) {
        const size_t padded = (count + 7) / 8 * 8;
        for (auto& lane : center) lane.assign(padded, 0);
        for (auto& lane : extent) lane.assign(padded, -1e30f);
    }

    /// Which of the eight boxes from the i-th on touch the frustum.
    __attribute__((target("avx2"))) unsigned touched(size_t i, const View& view) const {
        unsigned mask = 0xff;
        __m256 middle[3], half[3];
        for (int k = 0; k < 3; ++k) {
            middle[k] = _mm256_loadu_ps(&center[k][i]);
            half[k] = _mm256_loadu_ps(&extent[k][i]);
        }
        for (int p = 0; p < 6 && mask; ++p) {
            // The corner that is farthest along the plane's normal: centre + |normal| * extent.
            __m256 sum = _mm256_set1_ps(-view.distance[p]);
            for (int k = 0; k < 3; ++k) {
                sum = _mm256_add_ps(sum, _mm256_mul_ps(_mm256_set1_ps(view.normal[p][k]), middle[k]));
                sum = _mm256_add_ps(sum, _mm256_mul_ps(_mm256_set1_ps(view.reach[p][k]), half[k]));
            }
            mask &= static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(sum, _mm256_setzero_ps(), _CMP_GE_OQ)));
        }
        for (int k = 0; k < 3 && mask; ++k) {
            const __m256 below =
                _mm256_cmp_ps(_mm256_add_ps(middle[k], half[k]), _mm256_set1_ps(view.low[k]), _CMP_LT_OQ);
            const __m256 above =
                _mm256_cmp_ps(_mm256_sub_ps(middle[k], half[k]), _mm256_set1_ps(view.high[k]), _CMP_GT_OQ);
            mask &= ~static_cast<unsigned>(_mm256_movemask_ps(_mm256_or_ps(below, above)));
        }
        return mask;
    }
};

/// The bits of a number of ten bits, three apart.
uint32_t spread(uint32_t x) {
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
}

class SimdSweep final : public Implementation {
public:
    explicit SimdSweep(bool in_blocks) : in_blocks_(in_blocks) {}

    bool load(const std::vector<gphys_obb>& boxes) override {
        ids_.resize(boxes.size());
        std::iota(ids_.begin(), ids_.end(), 0u);
        if (in_blocks_) sort_along_curve(boxes);
        all_.resize(boxes.size());
        for (size_t i = 0; i < boxes.size(); ++i) set(i, boxes[ids_[i]]);
        const size_t blocks = (boxes.size() + per_block - 1) / per_block;
        blocks_.resize(blocks);
        for (size_t block = 0; block < blocks; ++block) set_block(block, boxes.size());
        seen_.resize(boxes.size() + 8);
        return true;
    }

    bool cull(const gphys_frustum& frustum, uint64_t& total) override {
        View view;
        if (!view.prepare(frustum)) return false;
        uint32_t count = 0;
        if (!in_blocks_) {
            for (size_t i = 0; i < all_.center[0].size(); i += 8) add(i, view, count);
        } else {
            for (size_t i = 0; i < blocks_.center[0].size(); i += 8) {
                for (unsigned mask = blocks_.touched(i, view); mask; mask &= mask - 1) {
                    const size_t first = (i + static_cast<size_t>(__builtin_ctz(mask))) * per_block;
                    const size_t last = std::min(first + per_block, all_.center[0].size());
                    for (size_t j = first; j < last; j += 8) add(j, view, count);
                }
            }
        }
        total = count;
        return true;
    }

private:
    static constexpr size_t per_block = 64;

    void add(size_t i, const View& view, uint32_t& count) {
        for (unsigned mask = all_.touched(i, view); mask; mask &= mask - 1) {
            seen_[count++] = ids_[i + static_cast<size_t>(__builtin_ctz(mask))];
        }
    }

    /// By the Morton code of their centres.
    void sort_along_curve(const std::vector<gphys_obb>& boxes) {
        float reach = 0;
        for (const gphys_obb& b : boxes) {
            reach = std::max({reach, std::fabs(b.center.x), std::fabs(b.center.y), std::fabs(b.center.z)});
        }
        const auto cell = [&](float x) { return static_cast<uint32_t>(std::min((x / reach + 1) * 512, 1023.0f)); };
        std::vector<uint32_t> codes;
        for (const gphys_obb& b : boxes) {
            codes.push_back(spread(cell(b.center.x)) | spread(cell(b.center.y)) << 1 | spread(cell(b.center.z)) << 2);
        }
        std::sort(ids_.begin(), ids_.end(), [&](uint32_t a, uint32_t b) { return codes[a] < codes[b]; });
    }

    void set(size_t i, const gphys_obb& box) {
        const gphys_quat q = box.rotation;
        const float h[3] = {box.half_extents.x, box.half_extents.y, box.half_extents.z};
        const float r[3][3] = {
            {1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y - q.w * q.z), 2 * (q.x * q.z + q.w * q.y)},
            {2 * (q.x * q.y + q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z - q.w * q.x)},
            {2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)}};
        const float c[3] = {box.center.x, box.center.y, box.center.z};
        for (int k = 0; k < 3; ++k) {
            all_.center[k][i] = c[k];
            all_.extent[k][i] = std::fabs(r[k][0]) * h[0] + std::fabs(r[k][1]) * h[1] + std::fabs(r[k][2]) * h[2];
        }
    }

    void set_block(size_t block, size_t count) {
        const size_t first = block * per_block, last = std::min(first + per_block, count);
        for (int k = 0; k < 3; ++k) {
            float low = INFINITY, high = -INFINITY;
            for (size_t i = first; i < last; ++i) {
                low = std::min(low, all_.center[k][i] - all_.extent[k][i]);
                high = std::max(high, all_.center[k][i] + all_.extent[k][i]);
            }
            blocks_.center[k][block] = (low + high) / 2;
            blocks_.extent[k][block] = 1.000001f * (high - low) / 2;
        }
    }

    bool in_blocks_;
    Boxes all_, blocks_;
    std::vector<uint32_t> ids_, seen_;
};

}  // namespace

std::unique_ptr<Implementation> make_simd_sweep(bool in_blocks) { return std::make_unique<SimdSweep>(in_blocks); }

}  // namespace bench
