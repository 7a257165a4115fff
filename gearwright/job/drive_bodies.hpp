// The solids of a drive, in their places and laid out for printing, and the files of them.
//
// External gears of one body with the same bore are one solid, in which a plain cylinder joins each
// gear to the next one. Such a body is a stepped planet or the intermediate shaft of a train. Gears
// with different bores are separate workpieces, and so are rings.
#pragma once

#include <filesystem>
#include <vector>

#include "gearwright/cad/toothed_body.hpp"
#include "gearwright/job/drive_job.hpp"

namespace gearwright {

/// Every copy of every solid in its place, in the common frame of one file. Copies refer to the
/// first solid with the same shape. Solids of one body have the same colour. If a gear is not
/// joined to a gear of its body, `separate` gives the reason.
///
/// Errors    a drive without a layout; a gear without an outline
Result<std::vector<ToothedBody>> drive_bodies(const DriveJob& job);

/// The same solids laid out side by side on the plane z = 0 for printing. The wider end of a solid
/// with several gears is below.
std::vector<ToothedBody> laid_out(std::vector<ToothedBody> bodies);

/// One file of the whole drive, made in the same way as by make_file(). In a 3MF file the bodies
/// are laid out for printing.
///
/// Domain    bodies = drive_bodies(job) (contract)
/// Errors    `drive` if an outline is requested and the gears lie in several planes; those of
///           make_file()
Result<JobFile> make_drive_file(FileKind kind, const DriveJob& job,
                                const std::vector<ToothedBody>& bodies,
                                const std::filesystem::path& path, const FileOptions& options);

}  // namespace gearwright
