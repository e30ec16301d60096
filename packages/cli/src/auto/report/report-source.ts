import type { AutoWrinkles } from 'furrow/author'
import type { FoundSkin, Glb } from 'furrow-files'

/** Input of a report. */
export interface ReportSource {
  /** Path of the file with wrinkles, which may not exist yet. */
  path: string
  glb: Glb
  found: FoundSkin
  wrinkles: AutoWrinkles
  /** Values by option name, as on the command line. */
  settings: Readonly<Record<string, string | number>>
  warnings: readonly string[]
}
