// Minimum degree ordering on a quotient graph (George & Liu 1989, "The evolution of the minimum degree ordering
// algorithm"). The notation and the treatment of dense rows are those of Amestoy, Davis & Duff 1996, "An approximate
// minimum degree ordering algorithm". An eliminated node becomes an element: the list of the nodes that its elimination
// has made neighbours, instead of the edges between all of them. The neighbours of a node and the elements that it is
// in never take more memory than its edges did. Degrees are exact, not approximate: graphs of bodies are small or
// nearly trees, and with exact degrees the order depends on the graph alone.
#include "solver/joints/elimination_order.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "foundation/floating_point.h"

namespace gphys {
namespace {

/// A node with more neighbours than this is dense. Each elimination next to it would read its whole list, which takes
/// n^2 in a star. Eliminating it last adds no fill (Amestoy, Davis & Duff 2004, "Algorithm 837").
size_t most_neighbours(uint32_t nodes) {
    return static_cast<size_t>(std::max(16.0, 10 * std::sqrt(static_cast<double>(nodes))));
}

struct Candidate {
    uint32_t degree, node;

    bool operator<(const Candidate& other) const {
        return degree != other.degree ? degree > other.degree : node > other.node;
    }
};

class QuotientGraph {
public:
    QuotientGraph(uint32_t nodes, const Vector<Edge>& edges, std::pmr::memory_resource* memory)
        : nodes_(nodes, Node{}, memory),
          lists_(memory),
          members_(memory),
          found_(memory),
          in_pivot_(nodes, 0u, memory),
          counted_(nodes, 0u, memory),
          next_(std::less<Candidate>{}, Vector<Candidate>(memory)) {
        list_neighbours(edges);
    }

    void order(Vector<uint32_t>& order) {
        order.clear();
        for (uint32_t n = 0; n < nodes_.size(); ++n) {
            if (nodes_[n].state == State::variable) next_.push({nodes_[n].degree, n});
        }
        while (!next_.empty()) {
            const Candidate candidate = next_.top();
            next_.pop();
            const Node& node = nodes_[candidate.node];
            if (node.state != State::variable || node.degree != candidate.degree) continue;  // outdated entry
            eliminate(candidate.node);
            order.push_back(candidate.node);
        }
        const std::ptrdiff_t sparse = static_cast<std::ptrdiff_t>(order.size());
        for (uint32_t n = 0; n < nodes_.size(); ++n) {
            if (nodes_[n].state == State::dense) order.push_back(n);
        }
        std::sort(order.begin() + sparse, order.end(), [&](uint32_t a, uint32_t b) {
            return nodes_[a].degree != nodes_[b].degree ? nodes_[a].degree < nodes_[b].degree : a < b;
        });
    }

private:
    enum class State : uint8_t { variable, element, absorbed, dense };
    struct Node {
        State state = State::variable;
        uint32_t degree = 0;
        // For a variable, in lists_: the neighbours that are in no common element, then the elements that it is in.
        size_t begin = 0;
        uint32_t neighbour_count = 0, element_count = 0;
        // For an element, in members_.
        size_t members_begin = 0, members_end = 0;
    };

    void list_neighbours(const Vector<Edge>& edges) {
        Vector<size_t> begin(nodes_.size() + 1, 0, lists_.get_allocator().resource());
        for (const Edge& edge : edges) {
            ++begin[edge.a + 1];
            ++begin[edge.b + 1];
        }
        for (size_t n = 0; n < nodes_.size(); ++n) begin[n + 1] += begin[n];
        lists_.resize(begin.back());
        for (size_t n = 0; n < nodes_.size(); ++n) nodes_[n].begin = begin[n];
        for (const Edge& edge : edges) {
            lists_[begin[edge.a]++] = edge.b;
            lists_[begin[edge.b]++] = edge.a;
        }
        const auto of = [&](size_t place) { return lists_.begin() + static_cast<std::ptrdiff_t>(place); };
        for (size_t n = 0; n < nodes_.size(); ++n) {
            std::sort(of(nodes_[n].begin), of(begin[n]));
            const auto end = std::unique(of(nodes_[n].begin), of(begin[n]));
            nodes_[n].neighbour_count = nodes_[n].degree = static_cast<uint32_t>(end - of(nodes_[n].begin));
        }
        const size_t most = most_neighbours(static_cast<uint32_t>(nodes_.size()));
        for (Node& node : nodes_) {
            if (node.degree > most) node.state = State::dense;
        }
        // Dense nodes are in no other node's list.
        for (Node& node : nodes_) {
            if (node.state == State::dense) continue;
            keep_neighbours(node, [&](uint32_t n) { return nodes_[n].state != State::dense; });
            node.degree = node.neighbour_count;
        }
    }

