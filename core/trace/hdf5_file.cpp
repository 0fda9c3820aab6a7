// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// The part of hdf5.h that needs the library. It works on images in memory (its core driver).
#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>

#include "base/contract.h"
#include "base/hash.h"
#include "trace/control_trace.h"
#include "trace/hdf5.h"
#include "trace/import/import_error.h"

namespace rivulet::trace {

namespace {

constexpr const char* kFormat = "rivulet-signals";
constexpr const char* kEventGroup = "events";
constexpr const char* kChecksum = "checksum";
constexpr const char* kVersion = "1";
constexpr hsize_t kChunk = 16384;
constexpr unsigned kDeflate = 4;
/// Values of a dataset without chunks that are read at once.
constexpr std::size_t kPieceMax = std::size_t{1} << 18U;
/// Cycles of links end here.
constexpr int kDepthMax = 16;
constexpr std::size_t kObjectsMax = 20'000;
constexpr std::size_t kTextMax = 1000;
/// Less than this part of a file is not worth the memory of the whole.
constexpr std::uint64_t kGrowthMax = 100;
// What is held of a file, with what is made of it, bytes.
constexpr std::size_t kRowBytes = 1000;                  // beside its values: names, role, remarks
constexpr std::size_t kValueBytes = sizeof(double) + 2;  // packed at worst

/// Not every build of the library can be used by several threads.
std::mutex libraryMutex;

/// An identifier of the library, released at the end.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : m_id(id), m_close(close) {}
  Handle(Handle&& other) noexcept : m_id(std::exchange(other.m_id, -1)), m_close(other.m_close) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (m_id >= 0) {
      m_close(m_id);
    }
  }
  [[nodiscard]] bool ok() const { return m_id >= 0; }
  [[nodiscard]] hid_t id() const { return m_id; }

 private:
  hid_t m_id;
  Close m_close;
};

/// For what fails only without memory.
Handle made(hid_t id, Handle::Close close) {
  RIVULET_ASSERT(id >= 0);
  return {id, close};
}

/// Of the values as the file holds them, piece by piece.
class Checksum {
 public:
  void add(const std::vector<double>& values) {
    static_assert(std::endian::native == std::endian::little);
    const std::string_view bytes(reinterpret_cast<const char*>(values.data()),
                                 values.size() * sizeof(double));
    for (const char byte : bytes) {
      m_hash = (m_hash ^ static_cast<unsigned char>(byte)) * base::kHashPrime;  // as `hashOf`
    }
  }
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", m_hash); }

 private:
  std::uint64_t m_hash = base::kHashBasis;
};

/// The library reads the bytes where they are: it neither copies nor frees nor changes them.
struct SharedImage {
  std::string_view bytes;

  [[nodiscard]] H5FD_file_image_callbacks_t callbacks() {
    return {allocate, copy, resize, release, keep, release, this};
  }

 private:
  static void* memoryOf(void* image) {
    return const_cast<char*>(static_cast<SharedImage*>(image)->bytes.data());
  }
  static void* allocate(size_t size, H5FD_file_image_op_t /*for*/, void* image) {
    return size == static_cast<SharedImage*>(image)->bytes.size() ? memoryOf(image) : nullptr;
  }
  static void* copy(void* to, const void* from, size_t /*size*/, H5FD_file_image_op_t /*for*/,
                    void* /*image*/) {
    return to == from ? to : nullptr;
  }
  static void* resize(void* /*at*/, size_t /*size*/, H5FD_file_image_op_t /*for*/,
                      void* /*image*/) {
    return nullptr;
  }
  static herr_t release(void* /*at*/, H5FD_file_image_op_t /*for*/, void* /*image*/) { return 0; }
  static void* keep(void* image) { return image; }
  static herr_t release(void* /*image*/) { return 0; }
};

std::uint64_t littleEndian(std::string_view bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[at + i]);
    value |= static_cast<std::uint64_t>(byte) << (8 * i);
  }
  return value;
}

