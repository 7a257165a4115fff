#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <sys/stat.h>
#include <windows.h>
// windows.h must be included before the headers below.
#include <shellapi.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <cstdlib>
#include <cwchar>
#include <utility>

#include "gearwright/base/system.hpp"

#ifdef __MINGW32__
// libstdc++ converts a std::string to a path with mbrtowc, which uses the encoding of the C locale.
// In msvcrt, this encoding cannot be UTF-8. The linker therefore replaces mbrtowc by this function
// (--wrap, cmake/gw_portable.cmake), which converts UTF-8 to UTF-16. For a character of two UTF-16
// units, the first call returns the first unit and consumes three of the four bytes. The second
// unit is kept in `state`, and the next call returns it and consumes the fourth byte.
extern "C" std::size_t __wrap_mbrtowc(wchar_t* to, const char* from, std::size_t most,
                                      std::mbstate_t* state) {
  constexpr auto kBad = static_cast<std::size_t>(-1), kPart = static_cast<std::size_t>(-2);
  if (from == nullptr) return 0;
  if (most == 0) return kPart;
  if (*state != 0) {
    *to = static_cast<wchar_t>(std::exchange(*state, 0));
    return 1;
  }
  const auto lead = static_cast<unsigned char>(*from);
  const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  if (most < bytes) return kPart;
  wchar_t units[2] = {};
  const int count =
      ::MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, from, static_cast<int>(bytes), units, 2);
  if (count == 0) {
    errno = EILSEQ;
    return kBad;
  }
  *to = units[0];
  if (count == 2) {
    *state = units[1];
    return 3;
  }
  return lead == 0 ? 0 : bytes;
}
#endif

namespace gearwright {

namespace {

constexpr std::size_t kAtOnce = std::size_t{1}
                                << 30;  // longest block of one call, whose count is an int

int open_file(const std::filesystem::path& path, int flags) {
  return ::_wopen(path.c_str(), flags | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
}

std::string utf8(const wchar_t* text, int length) {
  const int bytes = ::WideCharToMultiByte(CP_UTF8, 0, text, length, nullptr, 0, nullptr, nullptr);
  std::string out(static_cast<std::size_t>(std::max(bytes, 0)), '\0');
  ::WideCharToMultiByte(CP_UTF8, 0, text, length, out.data(), bytes, nullptr, nullptr);
  return out;
}

}  // namespace

FileHandle FileHandle::create(const std::filesystem::path& path) {
  const int file = open_file(path, _O_WRONLY | _O_CREAT | _O_TRUNC);
  return {file, file < 0 ? errno : 0};
}

FileHandle FileHandle::create_new(const std::filesystem::path& path) {
  const int file = open_file(path, _O_WRONLY | _O_CREAT | _O_EXCL);
  return {file, file < 0 ? errno : 0};
}

FileHandle FileHandle::open_to_read(const std::filesystem::path& path) {
  const int file = open_file(path, _O_RDONLY);
  return {file, file < 0 ? errno : 0};
}

int FileHandle::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const auto count = static_cast<unsigned>(std::min(bytes.size(), kAtOnce));
    _doserrno = 0;
    const int written = ::_write(descriptor_, bytes.data(), count);
    // If the disk has room for some of the bytes only, Wine fails without setting a system error.
    if (written < 0) return _doserrno == 0 ? ENOSPC : errno;
    if (written == 0) return ENOSPC;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

int FileHandle::read(std::size_t most, std::string& bytes) {
  bytes.assign(most, '\0');
  std::size_t have = 0;
  while (have < most) {
    const auto count = static_cast<unsigned>(std::min(most - have, kAtOnce));
    const int got = ::_read(descriptor_, bytes.data() + have, count);
    if (got < 0) return errno;
    if (got == 0) break;
    have += static_cast<std::size_t>(got);
  }
  bytes.resize(have);
  return 0;
}

int FileHandle::size(std::uint64_t& bytes) const {
  const __int64 length = ::_filelengthi64(descriptor_);
  if (length < 0) return errno;
  bytes = static_cast<std::uint64_t>(length);
  return 0;
}

int FileHandle::close() {
  if (descriptor_ < 0) return 0;
  return ::_close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno;
}

long process_id() { return ::_getpid(); }

bool process_has_ended(long id) {
  const HANDLE process =
      ::OpenProcess(PROCESS_QUERY_LIMITED_INFORMATION, FALSE, static_cast<DWORD>(id));
  if (process == nullptr) return ::GetLastError() == ERROR_INVALID_PARAMETER;
  DWORD status = STILL_ACTIVE;
  const bool known = ::GetExitCodeProcess(process, &status) != 0;
  ::CloseHandle(process);
  return known && status != STILL_ACTIVE;
}

std::string host_name() {
  wchar_t name[MAX_COMPUTERNAME_LENGTH + 1] = {};
  DWORD length = MAX_COMPUTERNAME_LENGTH + 1;
  if (::GetComputerNameW(name, &length) == 0) return "unnamed";
  return utf8(name, static_cast<int>(length));
}

bool is_terminal(std::FILE* stream) { return ::_isatty(::_fileno(stream)) != 0; }

std::string native_text(std::filesystem::path path) { return path.make_preferred().string(); }

std::vector<std::string> start_program(int argc, char** argv) {
#ifndef __MINGW32__
  std::setlocale(LC_CTYPE, ".UTF-8");  // the C++ library of Microsoft then converts paths as UTF-8
#endif
  for (std::FILE* stream : {stdin, stdout}) ::_setmode(::_fileno(stream), _O_BINARY);
  ::SetConsoleOutputCP(CP_UTF8);
  // The progress line is cleared by an escape sequence. The console processes such sequences
  // only in this mode.
  const HANDLE console = ::GetStdHandle(STD_ERROR_HANDLE);
  DWORD mode = 0;
  if (::GetConsoleMode(console, &mode) != 0)
    ::SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);

  int count = 0;
  wchar_t** const wide = ::CommandLineToArgvW(::GetCommandLineW(), &count);
  if (wide == nullptr) return {argv + 1, argv + argc};
  std::vector<std::string> arguments;
  for (int i = 1; i < count; ++i)
    arguments.push_back(utf8(wide[i], static_cast<int>(std::wcslen(wide[i]))));
  ::LocalFree(wide);
  return arguments;
}

}  // namespace gearwright
