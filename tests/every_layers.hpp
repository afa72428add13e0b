#pragma once
// Assignments to layers written from their definition, apart from the code that lists those worth a look.

#include <vector>

#include "workspace/parts.hpp"

namespace kempe::test {

/// Every way to lay VA, VB, ACX and BCY into layers, empty ones in between or below included: links that share a joint lie in
/// different layers.
inline std::vector<LayerAssignment> every_layers(int layers) {
  std::vector<LayerAssignment> all;
  for (int VA = 1; VA <= layers; ++VA)
    for (int VB = 1; VB <= layers; ++VB)
      for (int ACX = 1; ACX <= layers; ++ACX)
        for (int BCY = 1; BCY <= layers; ++BCY)
          if (VA != VB && VA != ACX && VB != BCY && ACX != BCY) all.push_back({{VA, VB, ACX, BCY}});
  return all;
}

}  // namespace kempe::test
