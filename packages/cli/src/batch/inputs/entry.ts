import type { JobOptions } from '../jobs/job-options.ts'

/** An input and its output. */
export interface Entry {
  /** Path or URL. */
  input: string
  /** Absent for commands that write no file. */
  output?: string
  options: JobOptions
  /** Content identity, if a listing already gave it; see `FileStore.identify`. */
  identity?: string
}
