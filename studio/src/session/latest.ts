/** Runs a task again and again, one run at a time, with the latest value: those that come and are replaced while it runs are dropped. */
export class Latest<T> {
  readonly #task: (value: T) => Promise<void>
  #next: { value: T } | null = null
  #isRunning = false

  constructor(task: (value: T) => Promise<void>) {
    this.#task = task
  }

  /** Runs the task with a value, when the run that is under way has ended. Rejects with what the task rejects with; the values stay. */
  async run(value: T): Promise<void> {
    this.#next = { value }
    if (this.#isRunning) return
    this.#isRunning = true
    try {
      while (this.#next) {
        const { value: latest } = this.#next
        this.#next = null
        await this.#task(latest)
      }
    } finally {
      this.#isRunning = false
    }
  }

  /** Drops the value that waits. */
  drop(): void {
    this.#next = null
  }
}
