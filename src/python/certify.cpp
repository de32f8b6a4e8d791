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
    R"(A proof of N(q), as the text that the verifier checks.

>>> Certificate(certify(10).bytes)
<Certificate of 10/1: N = 4>

What is read from bytes, or from a file by its name, is verified first. InputError: it is not verified.
)";

constexpr const char* certify_text =
    R"(Proves the greatest number of collisions N(q) for a mass ratio, or for every one of a range.

>>> certify(10)
<Certificate of 10/1: N = 4>
>>> stairs = certify((1, 100))
>>> stairs.lower, stairs.upper
(2, 10)
>>> certify(4.6) == certify('4.6')  # a float is its exact value, a decimal in text is as written
False

`q` is exact: an int, a Fraction, a Decimal, a float (its exact value), text such as '9/2', '4.6' or '1:100', or a pair
(lo, hi). Below 1 the masses are swapped. `section`: 'turning', 'full' or 'plain'. `gap`: the relative width of the gaps
at the steps of a range. `budget`: seconds; what is not decided by then is open.
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

std::string ratio_text(const Proof& proof) {
    const std::string &lo = proof.pieces.front().lo, &hi = proof.pieces.back().hi;
    return lo == hi ? lo : lo + ":" + hi;
}

std::string described(const Proof& proof) {
    const long least = proof.least();
    const auto most = proof.most();
    const std::string bounds = !most            ? "N >= " + std::to_string(least) + ", open"
                               : *most == least ? "N = " + std::to_string(least)
                                                : std::to_string(least) + " <= N <= " + std::to_string(*most);
    return "<Certificate of " + ratio_text(proof) + ": " + bounds + ">";
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

api::CertifyOptions certify_options(const Word& section, const Number& gap, const Whole& jobs,
                                    const Budget& budget) {
    auto options = within(api::CertifyOptions{.gap = gap.value, .jobs = jobs}, budget);
    if (section.value == "full" || section.value == "plain") {
        options.section = section.value == "full" ? api::Section::full : api::Section::plain;
    } else if (section.value != "turning") {
        throw api::InputError("section is 'turning', 'full' or 'plain'");
    }
    return options;
}

Proof certify(const Number& q, const Word& section, const Number& gap, const Whole& jobs,
              const Budget& budget) {
    const MassRatio ratio(q.value);
    api::CertifyOptions options = certify_options(section, gap, jobs, budget);
    return running([&](const api::Stopped& stopped) {
        options.stopped = stopped;
        return api::certify(ratio, options);
    });
}

std::vector<Proof> certify_many(const Numbers& ratios, const Word& section, const Number& gap,
                                const Whole& jobs, const Budget& budget) {
    std::vector<MassRatio> all;
    for (const std::string& q : ratios.value) {
        all.emplace_back(q);
        if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
        }
    }
    api::CertifyOptions options = certify_options(section, gap, jobs, budget);
    return running([&](const api::Stopped& stopped) {
        options.stopped = stopped;
        return api::certify_many(all, options);
    });
}

template <class Function>
void add(py::module_& module, const char* name, Function function, const char* text, const char* given) {
    module.def(name, function, text, py::arg(given), py::kw_only(), py::arg("section") = "turning",
               py::arg("gap") = "1e-6", py::arg("jobs") = 1, py::arg("budget") = py::none());
}

}  // namespace

void add_certify(py::module_& module) {
    certificate_class<Proof>(module, "Certificate", certificate_text)
        .def(py::init(&read), py::arg("file"), py::kw_only(), py::arg("jobs") = 1)
        .def(py::pickle([](const Proof& p) { return py::bytes(p.certificate); },
                        [](const py::bytes& text) { return api::read_proof(text.cast<std::string>()); }))
        .def_property_readonly(
            "ratio", [](const Proof& p) { return ratio_of(p.pieces.front().lo, p.pieces.back().hi); },
            "the pair (lo, hi) of Fractions")
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
        .def("__hash__", [](const Proof& p) { return py::hash(py::str(p.sha256)); })
        .def("__repr__", described);
    add(module, "certify", certify, certify_text, "q");
    add(module, "certify_many", certify_many, certify_many_text, "ratios");
}

}  // namespace dumbbell::python
