// nanoflann: a k-d tree of points.
#include <cmath>
#include <nanoflann.hpp>

#include "implementation.h"

namespace bench {

namespace {

/// The form in which nanoflann takes points.
struct Cloud {
    std::vector<gphys_vec3> points;

    size_t kdtree_get_point_count() const { return points.size(); }
    float kdtree_get_pt(size_t i, size_t axis) const {
        return axis == 0 ? points[i].x : axis == 1 ? points[i].y : points[i].z;
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, uint32_t>;

class Nanoflann final : public Implementation {
public:
    bool load(const std::vector<gphys_vec3>& points) override {
        cloud_.points = points;
        tree_ = std::make_unique<Tree>(3, cloud_, nanoflann::KDTreeSingleIndexAdaptorParams(10));
        tree_->buildIndex();
        return true;
    }

    bool nearest(const std::vector<gphys_vec3>& points) override {
        if (!tree_) return false;
        answers_.resize(points.size());
        for (size_t i = 0; i < points.size(); ++i) {
            float squared = 0;
            uint32_t object = no_object;
            tree_->knnSearch(&points[i].x, 1, &object, &squared);
            answers_[i] = {std::sqrt(squared), object};
        }
        return true;
    }
    bool nearest_singly(const std::vector<gphys_vec3>& points) override { return nearest(points); }

private:
    Cloud cloud_;
    std::unique_ptr<Tree> tree_;
};

}  // namespace

std::unique_ptr<Implementation> make_nanoflann() { return std::make_unique<Nanoflann>(); }

}  // namespace bench
