#include "app/accuracy/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/accuracy/error_time_chart.h"
#include "app/png_url.h"
#include "app/svg.h"
#include "renderer/core/wording.h"

namespace glimt {
namespace {

constexpr const char* kHead = R"html(<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>What accuracy costs</title>
<style>
body { font: 15px/1.5 system-ui, sans-serif; color: #222; margin: 2em auto; max-width: 1340px; padding: 0 1em; }
h1 { font-size: 1.5em; } h2 { font-size: 1.15em; margin-top: 2em; }
table { border-collapse: collapse; } td, th { padding: .25em .9em .25em 0; text-align: right; vertical-align: top; }
th { color: #555; font-weight: normal; border-bottom: 1px solid #ccc; }
td.text, th.text { text-align: left; }
code { background: #f3f3f3; padding: .1em .35em; user-select: all; }
.charts { display: flex; flex-wrap: wrap; gap: 1em; } .charts svg { max-width: 100%; height: auto; }
.stack { position: relative; display: inline-block; line-height: 0; }
.stack img { width: min(90vw, 640px); image-rendering: pixelated; }
.stack img + img { position: absolute; left: 0; top: 0; }
input[type=range] { width: min(90vw, 640px); } .quiet { color: #555; }
</style></head><body>
)html";

constexpr const char* kScript = R"html(<script>
const byId = id => document.getElementById(id);
function show() {
  for (const side of ["left", "right"]) {
    const chosen = pictures[byId(side).value];
    byId(side + "-picture").src = byId("difference").checked && chosen.difference || chosen.picture;
  }
  byId("left-picture").style.clipPath = `inset(0 ${100 - byId("slider").value}% 0 0)`;
}
for (const side of ["left", "right"])
  pictures.forEach((p, i) => byId(side).add(new Option(p.name, i)));
byId("left").value = 0; byId("right").value = pictures.length - 1;
for (const id of ["left", "right", "slider", "difference"]) byId(id).addEventListener("input", show);
show();
</script>
)html";

// As a shell takes it.
std::string quoted(const std::string& word) {
  const std::string plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

class Page {
 public:
  Page(const ReportSubject& subject, const AccuracyResult& result)
      : subject_(subject), result_(result), frontier_(frontierOf(result.curves)) {}

  std::string text(const std::vector<ReportPicture>& pictures) {
    addTitle();
    addRecommendations();
    addBudget();
    addPictures(pictures);
    addCharts();
    return page_ + "</body></html>\n";
  }

 private:
  template <typename... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    page_ += fmt::format(format, std::forward<Values>(values)...);
  }

  void addTitle() {
    page_ = kHead;
    add("<h1>What accuracy costs: {}</h1>\n", escapedMarkup(printable(subject_.scene)));
    add("<p class=\"quiet\">{} x {} pixels on {}, glimt {}. ", subject_.width, subject_.height,
        escapedMarkup(printable(result_.context.renderer)), escapedMarkup(subject_.version));
    if (subject_.measured_width != subject_.width)
      add("Measured with {} x {} pixels, whose error is the same; times are multiplied by {:.3g}, "
          "which is how much longer a sample of the whole picture takes. ",
          subject_.measured_width, subject_.measured_height, subject_.time_factor);
    if (result_.reference_samples > 0)
      add("The reference has {} samples of up to {} bounces and is wrong by {} itself.",
          grouped(static_cast<std::uintmax_t>(result_.reference_samples)),
          result_.reference_bounces, percent(result_.reference_noise));
    else
      add("The reference was given.");
    add("</p>\n<p>Error is the root of the mean squared relative difference of brightness from the "
        "reference: 10% is coarse grain, 2% is hard to see, and half the error takes up to four "
        "times the time.</p>\n");
  }

  double wholeSeconds(double seconds) const { return seconds * subject_.time_factor; }

  void addRecommendations() {
    add("<h2>The cheapest way to an error</h2>\n<table><tr><th>error</th><th>samples</th>"
        "<th>time</th><th class=\"text\">command</th></tr>\n");
    for (const Recommendation& way : recommendationsOf(result_.curves))
      add("<tr><td>{}</td><td>{}</td><td>{}</td><td class=\"text\"><code>{}</code></td></tr>\n",
          percent(way.goal), grouped(static_cast<std::uintmax_t>(way.samples)),
          duration(wholeSeconds(way.seconds)),
          escapedMarkup(commandOf(subject_, result_.curves[way.curve], way.samples)));
    add("</table>\n<p class=\"quiet\">Errors that are not listed are below what the limits of "
        "every "
        "variant leave. Times beyond those measured follow from how the error fell.</p>\n");
  }

  void addBudget() {
    const ErrorBudget& budget = result_.budget;
    if (budget.samples == 0) return;
    add("<h2>What the error is made of</h2>\n<p>As asked, after {} samples. Parts that have "
        "nothing "
        "to do with each other add up as squares.</p>\n<table>"
        "<tr><th class=\"text\">part</th><th>error</th><th class=\"text\"></th></tr>\n",
        grouped(static_cast<std::uintmax_t>(budget.samples)));
    const auto row = [&](const char* part, double error, const std::string& what) {
      add("<tr><td class=\"text\">{}</td><td>{}</td><td class=\"text quiet\">{}</td></tr>\n", part,
          percent(error), what);
    };
    row("noise", budget.noise, "estimated while rendering; falls with more samples");
    row("truncation", budget.truncation,
        fmt::format("light beyond the limit on bounces; {} bring it below this noise",
                    budget.enough_bounces));
    row("clamp", budget.clamp, "light that the clamp took");
    row("together", std::hypot(budget.noise, budget.limits), "");
    row("measured", budget.measured, "against the reference");
    add("</table>\n");
  }

  void addPictures(const std::vector<ReportPicture>& pictures) {
    add("<h2>Side by side</h2>\n<p>Left <select id=\"left\"></select> right <select id=\"right\">"
        "</select> <label><input type=\"checkbox\" id=\"difference\"> where they differ visibly "
        "from "
        "the reference (FLIP)</label></p>\n<div class=\"stack\"><img id=\"right-picture\" alt=\"\">"
        "<img id=\"left-picture\" alt=\"\"></div><br>\n"
        "<input type=\"range\" id=\"slider\" min=\"0\" max=\"100\" value=\"50\">\n"
        "<script>const pictures = [\n");
    for (const ReportPicture& picture : pictures)
      add("{{name: {}, picture: \"{}\", difference: \"{}\"}},\n", Json(picture.name).dump(),
          pngUrl(picture.png), pngUrl(picture.difference));
    add("];</script>\n");
    page_ += kScript;
  }

  std::vector<std::string> knobs() const {
    std::vector<std::string> knobs;
    for (const AccuracyCurve& curve : result_.curves)
      if (!curve.knob.empty() && std::find(knobs.begin(), knobs.end(), curve.knob) == knobs.end())
        knobs.push_back(curve.knob);
    return knobs;
  }

  ChartCurve chartCurveOf(const AccuracyCurve& curve) const {
    ChartCurve drawn{curve.name(), curve.points};
    for (AccuracyPoint& point : drawn.points) point.seconds = wholeSeconds(point.seconds);
    return drawn;
  }

  void addCharts() {
    add("<h2>Error against time</h2>\n<p>Encircled: of all that was measured, nothing was more "
        "exact "
        "in as little time. The numbers are in report.csv and report.json.</p>\n"
        "<div class=\"charts\">\n");
    for (const std::string& knob : knobs()) {
      std::vector<ChartCurve> drawn{chartCurveOf(result_.curves.front())};
      std::vector<AccuracyPoint> marked;
      for (std::size_t i = 0; i < result_.curves.size(); ++i) {
        if (i > 0 && result_.curves[i].knob != knob) continue;
        if (i > 0) drawn.push_back(chartCurveOf(result_.curves[i]));
        for (const FrontierPoint& best : frontier_)
          if (best.curve == i)
            marked.push_back({0, wholeSeconds(best.point.seconds), best.point.error});
      }
      page_ += errorTimeChart(knob, drawn, marked, marked.empty() ? "" : "best of all") + "\n";
    }
    add("</div>\n");
  }

  const ReportSubject& subject_;
  const AccuracyResult& result_;
  std::vector<FrontierPoint> frontier_;
  std::string page_;
};

}  // namespace

std::string commandOf(const ReportSubject& subject, const AccuracyCurve& curve, double samples) {
  std::string command = fmt::format("glimt render {} -o picture.png --spp {:.0f} --size {}x{}",
                                    quoted(subject.scene), samples, subject.width, subject.height);
  // What the variant turns takes the place of what was asked for.
  for (const auto& [name, value] : subject.options)
    if ((curve.options + " ").find(name + " ") == std::string::npos)
      command += fmt::format(" {} {}", name, quoted(value));
  return curve.options.empty() ? command : command + " " + curve.options;
}

std::string reportPage(const ReportSubject& subject, const AccuracyResult& result,
                       const std::vector<ReportPicture>& pictures) {
  return Page(subject, result).text(pictures);
}

}  // namespace glimt
