import type { Issue } from 'gltf-validator'

/** Message to the thread that runs the Khronos validator. */
export interface ValidatorTask {
  /** Content of the file. Its buffer is transferred to the thread. */
  bytes: Uint8Array<ArrayBuffer>
  /** Content of the referenced files, by normalised path. */
  files: ReadonlyMap<string, Uint8Array>
  maxIssues: number
}

/** Message from the thread: the issues that the validator found, or the reason why it failed. */
export interface ValidatorOutcome {
  issues?: Issue[]
  failure?: string
}
