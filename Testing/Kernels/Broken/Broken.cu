#include "Dialects/Cuda.h"
#include "Shared/RayCast.h"
#include "Broken/Undeclared.h"
