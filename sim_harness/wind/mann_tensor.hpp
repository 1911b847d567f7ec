// SPDX-License-Identifier: Apache-2.0
// The spectral tensor of core/ under the names of the harness.
#pragma once

#include "core/mann_tensor.hpp"

namespace lac::sim {

using lac::CrossSpectra;
using lac::EddyLifetime;
using lac::MannParams;
using lac::MannTensor;
using lac::scaled_to_sigma_u;
using lac::Separation;
using lac::SinhNodes;
using lac::SpectralTensor;
using lac::TensorIndex;
using enum lac::TensorIndex;

}  // namespace lac::sim
