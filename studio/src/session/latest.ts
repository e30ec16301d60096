/** Runs a task with values, one run at a time. If several values arrive during a run, only the last of them is used. */
export class Latest<T> {
  readonly #task: (value: T) => Promise<void>
  #next: { value: T } | null = null
  #isRunning = false

  constructor(task: (value: T) => Promise<void>) {
    this.#task = task
  }

  /**
   * Runs the task with a value, or queues the value while the task runs. A failing run does not remove the queued value. A call that
   * queues its value resolves at once. A call that starts a run settles when the queue is empty, and rejects if one of the runs failed.
   */
  async run(value: T): Promise<void> {
    this.#next = { value }
    if (this.#isRunning) return
    this.#isRunning = true
    try {
      await this.#runQueued()
    } finally {
      this.#isRunning = false
    }
  }

  drop(): void {
    this.#next = null
  }

  async #runQueued(): Promise<void> {
    if (!this.#next) return
    const { value } = this.#next
    this.#next = null
    try {
      await this.#task(value)
    } finally {
      await this.#runQueued()
    }
  }
}
