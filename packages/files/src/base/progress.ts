/** Callback for the progress of a long task, with the optional name of the current step. */
export type Progress = (done: number, total: number, step?: string) => void
