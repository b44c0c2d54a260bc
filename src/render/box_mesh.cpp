#include "render/box_mesh.h"

#include "math/types.h"

#include <cmath>
#include <cstddef>

namespace cambrian {
namespace {

constexpr double kEighth = 0.7853981633974483;  // of a turn, rad

// A line of vertices across a face, from the middle of one edge to the middle of the other.
struct MeshRow {
    double corner;
    double angle;  // rad, away from the face's normal
};

MeshRow row_of(int index, int steps) {
    if (index <= steps) return {-1.0, -kEighth * (1.0 - static_cast<double>(index) / steps)};
    return {1.0, kEighth * static_cast<double>(index - steps - 1) / steps};
}

void add_face(BoxMesh& mesh, int axis, int sign, int steps) {
    const int u = (axis + (sign > 0 ? 1 : 2)) % 3;
    const int v = (axis + (sign > 0 ? 2 : 1)) % 3;
    const int side = 2 * steps + 2;
    const auto first = static_cast<unsigned>(mesh.vertices.size());
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            const MeshRow across = row_of(i, steps);
            const MeshRow along = row_of(j, steps);
            Vec3 normal = Vec3::Zero();
            normal[axis] = sign;
            normal[u] = std::tan(across.angle);
            normal[v] = std::tan(along.angle);
            normal.normalize();
            BoxVertex vertex{};
            const auto put = [&vertex](int at, double corner) {
                vertex.corner[static_cast<std::size_t>(at)] = static_cast<float>(corner);
            };
            put(axis, sign);
            put(u, across.corner);
            put(v, along.corner);
            for (int k = 0; k < 3; ++k)
                vertex.normal[static_cast<std::size_t>(k)] = static_cast<float>(normal[k]);
            mesh.vertices.push_back(vertex);
        }
    }
    const auto width = static_cast<unsigned>(side);
    for (unsigned i = 0; i + 1 < width; ++i) {
        for (unsigned j = 0; j + 1 < width; ++j) {
            const unsigned at = first + i * width + j;
            for (const unsigned each : {at, at + width, at + 1, at + 1, at + width, at + width + 1})
                mesh.triangles.push_back(each);
        }
    }
}

}  // namespace

BoxMesh rounded_box(int steps) {
    BoxMesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {-1, 1})
            add_face(mesh, axis, sign, steps);
    }
    return mesh;
}

}  // namespace cambrian
