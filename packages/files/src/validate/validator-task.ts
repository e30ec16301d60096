import type { Issue } from 'gltf-validator'

/** What the Khronos validator is to check. */
export interface ValidatorTask {
  /** Taken over by the thread that it runs in. */
  bytes: Uint8Array<ArrayBuffer>
  /** The files that it refers to, by normalised paths. */
  files: ReadonlyMap<string, Uint8Array>
  maxIssues: number
}

/** What came of it: what it found, or else why it found nothing. */
export interface ValidatorOutcome {
  issues?: Issue[]
  failure?: string
}
