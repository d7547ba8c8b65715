// An accumulation on disk: complete, or not there. docs/physics.md, "What is kept", tells what is in
// the file.
#pragma once

#include "image/image_file.h"
#include "render/accumulate/accumulation.h"

#include <string>
#include <utility>
#include <vector>

namespace render {

// What a picture is made from, each thing by its name and as a text, in an order of its own.
using StateWords = std::vector<std::pair<std::string, std::string>>;

// Writes the file beside its place and puts it there with one step, so that whatever happens the one that was there is
// whole. threads: to pack it with. Throws core::Error where that cannot be done.
void writeState(const image::FileName& file, const StateWords& words, const Accumulation& accumulation, int threads);

// Reads it into an accumulation for the same part of the picture and the same layers. Returns whether the file is
// there. Throws core::Error, and leaves the file as it is, where it is damaged, where it is of other words, naming the
// first that differs, or where a pixel has more than `most` samples.
bool readState(const image::FileName& file, const StateWords& words, int most, Accumulation& accumulation);

}  // namespace render
