// The makers of the stages' registry entries, one per file of this room. To add a stage: write pipeline/<name>.cpp,
// declare its maker here, and list it in stages.cpp.
#pragma once

#include "pipeline/stage.h"

namespace goniolux::pipeline {

Stage newStage();
Stage importStage();
Stage exportStage();
Stage runStage();
Stage checkStage();
Stage planStage();
Stage illuminateStage();
Stage scenesStage();
Stage renderStage();
Stage displayStage();
Stage probeStage();
Stage compareStage();
Stage mixStage();
Stage glareStage();
Stage plotStage();
Stage reportStage();
Stage studyStage();
Stage verifyStage();
Stage luminaireStage();
Stage spectrumStage();
Stage schemaStage();

}  // namespace goniolux::pipeline
