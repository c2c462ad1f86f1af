#include <glm/glm.hpp>

#include <cmath>
#include <functional>

namespace broken
{
using real = float;

#include "Dialects/Cpp.h"
#include "Shared/RayCast.h"
#include "Broken/Undeclared.h"
}
