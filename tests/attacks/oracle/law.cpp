#include "law.hpp"

namespace dumbbell_oracle::law {

using D = Digits80;

Derivatives derivatives(const D& f, const D& q) {
    const D r = f * f - q * q;
    const D r1 = 1 / sqrt(r);
    const D r3 = r1 / r;
    const D r5 = r3 / r;
    const D r7 = r5 / r;
    const D r9 = r7 / r;
    const D f2 = f * f;
    return {
        D(-q * (r1 / f2 + r3)), D(q * (2 * r1 / (f2 * f) + r3 / f + 3 * f * r5)),
        D(-q * (6 * r1 / (f2 * f2) + 3 * r3 / f2 + 15 * f2 * r7)),
        D(q * (24 * r1 / (f2 * f2 * f) + 12 * r3 / (f2 * f) + 9 * r5 / f - 30 * f * r7 + 105 * f2 * f * r9))};
}

Range first_part(const D& U, const D& d, const D& Q) {
    const D f = pi<D>() - U;
    const D dd = d * d;
    const Derivatives at = derivatives(f, Q);
    const Derivatives below = derivatives(f - d, Q);
    const Derivatives above = derivatives(f + d, Q);
    const Range i2 = Range(D(1) / 3) * up_to_1(3 * dd / 10);
    const Range j1 = Range(D(1) / 3) * up_to_1(dd / 10);
    const Range i4 = Range(dd / 5) * up_to_1(dd / 2);
    const Range j3 = Range(dd / 5) * up_to_1(dd / 6);
    return Range(sin(U)) * (Range(at.g2) * i2 + Range(below.g4, above.g4) * i4 * Range(D(1) / 12)) -
           Range(2 * cos(U)) * (Range(at.g1) * j1 + Range(below.g3, above.g3) * j3 * Range(D(1) / 6));
}

Layer layer(const D& U, const D& rho, const D& Q) {
    const D d = rho * U;
    const D f = pi<D>() - U;
    const D cos_th = Q / f;
    const D sin_th = sqrt(1 - cos_th * cos_th);
    const D u = (1 + rho) * U;
    const D v = (1 - rho) * U;
    Layer out;
    out.ehat = sinc(d) * sinc(U) * cos_th / (sin_th * f);
    const D& e = out.ehat;
    const D b = e / ((1 + rho) * sinc(u));
    const D b_v = e / ((1 - rho) * sinc(v));
    const D c = 1 / sqrt(1 + d * d * b * b);
    const D c_v = 1 / sqrt(1 + d * d * b_v * b_v);
    const D sin_share = rho * sinc(d) / sinc(U);  // sin d / sin U
    const D less = 1 - rho * rho;
    const D sincs = sinc(D(2 * U)) * sinc(D(2 * d));
    const D kc = c * c * c_v * c_v / (c + c_v) * 4 * e * e * sincs / pow(less * sinc(u) * sinc(v), 2);
    const D ks = 4 * e * sincs * c * c_v /
                 (less * sinc(u) * sinc(v) * ((1 + rho) * sinc(u) / c + (1 - rho) * sinc(v) / c_v));
    const Range xh = Range(2 / (1 - sin_share * sin_share)) *
                     (Range(pow(sinc(d) / sinc(U), 2)) - Range(2 * U * U / 3) * up_to_1(d * d / 5));
    const Range x1 = -((Range(cos(U) * sinc(d)) + Range(sin(U) * d / 3) * up_to_1(d * d / 10)) *
                       Range(1 / ((1 - rho) * sinc(v))));
    out.a =
        Range(cos_th) * (Range(c) * xh + x1 * Range(d * rho * kc * U)) + Range(Q * kc * U + sin_th * ks * U);
    out.a_second =
        Range(cos_th * c_v) * x1 - Range(Q * U * b_v * b_v * c_v * c_v / (1 + c_v) + sin_th * U * b_v * c_v);
    out.a_first = out.a_second + Range(rho) * out.a;

    const D g1 = moment(u, [&](const D& x) { return h_of(x, Q); });
    const D mu = integral<D>(
        [&](const D& t) {
            return D((1 + rho * t) * sinc(D(U * (1 + rho * t))) * h_of(D(pi<D>() - U * (1 + rho * t)), Q));
        },
        D(-1), D(1));
    const D j_low = Q + out.a_first.lo * d * rho;  // A = aA d rho
    const D j_v_low = Q + out.a_second.lo * d * rho;
    const auto second = [&](const D& at, const D& low) {
        return Range(moment(at, [&](const D& x) { return h2_of(x, low); }),
                     moment(at, [&](const D& x) { return h2_of(x, Q); }));
    };
    const Range m2 =
        Range(pow(1 + rho, 2) * g1) * out.a + Range(mu) * out.a_second +
        Range(d / 2) * (Range(pow(1 + rho, 2)) * second(u, j_low) * out.a_first * out.a_first -
                        Range(pow(1 - rho, 2)) * second(v, j_v_low) * out.a_second * out.a_second);
    out.m = first_part(U, d, Q) + m2;
    const auto b_cubed = [&](const D& j) {  // B^3; k1 increases with J
        const D k1 = pow(1 + rho, 2) * moment(u, [&](const D& x) { return g(x, j); });
        return D(pow(sqrt(k1) + sqrt(k1 - 2 * rho * e), 3));
    };
    out.ratio = out.m * Range(b_cubed(j_low), b_cubed(Q + out.a_first.hi * d * rho)) *
                Range(1 / (pow(D(2), D(2.5)) * k0<D>() * e * e * e));
    return out;
}

}  // namespace dumbbell_oracle::law
