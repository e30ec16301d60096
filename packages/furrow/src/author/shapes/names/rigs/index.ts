import type { RigNames } from '../rig-names.ts'
import { CHARACTER_CREATOR } from './character-creator.ts'
import { DAZ } from './daz.ts'
import { FACESHIFT } from './faceshift.ts'
import { GENERAL } from './general.ts'
import { META } from './meta.ts'
import { METAHUMAN } from './metahuman.ts'
import { MMD } from './mmd.ts'
import { SRANIPAL } from './sranipal.ts'
import { UNIFIED } from './unified.ts'
import { VROID } from './vroid.ts'

/** Names of all rigs except ARKit's. If two rigs share a name, the first one wins. */
export const RIGS: readonly RigNames[] = [
  METAHUMAN,
  CHARACTER_CREATOR,
  DAZ,
  META,
  UNIFIED,
  SRANIPAL,
  FACESHIFT,
  MMD,
  VROID,
  GENERAL,
]