/// How long the file was when it was whole, by its superblock; nothing: unusual.
std::optional<std::uint64_t> declaredBytes(std::string_view bytes) {
  std::size_t at = 0;
  while (!isHdf5(bytes.substr(at, 8))) {
    at = at == 0 ? 512 : 2 * at;
    if (at + 64 > bytes.size()) {
      return std::nullopt;
    }
  }
  const std::string_view block = bytes.substr(at);
  if (block.size() < 64) {
    return std::nullopt;
  }
  // Versions 0 and 1, or 2 and 3; addresses of 8 bytes.
  const int version = static_cast<unsigned char>(block[8]);
  const bool isEarly = version < 2;
  if (version > 3 || block[isEarly ? 13 : 9] != 8) {
    return std::nullopt;
  }
  const std::size_t end = isEarly ? (version == 1 ? 44 : 40) : 28;
  return littleEndian(block, end);
}

std::string textOf(const Handle& attribute) {
  const Handle type(H5Aget_type(attribute.id()), H5Tclose);
  const Handle space(H5Aget_space(attribute.id()), H5Sclose);
  if (!type.ok() || !space.ok() || H5Tget_class(type.id()) != H5T_STRING ||
      H5Sget_simple_extent_npoints(space.id()) != 1) {
    return {};
  }
  if (H5Tis_variable_str(type.id()) > 0) {
    char* text = nullptr;
    if (H5Aread(attribute.id(), type.id(), &text) < 0 || text == nullptr) {
      return {};
    }
    std::string copy(text, strnlen(text, kTextMax));
    H5free_memory(text);
    return copy;
  }
  const std::size_t size = H5Tget_size(type.id());
  if (size == 0 || size > kTextMax) {
    return {};
  }
  std::string text(size, '\0');
  if (H5Aread(attribute.id(), type.id(), text.data()) < 0) {
    return {};
  }
  text.resize(strnlen(text.data(), size));
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

std::string attributeText(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) {
    return {};
  }
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  return attribute.ok() ? textOf(attribute) : std::string();
}

/// Reads one file.
class Reader {
 public:
  Reader(std::string_view bytes, const base::Budget& budget) : m_bytes(bytes), m_budget(budget) {}

  base::Result<Hdf5Content> read() {
    const Handle file = open();
    if (!file.ok() && !m_isExceeded) {
      return base::fail(ImportError::NotATable,
                        m_isCut ? "The HDF5 file was cut off: what is left cannot be read."
                                : "The HDF5 file is damaged and cannot be read.");
    }
    const Handle root(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose);
    m_isOurs = root.ok() && attributeText(root.id(), "format") == kFormat;
    if (root.ok()) {
      readGroup(root.id(), "", 0);
    }
    if (m_isOurs) {
      readEvents(root.id());
    }
    if (m_isExceeded) {
      return base::fail(m_budget.exceeded("The HDF5 file, unpacked and with its analysis,"));
    }
    if (m_content.rows.empty()) {
      return base::fail(ImportError::NotATable,
                        m_isCut
                            ? "The HDF5 file was cut off: no row of numbers is left."
                            : "The HDF5 file has no row of numbers (dataset of one dimension).");
    }
    std::vector<Remark>& remarks = m_content.remarks;
    if (m_isCut) {
      remarks.push_back({RemarkCode::CutFile});
    }
    if (m_others > 0) {
      remarks.push_back({RemarkCode::OtherDatasets, {std::to_string(m_others), m_firstOther}});
    }
    if (m_damaged > 0) {
      remarks.push_back({RemarkCode::DamagedDatasets, {std::to_string(m_damaged), m_firstDamaged}});
    }
    return std::move(m_content);
  }

