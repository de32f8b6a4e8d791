#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/interrupted.hpp"
#include "campaign/order.hpp"
#include "campaign/plan.hpp"

namespace dumbbell::campaign {

/// What a look at a result says.
struct Judgement {
    enum class Verdict {
        proved,  ///< all that the order asks for
        open,    ///< a true answer, but it leaves something undecided
        wrong,   ///< not a result of this order, or not proved
        none     ///< nobody could look: that says nothing about the result
    };
    Verdict verdict = Verdict::none;
    std::string reason;  ///< unless proved
};

/// How closely a result is looked at.
enum class Scrutiny {
    form,  ///< whether it is complete, and says what the order asks for; nothing is proved by that
    proof  ///< whether an independent check accepts all that it claims, too
};

/// What a merged file rests on.
enum class Evidence {
    file,     ///< itself: dumbbell-verify accepts it, or does not
    results,  ///< the look at each result before they are merged
    workers   ///< the word of the workers
};

/// What a campaign of one kind proves: its orders and their results. All functions may be used by several
/// threads at once.
class Kind {
  public:
    Kind() = default;
    virtual ~Kind() = default;
    Kind(const Kind&) = delete;
    Kind& operator=(const Kind&) = delete;

    [[nodiscard]] virtual Evidence evidence() const = 0;

    /// Carries an order out, on this thread; nothing if interrupted. The result depends on the order alone.
    /// `folder`: where the plan's inputs lie. Throws InputError if the order is not of this kind's making.
    [[nodiscard]] virtual std::optional<std::string> work(const Order& order, const std::string& folder,
                                                          const Interrupted& interrupted) const = 0;

    /// Whether the file, which may hold anything, is a result of this order.
    [[nodiscard]] Judgement judge(const Order& order, const std::string& folder, const std::string& file,
                                  Scrutiny scrutiny) const;

    /// The results of all shards, in the plan's order, as one.
    struct Merged {
        std::string text;
        bool is_open = false;  ///< something in it is undecided
    };
    [[nodiscard]] virtual Merged merge(const Plan& plan, const std::string& folder,
                                       const std::vector<std::string>& files) const = 0;

  protected:
    /// Of a merge: throws InputError unless the results tile the claim.
    static void require_tiling(bool tiles);
    /// As `refutation` says it: what dumbbell-verify says of the file, of which this is demanded.
    [[nodiscard]] static std::string refuted(const std::string& demand, const std::string& file);

  private:
    /// Scrutiny::form, of a file that is plain text and may be anything else: it takes no more memory than a
    /// result of this order and the file's longest part need. Throws InputError for `wrong`, too.
    [[nodiscard]] virtual Judgement form(const Order& order, const std::string& file) const = 0;

    /// Why an independent check does not accept what the file claims; empty if it does. Precondition: by its
    /// form it is a result of this order.
    [[nodiscard]] virtual std::string refutation(const Order& order, const std::string& folder,
                                                 const std::string& file) const = 0;
};

/// The kind of an order or a plan. Throws InputError if there is none of this name.
[[nodiscard]] const Kind& kind_named(std::string_view name);

}  // namespace dumbbell::campaign
