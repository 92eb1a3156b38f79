// Contacts between bodies: the ranges of islands, joined to one list (body_contacts.h).
#include "solver/contact/body_contacts.h"

#include "solver/body_table.h"
#include "solver/islands.h"

namespace gphys {
namespace {

// Capacity for each particle. In the densest packing of equal spheres each touches 12 others, and a contact counts
// once. Contacts beyond the capacity are not listed.
constexpr size_t per_particle = 6;

bool same_pair(const BodyContact& a, const BodyContact& b) { return !(a < b) && !(b < a); }

}  // namespace

void IslandContacts::sort() const {
    std::sort(contacts_, contacts_ + *count_);
    *sorted_ = *count_;
}

uint32_t IslandContacts::add(const BodyContact& contact) const {
    const BodyContact* const end = contacts_ + *sorted_;
    const BodyContact* const found = std::lower_bound(static_cast<const BodyContact*>(contacts_), end, contact);
    if (found != end && same_pair(*found, contact)) return static_cast<uint32_t>(found - contacts_);
    if (*count_ == most_) return none;
    contacts_[*count_] = contact;
    return (*count_)++;
}

void BodyContacts::reserve(uint32_t particles) {
    // Never made smaller: the list of the last step is in it.
    if (contacts_.size() < particles * per_particle) contacts_.resize(particles * per_particle);
    counts_.resize(particles);
    sorted_counts_.resize(particles);
}

void BodyContacts::begin_step(const IdTable& ids, const BodyTable& bodies, uint32_t moving) noexcept {
    const auto wakes = [&](gphys_body_id id) { return !ids.has(id) || !bodies[IdTable::slot_of(id)].sleep.asleep; };
    const auto begin = contacts_.begin(), end = begin + static_cast<ptrdiff_t>(listed_);
    const auto kept = std::remove_if(
        begin, end, [&](const BodyContact& contact) { return wakes(contact.body_a) || wakes(contact.body_b); });
    // If bodies among them were removed, others may have more contacts than there is room for.
    asleep_ = std::min(static_cast<size_t>(kept - begin), contacts_.size() - moving * per_particle);
    std::move_backward(begin, begin + static_cast<ptrdiff_t>(asleep_), contacts_.end());
    listed_ = 0;
}

IslandContacts BodyContacts::of_island(uint32_t first_particle, uint32_t particles) {
    return {&contacts_[first_particle * per_particle], static_cast<uint32_t>(particles * per_particle),
            &counts_[first_particle], &sorted_counts_[first_particle]};
}

void BodyContacts::end_step(const Vector<Island>& islands) {
    listed_ = 0;
    const auto list = [&](size_t first, size_t count) {
        const auto from = contacts_.begin() + static_cast<ptrdiff_t>(first);
        std::move(from, from + static_cast<ptrdiff_t>(count), contacts_.begin() + static_cast<ptrdiff_t>(listed_));
        listed_ += count;
    };
    for (const Island& island : islands) {
        if (island.colliding_count > 0) list(island.first_particle * per_particle, counts_[island.first_particle]);
    }
    list(contacts_.size() - asleep_, asleep_);
}

}  // namespace gphys
