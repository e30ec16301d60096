import type { JobOptions } from '../jobs/job-options.ts'

/** One wish of the user: an input, and where its result goes. */
export interface Entry {
  /** A path or an address. */
  input: string
  /** Absent where the command makes no file. */
  output?: string
  options: JobOptions
  /** Where a list told it; see `Place.identify`. */
  identity?: string
}
