// Sums of impulses by model (impulse_sums.h).
#include "solver/contact/impulse_sums.h"

namespace gphys {

void ImpulseSums::sum() {
    std::sort(parts_.begin(), parts_.end());
    for (uint32_t i = 0; i < parts_.size(); ++i) {
        if (i == 0 || parts_[i].impulse.model != parts_[i - 1].impulse.model)
            sums_.push_back({parts_[i].impulse, i, i, 0});
        sums_.back().end = i + 1;
    }
    for (Sum& sum : sums_) sum_parts(sum);
}

void ImpulseSums::sum_parts(Sum& sum) const {
    sum.parts = 0;
    for (uint32_t i = sum.first; i < sum.end; ++i) {
        if (parts_[i].slot == taken_out) continue;
        const ModelImpulse& impulse = parts_[i].impulse;
        if (sum.parts++ == 0) {
            sum.total = impulse;
        } else {
            sum.total.linear += impulse.linear;
            sum.total.angular += impulse.angular;
        }
    }
}

void ImpulseSums::remove(uint32_t slot, const Vector<ModelImpulse>& impulses) {
    const auto before = [](const Sum& sum, gphys_model_id model) { return sum.total.model < model; };
    for (const ModelImpulse& impulse : impulses) {
        Sum& sum = *std::lower_bound(sums_.begin(), sums_.end(), impulse.model, before);
        for (uint32_t i = sum.first; i < sum.end; ++i) {
            if (parts_[i].slot == slot) parts_[i].slot = taken_out;
        }
        sum_parts(sum);
    }
}

}  // namespace gphys
