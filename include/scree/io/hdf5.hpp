// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <hdf5.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

/// Owning handles and readable error messages for the HDF5 C interface, as far as scree's writers need them.
namespace scree::hdf5 {

/// The owner of one HDF5 identifier, which it closes with a given function. Movable, but not copyable.
class Handle {
 public:
  /// An HDF5 function that closes an identifier.
  using Close = herr_t (*)(hid_t);

  Handle() = default;
  /// Takes ownership of an identifier, which `closer` closes.
  Handle(hid_t id, Close closer) : id_(id), close_(closer) {}
  /// Takes over the identifier of another handle.
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }

  operator hid_t() const { return id_; }

  /// Closes the identifier and returns HDF5's status: closing a file writes and can therefore fail, which the
  /// destructor cannot report.
  [[nodiscard]] herr_t close() { return close_(std::exchange(id_, H5I_INVALID_HID)); }

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// A guard that stops HDF5 from printing its error stack as long as it exists: scree reports one message of its own.
class Silence {
 public:
  /// Stops HDF5 from printing errors.
  Silence() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Silence() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  Silence(Silence const&) = delete;
  Silence& operator=(Silence const&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

namespace detail {

inline herr_t first_description(unsigned, H5E_error2_t const* entry, void* text) {
  auto& cause = *static_cast<std::string*>(text);
  if (cause.empty() && entry->desc != nullptr) cause = entry->desc;
  return 0;
}

}  // namespace detail

/// Returns why the last HDF5 call failed: the reason of the operating system if there is one ("No space left on
/// device"), otherwise HDF5's innermost description.
inline std::string last_cause() {
  std::string cause;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, detail::first_description, &cause);
  std::string const mark = "error message = '";
  if (auto const begin = cause.find(mark); begin != std::string::npos) {
    auto const from = begin + mark.size();
    return cause.substr(from, cause.find('\'', from) - from);
  }
  return cause.empty() ? "HDF5 gives no reason" : cause;
}

/// The exception of check(). A writer catches it and adds the name of the file and the failed action.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Returns an HDF5 return value; throws Failure with the cause if it is negative.
template <class T>
T check(T result) {
  if (result < 0) throw Failure(last_cause());
  return result;
}

/// Returns a dataspace of one value.
inline Handle scalar_space() { return {check(H5Screate(H5S_SCALAR)), H5Sclose}; }
/// Opens a group and returns it. Throws Failure if there is no group of this name.
inline Handle open_group(hid_t where, char const* name) {
  return {check(H5Gopen2(where, name, H5P_DEFAULT)), H5Gclose};
}
/// Creates a group and returns it. Throws Failure if that fails.
inline Handle create_group(hid_t where, char const* name) {
  return {check(H5Gcreate2(where, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)), H5Gclose};
}

/// Returns properties for creating a dataset without time stamps, so that identical runs write identical files.
inline Handle without_times() {
  Handle creation{check(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose};
  check(H5Pset_obj_track_times(creation, false));
  return creation;
}

/// Returns properties for opening a file without locking it: HDF5 would fail on network file systems that have no
/// locks.
inline Handle without_locks() {
  Handle access{check(H5Pcreate(H5P_FILE_ACCESS)), H5Pclose};
#if H5_VERSION_GE(1, 10, 7)
  check(H5Pset_file_locking(access, false, true));
#endif
  return access;
}

/// Returns the type of a fixed-length string for a text (VTK rejects variable-length strings for Type).
inline Handle text_type(std::string const& text) {
  Handle type{check(H5Tcopy(H5T_C_S1)), H5Tclose};
  bool const ascii = std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 128; });
  check(H5Tset_cset(type, ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8));
  check(H5Tset_size(type, text.empty() ? 1 : text.size()));
  check(H5Tset_strpad(type, H5T_STR_NULLPAD));
  return type;
}
/// Writes a text of less than 64 KiB as an attribute.
inline void write_text(hid_t where, std::string const& name, std::string const& text) {
  Handle const type = text_type(text);
  Handle const attribute{check(H5Acreate2(where, name.c_str(), type, scalar_space(), H5P_DEFAULT, H5P_DEFAULT)),
                         H5Aclose};
  check(H5Awrite(attribute, type, text.c_str()));
}

}  // namespace scree::hdf5
