#include "Dialects/OpenCl.h"
#include "Shared/RayCast.h"
#include "Broken/Undeclared.h"
