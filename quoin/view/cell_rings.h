// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "quoin/arrangement/cells/dcel.h"
#include "quoin/view/picture_path.h"

namespace quoin {

/// The boundaries of a face as closed paths, from the paths of the edges (left to right). Where a boundary runs along
/// the frame at infinity its path runs counterclockwise along the border of `reach`, on which unbounded edges end.
std::vector<PicturePath> face_rings(const dcel::Dcel& cells, dcel::FaceId face, const std::vector<PicturePath>& edges,
                                    const PictureBox& reach);

}  // namespace quoin
