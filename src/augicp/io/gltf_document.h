// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "augicp/io/format.h"
#include "augicp/io/gltf_file.h"

namespace augicp {

// The JSON of a file, whose members are checked as they are read.
class GltfDocument {
 public:
  using Json = nlohmann::json;

  explicit GltfDocument(const FileBytes& file) : file_(file), text_(gltf_text(file)) {
    json_ = Json::parse(text_.json, nullptr, /*allow_exceptions=*/false);
    if (!json_.is_object() || text_.json.find('\0') != std::string_view::npos)
      fail("expected glTF: a JSON object, or the mark 'glTF'");
    const Json* const asset = member(json_, "asset");
    if (!asset || !asset->is_object() || !asset->contains("version")) fail("expected \"asset\" with a version of glTF");
  }

  const FileBytes& file() const { return file_; }
  const Json& root() const { return json_; }
  const std::optional<std::string_view>& binary() const { return text_.binary; }
  [[noreturn]] void fail(const std::string& what) const { throw io_error(file_.path, what); }

  // Null if the object lacks the key.
  static const Json* member(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
  }

  // A list, such as "nodes"; empty if the object lacks it.
  std::span<const Json> list(const Json& object, const char* key) const {
    const Json* const found = member(object, key);
    if (found && !found->is_array()) fail(fmt::format("expected a list \"{}\"", key));
    return found ? std::span<const Json>(found->get_ref<const Json::array_t&>()) : std::span<const Json>();
  }

  // An object of a list of the file.
  const Json& item(const char* key, std::uint64_t index) const {
    const std::span<const Json> all = list(json_, key);
    if (index >= all.size() || !all[index].is_object())
      fail(fmt::format("expected number {} of \"{}\", found {}", index, key, all.size()));
    return all[index];
  }

  std::optional<std::uint64_t> count(const Json& object, const char* key) const {
    const Json* const found = member(object, key);
    if (!found) return std::nullopt;
    if (!found->is_number_unsigned()) fail(fmt::format("expected \"{}\" to be a whole number", key));
    return found->get<std::uint64_t>();
  }

  std::uint64_t index(const Json& value, const char* key) const {
    if (!value.is_number_unsigned()) fail(fmt::format("expected \"{}\" to be whole numbers", key));
    return value.get<std::uint64_t>();
  }

  std::optional<std::vector<double>> numbers(const Json& object, const char* key, std::size_t size) const {
    const Json* const found = member(object, key);
    if (!found) return std::nullopt;
    std::vector<double> values;
    if (found->is_array())
      for (const Json& value : *found)
        if (value.is_number()) values.push_back(value.get<double>());
    if (values.size() != size) fail(fmt::format("expected \"{}\" with {} numbers", key, size));
    return values;
  }

 private:
  const FileBytes& file_;
  GltfText text_;
  Json json_;
};

}  // namespace augicp
