// Exact sums and products of doubles: expansions (Shewchuk 1997), and determinants in 128-bit integers (exact.h).
#include "foundation/exact.h"

#include <cstring>

#include "foundation/compiler.h"

namespace gphys {
namespace {

struct Split {
    double high, low;
};

/// a + b without error (Knuth 1969).
Split two_sum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    const double a_part = sum - b_part;
    return {sum, (a - a_part) + (b - b_part)};
}

/// a + b without error if |a| >= |b| (Dekker 1971).
Split fast_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a as two halves of 26 bits (Veltkamp 1968).
Split halves(double a) {
    const double c = 134217729.0 * a;  // 2^27 + 1
    const double high = c - (c - a);
    return {high, a - high};
}

/// a * b without error (Dekker 1971). std::fma would be far slower on processors without it.
Split two_product(double a, double b) {
    const double product = a * b;
    const Split x = halves(a), y = halves(b);
    const double rest = ((product - x.high * y.high) - x.low * y.high) - x.high * y.low;
    return {product, x.low * y.low - rest};
}

}  // namespace

/// Exact sum of doubles: a nonoverlapping expansion that grows by one term at a time (Shewchuk 1997, theorem 10) and
/// is compressed before it exceeds its capacity.
class Accumulator {
public:
    explicit Accumulator(const Exact& start) {
        for (int i = start.size_; i-- > 0;) term_[size_++] = start.term_[i];
    }

    void add(double value) {
        if (size_ == max_terms) compress();
        int kept = 0;
        for (int i = 0; i < size_; ++i) {
            const Split sum = two_sum(value, term_[i]);
            if (sum.low != 0) term_[kept++] = sum.low;
            value = sum.high;
        }
        if (value != 0) term_[kept++] = value;
        size_ = kept;
    }

    Exact result() {
        compress();
        Exact exact;
        for (int i = size_; i-- > 0;) exact.term_[exact.size_++] = term_[i];
        return exact;
    }

private:
    /// From the largest term down, each term becomes the double nearest to the sum of the remaining ones. So the next
    /// one is at most half an ulp of it.
    void compress() {
        if (size_ == 0) return;
        int bottom = size_;
        double top = term_[size_ - 1];
        for (int i = size_ - 1; i-- > 0;) {
            const Split sum = fast_two_sum(top, term_[i]);
            top = sum.high;
            if (sum.low == 0) continue;
            term_[--bottom] = top;
            top = sum.low;
        }
        if (top != 0) term_[--bottom] = top;
        std::copy(term_ + bottom, term_ + size_, term_);
        size_ -= bottom;
        // Only an expansion that has overflowed keeps more terms; its sign is unknown.
        if (size_ > Exact::capacity) size_ = 0;
    }

    // A multiple of the length of a compressed expansion: the larger it is, the less often it is compressed.
    static constexpr int max_terms = 3 * Exact::capacity;
    int size_ = 0;
    double term_[max_terms + 1];  // smallest first
};

Exact operator+(const Exact& a, const Exact& b) {
    Accumulator sum(a);
    for (int i = b.size_; i-- > 0;) sum.add(b.term_[i]);
    return sum.result();
}

Exact operator-(const Exact& a) {
    Exact negated;
    negated.size_ = a.size_;
    for (int i = 0; i < a.size_; ++i) negated.term_[i] = -a.term_[i];
    return negated;
}

Exact operator*(const Exact& a, const Exact& b) {
    Accumulator sum{Exact()};
    for (int i = a.size_; i-- > 0;) {
        for (int k = b.size_; k-- > 0;) {
            const Split product = two_product(a.term_[i], b.term_[k]);
            sum.add(product.low);
            sum.add(product.high);
        }
    }
    return sum.result();
}

Exact operator*(double a, const Exact& b) { return Exact(a) * b; }

template <>
Exact difference_of(double a, double b) {
    return Exact(a) - Exact(b);
}
template <>
Exact minor_of(double a, double b, double c, double d) {
    return a * Exact(d) - b * Exact(c);
}
template <>
Exact determinant_of(Vec3 a, Vec3 b, Vec3 c) {
    Exact sum = a.x * minor_of<Exact>(b.y, b.z, c.y, c.z);
    sum = sum + a.y * minor_of<Exact>(b.z, b.x, c.z, c.x);
    return sum + a.z * minor_of<Exact>(b.x, b.y, c.x, c.y);
}
template <>
Exact dot_of(Vec3 a, Vec3 b) {
    Exact sum = a.x * Exact(b.x);
    sum = sum + a.y * Exact(b.y);
    return sum + a.z * Exact(b.z);
}
template <>
Exact height_of(Vec3 normal, Vec3 point, Vec3 origin) {
    Exact sum = normal.x * difference_of<Exact>(point.x, origin.x);
    sum = sum + normal.y * difference_of<Exact>(point.y, origin.y);
    return sum + normal.z * difference_of<Exact>(point.z, origin.z);
}

Vec3 difference(Vec3 a, Vec3 b, Vec3& rest) {
    const Split x = two_sum(a.x, -b.x), y = two_sum(a.y, -b.y), z = two_sum(a.z, -b.z);
    rest = {x.low, y.low, z.low};
    return {x.high, y.high, z.high};
}

bool difference_is_exact(Vec3 a, Vec3 b, Vec3& out) {
    Vec3 rest;
    out = difference(a, b, rest);
    return rest == Vec3{};
}

