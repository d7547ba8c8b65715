// A picture that has no place any more is not thrown away.
#pragma once

#include "grsh/file_access.h"
#include "grsh/render_job.h"
#include "image/film.h"
#include "image/image_file.h"

namespace grsh {

// Writes the picture; where that fails, because its folder is gone, the disk is full or the like, it writes it to the
// current folder, to $TMPDIR or to /tmp, wherever it may, and throws core::Error that says why, and where it is.
void writeOrRescue(const image::ImageFile& file, const FileAccess& files, const RenderJob& job, const image::Film& film,
                   const image::Metadata& metadata);

}  // namespace grsh