    /// Keeps the neighbours with keep(node). The elements, which are stored behind them, move up.
    template <class Keep>
    void keep_neighbours(Node& node, Keep&& keep) {
        uint32_t* const list = lists_.data() + node.begin;
        uint32_t* const end = list + node.neighbour_count;
        uint32_t* const kept = std::remove_if(list, end, [&](uint32_t n) { return !keep(n); });
        std::copy(end, end + node.element_count, kept);
        node.neighbour_count = static_cast<uint32_t>(kept - list);
    }

    /// Calls visit(variable) for all neighbours of a variable, for some of them several times.
    template <class Visit>
    void each_neighbour(const Node& node, uint32_t but_element, Visit&& visit) const {
        const uint32_t* const list = lists_.data() + node.begin;
        for (uint32_t i = 0; i < node.neighbour_count; ++i) visit(list[i]);
        for (uint32_t i = 0; i < node.element_count; ++i) {
            const uint32_t element = list[node.neighbour_count + i];
            if (element == but_element) continue;
            const Node& of = nodes_[element];
            for (size_t m = of.members_begin; m < of.members_end; ++m) visit(members_[m]);
        }
    }

    void eliminate(uint32_t pivot) {
        Node& node = nodes_[pivot];
        const uint32_t round = ++round_;
        in_pivot_[pivot] = round;
        const size_t begin = members_.size();
        found_.clear();
        each_neighbour(node, none, [&](uint32_t n) {
            if (in_pivot_[n] == round) return;
            in_pivot_[n] = round;
            found_.push_back(n);
        });
        members_.insert(members_.end(), found_.begin(), found_.end());
        const uint32_t* const list = lists_.data() + node.begin;
        for (uint32_t i = 0; i < node.element_count; ++i) {
            nodes_[list[node.neighbour_count + i]].state = State::absorbed;
        }
        node.state = State::element;
        node.members_begin = begin;
        node.members_end = members_.size();
        for (size_t m = begin; m < node.members_end; ++m) join(members_[m], pivot, round);
        const uint32_t others = static_cast<uint32_t>(node.members_end - begin);
        for (size_t m = begin; m < node.members_end; ++m) count_neighbours(members_[m], pivot, others - 1);
    }

    /// The new element of a variable takes the place of an edge, or of an element that it has absorbed.
    void join(uint32_t variable, uint32_t element, uint32_t round) {
        Node& node = nodes_[variable];
        uint32_t* const elements = lists_.data() + node.begin + node.neighbour_count;
        uint32_t* const end = std::remove_if(elements, elements + node.element_count,
                                             [&](uint32_t e) { return nodes_[e].state == State::absorbed; });
        node.element_count = static_cast<uint32_t>(end - elements);
        keep_neighbours(node, [&](uint32_t n) { return in_pivot_[n] != round; });
        lists_[node.begin + node.neighbour_count + node.element_count++] = element;
    }

    void count_neighbours(uint32_t variable, uint32_t pivot, uint32_t in_element) {
        Node& node = nodes_[variable];
        const uint32_t stamp = ++stamp_;
        counted_[variable] = stamp;
        uint32_t degree = in_element;
        each_neighbour(node, pivot, [&](uint32_t n) {
            if (in_pivot_[n] == round_ || counted_[n] == stamp) return;
            counted_[n] = stamp;
            ++degree;
        });
        node.degree = degree;
        next_.push({degree, variable});
    }

    static constexpr uint32_t none = 0xffffffff;

    Vector<Node> nodes_;
    Vector<uint32_t> lists_, members_, found_;
    Vector<uint32_t> in_pivot_, counted_;  // by node: the last round, or stamp, that visited it
    uint32_t round_ = 0, stamp_ = 0;
    std::priority_queue<Candidate, Vector<Candidate>> next_;
};

}  // namespace

void order_by_degree(uint32_t nodes, const Vector<Edge>& edges, Vector<uint32_t>& order) {
    QuotientGraph(nodes, edges, order.get_allocator().resource()).order(order);
}

}  // namespace gphys