 private:
  /// A file that was cut off is filled up with zeros: the library opens none that is too short.
  /// What lies beyond its end is not read as values.
  Handle open() {
    const auto declared = declaredBytes(m_bytes);
    m_isCut = declared && *declared > m_bytes.size();
    m_image.bytes = m_bytes;
    const bool isFilled = m_isCut && *declared / kGrowthMax <= m_bytes.size();
    if (isFilled) {
      hold(*declared);
    }
    if (m_isExceeded) {
      return {-1, H5Fclose};
    }
    if (isFilled) {
      m_filled.reserve(*declared);
      m_filled = m_bytes;
      m_filled.resize(*declared, '\0');
      m_image.bytes = m_filled;
    }
    const Handle access = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    RIVULET_ASSERT(H5Pset_fapl_core(access.id(), 1U << 16U, false) >= 0);
    H5FD_file_image_callbacks_t callbacks = m_image.callbacks();
    // A file that is opened to be read is not written to.
    const bool isSet = H5Pset_file_image_callbacks(access.id(), &callbacks) >= 0 &&
                       H5Pset_file_image(access.id(), const_cast<char*>(m_image.bytes.data()),
                                         m_image.bytes.size()) >= 0;
    return {isSet ? H5Fopen("image", H5F_ACC_RDONLY, access.id()) : -1, H5Fclose};
  }

