/** Callback that reports the progress of a long task. `step` is the name of the current step. */
export type Progress = (done: number, total: number, step?: string) => void
