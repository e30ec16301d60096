import { IFACIALMOCAP } from './ifacialmocap.ts'
import { LIVE_LINK_FACE } from './live-link-face.ts'
import { OPEN_SEE_FACE } from './openseeface.ts'
import type { LiveSource } from './source.ts'
import { VMC } from './vmc.ts'

/** All sources by name. */
export const SOURCES = {
  'live-link-face': LIVE_LINK_FACE,
  vmc: VMC,
  ifacialmocap: IFACIALMOCAP,
  openseeface: OPEN_SEE_FACE,
} satisfies Record<string, LiveSource>

export type SourceName = keyof typeof SOURCES
