import type { AutoWrinkles } from 'furrow/author'
import type { FoundSkin, Glb } from 'furrow-files'
import type { PosedSurface } from './joint-poses.ts'

export interface ReportSource {
  /** Path of the output file, which may not be written yet. */
  path: string
  glb: Glb
  found: FoundSkin
  wrinkles: AutoWrinkles
  /** All surfaces with wrinkles, including `found`. */
  surfaces: readonly PosedSurface[]
  /** Value per option of `furrow auto`, by the option's name. */
  settings: Readonly<Record<string, string | number>>
  warnings: readonly string[]
}
