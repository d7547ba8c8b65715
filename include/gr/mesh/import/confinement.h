// What the importer may still do once it is told of a folder.
#pragma once

namespace gr::importer {

// From now on the process can read files below the folder, and neither write nor run any: for what a file may bring a
// reader to that has a fault. Linux older than 5.13 cannot do that, and nothing happens.
void confineTo(int folder);

}  // namespace gr::importer
