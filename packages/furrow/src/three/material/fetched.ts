/** What is fetched when it is first wanted; a module that has it may set `value` before. */
export class Fetched<T> {
  /** Null until it is there. */
  value: T | null = null
  readonly #fetch: () => Promise<T>

  constructor(fetch: () => Promise<T>) {
    this.#fetch = fetch
  }

  async load(): Promise<T> {
    this.value ??= await this.#fetch()
    return this.value
  }

  /** Uses it at once if it is there, else when it was fetched; a warning says that this was not possible. */
  use(run: (value: T) => void = () => {}): void {
    if (this.value) run(this.value)
    else
      this.load()
        .then(run)
        .catch(({ message }) => console.warn(message))
  }
}
