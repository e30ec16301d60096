import type { AutoWrinkles } from 'furrow/author'
import type { FoundSkin, Glb } from 'furrow-files'

/** The input of a report. */
export interface ReportSource {
  /** Path of the file with the wrinkles, which need not have been written yet. */
  path: string
  glb: Glb
  found: FoundSkin
  wrinkles: AutoWrinkles
  /** By name, as on the command line. */
  settings: Readonly<Record<string, string | number>>
  warnings: readonly string[]
}
