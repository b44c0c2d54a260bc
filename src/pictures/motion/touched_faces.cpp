#include "pictures/motion/touched_faces.h"

namespace cambrian {

std::vector<FaceSet> touched_faces(const BodyView& body) {
    std::vector<FaceSet> touched(body.part_count());
    for (std::size_t part = 0; part < touched.size(); ++part) {
        for (std::size_t number = 0; number < kFaceCount; ++number) {
            const auto face = static_cast<Face>(number);
            if (body.face_touched(part, face))
                touched[part] = static_cast<FaceSet>(touched[part] | face_bit(face));
        }
    }
    return touched;
}

}  // namespace cambrian
