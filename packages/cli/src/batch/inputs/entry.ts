import type { JobOptions } from '../jobs/job-options.ts'

export interface Entry {
  /** Path or URL. */
  input: string
  /** Path or URL. Absent for commands that write no file. */
  output?: string
  options: JobOptions
  /** Content identity, if the S3 listing contained it. See `FileStore.identify`. */
  identity?: string
}
