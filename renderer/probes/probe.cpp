#include "renderer/probes/probe.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/core/error.h"
#include "renderer/shader/composer.h"

namespace glimt {
namespace {

std::string compose(std::vector<std::string> files, const std::string& text, int inputs) {
  files.insert(files.begin(), "layout.h");
  return composeProbe(files, fmt::format("{}\n{}", text, probeMain(inputs)));
}

gl::Texture inputTexture(const gl::Device& device, std::vector<Vec4> list, int width, int height) {
  list.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return gl::Texture::floats(device.gl(), device.floatForm(), width, height, list);
}

void require(bool condition, const char* what) {
  if (!condition) throw Error(ErrorKind::failed, fmt::format("a probe cannot run: {}", what));
}

}  // namespace

std::string probeMain(int inputs) {
  std::string samplers = "uniform vec2 uProbeStep;\n";
  std::string values;
  for (int i = 0; i < inputs; ++i) {
    samplers += fmt::format("uniform sampler2D uInput{};\n", i);
    values += fmt::format("{}texture2D(uInput{}, at)", i ? ", " : "", i);
  }
  return fmt::format(
      "{}void main() {{\n  vec2 at = pixelCenter() * uProbeStep;\n  writeTexel(probe({}));\n}}\n",
      samplers, values);
}

Probe::Probe(const gl::Device& device, const std::vector<std::string>& files,
             const std::string& text, int inputs)
    : Probe(device, compose(files, text, inputs)) {}

Probe::Probe(const gl::Device& device, const std::string& shader, int gles)
    : device_(&device), program_(device.gl(), "probe", composeVertexShader(gles), shader) {}

std::vector<Vec4> Probe::run(const std::vector<std::vector<Vec4>>& lists, const Binder& bind,
                             int width) {
  const std::size_t count = lists.at(0).size();
  const auto other = [&](const auto& list) { return list.size() != count; };
  require(count > 0 && std::none_of(lists.begin(), lists.end(), other), "its inputs do not match");
  const int height = static_cast<int>((count - 1) / static_cast<std::size_t>(width)) + 1;
  require(std::max(width, height) <= device_->maxTextureSize(), "its inputs do not fit a texture");

  std::vector<gl::Texture> inputs;
  for (const auto& list : lists) inputs.push_back(inputTexture(*device_, list, width, height));
  const gl::Target target(gl::Texture::floats(device_->gl(), device_->floatForm(), width, height));

  program_.use();
  program_.set("uZero", Vec4(0));
  program_.set("uProbeStep", 1.0f / Vec2(width, height));
  if (bind) bind(program_);
  for (std::size_t i = 0; i < inputs.size(); ++i)
    program_.set(fmt::format("uInput{}", i), inputs[i]);
  target.bind();
  device_->draw({0, 0, width, height});
  std::vector<Vec4> results = target.readFloats();
  require(device_->gl().GetError() == GL_NO_ERROR, "GL answers with an error");
  results.resize(count);
  return results;
}

}  // namespace glimt
