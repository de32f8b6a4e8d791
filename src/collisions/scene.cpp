#include "collisions/scene.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "collisions/names.hpp"

namespace dumbbell::collisions {

const SceneRow& row_of(Scene scene) {
    switch (scene) {
        case Scene::dumbbell:
            return dumbbell_row;
        case Scene::hybrid:
            return hybrid_row;
        case Scene::wedge:
            return wedge_row;
        case Scene::body:
            return body_row;
    }
    throw BrokenInvariant("unknown scene");
}

std::string option_of(Scene scene) { return scene == Scene() ? "" : fmt::format("--scene {} ", name(scene)); }

}  // namespace dumbbell::collisions
