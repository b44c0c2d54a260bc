#include "pictures/motion/touched_faces.h"

namespace cambrian {

std::vector<FaceSet> touched_faces(const BodyView& body) {
    std::vector<FaceSet> touched(body.part_count());
    for (std::size_t part = 0; part < touched.size(); ++part) {
        for (const Face face : {Face::kDistal, Face::kLeft, Face::kProximal, Face::kRight}) {
            if (body.face_touched(part, face))
                touched[part] = static_cast<FaceSet>(touched[part] | face_bit(face));
        }
    }
    return touched;
}

}  // namespace cambrian
