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
}
