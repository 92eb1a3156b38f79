// The answer of a test that may leave a question open. "No" and "yes" are certain.
#pragma once

namespace gphys {

enum class TriState { no, yes, undecided };
/// For a test of which only "no" is valid.
constexpr TriState only_no(TriState result) { return result == TriState::no ? TriState::no : TriState::undecided; }

/// Without a branch, which would be unpredictable.
constexpr TriState tri_state(bool is_no, bool is_yes) { return static_cast<TriState>(is_yes | !(is_no | is_yes) << 1); }

}  // namespace gphys
