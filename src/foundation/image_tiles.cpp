// Detection of the row length of an image or a lidar scan, and the tiles that follow from it (image_tiles.h).
#include "foundation/image_tiles.h"

#include <algorithm>

namespace gphys {
namespace {

/// Squared distance of two items.
struct SquaredDistance {
    const Strided<float>& items;
    uint32_t floats;

    double operator()(uint32_t i, uint32_t j) const {
        const float *a = &items[i], *b = &items[j];
        double sum = 0;
        for (uint32_t k = 0; k < floats; ++k) {
            const double difference = double{a[k]} - b[k];
            sum += difference * difference;
        }
        return sum;
    }
};

/// The item that starts the second row: the first one after a jump, or else the one nearest to the first item. A lidar
/// scan is a closed circle, so the end of its row is near its start, too.
uint32_t begin_of_row(const SquaredDistance& distance, uint32_t from, uint32_t end, double step, double near) {
    uint32_t nearest = from;
    for (uint32_t i = from; i < end && distance(0, i) <= near; ++i) {
        if (distance(i - 1, i) > 2 * step) return i;
        if (distance(0, i) < distance(0, nearest)) nearest = i;
    }
    return nearest;
}

/// The number of items in a row: they move away from the first in even steps and come back. 0 if they do not.
uint32_t row_length(const SquaredDistance& distance, uint32_t count) {
    constexpr uint32_t even_steps = 7, longest = 1 << 14, samples = 8;
    if (count < 2 * ImageTiles::most) return 0;
    const double step = distance(0, 1), near = 36 * step;
    // The first few steps reject most batches without rows.
    for (uint32_t i = 1; i < even_steps; ++i) {
        const double next = distance(i, i + 1);
        if (!(0 < next && next <= 4 * step && step <= 4 * next)) return 0;
    }
    const uint32_t end = std::min(count, longest);
    uint32_t row = 1;
    while (row < end && distance(0, row) <= near) ++row;
    while (row < end && !(distance(0, row) <= near)) ++row;
    if (row == end) return 0;
    row = begin_of_row(distance, row, end, step, near);
    // Further rows must have the same length.
    for (uint32_t k = 0; k < samples; ++k) {
        const auto i = static_cast<uint32_t>(uint64_t{count - 1 - row} * k / samples);
        if (!(distance(i, i + row) <= 4 * near)) return 0;
    }
    return row;
}

}  // namespace

ImageTiles::ImageTiles(const Strided<float>& items, uint32_t floats, uint32_t count) : count_(count) {
    const SquaredDistance distance{items, floats};
    const uint32_t row = row_length(distance, count);
    if (row == 0) return;
    row_ = row;
    width_ = 8;
    // Tiles are square in space, not in items: neighbours in a row and rows may have different distances.
    const double along = distance(0, 1), across = distance(0, row);
    const auto twice = [](double a, uint32_t as, double b, uint32_t bs) { return a * as * as > 4 * b * bs * bs; };
    while (width_ > 1 && twice(along, width_, across, height())) width_ /= 2;
    while (width_ < most && twice(across, height(), along, width_)) width_ *= 2;
    width_ = std::min(width_, row);
    in_band_ = (row + width_ - 1) / width_;
}

uint32_t ImageTiles::count() const {
    const uint64_t rows = (uint64_t{count_} + row_ - 1) / row_, bands = (rows + height() - 1) / height();
    return static_cast<uint32_t>(bands * in_band_);
}

uint32_t ImageTiles::items(uint32_t tile, uint32_t* out) const {
    const uint32_t left = tile % in_band_ * width_, right = std::min(left + width_, row_);
    const uint64_t top = uint64_t{tile / in_band_} * height();
    // Kernels take eight items at a time: those of a block of four times two are closer together than those of a row.
    const uint32_t rows = height() == 1 ? 1 : 2, columns = 8 / rows;
    uint32_t size = 0;
    for (uint32_t y = 0; y < height(); y += rows) {
        const uint64_t row = (top + y) * row_;
        for (uint32_t x = left; x < right && row + x < count_; x += columns) {
            const uint32_t last = std::min(x + columns, right), below = std::min(rows, height() - y);
            for (uint32_t v = 0; v < below; ++v) {
                const uint64_t begin = row + uint64_t{v} * row_, end = std::min<uint64_t>(begin + last, count_);
                for (uint64_t i = begin + x; i < end; ++i) out[size++] = static_cast<uint32_t>(i);
            }
        }
    }
    return size;
}

}  // namespace gphys
