#include <dumbbell/certify.hpp>

#include "python/exact.hpp"
#include "python/module.hpp"
#include "python/proof.hpp"

namespace py = pybind11;

namespace dumbbell::python {
namespace {

using api::MassRatio;
using api::Piece;
using api::Proof;

constexpr const char* certificate_text =
    R"(A proof of the greatest number of collisions, as the text that the verifier checks.

>>> Certificate(certify(10).bytes)
<Certificate: --ratio 10 --exactly 4>

What is read from bytes, or from a file by its name, is verified first. InputError: it is not verified.
)";

constexpr const char* certify_text =
    R"(Proves the greatest number of collisions N(q) for a mass ratio, or for every one of a range; or that of a body.

>>> certify(10)
<Certificate: --ratio 10 --exactly 4>
>>> stairs = certify((1, 100))
>>> stairs.lower, stairs.upper
(2, 10)
>>> certify(4.6) == certify('4.6')  # a float is its exact value, a decimal in text is as written
False
>>> certify(coin=True), certify(10, rod_mass='1/100').upper
(<Certificate: --coin --exactly 4>, 5)

`q` is exact: an int, a Fraction, a Decimal, a float (its exact value), text such as '9/2', '4.6' or '1:100', or a pair
(lo, hi). Below 1 the masses are swapped. `section`: 'turning', 'full' or 'plain'. `gap`: the relative width of the
gaps at the steps of a range. `budget`: seconds; what is not decided by then is open. A rigid body, in a plane: `rho`
and `inertia`, a number or a pair; or `coin`; or `q` with `rod_mass`, the dumbbell whose rod has so many times the mass
of its ends.
)";

constexpr const char* certify_many_text =
    R"(Proves N(q) for each of many mass ratios, on `jobs` threads: a list in their order.

>>> [certificate.upper for certificate in certify_many([10, '9/2', 1e6])]
[4, 3, 887]
)";

py::tuple ratio_of(const std::string& lo, const std::string& hi) {
    return py::make_tuple(fraction(lo), fraction(hi));
}

py::tuple pieces_of(const Proof& proof) {
    py::tuple pieces(proof.pieces.size());
    for (std::size_t i = 0; i < proof.pieces.size(); ++i) {
        const Piece& piece = proof.pieces[i];
        pieces[i] = py::make_tuple(fraction(piece.lo), fraction(piece.hi), piece.least, piece.most);
    }
    return pieces;
}

/// Of a file that says something false there is none.
Proof read(const Content& file, const Whole& jobs) {
    Proof proof = api::read_proof(file.value);
    const api::Verification found = verify_itself(proof, jobs);
    if (!found && found.verdict != api::Verdict::open) {
        throw api::InputError("not a certificate of N(q) that the verifier verifies: " + found.text);
    }
    return proof;
}

/// What is meant, if it is a body.
std::optional<api::Body> body_of(const std::optional<Number>& q, const std::optional<Number>& rho,
                                 const std::optional<Number>& inertia, bool coin,
                                 const std::optional<Number>& rod_mass) {
    if (coin + rod_mass.has_value() + (rho || inertia) > 1 || rho.has_value() != inertia.has_value() ||
        q.has_value() == (coin || rho)) {
        throw api::InputError("give q, or q and rod_mass, or rho and inertia, or coin=True");
    }
    return coin       ? std::optional(api::Body{"1", "4"})
           : rod_mass ? std::optional(api::body_of_rod(MassRatio(q->value), rod_mass->value))
           : rho      ? std::optional(api::Body{rho->value, inertia->value})
                      : std::nullopt;
}

api::CertifyOptions options_of(api::Section section, const Number& gap, const Whole& jobs) {
    return {.gap = gap.value, .jobs = jobs, .section = section};
}

Proof certify(const std::optional<Number>& q, api::Section section, const Number& gap, const Whole& jobs,
              const Budget& budget, const std::optional<Number>& rho, const std::optional<Number>& inertia,
              const Truth& coin, const std::optional<Number>& rod_mass) {
    const auto body = body_of(q, rho, inertia, coin.value, rod_mass);
    const auto ratio = body ? std::nullopt : std::optional<MassRatio>(q->value);
    return running(options_of(section, gap, jobs), budget, [&](const auto& options) {
        return body ? api::certify(*body, options) : api::certify(*ratio, options);
    });
}

std::vector<Proof> certify_many(const Numbers& ratios, api::Section section, const Number& gap,
                                const Whole& jobs, const Budget& budget) {
    std::vector<MassRatio> all;
    for (const std::string& q : ratios.value) {
        all.emplace_back(q);
        if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
        }
    }
    return running(options_of(section, gap, jobs), budget,
                   [&](const auto& options) { return api::certify_many(all, options); });
}

template <class Function, class... More>
void add(py::module_& module, const char* name, Function function, const char* text, const auto& given,
         const More&... more) {
    module.def(name, function, text, given, py::kw_only(), py::arg("section") = api::Section::turning,
               py::arg("gap") = "1e-6", py::arg("jobs") = 1, py::arg("budget") = py::none(), more...);
}

}  // namespace

void add_certify(py::module_& module) {
    certificate_class<Proof>(module, "Certificate", certificate_text)
        .def(py::init(&read), py::arg("file"), py::kw_only(), py::arg("jobs") = 1)
        .def(py::pickle([](const Proof& p) { return py::bytes(p.certificate); },
                        [](const py::bytes& text) { return api::read_proof(text.cast<std::string>()); }))
        .def_property_readonly(
            "ratio", [](const Proof& p) { return ratio_of(p.pieces.front().lo, p.pieces.back().hi); },
            "the pair (lo, hi) of Fractions; of bodies that of their Q")
        .def_readonly("scene", &Proof::scene, "'dumbbell' or 'body'")
        .def_property_readonly(
            "rho", [](const Proof& p) { return p.rho.empty() ? py::object(py::none()) : fraction(p.rho); },
            "of bodies a Fraction; else None")
        .def_property_readonly("lower", &Proof::least, "N(q) is at least this, for every q")
        .def_property_readonly("upper", &Proof::most, "and at most this; None: a piece is open")
        .def_property_readonly("pieces", pieces_of, "(lo, hi, lower, upper) of each, in order")
        .def(
            "save", [](const Proof& p, const Path& path) { api::save(p, path.value); },
            "Writes the file (NAME.gz: compressed), whole or not at all.", py::arg("path"))
        .def("svg", static_cast<std::string (*)(const Proof&)>(api::picture),
             "The staircase of a range, with the source paper's bound; the orbit of a ratio.")
        .def(
            "__eq__", [](const Proof& a, const Proof& b) { return a.certificate == b.certificate; },
            py::is_operator())
        .def("__hash__", [](const Proof& p) { return py::hash(py::str(p.sha256)); });
    const auto none = [](const char* name) { return py::arg(name) = py::none(); };
    add(module, "certify", certify, certify_text, none("q"), none("rho"), none("inertia"),
        py::arg("coin") = false, none("rod_mass"));
    add(module, "certify_many", certify_many, certify_many_text, py::arg("ratios"));
}

}  // namespace dumbbell::python