  void readGroup(hid_t group, const std::string& folder, int depth) {
    H5G_info_t info{};
    if (depth > kDepthMax || H5Gget_info(group, &info) < 0) {
      return;
    }
    const H5_index_t index = isOrdered(group) ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
    std::vector<std::string> folders;
    for (hsize_t i = 0; i < info.nlinks && m_objects < kObjectsMax && !m_isExceeded; ++i) {
      ++m_objects;
      H5L_info_t link{};
      // Links into other files are not followed.
      if (H5Lget_info_by_idx(group, ".", index, H5_ITER_INC, i, &link, H5P_DEFAULT) < 0 ||
          link.type != H5L_TYPE_HARD) {
        continue;
      }
      const ssize_t length =
          H5Lget_name_by_idx(group, ".", index, H5_ITER_INC, i, nullptr, 0, H5P_DEFAULT);
      if (length <= 0 || static_cast<std::size_t>(length) > kTextMax) {
        continue;
      }
      std::string name(static_cast<std::size_t>(length), '\0');
      H5Lget_name_by_idx(group, ".", index, H5_ITER_INC, i, name.data(), name.size() + 1,
                         H5P_DEFAULT);
      const Handle object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose);
      if (!object.ok()) {
        noteDamaged(folder, name);
      } else if (H5Iget_type(object.id()) == H5I_DATASET) {
        readDataset(object.id(), folder, name);
      } else if (H5Iget_type(object.id()) == H5I_GROUP &&
                 !(m_isOurs && depth == 0 && name == kEventGroup)) {
        folders.push_back(std::move(name));
      }
    }
    for (const std::string& name : folders) {
      const Handle inner(H5Gopen2(group, name.c_str(), H5P_DEFAULT), H5Gclose);
      if (inner.ok()) {
        readGroup(inner.id(), folder.empty() ? name : folder + "/" + name, depth + 1);
      }
    }
  }

  static bool isOrdered(hid_t group) {
    const Handle creation(H5Gget_create_plist(group), H5Pclose);
    unsigned flags = 0;
    return creation.ok() && H5Pget_link_creation_order(creation.id(), &flags) >= 0 &&
           (flags & static_cast<unsigned>(H5P_CRT_ORDER_INDEXED)) != 0;
  }

  void readDataset(hid_t dataset, const std::string& folder, const std::string& name) {
    const Handle type(H5Dget_type(dataset), H5Tclose);
    const Handle space(H5Dget_space(dataset), H5Sclose);
    const Handle creation(H5Dget_create_plist(dataset), H5Pclose);
    if (!type.ok() || !space.ok() || !creation.ok()) {
      noteDamaged(folder, name);
      return;
    }
    const H5T_class_t kind = H5Tget_class(type.id());
    const bool isNumber = kind == H5T_INTEGER || kind == H5T_FLOAT;
    // Parts of it may be in other files.
    const H5D_layout_t layout = H5Pget_layout(creation.id());
    const bool isInside = layout != H5D_VIRTUAL && H5Pget_external_count(creation.id()) == 0;
    const auto shape = shapeOf(space.id());
    if (!isNumber || !isInside || !shape) {
      ++m_others;
      m_firstOther = m_others == 1 ? pathOf(folder, name) : m_firstOther;
      return;
    }
    if (shape->count == 0) {
      return;
    }
    const ChunkSizes chunks(creation.id(), type.id(), *shape);
    // A chunk is unpacked and converted as a whole, beside the values that it has.
    m_longest = std::max<std::uint64_t>(m_longest, shape->count);
    if (!hold(kRowBytes) || !hold(shape->count, kValueBytes) || !fits(chunks.bytes(), 2) ||
        !fits(m_longest, kAnalysedRowBytes)) {
      m_isExceeded = true;
      return;
    }
    Hdf5Row row;
    const std::string title = attributeText(dataset, "name");
    row.folder = folder;
    row.name = title.empty() ? name : title;
    row.unit = attributeText(dataset, "unit");
    row.unit = row.unit.empty() ? attributeText(dataset, "units") : row.unit;
    row.count = shape->count;
    const std::size_t whole = m_isCut || layout == H5D_COMPACT
                                  ? wholeValues(dataset, layout, *shape, type.id())
                                  : shape->count;
    Checksum ofValues;
    const bool isWhole =
        readValues(dataset, space.id(), chunks, *shape, whole, row.values, ofValues);
    if (!isWhole) {
      noteDamaged(folder, name);
    }
    // A damaged index puts pieces in other places: their own checksums do not show that.
    const std::string checksum = m_isOurs && whole == row.count && isWhole
                                     ? attributeText(dataset, kChecksum)
                                     : std::string();
    if (!checksum.empty() && checksum != ofValues.text()) {
      noteDamaged(folder, name);
    } else if (!row.values.empty()) {
      m_content.rows.push_back(std::move(row));
    }
  }

  struct Shape {
    std::vector<hsize_t> sizes;
    std::size_t axis = 0;   ///< the one that may be longer than 1
    std::size_t count = 0;  ///< its length
  };

  /// Nothing: more than one row.
  static std::optional<Shape> shapeOf(hid_t space) {
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank < 1 || H5Sget_simple_extent_type(space) != H5S_SIMPLE) {
      return std::nullopt;
    }
    Shape shape;
    shape.sizes.resize(static_cast<std::size_t>(rank));
    H5Sget_simple_extent_dims(space, shape.sizes.data(), nullptr);
    const auto longer = std::count_if(shape.sizes.begin(), shape.sizes.end(),
                                      [](hsize_t size) { return size != 1; });
    if (longer > 1) {
      return std::nullopt;
    }
    const auto axis = std::find_if(shape.sizes.begin(), shape.sizes.end(),
                                   [](hsize_t size) { return size != 1; });
    shape.axis =
        axis == shape.sizes.end() ? 0 : static_cast<std::size_t>(axis - shape.sizes.begin());
    shape.count = shape.sizes[shape.axis];
    return shape;
  }

  /// In the header of the dataset. The library does not compare their number with the shape.
  static std::size_t storedValues(hid_t dataset, hid_t type) {
    return H5Dget_storage_size(dataset) / H5Tget_size(type);
  }

  /// How many values lie before the end of a file that was cut off.
  std::size_t wholeValues(hid_t dataset, H5D_layout_t layout, const Shape& shape, hid_t type) {
    const std::uint64_t end = m_bytes.size();
    if (layout == H5D_CONTIGUOUS) {
      const haddr_t begin = H5Dget_offset(dataset);
      if (begin == HADDR_UNDEF) {
        return shape.count;  // never written: all values are the fill value
      }
      const std::uint64_t there = begin < end ? (end - begin) / H5Tget_size(type) : 0;
      return std::min<std::size_t>(shape.count, there);
    }
    if (layout != H5D_CHUNKED) {
      return std::min(shape.count, storedValues(dataset, type));
    }
    const Handle all(H5Dget_space(dataset), H5Sclose);
    hsize_t chunks = 0;
    if (!all.ok() || H5Dget_num_chunks(dataset, all.id(), &chunks) < 0) {
      return 0;
    }
    std::size_t whole = shape.count;
    std::vector<hsize_t> first(shape.sizes.size());
    for (hsize_t i = 0; i < chunks; ++i) {
      unsigned mask = 0;
      haddr_t begin = 0;
      hsize_t size = 0;
      if (H5Dget_chunk_info(dataset, all.id(), i, first.data(), &mask, &begin, &size) < 0) {
        return 0;
      }
      if (begin == HADDR_UNDEF || begin > end || size > end - begin) {
        whole = std::min<std::size_t>(whole, first[shape.axis]);
      }
    }
    return whole;
  }

  /// Of the chunks of a dataset. The library reads one of another size beyond its end.
  class ChunkSizes {
   public:
    ChunkSizes(hid_t creation, hid_t type, const Shape& shape)
        : m_axis(shape.axis), m_sizes(shape.sizes.size()) {
      if (H5Pget_layout(creation) == H5D_CHUNKED &&
          H5Pget_chunk(creation, static_cast<int>(m_sizes.size()), m_sizes.data()) > 0) {
        m_values = m_sizes[m_axis];
        m_bytes = std::accumulate(m_sizes.begin(), m_sizes.end(), hsize_t{H5Tget_size(type)},
                                  std::multiplies<>());
        m_isFiltered = H5Pget_nfilters(creation) > 0;
      }
    }

    /// Of one, unpacked; 0: there are no chunks.
    [[nodiscard]] std::uint64_t bytes() const { return m_bytes; }
    /// Values in one along the axis; 0: there are no chunks.
    [[nodiscard]] std::size_t values() const { return m_values; }
    /// Whether all that hold these values have the size that they should have. What a filter makes
    /// of one is not known before it is read.
    [[nodiscard]] bool areRight(hid_t dataset, std::size_t at, std::size_t count) const {
      std::vector<hsize_t> first(m_sizes.size(), 0);
      for (std::size_t i = at; m_values > 0 && i < at + count; i += m_values) {
        first[m_axis] = i / m_values * m_values;
        unsigned mask = 0;
        haddr_t begin = HADDR_UNDEF;
        hsize_t size = 0;
        if (H5Dget_chunk_info_by_coord(dataset, first.data(), &mask, &begin, &size) < 0) {
          return false;
        }
        const bool isFiltered = m_isFiltered && mask == 0;
        if (begin != HADDR_UNDEF && !isFiltered && size != m_bytes) {
          return false;
        }
      }
      return true;
    }

   private:
    std::size_t m_axis;
    std::vector<hsize_t> m_sizes;
    std::size_t m_values = 0;
    hsize_t m_bytes = 0;
    bool m_isFiltered = false;
  };

  /// Piece by piece, so that a damaged one costs no other. @return false if one is damaged
  static bool readValues(hid_t dataset, hid_t space, const ChunkSizes& chunks, const Shape& shape,
                         std::size_t count, PackedValues& values, Checksum& checksum) {
    std::size_t piece = std::min(count, kPieceMax);
    if (chunks.values() > 0) {
      piece = std::clamp<std::size_t>(chunks.values(), 1, std::max<std::size_t>(count, 1));
      piece *= std::max<std::size_t>(1, kChunk / piece);
    }
    bool isWhole = true;
    bool isAny = false;
    std::vector<double> buffer;
    for (std::size_t at = 0; at < count; at += piece) {
      std::vector<hsize_t> from(shape.sizes.size(), 0);
      std::vector<hsize_t> size(shape.sizes.size(), 1);
      from[shape.axis] = at;
      size[shape.axis] = std::min(piece, count - at);
      buffer.assign(size[shape.axis], kNoValue);
      const Handle memory = made(H5Screate_simple(1, &size[shape.axis], nullptr), H5Sclose);
      const bool isRead =
          chunks.areRight(dataset, at, size[shape.axis]) &&
          H5Sselect_hyperslab(space, H5S_SELECT_SET, from.data(), nullptr, size.data(), nullptr) >=
              0 &&
          H5Dread(dataset, H5T_NATIVE_DOUBLE, memory.id(), space, H5P_DEFAULT, buffer.data()) >= 0;
      if (!isRead) {
        std::ranges::fill(buffer, kNoValue);
      }
      for (const double value : buffer) {
        values.push_back(value);
      }
      checksum.add(buffer);
      isWhole = isWhole && isRead;
      isAny = isAny || isRead;
    }
    if (!isAny) {
      values.clear();
    }
    return isWhole;
  }

  void readEvents(hid_t root) {
    if (H5Lexists(root, kEventGroup, H5P_DEFAULT) <= 0) {
      return;
    }
    const Handle group(H5Gopen2(root, kEventGroup, H5P_DEFAULT), H5Gclose);
    if (!group.ok()) {
      noteDamaged("", kEventGroup);
      return;
    }
    const auto from = numbersOf(group.id(), "from");
    const auto to = numbersOf(group.id(), "to");
    const auto kinds = textsOf(group.id(), "kind");
    const auto texts = textsOf(group.id(), "text");
    if (from.size() != to.size() || from.size() != kinds.size() || from.size() != texts.size()) {
      noteDamaged("", kEventGroup);
      return;
    }
    constexpr double kSecondsMax = 9e9;  // beyond, an instant overflows
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (std::abs(from[i]) <= kSecondsMax && std::abs(to[i]) <= kSecondsMax) {
        m_content.events.push_back({base::Instant{base::fromSeconds(from[i])},
                                    base::Instant{base::fromSeconds(to[i])}, kinds[i], texts[i]});
      }
    }
  }

  std::vector<double> numbersOf(hid_t group, const char* name) {
    const Handle dataset(H5Dopen2(group, name, H5P_DEFAULT), H5Dclose);
    const auto count = countOf(dataset);
    std::vector<double> values(count.value_or(0));
    if (!count || (*count > 0 && H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL,
                                         H5P_DEFAULT, values.data()) < 0)) {
      return {};
    }
    return values;
  }

  std::vector<std::string> textsOf(hid_t group, const char* name) {
    const Handle dataset(H5Dopen2(group, name, H5P_DEFAULT), H5Dclose);
    const auto count = countOf(dataset);
    if (!count || *count == 0) {
      return {};
    }
    const Handle type(H5Dget_type(dataset.id()), H5Tclose);
    const bool isText =
        type.ok() && H5Tget_class(type.id()) == H5T_STRING && H5Tis_variable_str(type.id()) == 0;
    const std::size_t size = isText ? H5Tget_size(type.id()) : 0;
    // In the file, beside each other, and one by one.
    if (size == 0 || !fits(size, 3) || !hold(*count, 3 * size)) {
      return {};
    }
    std::string cells(*count * size, '\0');
    if (H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, cells.data()) < 0) {
      return {};
    }
    std::vector<std::string> texts;
    for (std::size_t at = 0; at < cells.size(); at += size) {
      texts.emplace_back(&cells[at], strnlen(&cells[at], size));
    }
    return texts;
  }

  std::optional<std::size_t> countOf(const Handle& dataset) {
    if (!dataset.ok()) {
      return std::nullopt;
    }
    const Handle type(H5Dget_type(dataset.id()), H5Tclose);
    const Handle space(H5Dget_space(dataset.id()), H5Sclose);
    const Handle creation(H5Dget_create_plist(dataset.id()), H5Pclose);
    if (!type.ok() || !space.ok() || !creation.ok()) {
      return std::nullopt;
    }
    const auto shape = shapeOf(space.id());
    if (!shape || !hold(shape->count, sizeof(SignalEvent))) {
      return std::nullopt;
    }
    const bool isCompact = H5Pget_layout(creation.id()) == H5D_COMPACT;
    const std::size_t there = isCompact ? storedValues(dataset.id(), type.id()) : shape->count;
    return there >= shape->count && ChunkSizes(creation.id(), type.id(), *shape)
                                        .areRight(dataset.id(), 0, shape->count)
               ? std::optional(shape->count)
               : std::nullopt;
  }

  /// A few bytes can declare any number of items.
  [[nodiscard]] bool fits(std::uint64_t count, std::size_t bytesEach) const {
    return count <= m_budget.without(m_held).items(bytesEach);
  }
  /// @return false: the budget is exceeded
  bool hold(std::uint64_t count, std::size_t bytesEach = 1) {
    m_isExceeded = m_isExceeded || !fits(count, bytesEach);
    m_held += m_isExceeded ? 0 : count * bytesEach;
    return !m_isExceeded;
  }
  static std::string pathOf(const std::string& folder, const std::string& name) {
    return folder.empty() ? name : folder + "/" + name;
  }
  void noteDamaged(const std::string& folder, const std::string& name) {
    ++m_damaged;
    m_firstDamaged = m_damaged == 1 ? pathOf(folder, name) : m_firstDamaged;
  }

  std::string_view m_bytes;
  std::string m_filled;  ///< a file that was cut off
  SharedImage m_image;
  base::Budget m_budget;
  bool m_isCut = false;
  bool m_isOurs = false;
  std::size_t m_objects = 0;
  std::uint64_t m_longest = 0;  ///< values of one row
  std::uint64_t m_held = 0;
  bool m_isExceeded = false;
  std::size_t m_others = 0;
  std::size_t m_damaged = 0;
  std::string m_firstOther;
  std::string m_firstDamaged;
  Hdf5Content m_content;
};

