// The charts are files that any program reads, and say what they show.
#include "app/bench_chart.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <regex>

#include "app/svg.h"

using namespace glimt;
using Catch::Matchers::Contains;

namespace {

// Every tag is closed in the right order, attributes are quoted, and text holds no markup.
bool isWellFormed(const std::string& xml) {
  static const std::regex kTag(R"(<(/?)([a-z]+)((?: [A-Za-z-]+="[^"<]*")*)(/?)>)");
  static const std::regex kText(R"((?:[^<>&]|&(?:amp|lt|gt|quot);)*)");
  std::vector<std::string> open;
  std::size_t end = 0;
  for (std::sregex_iterator tag(xml.begin(), xml.end(), kTag); tag != std::sregex_iterator();
       ++tag) {
    const auto begin = static_cast<std::size_t>(tag->position());
    if (!std::regex_match(xml.substr(end, begin - end), kText)) return false;
    end = begin + static_cast<std::size_t>(tag->length());
    const std::string name = (*tag)[2];
    if ((*tag)[1].length() > 0) {
      if (open.empty() || open.back() != name) return false;
      open.pop_back();
    } else if ((*tag)[4].length() == 0) {
      open.push_back(name);
    }
  }
  return open.empty() && end > 0 && xml.substr(end) == "\n";
}

BenchConditions conditions() {
  BenchConditions conditions;
  conditions.context.renderer = "Card <A> & \"B\"";
  conditions.context.version = "OpenGL ES 2.0";
  conditions.side = 96;
  return conditions;
}

TraversalRow traversalRow(const std::string& name, std::size_t triangles) {
  TraversalRow row;
  row.scene = "knot";
  row.triangles = triangles;
  row.traversal = name;
  row.rates = {Rate{3, 2, 4}, Rate{2, 1, 3}, Rate{2.5, 2, 3}};
  return row;
}

PassesRow passesRow(const std::string& variant, int bounces) {
  PassesRow row;
  row.scene = "box";
  row.triangles = 38;
  row.bounces = bounces;
  row.variant = variant;
  row.compile_seconds = 0.5 * bounces;
  row.sample_seconds = Spread{0.1 * bounces, 0.09 * bounces, 0.12 * bounces};
  row.agrees = true;
  return row;
}

std::vector<PassesRow> passesRows() {
  std::vector<PassesRow> rows;
  for (const int bounces : {1, 2, 4})
    for (const char* variant : {kPasses, kLoop, kUnrolled})
      rows.push_back(passesRow(variant, bounces));
  return rows;
}

std::vector<EffectsRow> effectsRows() {
  std::vector<EffectsRow> rows;
  for (const char* effect : {kOwnEffects, "no_mirror", "glass", kAllEffects}) {
    EffectsRow row;
    row.scene = "box";
    row.triangles = 38;
    row.bounces = 4;
    row.effect = effect;
    if (row.effect.starts_with(kWithheld)) row.withheld = {"mirror"};
    row.compile_seconds = Spread{0.5, 0.4, 0.6};
    row.sample_seconds = Spread{0.2, 0.1, 0.3};
    row.ratio = Spread{1.25, 1.2, 1.3};
    rows.push_back(row);
  }
  return rows;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

}  // namespace

TEST_CASE("a drawing is well-formed whatever its texts are") {
  Svg svg(100, 50);
  svg.text({10, 10}, "a < b && c > \"d\" ]]> \x01\n", {12, "#000000", "end", true, -90});
  svg.line({0, 0}, {100, 50});
  svg.circle({50, 25}, 3, "#ff0000");
  CHECK(isWellFormed(svg.file()));
  CHECK_THAT(svg.file(), Contains("a &lt; b &amp;&amp; c &gt; &quot;d&quot; ]]&gt;"));
  CHECK_THAT(svg.file(), Contains("width=\"100\" height=\"50\""));
}

TEST_CASE("rectangles have positive sizes whichever corners they are given") {
  Svg svg(100, 100);
  svg.rectangle({30, 40}, {10, 15}, "#123456");
  CHECK_THAT(svg.file(), Contains("<rect x=\"10\" y=\"15\" width=\"20\" height=\"25\""));
}

TEST_CASE("the traversals' chart names device, size, meshes, kinds of rays and traversals") {
  std::vector<TraversalRow> rows{traversalRow(kEmbree, 996), traversalRow("octant", 996),
                                 traversalRow(kEmbree, 69996), traversalRow("stack", 69996)};
  const std::string chart = chartOf(rows, conditions());
  CHECK(isWellFormed(chart));
  for (const char* label :
       {"Card &lt;A&gt; &amp; &quot;B&quot;", "OpenGL ES 2.0", "96 x 96", ">996 triangles<",
        ">69,996 triangles<", "Million rays per second", ">camera rays<", ">bounce rays<",
        ">shadow rays<", ">octant<", ">stack<", ">Embree on the processor<"})
    CHECK_THAT(chart, Contains(label));
}

TEST_CASE("a traversal that does not run on a mesh has no bar there") {
  TraversalRow unfit = traversalRow("trail", 996);
  unfit.rates.reset();
  const std::string chart = chartOf({traversalRow("octant", 996), unfit}, conditions());
  CHECK(isWellFormed(chart));
  CHECK_THAT(chart, !Contains("trail"));
  CHECK_THAT(chart, !Contains("Embree"));
}

TEST_CASE("the passes' chart names scenes, units and bounces, and has a line for each variant") {
  const std::string chart = chartOf(passesRows(), conditions());
  CHECK(isWellFormed(chart));
  for (const char* label :
       {"box, 38 triangles: seconds per sample", "box, 38 triangles: seconds to compile",
        "secondary bounces", "96 x 96", "passes: ", "loop: ", "unrolled: ", ">4<"})
    CHECK_THAT(chart, Contains(label));
  CHECK(count(chart, "stroke-width=\"2\"") == 6);
  CHECK_THAT(chart, !Contains("refused"));
}

TEST_CASE("the passes' chart shows where a driver refused the shader") {
  std::vector<PassesRow> rows = passesRows();
  rows.back().compile_seconds.reset();
  rows.back().sample_seconds.reset();
  const std::string chart = chartOf(rows, conditions());
  CHECK(isWellFormed(chart));
  CHECK(count(chart, ">refused<") == 2);
}

TEST_CASE("the effects' chart names scene, bounces and effects, and has two bars for each") {
  std::vector<EffectsRow> rows = effectsRows();
  const std::string chart = chartOf(rows, conditions());
  CHECK(isWellFormed(chart));
  for (const char* label :
       {"box, 38 triangles, 4 bounces", "96 x 96", "seconds per sample", "seconds to compile",
        ">none<", ">no_mirror<", ">glass<", ">all<", ">1.25<"})
    CHECK_THAT(chart, Contains(label));
  CHECK_THAT(chart, !Contains("refused"));
  rows[1].compile_seconds.reset();
  rows[1].sample_seconds.reset();
  rows[1].ratio.reset();
  const std::string without = chartOf(rows, conditions());
  CHECK(isWellFormed(without));
  CHECK(count(without, ">refused<") == 2);
  CHECK(count(chart, "<rect") == count(without, "<rect") + 2);
}
