#include "kinematics/copying_linkage.hpp"

#include <gtest/gtest.h>
