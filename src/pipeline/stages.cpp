#include "pipeline/stages.h"

namespace goniolux::pipeline {

const std::vector<Stage>& stages() {
  static const std::vector<Stage> list = {
      // the main job
      runStage(),

      // projects
      newStage(),
      importStage(),
      exportStage(),

      // from the project to its light
      checkStage(),
      planStage(),
      illuminateStage(),
      scenesStage(),

      // from light to pictures
      renderStage(),
      displayStage(),
      plotStage(),
      reportStage(),
      probeStage(),
      compareStage(),
      mixStage(),
      glareStage(),

      // many projects
      studyStage(),
      verifyStage(),

      // files on their own
      luminaireStage(),
      spectrumStage(),
      schemaStage(),
  };
  return list;
}

}  // namespace goniolux::pipeline
