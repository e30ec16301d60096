import { chinAndNeck } from './chin.ts'
import { eyes } from './eyes.ts'
import { forehead } from './forehead.ts'
import { frown } from './frown.ts'
import { mouth } from './mouth.ts'
import { nose } from './nose.ts'
import type { Build, Region } from './region.ts'

/** All parts of a face that crease. */
export function regionsOf(build: Build): Region[] {
  return [forehead, frown, nose, eyes, mouth, chinAndNeck].flatMap((part) => part(build))
}
