#include "spatial/algebra.h"

namespace cambrian::spatial {

Rotation rotation_of(const Turn& turn) {
    const Vec3& x = turn.axis[0];
    const Vec3& y = turn.axis[1];
    const Vec3& z = turn.axis[2];
    const double trace = x.x() + y.y() + z.z();
    if (trace >= x.x() && trace >= y.y() && trace >= z.z())
        return normalized({1.0 + trace, y.z() - z.y(), z.x() - x.z(), x.y() - y.x()});
    if (x.x() >= y.y() && x.x() >= z.z())
        return normalized(
            {y.z() - z.y(), 1.0 + x.x() - y.y() - z.z(), x.y() + y.x(), z.x() + x.z()});
    if (y.y() >= z.z())
        return normalized(
            {z.x() - x.z(), x.y() + y.x(), 1.0 + y.y() - x.x() - z.z(), y.z() + z.y()});
    return normalized({x.y() - y.x(), z.x() + x.z(), y.z() + z.y(), 1.0 + z.z() - x.x() - y.y()});
}

Symmetric& Symmetric::operator+=(const Symmetric& other) {
    xx += other.xx;
    yy += other.yy;
    zz += other.zz;
    xy += other.xy;
    xz += other.xz;
    yz += other.yz;
    return *this;
}

Symmetric point_inertia(double mass, const Vec3& place) {
    const double x = place.x();
    const double y = place.y();
    const double z = place.z();
    return {mass * (y * y + z * z), mass * (x * x + z * z), mass * (x * x + y * y),
            -mass * (x * y),        -mass * (x * z),        -mass * (y * z)};
}

Symmetric turned(const Symmetric& matrix, const Turn& turn) {
    // The columns of S R', whose rows are those of R S.
    const auto row = [&turn](int i) {
        return Vec3(turn.axis[0][i], turn.axis[1][i], turn.axis[2][i]);
    };
    const Vec3 x = row(0);
    const Vec3 y = row(1);
    const Vec3 z = row(2);
    const Vec3 sx = matrix * x;
    const Vec3 sy = matrix * y;
    const Vec3 sz = matrix * z;
    return {dot(x, sx), dot(y, sy), dot(z, sz), dot(x, sy), dot(x, sz), dot(y, sz)};
}

Vec3 solved(const Symmetric& m, const Vec3& right) {
    const double a = m.yy * m.zz - m.yz * m.yz;
    const double b = m.xz * m.yz - m.xy * m.zz;
    const double c = m.xy * m.yz - m.xz * m.yy;
    const Symmetric cofactors{a, m.xx * m.zz - m.xz * m.xz, m.xx * m.yy - m.xy * m.xy, b,
                              c, m.xy * m.xz - m.xx * m.yz};
    const double determinant = m.xx * a + m.xy * b + m.xz * c;
    return (cofactors * right) / determinant;
}

}  // namespace cambrian::spatial
