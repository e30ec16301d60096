import type { Issue } from 'gltf-validator'

/** Input of the thread that runs the Khronos validator. */
export interface ValidatorTask {
  /** Transferred to the thread. */
  bytes: Uint8Array<ArrayBuffer>
  /** Referenced files, by normalised path. */
  files: ReadonlyMap<string, Uint8Array>
  maxIssues: number
}

/** Result of the validator: its issues, or the reason for a failure. */
export interface ValidatorOutcome {
  issues?: Issue[]
  failure?: string
}
