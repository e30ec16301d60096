/** Called now and then during a long task with how much of it is done, and the name of the current step. */
export type Progress = (done: number, total: number, step?: string) => void
