#pragma once

// Several scenes that are advanced as one, with contacts between their bodies.

#include "world/physics_scene.h"

#include <memory>
#include <span>

namespace cambrian {

class JoinedScenes {
public:
    virtual ~JoinedScenes() = default;

    // Advances all scenes by a tick (s), as their own advance() would, but for the contacts. They
    // must be those that were joined, in the same order and in the same environment. Contacts of
    // one tick are the first guess of the next, unless a scene was moved otherwise in between. If
    // no valid motion is found, no scene changes, and these scenes must not be advanced as one
    // again.
    virtual SceneStatus advance(std::span<PhysicsScene* const> scenes, double duration,
                                SceneWorkspace& workspace) = 0;

    // The next tick starts from these besides the scenes themselves: the contacts of the last one.
    // It may be restored only into the object that made it, or one of equal scenes.
    virtual std::unique_ptr<SceneState> save() const = 0;
    virtual void restore(const SceneState& state) = 0;
};

}  // namespace cambrian
