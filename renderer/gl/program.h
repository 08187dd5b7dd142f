// A linked program and its uniforms.
#pragma once

#include <string>
#include <unordered_map>

#include "renderer/core/vector.h"
#include "renderer/gl/handle.h"
#include "renderer/gl/texture.h"

namespace glimt::gl {

class Program {
 public:
  // `name` is for messages. The vertex attributes `position`, `texcoord` and `color` have the
  // locations 0, 1 and 2.
  // Errors: failed, with the driver's log and the line of the source that it speaks of.
  Program(const Functions& gl, const std::string& name, const std::string& vertex_source,
          const std::string& fragment_source);

  void use() const;

  // Uniforms of the program in use. A uniform that the program does not have is ignored: which ones
  // a composed shader keeps depends on the scene.
  void set(const std::string& uniform, float value);
  void set(const std::string& uniform, const Vec2& value);
  void set(const std::string& uniform, const Vec3& value);
  void set(const std::string& uniform, const Vec4& value);

  // Gives the texture a unit of its own and hands it to the sampler.
  void set(const std::string& sampler, const Texture& texture);

 private:
  GLint location(const std::string& uniform);

  ProgramHandle handle_;
  std::unordered_map<std::string, GLint> locations_;
  std::unordered_map<std::string, int> units_;
};

}  // namespace glimt::gl
