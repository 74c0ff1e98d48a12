// From the bytes of a URDF file to urdfdom's tree of links, with everything refused that has nothing to do
// with the robot's shape: unreadable files, broken XML, references that do not form one tree. Internal to
// robot/.
#pragma once

#include <filesystem>
#include <memory>

#include <urdf_model/model.h>

namespace dob {

// The tree of the file. Numbers are read independently of the locale; nothing is printed. Several threads may
// call it. Throws DescriptionError whose message does NOT name the file (the caller does): the place in the
// file (line:column) for XML errors, the link or joint for everything else. Every link hangs from the root by
// exactly one chain of joints.
std::shared_ptr<const urdf::ModelInterface> read_urdf(const std::filesystem::path& file);

}  // namespace dob
