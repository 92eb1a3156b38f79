// Numbers that are what they must be: what JavaScript, koffi or WebAssembly would turn into others is refused.

const word = 2 ** 32;

function refuse(value, name, expected) {
    if (typeof value !== 'number') throw new TypeError(`${name}: expected a number, got ${String(value)}`);
    throw new RangeError(`${name} ${value} is not ${expected}`);
}

/** An id, an index or a number of something. */
export const whole = (value, name) => (typeof value === 'number' && value >>> 0 === value ? value : refuse(value, name, `a whole number from 0 to ${word - 1}`));

/** A set of bits, which JavaScript's operators give with a sign. */
export const bits = (value, name) =>
    typeof value === 'number' && (value >>> 0 === value || (value | 0) === value) ? value >>> 0 : refuse(value, name, 'a set of 32 bits');

/** One of an enumeration's. */
export const signed = (value, name) => (typeof value === 'number' && (value | 0) === value ? value : refuse(value, name, 'a whole number of 32 bits'));

/** Yes or no, also as 1 or 0. */
export const flag = (value, name) => (typeof value === 'boolean' ? +value : signed(value, name));

export const real = (value, name) => (typeof value === 'number' ? value : refuse(value, name));
