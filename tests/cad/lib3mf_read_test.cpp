// Reads 3MF files with lib3mf, the library of the 3MF consortium, and prints the errors that it
// finds.
//
//   lib3mf_read_test FILE.3mf …
//
// Exit status 0: every file was read without a warning, and every object in it is a manifold and
// oriented mesh with one build item. If lib3mf 1.8 (the COM-style interface) is installed,
// test_meshes.py compiles this file.
#include <Model/COM/NMR_DLLInterfaces.h>

#include <cstdio>

namespace {

bool ok(LIB3MFRESULT result) { return result == 0; }

// Returns the reason why a file is invalid, or null if it is valid.
const char* fault(const char* path) {
  NMR::PLib3MFModel* model = nullptr;
  NMR::PLib3MFModelReader* reader = nullptr;
  if (!ok(NMR::lib3mf_createmodel(&model))) return "lib3mf makes no 3MF model";
  if (!ok(NMR::lib3mf_model_queryreader(model, "3mf", &reader)))
    return "lib3mf makes no 3MF reader";
  if (!ok(NMR::lib3mf_reader_readfromfileutf8(reader, path))) return "not readable";
  DWORD warnings = 1;
  if (!ok(NMR::lib3mf_reader_getwarningcount(reader, &warnings)) || warnings > 0) return "warnings";

  NMR::PLib3MFModelResourceIterator* objects = nullptr;
  if (!ok(NMR::lib3mf_model_getmeshobjects(model, &objects))) return "no objects";
  unsigned count = 0;
  for (BOOL more = false; ok(NMR::lib3mf_resourceiterator_movenext(objects, &more)) && more;
       ++count) {
    NMR::PLib3MFModelResource* object = nullptr;
    if (!ok(NMR::lib3mf_resourceiterator_getcurrent(objects, &object)))
      return "object not readable";
    BOOL manifold = false;
    if (!ok(NMR::lib3mf_meshobject_ismanifoldandoriented(object, &manifold)) || !manifold) {
      return "a mesh that is not manifold and oriented";
    }
    DWORD triangles = 0;
    if (!ok(NMR::lib3mf_meshobject_gettrianglecount(object, &triangles)) || triangles == 0) {
      return "an empty mesh";
    }
    std::printf("%s: %u triangles, manifold and oriented\n", path,
                static_cast<unsigned>(triangles));
  }
  if (count == 0) return "no mesh";

  NMR::PLib3MFModelBuildItemIterator* items = nullptr;
  if (!ok(NMR::lib3mf_model_getbuilditems(model, &items))) return "no build";
  unsigned placed = 0;
  for (BOOL more = false; ok(NMR::lib3mf_builditemiterator_movenext(items, &more)) && more;
       ++placed) {
  }
  return placed == count ? nullptr : "the numbers of build items and objects differ";
}

}  // namespace

int main(int argc, char** argv) {
  int failed = argc < 2 ? 1 : 0;
  for (int i = 1; i < argc; ++i) {
    if (const char* reason = fault(argv[i])) {
      std::fprintf(stderr, "%s: %s\n", argv[i], reason);
      failed = 1;
    }
  }
  return failed;
}
