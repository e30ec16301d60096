import { BLENDSHAPE_SAMPLES } from './cases/blendshape-drivers.ts'
import { COORDINATE_SAMPLES } from './cases/coordinates.ts'
import { LAYER_SAMPLES } from './cases/layers.ts'
import { OTHER_DRIVER_SAMPLES } from './cases/other-drivers.ts'
import { REFUSED_SAMPLES } from './cases/refused.ts'
import type { Sample } from './sample.ts'

/** All samples of the conformance suite. Each tests one rule of the specification. */
export const SAMPLES: readonly Sample[] = [
  ...LAYER_SAMPLES,
  ...COORDINATE_SAMPLES,
  ...BLENDSHAPE_SAMPLES,
  ...OTHER_DRIVER_SAMPLES,
  ...REFUSED_SAMPLES,
]
