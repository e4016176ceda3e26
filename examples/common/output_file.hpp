// SPDX-License-Identifier: MIT
// Output files. Each is written beside its final name (NAME.partial) and renamed once it is complete, so that a full disk or
// an interrupt leaves the file that was there before as it was.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <list>
#include <string>

#include "input_error.hpp"

namespace common {

class OutputFile {
 public:
  /// Numbers are written with 17 digits, from which a double is read back unchanged.
  /// @throws InputError if the file cannot be created, or if the name belongs to something other than a plain file
  explicit OutputFile(const std::string& file) : file_(file), partial_(file + ".partial") {
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored))
      fail({file}, "is not a plain file");
    stream_.open(partial_, std::ios::binary);
    if (!stream_) fail({file}, std::string("cannot be written: ") + std::strerror(errno));
    stream_.precision(17);
  }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() {
    if (in_place_) return;
    stream_.close();
    std::remove(partial_.c_str());
  }

  std::ostream& stream() { return stream_; }

  /// Renames the file to its final name. @throws InputError if a part of it could not be written
  void complete() {
    finish();
    put_in_place();
  }

 private:
  friend class OutputFolder;

  void finish() {
    errno = 0;
    stream_.close();  // flushes
    if (!stream_)
      fail({file_}, std::string("cannot be written: ") + (errno != 0 ? std::strerror(errno) : "is the disk full?"));
  }
  void put_in_place() {
    std::error_code fault;
    std::filesystem::rename(partial_, file_, fault);
    if (fault) fail({file_}, "cannot be written: " + fault.message());
    in_place_ = true;
  }

  std::string file_;
  std::string partial_;
  std::ofstream stream_;
  bool in_place_ = false;
};

/// Creates a folder where there is none. @throws InputError if that fails
inline void create_folder(const std::string& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault) fail({folder}, "the folder cannot be created: " + fault.message());
}

/// The output files of one run. None of them is renamed before all of them are written.
class OutputFolder {
 public:
  /// Creates the folder. @throws InputError if it cannot be created
  explicit OutputFolder(const std::string& folder) : folder_(folder) { create_folder(folder); }

  /// A file of this name. The stream lives as long as the folder. @throws InputError as OutputFile does
  std::ostream& file(const std::string& name) {
    return files_.emplace_back((std::filesystem::path(folder_) / name).string()).stream();
  }

  /// @throws InputError if a part of any file could not be written
  void complete() {
    for (OutputFile& file : files_) file.finish();
    for (OutputFile& file : files_) file.put_in_place();
    files_.clear();
  }

 private:
  std::string folder_;
  std::list<OutputFile> files_;
};

}  // namespace common
