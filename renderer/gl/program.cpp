#include "renderer/gl/program.h"

#include <fmt/format.h>

#include <array>
#include <regex>
#include <sstream>

#include "renderer/gl/errors.h"

namespace glimt::gl {
namespace {

std::string firstLine(const std::string& log) {
  if (log.empty()) return "the driver does not say why";
  return log.substr(0, log.find('\n'));
}

std::string sourceLine(const std::string& source, int number) {
  std::istringstream lines(source);
  std::string line;
  while (number-- > 0 && std::getline(lines, line)) {
  }
  return line;
}

// Drivers write "0:LINE(COLUMN): error" or "0(LINE) : error"; the line itself says more than both.
std::string quotedLine(const std::string& source, const std::string& log) {
  std::smatch match;
  if (!std::regex_search(log, match, std::regex(R"(0[:(](\d+))"))) return {};
  return fmt::format(" in \"{}\"", sourceLine(source, std::stoi(match[1])));
}

template <class GetParameter, class GetLog>
std::string readLog(GLuint name, GetParameter parameter, GetLog read) {
  GLint length = 0;
  parameter(name, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  GLsizei written = 0;
  read(name, length, &written, log.data());
  log.resize(static_cast<std::size_t>(written));
  return log;
}

ShaderHandle compile(const Functions& gl, const std::string& name, GLenum stage,
                     const std::string& source) {
  ShaderHandle shader(gl, gl.CreateShader(stage));
  const char* text = source.c_str();
  gl.ShaderSource(shader.name(), 1, &text, nullptr);
  gl.CompileShader(shader.name());
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (!compiled) {
    checkErrors(gl, fmt::format("compiling the shader '{}'", name));
    const std::string log = readLog(shader.name(), gl.GetShaderiv, gl.GetShaderInfoLog);
    throw Error(ErrorKind::failed, fmt::format("the shader '{}' does not compile: {}{}", name,
                                               firstLine(log), quotedLine(source, log)));
  }
  return shader;
}

// Samplers that a linked program reads: it takes as many texture units.
int samplersOf(const Functions& gl, GLuint program) {
  GLint uniforms = 0;
  gl.GetProgramiv(program, GL_ACTIVE_UNIFORMS, &uniforms);
  int samplers = 0;
  for (GLint i = 0; i < uniforms; ++i) {
    std::array<char, 64> name{};
    GLint size = 0;
    GLenum type = 0;
    gl.GetActiveUniform(program, static_cast<GLuint>(i), name.size(), nullptr, &size, &type,
                        name.data());
    if (type == GL_SAMPLER_2D) ++samplers;
  }
  return samplers;
}

void demandUnits(const Functions& gl, GLuint program, const std::string& name) {
  GLint units = 0;
  gl.GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
  const int samplers = samplersOf(gl, program);
  if (samplers <= units) return;
  throw Error(ErrorKind::no_gl,
              fmt::format("the shader '{}' reads {} textures, but this device has {} texture "
                          "units; use another device, or a scene with fewer effects",
                          name, samplers, units));
}

}  // namespace

Program::Program(const Functions& gl, const std::string& name, const std::string& vertex_source,
                 const std::string& fragment_source)
    : handle_(gl, gl.CreateProgram()) {
  clearErrors(gl);
  const ShaderHandle vertex = compile(gl, name, GL_VERTEX_SHADER, vertex_source);
  const ShaderHandle fragment = compile(gl, name, GL_FRAGMENT_SHADER, fragment_source);
  gl.AttachShader(handle_.name(), vertex.name());
  gl.AttachShader(handle_.name(), fragment.name());
  GLuint place = 0;
  for (const char* const attribute : {"position", "texcoord", "color"})
    gl.BindAttribLocation(handle_.name(), place++, attribute);
  gl.LinkProgram(handle_.name());
  GLint linked = GL_FALSE;
  gl.GetProgramiv(handle_.name(), GL_LINK_STATUS, &linked);
  if (linked) {
    demandUnits(gl, handle_.name(), name);
    return;
  }
  checkErrors(gl, fmt::format("linking the shader '{}'", name));
  throw Error(
      ErrorKind::failed,
      fmt::format("the shader '{}' does not link: {}", name,
                  firstLine(readLog(handle_.name(), gl.GetProgramiv, gl.GetProgramInfoLog))));
}

void Program::use() const {
  handle_.gl().UseProgram(handle_.name());
}

void Program::set(const std::string& uniform, float value) {
  handle_.gl().Uniform1f(location(uniform), value);
}

void Program::set(const std::string& uniform, const Vec2& value) {
  handle_.gl().Uniform2f(location(uniform), value.x, value.y);
}

void Program::set(const std::string& uniform, const Vec3& value) {
  handle_.gl().Uniform3f(location(uniform), value.x, value.y, value.z);
}

void Program::set(const std::string& uniform, const Vec4& value) {
  handle_.gl().Uniform4f(location(uniform), value.x, value.y, value.z, value.w);
}

void Program::set(const std::string& sampler, const Texture& texture) {
  const GLint where = location(sampler);
  if (where < 0) return;
  const int unit = units_.try_emplace(sampler, static_cast<int>(units_.size())).first->second;
  texture.bind(unit);
  handle_.gl().Uniform1i(where, unit);
}

GLint Program::location(const std::string& uniform) {
  const auto found = locations_.find(uniform);
  if (found != locations_.end()) return found->second;
  const GLint where = handle_.gl().GetUniformLocation(handle_.name(), uniform.c_str());
  locations_.emplace(uniform, where);
  return where;
}

}  // namespace glimt::gl
