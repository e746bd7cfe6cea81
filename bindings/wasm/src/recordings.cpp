// SPDX-License-Identifier: MIT
// Recordings of moving boxes, read by the library's own reader from an in-memory file.
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <emscripten/bind.h>
#include <fmt/format.h>

#include <graze/io/recording.hpp>
#include <graze/io/text/quoting.hpp>

#include "bridge.hpp"

namespace graze::wasm {
namespace {

namespace fs = std::filesystem;

// JavaScript accesses boxes as consecutive numbers.
static_assert(sizeof(Aabb<2, float>) == 4 * sizeof(float) && sizeof(Aabb<3, float>) == 6 * sizeof(float));

/// A recording and the boxes of the last requested frame.
class RecordingHandle {
 public:
  RecordingHandle(const std::string& content, const std::string& name) : file_(name, content), reader_(file_.name()) {
    if (reader_.head().dimension() == 3) boxes_ = std::vector<Aabb<3, float>>();
  }

  const io::RecordingHead& head() const { return reader_.head(); }

  void read(std::size_t frame) {
    const auto has_frame = [&](auto& boxes) {
      reader_.seek(frame);
      return reader_.next(boxes);
    };
    if (frame >= head().frames || !std::visit(has_frame, boxes_)) {
      throw std::out_of_range(fmt::format("frame: there is no frame {}; the last is {}", frame, head().frames - 1));
    }
  }

  std::size_t boxes_address() const {
    return std::visit([](const auto& boxes) { return reinterpret_cast<std::size_t>(boxes.data()); }, boxes_);
  }

 private:
  /// The file, in its own folder, which is the current one while it is opened, so that messages contain only its name.
  class File {
   public:
    File(const std::string& name, const std::string& content) : name_(fs::path(name).filename().string()) {
      if (name_.empty() || name_ == "." || name_ == "..") name_ = "recording";
      static std::size_t count = 0;
      folder_ = fmt::format("/recordings/{}", count++);
      fs::create_directories(folder_);
      fs::current_path(folder_);
      std::ofstream out(name_, std::ios::binary);
      out << content;
      out.close();
      if (!out) throw std::runtime_error("the recording cannot be stored: out of memory");
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() {
      std::error_code ignored;
      fs::current_path("/", ignored);
      fs::remove_all(folder_, ignored);
    }

    const std::string& name() const { return name_; }

   private:
    std::string name_;
    fs::path folder_;
  };

  File file_;
  io::RecordingReader reader_;
  std::variant<std::vector<Aabb<2, float>>, std::vector<Aabb<3, float>>> boxes_;
};

RecordingHandle* read_recording(std::string content, std::string name) {
  return std::make_unique<RecordingHandle>(content, name).release();  // embind owns it
}

/// Its names, and the numbers of boxes and frames; the output contains the world.
std::string head(RecordingHandle& self) {
  const io::RecordingHead& head = self.head();
  for (const Vec<3, float>& corner : {head.world.min, head.world.max}) {
    for (Dim i = 0; i < head.dimension(); ++i) answer().push_back(corner[i]);
  }
  return fmt::format(R"({{"scene": {}, "objectsType": {}, "count": {}, "frames": {}, "dimension": {}}})",
                     io::json_string(head.scene), io::json_string(head.objects_type), head.boxes, head.frames,
                     head.dimension());
}

void read(RecordingHandle& self, std::size_t frame) { self.read(frame); }

}  // namespace

EMSCRIPTEN_BINDINGS(graze_recordings) {
  using namespace emscripten;  // NOLINT(google-build-using-namespace): as embind is written
  class_<RecordingHandle>("Recording")
      .class_function("make", &Guarded<&read_recording>::call, allow_raw_pointers())
      .function("head", &Guarded<&head>::call)
      .function("read", &Guarded<&read>::call)
      .function("boxesAddress", &RecordingHandle::boxes_address);
}

}  // namespace graze::wasm
