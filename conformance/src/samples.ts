import { COORDINATE_SAMPLES } from './cases/coordinates.ts'
import { DRIVER_SAMPLES } from './cases/drivers.ts'
import { LAYER_SAMPLES } from './cases/layers.ts'
import { REFUSED_SAMPLES } from './cases/refused.ts'
import type { Sample } from './sample.ts'

/** All sample files, one for each rule. */
export const SAMPLES: readonly Sample[] = [
  ...LAYER_SAMPLES,
  ...COORDINATE_SAMPLES,
  ...DRIVER_SAMPLES,
  ...REFUSED_SAMPLES,
]
