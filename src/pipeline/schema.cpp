// Stage `schema`: the JSON Schema of the project file, for editors that complete and check while one types.
#include "project/schema.h"

#include "pipeline/stages.h"

namespace goniolux::pipeline {
namespace {

StageReport run(const StageRequest& request, core::ProgressSink&) {
  StageReport report;
  report.json = project::projectSchema();
  report.text = core::toJson(report.json);
  if (request.common.output) {
    core::writeFile(*request.common.output, report.text);
    report.files.push_back(*request.common.output);
  }
  return report;
}

}  // namespace

Stage schemaStage() {
  Stage stage;
  stage.name = "schema";
  stage.title = "The JSON Schema of the project file";
  stage.help = "Prints the schema (draft 2020-12), or writes it to the file given with -o.";
  stage.run = run;
  return stage;
}

}  // namespace goniolux::pipeline
