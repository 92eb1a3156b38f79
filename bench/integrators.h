// The integrators of the Game Physics Cookbook as they stand there (chapter 14), for one coordinate of a particle: what
// our own solver is compared with. Steps are in seconds, `acceleration` is a function of the position.
#pragma once

namespace bench::book {

/// Position and velocity at the same time.
template <class Number>
struct Moving {
    Number position, velocity;
};

/// Explicit Euler: the position moves by the old velocity.
template <class Number, class Acceleration>
void explicit_euler(Moving<Number>& p, Number step, const Acceleration& acceleration) {
    const Number a = acceleration(p.position);
    p.position = p.position + p.velocity * step;
    p.velocity = p.velocity + a * step;
}

/// Semi-implicit Euler: the position moves by the new velocity.
template <class Number, class Acceleration>
void semi_implicit_euler(Moving<Number>& p, Number step, const Acceleration& acceleration) {
    p.velocity = p.velocity + acceleration(p.position) * step;
    p.position = p.position + p.velocity * step;
}

/// Verlet's scheme on positions, as Jakobsen (2001) has it: the velocity is implied by the last two positions.
template <class Number>
struct Verlet {
    Number position, old_position;
};
template <class Number, class Acceleration>
void verlet(Verlet<Number>& p, Number step, const Acceleration& acceleration) {
    const Number velocity = p.position - p.old_position;
    p.old_position = p.position;
    p.position = p.position + velocity + acceleration(p.position) * step * step;
}

}  // namespace bench::book