/// Nothing below fails but for want of memory.
void require(herr_t done) {
  RIVULET_ASSERT(done >= 0);
}

/// Of a fixed length: of damaged texts of any length, the library reads beyond its memory (1.10.8).
Handle textType(std::size_t bytes) {
  Handle type = made(H5Tcopy(H5T_C_S1), H5Tclose);
  require(H5Tset_size(type.id(), std::max<std::size_t>(bytes, 1)));
  require(H5Tset_strpad(type.id(), H5T_STR_NULLPAD));
  require(H5Tset_cset(type.id(), H5T_CSET_UTF8));
  return type;
}

void writeText(hid_t object, const char* name, const std::string& text) {
  const Handle type = textType(text.size());
  const Handle space = made(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute =
      made(H5Acreate2(object, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(H5Awrite(attribute.id(), type.id(), text.c_str()));
}

/// Members keep the order in which they are made.
Handle groupCreation(hid_t kind) {
  Handle creation = made(H5Pcreate(kind), H5Pclose);
  require(H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
  return creation;
}

Handle makeGroup(hid_t parent, const std::string& name) {
  const Handle creation = groupCreation(H5P_GROUP_CREATE);
  return made(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Gclose);
}

/// A slash would begin a folder, and a point alone is the folder itself.
std::string linkName(hid_t group, std::string_view name) {
  std::string plain(name.substr(0, kTextMax / 2));
  std::replace(plain.begin(), plain.end(), '/', '|');
  plain = plain.empty() || plain == "." ? "_" + plain : plain;
  std::string unique = plain;
  for (int count = 2; H5Lexists(group, unique.c_str(), H5P_DEFAULT) > 0; ++count) {
    unique = plain + " (" + std::to_string(count) + ")";
  }
  return unique;
}

Handle makeDataset(hid_t group, const std::string& name, hid_t type, std::size_t count) {
  const hsize_t size = count;
  const hsize_t chunk = std::min(size, kChunk);
  const Handle space = made(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Handle creation = made(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  // This also gives the header a checksum. The newer formats of whole files, which would do so,
  // too, have a wrong one in an image in memory (1.10.8).
  require(H5Pset_attr_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED));
  if (count > 0) {
    require(H5Pset_chunk(creation.id(), 1, &chunk));
    require(H5Pset_shuffle(creation.id()));
    if (H5Zfilter_avail(H5Z_FILTER_DEFLATE) > 0) {
      require(H5Pset_deflate(creation.id(), kDeflate));
    }
    require(H5Pset_fletcher32(creation.id()));
    // Values that a damaged index does not find are not there.
    if (H5Tget_class(type) == H5T_FLOAT) {
      require(H5Pset_fill_value(creation.id(), H5T_NATIVE_DOUBLE, &kNoValue));
    }
  }
  return made(
      H5Dcreate2(group, name.c_str(), type, space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
      H5Dclose);
}

void writeNumbers(hid_t group, std::string_view name, std::string_view unit,
                  const std::vector<double>& values) {
  const Handle dataset = makeDataset(group, linkName(group, name), H5T_IEEE_F64LE, values.size());
  if (!values.empty()) {
    require(
        H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  }
  writeText(dataset.id(), "name", std::string(name));
  Checksum checksum;
  checksum.add(values);
  writeText(dataset.id(), kChecksum, checksum.text());
  if (!unit.empty()) {
    writeText(dataset.id(), "unit", std::string(unit));
  }
}

void writeTexts(hid_t group, const char* name, const std::vector<std::string_view>& texts) {
  std::size_t longest = 1;
  for (const std::string_view text : texts) {
    longest = std::max(longest, text.size());
  }
  std::string cells(texts.size() * longest, '\0');
  for (std::size_t i = 0; i < texts.size(); ++i) {
    texts[i].copy(&cells[i * longest], longest);
  }
  const Handle type = textType(longest);
  const Handle dataset = makeDataset(group, name, type.id(), texts.size());
  if (!texts.empty()) {
    require(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, cells.data()));
  }
}

void writeEvents(hid_t root, const std::vector<SignalEvent>& events, base::Instant from,
                 base::Instant to) {
  std::vector<double> begins;
  std::vector<double> ends;
  std::vector<std::string_view> kinds;
  std::vector<std::string_view> texts;
  for (const SignalEvent& event : events) {
    if (event.from <= to && event.to >= from) {
      begins.push_back(base::toSeconds(event.from.time_since_epoch()));
      ends.push_back(base::toSeconds(event.to.time_since_epoch()));
      kinds.push_back(event.kind);
      texts.push_back(event.text);
    }
  }
  const Handle group = makeGroup(root, kEventGroup);
  writeNumbers(group.id(), "from", "s", begins);
  writeNumbers(group.id(), "to", "s", ends);
  writeTexts(group.id(), "kind", kinds);
  writeTexts(group.id(), "text", texts);
}

void writeSignals(hid_t root, const std::vector<ExportedSignal>& exported, base::Instant from,
                  base::Instant to, std::string_view timeName, std::string_view timeUnit) {
  int number = 0;
  std::vector<double> values;
  for (const SharedTimes& times : sharedTimesOf(exported, from, to)) {
    const Handle group = makeGroup(root, "signals_" + std::to_string(++number));
    values.clear();
    for (std::size_t i = times.begin; i < times.end; ++i) {
      const base::Instant at = times.members.front()->samples->timeAt(i);
      values.push_back(base::toSeconds(at.time_since_epoch()));
    }
    writeNumbers(group.id(), timeName, timeUnit, values);
    for (const ExportedSignal* member : times.members) {
      values.clear();
      for (std::size_t i = times.begin; i < times.end; ++i) {
        values.push_back(member->samples->valueAt(i));
      }
      writeNumbers(group.id(), member->name, member->unit, values);
    }
  }
}

/// Sentences of the library are for its own developers.
void silence() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace

bool hasHdf5() {
  return true;
}

base::Result<Hdf5Content> readHdf5(std::string_view bytes, const base::Budget& budget) {
  const std::lock_guard lock(libraryMutex);
  silence();
  return Reader(bytes, budget).read();
}

base::Result<std::string> printHdf5(const std::vector<ExportedSignal>& exported,
                                    const std::vector<SignalEvent>& events, base::Instant from,
                                    base::Instant to, std::string_view timeName,
                                    std::string_view timeUnit) {
  const std::lock_guard lock(libraryMutex);
  silence();
  const Handle access = made(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  require(H5Pset_fapl_core(access.id(), 1U << 20U, false));
  const Handle creation = groupCreation(H5P_FILE_CREATE);
  const Handle file = made(H5Fcreate("image", H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
  {
    const Handle root = made(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose);
    writeText(root.id(), "format", kFormat);
    writeText(root.id(), "version", kVersion);
    writeSignals(root.id(), exported, from, to, timeName, timeUnit);
    writeEvents(root.id(), events, from, to);
  }
  require(H5Fflush(file.id(), H5F_SCOPE_GLOBAL));
  const ssize_t size = H5Fget_file_image(file.id(), nullptr, 0);
  RIVULET_ASSERT(size > 0);
  std::string image(static_cast<std::size_t>(size), '\0');
  RIVULET_ASSERT(H5Fget_file_image(file.id(), image.data(), image.size()) == size);
  return image;
}

}  // namespace rivulet::trace
