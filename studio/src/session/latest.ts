/** Runs a task with the latest value, one run at a time. Values replaced during a run are dropped. */
export class Latest<T> {
  readonly #task: (value: T) => Promise<void>
  #next: { value: T } | null = null
  #isRunning = false

  constructor(task: (value: T) => Promise<void>) {
    this.#task = task
  }

  /** Queues a value until the current run ends. Rejects with errors of the task, and then keeps a queued value. */
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

  /** Drops the queued value. */
  drop(): void {
    this.#next = null
  }
}
