#include "workspace/parts.hpp"
