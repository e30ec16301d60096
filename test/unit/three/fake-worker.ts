import { FurrowError } from 'furrow'
import { type MeshWrinkles, makeCharacterWrinkles } from '../../../packages/furrow/src/auto/make-wrinkles.ts'
import type { AutoReply, AutoRequest } from '../../../packages/furrow/src/auto/messages.ts'

/** Replaces the web worker of automatic wrinkles: does the work of a character in the same thread. Set it as the global `Worker`. */
export class FakeWorker {
  /** Wrinkles that all workers made, in order. */
  static readonly parts: MeshWrinkles[] = []
  onmessage: (event: { data: AutoReply }) => void = () => {}
  #isEnded = false

  postMessage(request: AutoRequest): void {
    // The arrays of the page must survive the message.
    void this.#run(structuredClone(request))
  }

  terminate(): void {
    this.#isEnded = true
  }

  async #run(request: AutoRequest): Promise<void> {
    if (request.type !== 'character') throw new Error(request.type)
    const { character, options, version } = request
    const progress = (done: number, total: number, step: string) =>
      this.#reply({ type: 'progress', done, total, step })
    const part = (part: MeshWrinkles) => {
      FakeWorker.parts.push(part)
      this.#reply({ type: 'part', part })
    }
    try {
      this.#reply({ type: 'started' })
      const { notes } = await makeCharacterWrinkles(character, options, version, progress, part)
      this.#reply({ type: 'made', result: notes })
      this.#reply({ type: 'finished' })
    } catch (error) {
      if (!(error instanceof FurrowError)) throw error
      this.#reply({ type: 'failed', parts: { ...error }, message: error.message })
    }
  }

  #reply(data: AutoReply): void {
    if (!this.#isEnded) this.onmessage({ data })
  }
}
