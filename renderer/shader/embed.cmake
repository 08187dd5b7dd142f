# cmake -DOUTPUT=... -DFILES=a;b;c -P embed.cmake: writes the files' texts as C++ string literals.
set(entries "")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND entries "      {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"renderer/shader/embedded_files.h\"

namespace glimt {

const std::vector<EmbeddedFile>& embeddedFiles() {
  static const std::vector<EmbeddedFile> kFiles{
${entries}  };
  return kFiles;
}

}  // namespace glimt
")
