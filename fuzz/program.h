// The bytes of an input, read as a program: choices, numbers, shapes.
//
// Numbers are drawn so that things touch, coincide and nearly do. The first byte says of what kind most numbers
// of the program are (a grid, neighbours of it, roundings of sines, far out, tiny, huge), and one point in three
// is one of those that were drawn before. When the bytes have run out, everything is 0.
#pragma once

#include <gamephys_c.h>

#include <cstdint>
#include <cstring>
#include <vector>

namespace fuzz {

/// A shape in its public form. A mesh is not one: its handle stands for it.
struct AnyShape {
    gphys_shape_type type = 0;
    alignas(8) unsigned char bytes[112] = {};
    uint32_t size = 0;

    template <class Public>
    static AnyShape of(gphys_shape_type type, const Public& shape) {
        static_assert(sizeof shape <= sizeof bytes);
        AnyShape any;
        any.type = type;
        any.size = sizeof shape;
        std::memcpy(any.bytes, &shape, sizeof shape);
        return any;
    }
    template <class Public>
    Public as() const {
        Public shape;
        std::memcpy(&shape, bytes, sizeof shape);
        return shape;
    }
};

class Program {
public:
    Program(const uint8_t* bytes, size_t size);

    /// Whether all bytes have been used.
    bool done() const { return next_ == end_; }
    uint32_t byte() { return next_ < end_ ? *next_++ : 0; }
    uint32_t word();
    /// 0 .. count - 1; count at most 65536.
    uint32_t below(uint32_t count);
    bool one_in(uint32_t count) { return below(count) == count - 1; }

    /// Finite and in range.
    float number();
    /// A size or a radius: >= 0.
    float size();
    /// Any bits at all, and those that are most likely to be handled wrongly.
    float hostile();
    /// In range; often one that was drawn before.
    gphys_vec3 point();
    gphys_vec3 direction();
    gphys_quat rotation();
    gphys_transform transform();
    gphys_ray ray();
    gphys_segment segment();
    gphys_frustum frustum();
    /// One of those that a scene takes, or also a frustum.
    gphys_shape_type shape_type(bool with_frustum);
    AnyShape shape(gphys_shape_type type);
    /// Spoils one float of a struct of floats, one time in so many.
    template <class Public>
    void spoil(Public& value, uint32_t one_time_in) {
        if (!one_in(one_time_in)) return;
        const uint32_t field = below(sizeof value / 4);
        const float bad = hostile();
        std::memcpy(reinterpret_cast<char*>(&value) + 4 * field, &bad, 4);
    }
    void spoil(AnyShape& shape, uint32_t one_time_in);

    /// On a grid everything is a small whole number, and nothing is turned.
    bool on_grid() const { return style_ == Style::grid; }

private:
    enum class Style { grid, quarters, continuous, rounded, far, tiny, huge, mixed };
    float number(Style style);
    AnyShape draw_shape(gphys_shape_type type);

    const uint8_t* next_;
    const uint8_t* end_;
    Style style_;
    gphys_vec3 drawn_[16] = {};
    uint32_t drawn_count_ = 0;
};

/// Whether a shape is within the ranges beside its struct in the header: written from the header alone.
bool is_valid(const AnyShape& shape);
bool is_valid(const gphys_vec3& point);
bool is_valid(const gphys_ray& ray);
bool is_valid(const gphys_segment& segment);
bool is_valid(const gphys_transform& transform);
bool is_valid(const gphys_quat& rotation);

/// What each target defines.
void run(Program& program);
extern const char* const target_name;

}  // namespace fuzz