#if GPHYS_HAS_INT128
namespace {

constexpr int integer_bits = 41;

/// The e for which |value| is in 2^e .. 2^(e + 1); -1023 for subnormal numbers and zero.
int exponent(double value) {
    uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    return static_cast<int>(bits >> 52 & 0x7ff) - 1023;
}
double power_of_two(int exponent) {
    const uint64_t bits = static_cast<uint64_t>(exponent + 1023) << 52;
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

/// The power of two that scales numbers up to `largest` to below 2^integer_bits. Products of four such factors and
/// the determinant stay far within the range of doubles.
bool scale_to_integers(double largest, int& scale) {
    const int e = largest == 0 ? 0 : exponent(largest);
    scale = integer_bits - 1 - e;
    return -200 <= e && e <= 200;
}

bool to_integer(double value, int64_t& out) {
    out = static_cast<int64_t>(value);
    return static_cast<double>(out) == value;
}

}  // namespace

// Each axis has a scale that makes the components of b and c integers. Each term of the determinant has one component
// of every axis, so the components of a use the same scales times one common scale. With all integers below 2^41, the
// cross product is below 2^83 and the determinant below 3 * 2^124 < 2^127.
bool integer_determinant(Vec3 a, Vec3 b, Vec3 c, double& out) {
    int64_t whole_a[3], whole_b[3], whole_c[3];
    double scale_of_all = 1;
    Vec3 scaled_a;
    for (int k = 0; k < 3; ++k) {
        int scale;
        if (!scale_to_integers(std::max(std::fabs(b[k]), std::fabs(c[k])), scale)) return false;
        const double factor = power_of_two(scale);
        if (!to_integer(b[k] * factor, whole_b[k]) || !to_integer(c[k] * factor, whole_c[k])) return false;
        scale_of_all *= factor;
        scaled_a[k] = a[k] * factor;
    }
    int scale;
    if (!scale_to_integers(max_component(abs(scaled_a)), scale)) return false;
    const double factor = power_of_two(scale);
    for (int k = 0; k < 3; ++k) {
        if (!to_integer(scaled_a[k] * factor, whole_a[k])) return false;
    }
    const auto term = [&](int k, int i, int j) {
        return whole_a[k] *
               (static_cast<Int128>(whole_b[i]) * whole_c[j] - static_cast<Int128>(whole_b[j]) * whole_c[i]);
    };
    out = static_cast<double>(term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1)) / (scale_of_all * factor);
    return true;
}
#else
bool integer_determinant(Vec3, Vec3, Vec3, double&) { return false; }
#endif

int orientation(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Vec3 ab = b - a, ac = c - a, ad = d - a;
    const double volume = dot(cross(ab, ac), ad);
    // Shewchuk's static filter: (7 + 56 u) u times the permanent, u = 2^-53.
    const double permanent = (std::fabs(ab.y * ac.z) + std::fabs(ab.z * ac.y)) * std::fabs(ad.x) +
                             (std::fabs(ab.z * ac.x) + std::fabs(ab.x * ac.z)) * std::fabs(ad.y) +
                             (std::fabs(ab.x * ac.y) + std::fabs(ab.y * ac.x)) * std::fabs(ad.z);
    if (std::fabs(volume) > 8 * 0x1p-53 * permanent) return volume > 0 ? 1 : -1;
    return sign_of([&](auto number) {
        using V = Vec<decltype(number)>;
        return dot(cross(V::difference(b, a), V::difference(c, a)), V::difference(d, a));
    });
}

namespace {

/// (b - a) x (d - c) along one axis, as a polynomial for sign_of and value_of.
auto cross_component(Vec3 a, Vec3 b, Vec3 c, Vec3 d, int axis) {
    const int i = (axis + 1) % 3, k = (axis + 2) % 3;
    return [=](auto number) {
        using N = decltype(number);
        return (N(b[i]) - N(a[i])) * (N(d[k]) - N(c[k])) - (N(b[k]) - N(a[k])) * (N(d[i]) - N(c[i]));
    };
}

}  // namespace

int orientation(Vec3 a, Vec3 b, Vec3 c, int axis) { return sign_of(cross_component(a, b, a, c, axis)); }

int turning_axis(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 ab = b - a, ac = c - a;
    const Vec3 n = abs(cross(ab, ac));
    const int likely = longest_axis(n);
    // A static filter: with u = 2^-53 each of the two products has an error of 3 u of itself, their difference another
    // u of both, and 10 u covers the terms in u^2.
    if (n[likely] > 10 * 0x1p-53 * max_component(abs(ab)) * max_component(abs(ac))) return likely;
    for (int i = 0; i < 3; ++i) {
        const int axis = (likely + i) % 3;
        if (orientation(a, b, c, axis) != 0) return axis;
    }
    return -1;
}

Vec3 accurate_cross(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Vec3 p = b - a, q = d - c;
    const auto component = [&](int axis) {
        const int i = (axis + 1) % 3, k = (axis + 2) % 3;
        const double first = p[i] * q[k], second = p[k] * q[i], value = first - second;
        // The error is at most 4 u of both products, as above.
        const bool accurate = 5 * 0x1p-53 * (std::fabs(first) + std::fabs(second)) <= 0x1p-45 * std::fabs(value);
        return accurate ? value : value_of(cross_component(a, b, c, d, axis));
    };
    return {component(0), component(1), component(2)};
}

}  // namespace gphys
